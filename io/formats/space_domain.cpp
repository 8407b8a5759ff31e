#include "wellspaced/io/formats/space_domain.hpp"

#include <array>
#include <span>
#include <utility>

namespace wellspaced {
namespace {

class SpaceDomainReader {
 public:
  SpaceDomainReader(Scanner& scanner, Geometry& geometry)
      : scanner_(scanner), geometry_(geometry) {}

  void read_facets(FacetSyntax syntax);
  void read_holes();
  void read_regions();

 private:
  Pls::Facet read_poly_facet(bool marked);
  Pls::Facet read_smesh_facet(bool marked);
  std::vector<Index> read_polygon();
  Point3 read_seed(const char* number);

  Scanner& scanner_;
  Geometry& geometry_;
};

std::vector<Index> SpaceDomainReader::read_polygon() {
  const Index corners = scanner_.count("corners", 0);
  if (scanner_.ok() && corners == 0)
    scanner_.fail(ErrorCode::kUnreadable, "a polygon without corners");
  std::vector<Index> polygon;
  for (Index i = 0; i < corners && scanner_.ok(); ++i) {
    if (!scanner_.more()) scanner_.require_line("the next corner of the polygon");
    polygon.push_back(scanner_.point(geometry_.solid.points.size(), geometry_.index_base));
  }
  return polygon;
}

Point3 SpaceDomainReader::read_seed(const char* number) {
  scanner_.integer(number);
  const double x = scanner_.number("x coordinate");
  const double y = scanner_.number("y coordinate");
  return {x, y, scanner_.number("z coordinate")};
}

Pls::Facet SpaceDomainReader::read_poly_facet(bool marked) {
  Pls::Facet facet;
  const Index polygons = scanner_.count("polygons", 2);
  const Index holes = scanner_.more() ? scanner_.count("holes of a facet", 4) : 0;
  if (marked && scanner_.more()) facet.marker = scanner_.marker();
  for (Index i = 0; i < polygons && scanner_.next_record(polygons, "polygons"); ++i)
    facet.polygons.push_back(read_polygon());
  for (Index i = 0; i < holes && scanner_.next_record(holes, "holes of a facet"); ++i)
    facet.holes.push_back(read_seed("hole number"));
  return facet;
}

Pls::Facet SpaceDomainReader::read_smesh_facet(bool marked) {
  Pls::Facet facet;
  facet.polygons.push_back(read_polygon());
  if (marked && scanner_.more()) facet.marker = scanner_.marker();
  return facet;
}

bool is_segment(const Pls::Facet& facet) {
  return facet.holes.empty() && facet.polygons.size() == 1 && facet.polygons[0].size() == 2;
}

void SpaceDomainReader::read_facets(FacetSyntax syntax) {
  if (!scanner_.require_line("the number of facets")) return;
  const Index count = scanner_.count("facets", 2);
  const bool marked = scanner_.integer_or(0, "number of markers") != 0;
  for (Index i = 0; i < count && scanner_.next_record(count, "facets"); ++i) {
    Pls::Facet facet =
        syntax == FacetSyntax::kPoly ? read_poly_facet(marked) : read_smesh_facet(marked);
    if (is_segment(facet)) {
      const std::vector<Index>& ends = facet.polygons[0];
      geometry_.solid.segments.push_back({ends[0], ends[1], facet.marker});
    } else if (!facet.polygons.empty()) {
      add_facet(geometry_, std::move(facet));
    }
  }
}

void SpaceDomainReader::read_holes() {
  if (!scanner_.next_line()) return;
  const Index count = scanner_.count("holes", 4);
  for (Index i = 0; i < count && scanner_.next_record(count, "holes"); ++i)
    geometry_.volume_holes.push_back(read_seed("hole number"));
}

void SpaceDomainReader::read_regions() {
  if (!scanner_.next_line()) return;
  const Index count = scanner_.count("regions", 5);
  for (Index i = 0; i < count && scanner_.next_record(count, "regions"); ++i) {
    Pls::Region region;
    region.seed = read_seed("region number");
    region.attribute = scanner_.number("attribute");
    if (scanner_.more()) region.max_volume = scanner_.number("largest volume");
    geometry_.volume_regions.push_back(region);
  }
}

// Writes facets in one of the two ways.
class FacetWriter {
 public:
  FacetWriter(TextWriter& out, FacetSyntax syntax, Index base)
      : out_(out), syntax_(syntax), base_(base) {}

  void write(std::span<const Index> corners, int marker) {
    if (syntax_ == FacetSyntax::kPoly) out_ << "1 0 " << marker << '\n';
    write_corners(corners);
    if (syntax_ == FacetSyntax::kSmesh) out_ << ' ' << marker;
    out_ << '\n';
  }
  void write(const Pls::Facet& facet);

 private:
  void write_corners(std::span<const Index> corners) {
    out_ << corners.size();
    for (const Index v : corners) out_ << ' ' << std::uint64_t{v} + base_;
  }

  TextWriter& out_;
  FacetSyntax syntax_;
  Index base_;
};

void FacetWriter::write(const Pls::Facet& facet) {
  if (syntax_ == FacetSyntax::kSmesh) return write(facet.polygons[0], facet.marker);
  out_ << facet.polygons.size() << ' ' << facet.holes.size() << ' ' << facet.marker << '\n';
  for (const std::vector<Index>& polygon : facet.polygons) {
    write_corners(polygon);
    out_ << '\n';
  }
  for (std::size_t i = 0; i < facet.holes.size(); ++i) {
    const auto& [x, y, z] = facet.holes[i];
    out_ << i + base_ << ' ' << x << ' ' << y << ' ' << z << '\n';
  }
}

}  // namespace

void read_space_domain(Scanner& scanner, FacetSyntax syntax, Geometry& geometry) {
  SpaceDomainReader reader(scanner, geometry);
  reader.read_facets(syntax);
  reader.read_holes();
  reader.read_regions();
}

void write_space_domain(TextWriter& out, FacetSyntax syntax, const Geometry& geometry) {
  const TetMesh& solid = geometry.solid;
  const Index base = geometry.index_base;
  out << geometry.polygons.size() + solid.facets.size() + solid.segments.size() << " 1\n";
  FacetWriter facets(out, syntax, base);
  for (const Pls::Facet& facet : geometry.polygons) facets.write(facet);
  for (const TetMesh::Facet& facet : solid.facets) facets.write(facet.points, facet.marker);
  for (const Segment& s : solid.segments) facets.write(std::array{s.a, s.b}, s.marker);
  out << geometry.volume_holes.size() << '\n';
  for (std::size_t i = 0; i < geometry.volume_holes.size(); ++i) {
    const auto& [x, y, z] = geometry.volume_holes[i];
    out << i + base << ' ' << x << ' ' << y << ' ' << z << '\n';
  }
  if (geometry.volume_regions.empty()) return;
  out << geometry.volume_regions.size() << '\n';
  for (std::size_t i = 0; i < geometry.volume_regions.size(); ++i) {
    const Pls::Region& region = geometry.volume_regions[i];
    const auto& [x, y, z] = region.seed;
    out << i + base << ' ' << x << ' ' << y << ' ' << z << ' ' << region.attribute << ' '
        << region.max_volume << '\n';
  }
}

}  // namespace wellspaced
