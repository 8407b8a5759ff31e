#include <array>

#include "wellspaced/io/formats/space_domain.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {
namespace {

// Reads one text. Failures stick in the scanner.
class TriangleParser {
 public:
  TriangleParser(std::string_view text, const TextSource& source) : scanner_(text, source) {}

  void read_points(Geometry& geometry);
  std::vector<Segment> read_segments(const Geometry& geometry);
  void read_holes(Geometry& geometry);
  void read_regions(Geometry& geometry);
  void read_domain_in_space(FacetSyntax syntax, Geometry& geometry) {
    read_space_domain(scanner_, syntax, geometry);
  }
  std::vector<TetMesh::Facet> read_faces(const Geometry& geometry);
  void read_cells(Geometry& geometry);
  void require_end();

  bool ok() const { return scanner_.ok(); }
  const Error& error() const { return scanner_.error(); }
  Scanner& scanner() { return scanner_; }

 private:
  struct PointHeader {
    Index count = 0;
    int dimension = 2;
    Index attributes = 0;
    bool markers = false;
  };
  PointHeader read_point_header();
  void read_point_number(Index i, Geometry& geometry);
  void read_point(const PointHeader& header, Geometry& geometry);
  Index read_columns(const char* what);
  Index read_index(const Geometry& geometry) {
    return scanner_.point(geometry.point_count(), geometry.index_base);
  }
  Point2 read_seed(const char* number);
  template <std::size_t kCorners>
  void read_cell_lines(Index count, const Geometry& geometry,
                       std::vector<std::array<Index, kCorners>>& cells, Attributes& attributes);

  Scanner scanner_;
};

// How many columns of a kind there are: a million or more is a mistake.
Index TriangleParser::read_columns(const char* what) {
  constexpr std::int64_t kMost = 1'000'000;
  const std::int64_t count = scanner_.integer_or(0, what);
  if (count < 0 || count > kMost)
    scanner_.fail(ErrorCode::kUnreadable, {"the ", what, " ", count, " makes no sense"});
  return ok() ? static_cast<Index>(count) : 0;
}

// The count comes first, but how much room it needs depends on the columns behind it.
TriangleParser::PointHeader TriangleParser::read_point_header() {
  PointHeader header;
  if (!scanner_.require_line("the number of points")) return header;
  header.count = scanner_.count("points", 3);
  const std::int64_t dimension = scanner_.integer_or(2, "dimension");
  if (dimension != 2 && dimension != 3)
    scanner_.fail(ErrorCode::kUnreadable, {"the dimension is ", dimension, ", not 2 or 3"});
  header.dimension = dimension == 3 ? 3 : 2;
  header.attributes = read_columns("number of attributes");
  header.markers = read_columns("number of markers") != 0;
  const std::uint64_t fields = std::uint64_t{1} + (header.dimension == 3 ? 3 : 2) +
                               header.attributes + (header.markers ? 1 : 0);
  if (!ok() || !scanner_.has_room_for(header.count, fields, "points")) header.count = 0;
  return header;
}

void TriangleParser::read_point_number(Index i, Geometry& geometry) {
  const std::int64_t number = scanner_.integer("point number");
  if (i == 0 && number != 0 && number != 1)
    scanner_.fail(ErrorCode::kUnreadable, {"the first point has number ", number, ", not 0 or 1"});
  if (i == 0) geometry.index_base = number == 1 ? 1 : 0;
  if (const std::int64_t expected = std::int64_t{i} + geometry.index_base; number != expected)
    scanner_.fail(ErrorCode::kUnreadable,
                  {"point number ", number, " where ", expected, " should follow"});
}

void TriangleParser::read_point(const PointHeader& header, Geometry& geometry) {
  const double x = scanner_.number("x coordinate");
  const double y = scanner_.number("y coordinate");
  const bool plane = header.dimension == 2;
  if (plane) {
    geometry.mesh.points.push_back({x, y});
  } else {
    geometry.solid.points.push_back({x, y, scanner_.number("z coordinate")});
  }
  for (Index a = 0; a < header.attributes; ++a)
    geometry.point_attributes.values.push_back(scanner_.number("attribute"));
  if (!header.markers) return;
  auto& markers = plane ? geometry.mesh.point_markers : geometry.solid.point_markers;
  markers.push_back(scanner_.marker());
}

void TriangleParser::read_points(Geometry& geometry) {
  const PointHeader header = read_point_header();
  geometry.dimension = header.dimension;
  geometry.point_attributes.columns = header.attributes;
  geometry.point_attributes.values.reserve(std::size_t{header.count} * header.attributes);
  if (header.dimension == 2) {
    geometry.mesh.points.reserve(header.count);
  } else {
    geometry.solid.points.reserve(header.count);
  }
  for (Index i = 0; i < header.count && scanner_.next_record(header.count, "points"); ++i) {
    read_point_number(i, geometry);
    read_point(header, geometry);
  }
}

std::vector<Segment> TriangleParser::read_segments(const Geometry& geometry) {
  std::vector<Segment> segments;
  if (!scanner_.require_line("the number of segments")) return segments;
  const Index count = scanner_.count("segments", 3);
  const bool marked = read_columns("number of markers") != 0;
  if (!ok() || !scanner_.has_room_for(count, marked ? 4 : 3, "segments")) return segments;
  segments.reserve(count);
  for (Index i = 0; i < count && scanner_.next_record(count, "segments"); ++i) {
    scanner_.integer("segment number");
    Segment segment;
    segment.a = read_index(geometry);
    segment.b = read_index(geometry);
    if (marked) segment.marker = scanner_.marker();
    segments.push_back(segment);
  }
  return segments;
}

std::vector<TetMesh::Facet> TriangleParser::read_faces(const Geometry& geometry) {
  std::vector<TetMesh::Facet> faces;
  if (!scanner_.require_line("the number of faces")) return faces;
  const Index count = scanner_.count("faces", 4);
  const bool marked = read_columns("number of markers") != 0;
  if (!ok() || !scanner_.has_room_for(count, marked ? 5 : 4, "faces")) return faces;
  faces.reserve(count);
  for (Index i = 0; i < count && scanner_.next_record(count, "faces"); ++i) {
    scanner_.integer("face number");
    TetMesh::Facet face;
    for (Index& corner : face.points) corner = read_index(geometry);
    if (marked) face.marker = scanner_.marker();
    faces.push_back(face);
  }
  return faces;
}

Point2 TriangleParser::read_seed(const char* number) {
  scanner_.integer(number);
  const double x = scanner_.number("x coordinate");
  return {x, scanner_.number("y coordinate")};
}

void TriangleParser::read_holes(Geometry& geometry) {
  if (!scanner_.next_line()) return;
  const Index count = scanner_.count("holes", 3);
  geometry.holes.reserve(count);
  for (Index i = 0; i < count && scanner_.next_record(count, "holes"); ++i)
    geometry.holes.push_back(read_seed("hole number"));
}

void TriangleParser::read_regions(Geometry& geometry) {
  if (!scanner_.next_line()) return;
  const Index count = scanner_.count("regions", 4);
  geometry.regions.reserve(count);
  for (Index i = 0; i < count && scanner_.next_record(count, "regions"); ++i) {
    Pslg::Region region;
    region.seed = read_seed("region number");
    region.attribute = scanner_.number("attribute");
    region.max_area = scanner_.more() ? scanner_.number("largest area") : region.attribute;
    geometry.regions.push_back(region);
  }
}

template <std::size_t kCorners>
void TriangleParser::read_cell_lines(Index count, const Geometry& geometry,
                                     std::vector<std::array<Index, kCorners>>& cells,
                                     Attributes& attributes) {
  cells.reserve(count);
  attributes.values.reserve(std::size_t{count} * attributes.columns);
  for (Index i = 0; i < count && scanner_.next_record(count, "elements"); ++i) {
    scanner_.integer("element number");
    std::array<Index, kCorners> cell{};
    for (Index& corner : cell) corner = read_index(geometry);
    cells.push_back(cell);
    for (Index a = 0; a < attributes.columns; ++a)
      attributes.values.push_back(scanner_.number("attribute"));
  }
}

void TriangleParser::read_cells(Geometry& geometry) {
  if (!scanner_.require_line("the number of elements")) return;
  const Index count = scanner_.count("elements", 4);
  const Index expected = geometry.dimension == 3 ? 4 : 3;
  const std::int64_t corners = scanner_.integer_or(expected, "number of corners");
  if (corners != expected)
    scanner_.fail(ErrorCode::kUnreadable,
                  {"elements have ", corners, " nodes; only linear ones, with ", expected,
                   " over these points, are understood"});
  Attributes& attributes = geometry.cell_attributes;
  attributes.columns = read_columns("number of attributes");
  const std::uint64_t fields = std::uint64_t{1} + expected + attributes.columns;
  if (!ok() || !scanner_.has_room_for(count, fields, "elements")) return;
  if (geometry.dimension == 2) {
    read_cell_lines(count, geometry, geometry.mesh.triangles, attributes);
  } else {
    read_cell_lines(count, geometry, geometry.solid.tets, attributes);
  }
}

void TriangleParser::require_end() {
  if (scanner_.next_line())
    scanner_.fail(ErrorCode::kUnreadable, "more lines follow than the headers announce");
}

}  // namespace

Result<Geometry> parse_node(std::string_view text, const TextSource& source) {
  TriangleParser parser(text, source);
  Geometry geometry;
  parser.read_points(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return geometry;
}

bool poly_refers_to_node(std::string_view text) {
  Scanner scanner(text, "");
  return scanner.next_line() && scanner.integer("number of points") == 0 && scanner.ok();
}

Result<Geometry> parse_poly(std::string_view text, const TextSource& source,
                            const Geometry* points) {
  TriangleParser parser(text, source);
  Geometry geometry;
  parser.read_points(geometry);
  if (geometry.point_count() == 0 && points != nullptr) geometry = *points;
  if (geometry.dimension == 3) {
    parser.read_domain_in_space(FacetSyntax::kPoly, geometry);
  } else {
    geometry.mesh.segments = parser.read_segments(geometry);
    parser.read_holes(geometry);
    parser.read_regions(geometry);
  }
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return geometry;
}

Result<Geometry> parse_smesh(std::string_view text, const TextSource& source,
                             const Geometry* points) {
  TriangleParser parser(text, source);
  Geometry geometry;
  parser.read_points(geometry);
  if (geometry.point_count() == 0 && points != nullptr) geometry = *points;
  if (geometry.dimension != 3)
    parser.scanner().fail(ErrorCode::kUnreadable, "the points of an .smesh file must lie in space");
  parser.read_domain_in_space(FacetSyntax::kSmesh, geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return geometry;
}

Status parse_ele(std::string_view text, const TextSource& source, Geometry& geometry) {
  TriangleParser parser(text, source);
  parser.read_cells(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return Ok{};
}

Result<std::vector<Segment>> parse_edge(std::string_view text, const TextSource& source,
                                        const Geometry& geometry) {
  TriangleParser parser(text, source);
  std::vector<Segment> edges = parser.read_segments(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return edges;
}

Result<std::vector<TetMesh::Facet>> parse_face(std::string_view text, const TextSource& source,
                                               const Geometry& geometry) {
  TriangleParser parser(text, source);
  std::vector<TetMesh::Facet> faces = parser.read_faces(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return faces;
}

}  // namespace wellspaced
