#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/io/formats/solver_files.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr std::string_view kMfemBanner = "MFEM mesh v1.0";
enum : std::int64_t { kMfemPoint = 0, kMfemSegment = 1, kMfemTriangle = 2, kMfemTet = 4 };

// How many vertices the file announces: elements, which refer to them, come first.
std::size_t announced_mfem_vertices(std::string_view text) {
  Scanner scanner(text, "", {.across_lines = true});
  while (scanner.more())
    if (scanner.word("keyword") == "vertices") return scanner.count("vertices", 2);
  return 0;
}

class MfemParser {
 public:
  MfemParser(std::string_view text, const TextSource& source)
      : scanner_(text, source, {.across_lines = true}), vertices_(announced_mfem_vertices(text)) {}

  Result<Geometry> parse();

 private:
  void read_banner();
  bool read_section();
  void read_elements(const char* what);
  void read_vertices();
  Index read_corner() { return scanner_.point(vertices_, 0); }

  Scanner scanner_;
  std::size_t vertices_;
  Geometry geometry_;
  std::vector<int> tet_markers_;
};

void MfemParser::read_banner() {
  if (!scanner_.require_line(concat({"the line ", kMfemBanner}))) return;
  if (const std::string_view line = scanner_.rest_of_line(); line != kMfemBanner)
    scanner_.fail(ErrorCode::kUnreadable,
                  {in_quotes(line), " where ", kMfemBanner, " should stand"});
}

void MfemParser::read_elements(const char* what) {
  const Index count = scanner_.count(what, 3);
  TetMesh& solid = geometry_.solid;
  for (Index i = 0; i < count && scanner_.ok(); ++i) {
    const int marker = scanner_.marker();
    const std::int64_t type = scanner_.integer("type of element");
    if (type == kMfemPoint) {
      read_corner();
    } else if (type == kMfemSegment) {
      const Index a = read_corner();
      solid.segments.push_back({a, read_corner(), marker});
    } else if (type == kMfemTriangle) {
      const Index a = read_corner(), b = read_corner();
      solid.facets.push_back({{a, b, read_corner()}, marker});
    } else if (type == kMfemTet) {
      const Index a = read_corner(), b = read_corner(), c = read_corner();
      solid.tets.push_back({a, b, c, read_corner()});
      tet_markers_.push_back(marker);
    } else {
      scanner_.fail(ErrorCode::kUnreadable,
                    {"elements of type ", type,
                     " are not understood, only segments (1), triangles (2), tetrahedra (4)"});
    }
  }
}

void MfemParser::read_vertices() {
  const Index count = scanner_.count("vertices", 2);
  if (!scanner_.more()) return;  // none
  if (Scanner(scanner_).word("dimension") == "nodes")
    return scanner_.fail(ErrorCode::kUnreadable, "curved meshes (nodes) are not understood");
  const std::int64_t dimension = scanner_.integer("dimension of the vertices");
  if (dimension != 2 && dimension != 3)
    scanner_.fail(ErrorCode::kUnreadable, "the dimension of the vertices is not 2 or 3");
  for (Index i = 0; i < count && scanner_.ok(); ++i) {
    const double x = scanner_.number("x coordinate");
    const double y = scanner_.number("y coordinate");
    geometry_.solid.points.push_back({x, y, dimension == 3 ? scanner_.number("z coordinate") : 0});
  }
}

bool MfemParser::read_section() {
  if (!scanner_.more()) return false;
  const std::string_view keyword = scanner_.word("section");
  if (keyword == "dimension") {
    scanner_.integer("dimension");
  } else if (keyword == "elements" || keyword == "boundary") {
    read_elements(keyword == "elements" ? "elements" : "boundary elements");
  } else if (keyword == "vertices") {
    read_vertices();
  } else {
    scanner_.fail(
        ErrorCode::kUnreadable,
        {in_quotes(keyword), " where dimension, elements, boundary or vertices should be"});
  }
  return scanner_.ok();
}

Result<Geometry> MfemParser::parse() {
  geometry_.dimension = 3;
  read_banner();
  while (read_section()) {
  }
  if (geometry_.solid.points.size() != vertices_)
    scanner_.fail(ErrorCode::kUnreadable, "the vertices are listed more than once");
  if (!scanner_.ok()) return scanner_.error();
  set_cell_markers(geometry_, tet_markers_);
  lay_in_plane(geometry_);
  return std::move(geometry_);
}

class MfemWriter {
 public:
  MfemWriter(TextWriter& out, const Geometry& lifted, int dimension)
      : out_(out), geometry_(lifted), dimension_(dimension) {}

  void write();

 private:
  /// Elements of one dimension: what of(i) and marker_of(i) say of each of `count`.
  template <class Corners, class Marker>
  void write_elements(std::int64_t type, std::size_t count, Corners of, Marker marker_of);
  void write_segments();
  void write_facets();
  void write_tets();
  void write_vertices();

  TextWriter& out_;
  const Geometry& geometry_;
  int dimension_;
};

template <class Corners, class Marker>
void MfemWriter::write_elements(std::int64_t type, std::size_t count, Corners of,
                                Marker marker_of) {
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max<std::int64_t>(largest, marker_of(i));
  out_ << count << '\n';
  for (std::size_t i = 0; i < count; ++i) {
    out_ << (marker_of(i) > 0 ? std::int64_t{marker_of(i)} : largest + 1) << ' ' << type;
    for (const Index v : of(i)) out_ << ' ' << v;
    out_ << '\n';
  }
}

void MfemWriter::write_segments() {
  const auto& segments = geometry_.solid.segments;
  write_elements(
      kMfemSegment, segments.size(),
      [&](std::size_t i) {
        return std::array{segments[i].a, segments[i].b};
      },
      [&](std::size_t i) { return segments[i].marker; });
}

void MfemWriter::write_facets() {
  const auto& facets = geometry_.solid.facets;
  write_elements(
      kMfemTriangle, facets.size(), [&](std::size_t i) { return facets[i].points; },
      [&](std::size_t i) { return facets[i].marker; });
}

void MfemWriter::write_tets() {
  const std::vector<int> markers = cell_markers(geometry_);
  write_elements(
      kMfemTet, markers.size(), [&](std::size_t i) { return geometry_.solid.tets[i]; },
      [&](std::size_t i) { return markers[i]; });
}

void MfemWriter::write_vertices() {
  out_ << "\nvertices\n" << geometry_.solid.points.size() << '\n' << dimension_ << '\n';
  for (const Point3& p : geometry_.solid.points) {
    out_ << p.x << ' ' << p.y;
    if (dimension_ == 3) out_ << ' ' << p.z;
    out_ << '\n';
  }
}

void MfemWriter::write() {
  out_ << kMfemBanner << '\n';
  out_.comment("#", geometry_.remark);
  out_ << "\ndimension\n" << dimension_ << "\n\nelements\n";
  dimension_ == 2 ? write_facets() : write_tets();
  out_ << "\nboundary\n";
  dimension_ == 2 ? write_segments() : write_facets();
  write_vertices();
}

}  // namespace

Result<Geometry> parse_mfem(std::string_view text, const TextSource& source) {
  return MfemParser(text, source).parse();
}

bool recognise_mfem(std::string_view text) {
  Scanner scanner(text, "");
  return scanner.next_line() && scanner.rest_of_line().substr(0, 9) == "MFEM mesh";
}

Status write_mfem(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (Status status = refuse_polygons(geometry, path, "an MFEM file"); !status) return status;
  const Geometry lifted = lift_to_space(geometry);
  return outputs.add(path,
                     [&](TextWriter& out) { MfemWriter(out, lifted, geometry.dimension).write(); });
}

}  // namespace wellspaced
