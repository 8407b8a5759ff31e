#include <array>
#include <utility>

#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {
namespace {

// Reads one text. Failures stick in the scanner.
class TriangleParser {
 public:
  TriangleParser(std::string_view text, const std::string& name) : scanner_(text, name) {}

  void read_points(Geometry& geometry);
  std::vector<Segment> read_segments(const Geometry& geometry);
  void read_holes(Geometry& geometry);
  void read_regions(Geometry& geometry);
  void read_cells(Geometry& geometry);
  void require_end();

  bool ok() const { return scanner_.ok(); }
  const Error& error() const { return scanner_.error(); }
  void fail(ErrorCode code, std::string_view message) { scanner_.fail(code, message); }

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
  Index read_count(const char* what, std::uint64_t fields_each);
  Index read_columns(const char* what);
  Index read_index(const Geometry& geometry);
  Point2 read_seed(const char* number);
  template <std::size_t kCorners>
  void read_cell_lines(Index count, const Geometry& geometry,
                       std::vector<std::array<Index, kCorners>>& cells, Attributes& attributes);
  bool next_of(Index count, const char* what);

  Scanner scanner_;
};

// A count, after which that many lines of at least `fields_each` fields follow.
Index TriangleParser::read_count(const char* what, std::uint64_t fields_each) {
  const std::int64_t count = scanner_.integer(std::string("number of ") + what);
  if (count < 0)
    fail(ErrorCode::kUnreadable, "the number of " + std::string(what) + " is negative");
  if (!ok()) return 0;
  if (!scanner_.has_room_for(static_cast<std::uint64_t>(count), fields_each, what)) return 0;
  if (count >= kNoIndex) fail(ErrorCode::kLimit, "more than 4294967294 " + std::string(what));
  return ok() ? static_cast<Index>(count) : 0;
}

// How many columns of a kind there are: a million or more is a mistake.
Index TriangleParser::read_columns(const char* what) {
  constexpr std::int64_t kMost = 1'000'000;
  const std::int64_t count = scanner_.integer_or(0, what);
  if (count < 0 || count > kMost)
    fail(ErrorCode::kUnreadable,
         "the " + std::string(what) + " " + std::to_string(count) + " makes no sense");
  return ok() ? static_cast<Index>(count) : 0;
}

// Moves to the next of `count` lines of a kind.
bool TriangleParser::next_of(Index count, const char* what) {
  if (scanner_.next_line()) return true;
  fail(ErrorCode::kUnreadable,
       "the file ends before its " + std::to_string(count) + " " + what + " do");
  return false;
}

// The count comes first, but how much room it needs depends on the columns behind it.
TriangleParser::PointHeader TriangleParser::read_point_header() {
  PointHeader header;
  if (!scanner_.require_line("the number of points")) return header;
  header.count = read_count("points", 3);
  const std::int64_t dimension = scanner_.integer_or(2, "dimension");
  if (dimension != 2 && dimension != 3)
    fail(ErrorCode::kUnreadable, "the dimension is " + std::to_string(dimension) + ", not 2 or 3");
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
    fail(ErrorCode::kUnreadable,
         "the first point has number " + std::to_string(number) + ", not 0 or 1");
  if (i == 0) geometry.index_base = number == 1 ? 1 : 0;
  if (const std::int64_t expected = std::int64_t{i} + geometry.index_base; number != expected)
    fail(ErrorCode::kUnreadable, "point number " + std::to_string(number) + " where " +
                                     std::to_string(expected) + " should follow");
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
  for (Index i = 0; i < header.count && next_of(header.count, "points"); ++i) {
    read_point_number(i, geometry);
    read_point(header, geometry);
  }
}

Index TriangleParser::read_index(const Geometry& geometry) {
  const std::int64_t number = scanner_.integer("point number");
  const std::int64_t base = geometry.index_base;
  const auto count = static_cast<std::int64_t>(geometry.point_count());
  if (number >= base && number < base + count) return static_cast<Index>(number - base);
  const std::string range = count == 0 ? "there are none"
                                       : "they are numbered from " + std::to_string(base) + " to " +
                                             std::to_string(base + count - 1);
  fail(ErrorCode::kInvalidGeometry,
       "point " + std::to_string(number) + " is not among the points: " + range);
  return 0;
}

std::vector<Segment> TriangleParser::read_segments(const Geometry& geometry) {
  std::vector<Segment> segments;
  if (!scanner_.require_line("the number of segments")) return segments;
  const Index count = read_count("segments", 3);
  const bool marked = read_columns("number of markers") != 0;
  if (!ok() || !scanner_.has_room_for(count, marked ? 4 : 3, "segments")) return segments;
  segments.reserve(count);
  for (Index i = 0; i < count && next_of(count, "segments"); ++i) {
    scanner_.integer("segment number");
    Segment segment;
    segment.a = read_index(geometry);
    segment.b = read_index(geometry);
    if (marked) segment.marker = scanner_.marker();
    segments.push_back(segment);
  }
  return segments;
}

Point2 TriangleParser::read_seed(const char* number) {
  scanner_.integer(number);
  const double x = scanner_.number("x coordinate");
  return {x, scanner_.number("y coordinate")};
}

void TriangleParser::read_holes(Geometry& geometry) {
  if (!scanner_.next_line()) return;
  const Index count = read_count("holes", 3);
  geometry.holes.reserve(count);
  for (Index i = 0; i < count && next_of(count, "holes"); ++i)
    geometry.holes.push_back(read_seed("hole number"));
}

void TriangleParser::read_regions(Geometry& geometry) {
  if (!scanner_.next_line()) return;
  const Index count = read_count("regions", 4);
  geometry.regions.reserve(count);
  for (Index i = 0; i < count && next_of(count, "regions"); ++i) {
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
  for (Index i = 0; i < count && next_of(count, "elements"); ++i) {
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
  const Index count = read_count("elements", 4);
  const Index expected = geometry.dimension == 3 ? 4 : 3;
  const std::int64_t corners = scanner_.integer_or(expected, "number of corners");
  if (corners != expected)
    fail(ErrorCode::kUnreadable, "elements have " + std::to_string(corners) +
                                     " nodes; only linear ones, with " + std::to_string(expected) +
                                     " over these points, are understood");
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
    fail(ErrorCode::kUnreadable, "more lines follow than the headers announce");
}

}  // namespace

Result<Geometry> parse_node(std::string_view text, const std::string& name) {
  TriangleParser parser(text, name);
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

Result<Geometry> parse_poly(std::string_view text, const std::string& name,
                            const Geometry* points) {
  TriangleParser parser(text, name);
  Geometry geometry;
  parser.read_points(geometry);
  if (geometry.point_count() == 0 && points != nullptr) geometry = *points;
  if (geometry.dimension == 3)
    parser.fail(ErrorCode::kUnreadable,
                "this is a domain in space, where one in the plane is needed");
  geometry.mesh.segments = parser.read_segments(geometry);
  parser.read_holes(geometry);
  parser.read_regions(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return geometry;
}

Status parse_ele(std::string_view text, const std::string& name, Geometry& geometry) {
  TriangleParser parser(text, name);
  parser.read_cells(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return Ok{};
}

Result<std::vector<Segment>> parse_edge(std::string_view text, const std::string& name,
                                        const Geometry& geometry) {
  TriangleParser parser(text, name);
  std::vector<Segment> edges = parser.read_segments(geometry);
  parser.require_end();
  if (!parser.ok()) return parser.error();
  return edges;
}

}  // namespace wellspaced
