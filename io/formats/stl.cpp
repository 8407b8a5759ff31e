#include <algorithm>
#include <cmath>
#include <limits>

#include "wellspaced/io/formats/surface.hpp"
#include "wellspaced/io/formats/surface_files.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr std::size_t kStlHeader = 84;  // of which the last four bytes are the number of facets
constexpr std::size_t kStlRecord = 50;
constexpr std::size_t kStlReportEvery = 1 << 16;  // facets

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kStlHeader) return false;
  return bytes.size() - kStlHeader ==
         kStlRecord * std::uint64_t{read_bytes<std::uint32_t>(bytes, 80)};
}

// Corners as they come, three a facet; then the points that they are.
class StlSoup {
 public:
  void add_corner(const Point3& p) { corners_.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0}); }
  void end_facet(int marker) { markers_.push_back(marker); }
  std::size_t corners() const { return corners_.size(); }

  Geometry weld(const std::string& name);

 private:
  std::vector<Index> number_points(std::vector<Point3>& points) const;

  std::vector<Point3> corners_;
  std::vector<int> markers_;
};

// The number of each corner's point; points are numbered in the order of their appearance.
std::vector<Index> StlSoup::number_points(std::vector<Point3>& points) const {
  std::vector<Index> order(corners_.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  sort(order, [&](Index i, Index j) { return corners_[i] < corners_[j]; });
  std::vector<Index> first(corners_.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && corners_[order[k]] == corners_[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  std::vector<Index> number(corners_.size());
  for (Index i = 0; i < first.size(); ++i) {
    if (first[i] == i) points.push_back(corners_[i]);
    number[i] = first[i] == i ? static_cast<Index>(points.size() - 1) : number[first[i]];
  }
  return number;
}

Geometry StlSoup::weld(const std::string& name) {
  Geometry geometry;
  geometry.dimension = 3;
  const std::vector<Index> number = number_points(geometry.solid.points);
  for (std::size_t f = 0; f < markers_.size(); ++f) {
    const Index a = number[3 * f], b = number[3 * f + 1], c = number[3 * f + 2];
    if (a != b && b != c && c != a) geometry.solid.facets.push_back({{a, b, c}, markers_[f]});
  }
  if (const std::size_t left_out = markers_.size() - geometry.solid.facets.size(); left_out > 0)
    geometry.notes.push_back(
        concat({name, ": ", left_out, " facets with coincident corners were left out"}));
  lay_in_plane(geometry);
  return geometry;
}

class AsciiStlParser {
 public:
  AsciiStlParser(std::string_view text, const TextSource& source)
      : scanner_(text, source, {.comment = 0, .across_lines = true}) {}

  Result<Geometry> parse();

 private:
  void read_solid();
  void read_facet();
  void expect(std::string_view keyword);

  Scanner scanner_;
  StlSoup soup_;
  int solid_ = 0;
};

void AsciiStlParser::expect(std::string_view keyword) {
  const std::string_view word = scanner_.word(keyword);
  if (scanner_.ok() && lower_case(word) != keyword)
    scanner_.fail(ErrorCode::kUnreadable, {in_quotes(word), " where ", keyword, " should stand"});
}

void AsciiStlParser::read_facet() {
  expect("normal");
  scanner_.skip_fields(3);
  expect("outer");
  expect("loop");
  for (int i = 0; i < 3; ++i) {
    expect("vertex");
    const double x = scanner_.number("x coordinate");
    const double y = scanner_.number("y coordinate");
    soup_.add_corner({x, y, scanner_.number("z coordinate")});
  }
  expect("endloop");
  expect("endfacet");
  soup_.end_facet(solid_);
}

// Names may hold any words, so they end with their line.
void AsciiStlParser::read_solid() {
  expect("solid");
  scanner_.rest_of_line();
  ++solid_;
  while (scanner_.ok()) {
    const std::string word = lower_case(scanner_.word("facet or endsolid"));
    if (word == "endsolid") break;
    if (scanner_.ok() && word != "facet")
      scanner_.fail(ErrorCode::kUnreadable,
                    {in_quotes(word), " where facet or endsolid should stand"});
    if (scanner_.ok()) read_facet();
  }
  scanner_.rest_of_line();
}

Result<Geometry> AsciiStlParser::parse() {
  read_solid();
  while (scanner_.ok() && scanner_.more()) read_solid();
  if (soup_.corners() >= kNoIndex) scanner_.fail(ErrorCode::kLimit, "more than 1431655764 facets");
  if (!scanner_.ok()) return scanner_.error();
  Geometry geometry = soup_.weld(scanner_.file());
  if (solid_ == 1)
    for (TetMesh::Facet& facet : geometry.solid.facets) facet.marker = 0;
  if (solid_ == 1 && geometry.dimension == 2) geometry.cell_attributes = {};
  return geometry;
}

Result<Geometry> parse_binary_stl(std::string_view bytes, const TextSource& source) {
  const auto count = read_bytes<std::uint32_t>(bytes, 80);
  if (count > (kNoIndex - 1) / 3)
    return Error{ErrorCode::kLimit, {source.name, ": more than 1431655764 facets"}};
  StlSoup soup;
  for (std::size_t f = 0; f < count; ++f) {
    if (f % kStlReportEvery == 0 && !source.keep_going(f, count)) return source.cancelled();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      double c[3];
      for (std::size_t k = 0; k < 3; ++k)
        c[k] = double{
            read_bytes<float>(bytes, kStlHeader + kStlRecord * f + 12 + 12 * corner + 4 * k)};
      if (!std::isfinite(c[0]) || !std::isfinite(c[1]) || !std::isfinite(c[2]))
        return Error{ErrorCode::kInvalidGeometry,
                     {source.name, ": a corner of facet ", f, " (counted from 0) is not finite"},
                     {static_cast<Index>(f)}};
      soup.add_corner({c[0], c[1], c[2]});
    }
    soup.end_facet(0);
  }
  return soup.weld(source.name);
}

Point3 facet_normal(const std::vector<Point3>& points, const TetMesh::Facet& facet) {
  const auto& [a, b, c] = facet.points;
  const Point3 p = points[a], q = points[b], r = points[c];
  const Point3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {n.x / length, n.y / length, n.z / length};
}

void write_ascii_stl(TextWriter& out, const Geometry& geometry) {
  const auto& points = geometry.solid.points;
  out << "solid wellspaced\n";
  for (const TetMesh::Facet& facet : geometry.solid.facets) {
    const Point3 n = facet_normal(points, facet);
    out << "facet normal " << n.x << ' ' << n.y << ' ' << n.z << "\nouter loop\n";
    for (const Index v : facet.points)
      out << "vertex " << points[v].x << ' ' << points[v].y << ' ' << points[v].z << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid wellspaced\n";
}

void write_binary_stl(TextWriter& out, const Geometry& geometry) {
  std::string bytes = "wellspaced";
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(geometry.solid.facets.size()));
  out << bytes;
  std::vector<Point3> points = geometry.solid.points;  // as they will be read
  for (Point3& p : points)
    p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  const auto append = [&](const Point3& p) {
    for (const double c : {p.x, p.y, p.z}) append_bytes(bytes, static_cast<float>(c));
  };
  for (const TetMesh::Facet& facet : geometry.solid.facets) {
    bytes.clear();
    append(facet_normal(points, facet));
    for (const Index v : facet.points) append(points[v]);
    append_bytes(bytes, std::uint16_t{0});
    out << bytes;
  }
}

bool fits_float(const Point3& p) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return std::abs(p.x) <= kMost && std::abs(p.y) <= kMost && std::abs(p.z) <= kMost;
}

}  // namespace

Result<Geometry> parse_stl(std::string_view bytes, const TextSource& source) {
  if (is_binary_stl(bytes)) return parse_binary_stl(bytes, source);
  return AsciiStlParser(bytes, source).parse();
}

bool recognise_stl(std::string_view bytes) {
  if (is_binary_stl(bytes)) return true;
  Scanner scanner(bytes, "");
  return scanner.next_line() && lower_case(scanner.word("keyword")) == "solid";
}

Status write_stl(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (Status status = refuse_polygons(geometry, path, "an STL file"); !status) return status;
  return write_surface(outputs, path, geometry, "an STL file", write_ascii_stl);
}

Status write_stl_binary(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (Status status = refuse_polygons(geometry, path, "an STL file"); !status) return status;
  const Geometry lifted = lift_to_space(geometry);
  if (!std::all_of(lifted.solid.points.begin(), lifted.solid.points.end(), fits_float))
    return Error{ErrorCode::kUsage, {path, ": coordinates beyond 32 bits need --format stl"}};
  return write_surface(outputs, path, geometry, "an STL file", write_binary_stl);
}

}  // namespace wellspaced
