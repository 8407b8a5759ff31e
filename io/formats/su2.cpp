#include <array>
#include <map>
#include <span>
#include <utility>

#include "wellspaced/io/formats/solver_files.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {
namespace {

constexpr ScanRules kSu2Rules = {.comment = '%', .blank = '='};
enum : std::int64_t { kSu2Vertex = 1, kSu2Line = 3, kSu2Triangle = 5, kSu2Tet = 10 };

// How many points the file announces, wherever that stands.
std::size_t announced_su2_points(std::string_view text) {
  Scanner scanner(text, "", kSu2Rules);
  while (scanner.next_line())
    if (scanner.word("keyword") == "NPOIN") return scanner.count("points", 2);
  return 0;
}

class Su2Parser {
 public:
  Su2Parser(std::string_view text, const TextSource& source)
      : scanner_(text, source, kSu2Rules), points_(announced_su2_points(text)) {}

  Result<Geometry> parse();

 private:
  void read_statement();
  void read_dimension();
  void read_elements();
  void read_points();
  void begin_boundary(std::string_view tag);
  void read_boundary();
  void read_element(int marker);
  template <std::size_t kCorners>
  std::array<Index, kCorners> read_corners();

  Scanner scanner_;
  std::size_t points_;
  Geometry geometry_;
  std::int64_t dimension_ = 0;
  MarkerNumbering boundaries_{geometry_, 1};
  int boundary_ = 0;
  bool is_between_parts_ = false;
};

template <std::size_t kCorners>
std::array<Index, kCorners> Su2Parser::read_corners() {
  std::array<Index, kCorners> corners{};
  for (Index& corner : corners) corner = scanner_.point(points_, 0);
  return corners;
}

// Elements of the domain and of its boundary alike; the number behind the corners is optional.
void Su2Parser::read_element(int marker) {
  const std::int64_t type = scanner_.integer("element type");
  TetMesh& solid = geometry_.solid;
  if (type == kSu2Vertex) {
    read_corners<1>();
  } else if (type == kSu2Line) {
    const auto [a, b] = read_corners<2>();
    solid.segments.push_back({a, b, marker});
  } else if (type == kSu2Triangle) {
    solid.facets.push_back({read_corners<3>(), marker});
  } else if (type == kSu2Tet) {
    solid.tets.push_back(read_corners<4>());
  } else {
    scanner_.fail(ErrorCode::kUnreadable,
                  {"elements of type ", type,
                   " are not understood, only lines (3), triangles (5) and tetrahedra (10)"});
  }
}

void Su2Parser::read_dimension() {
  dimension_ = scanner_.integer("dimension");
  if (dimension_ != 2 && dimension_ != 3)
    scanner_.fail(ErrorCode::kUnreadable, "the dimension is not 2 or 3");
}

void Su2Parser::read_elements() {
  const Index count = scanner_.count("elements", 2);
  for (Index i = 0; i < count && scanner_.next_record(count, "elements"); ++i) read_element(0);
}

void Su2Parser::read_points() {
  if (dimension_ == 0) scanner_.fail(ErrorCode::kUnreadable, "NDIME must come before NPOIN");
  const Index count = scanner_.count("points", static_cast<std::uint64_t>(dimension_));
  for (Index i = 0; i < count && scanner_.next_record(count, "points"); ++i) {
    const double x = scanner_.number("x coordinate");
    const double y = scanner_.number("y coordinate");
    geometry_.solid.points.push_back({x, y, dimension_ == 3 ? scanner_.number("z coordinate") : 0});
  }
}

void Su2Parser::begin_boundary(std::string_view tag) {
  boundary_ = boundaries_.marker_of(tag);
  is_between_parts_ = tag == "SEND_RECEIVE";
}

// Between the parts of a divided mesh stand vertices, and before them who gets them.
void Su2Parser::read_boundary() {
  const Index count = scanner_.count("boundary elements", 2);
  if (is_between_parts_) scanner_.require_line("SEND_TO");
  for (Index i = 0; i < count && scanner_.next_record(count, "boundary elements"); ++i)
    read_element(boundary_);
}

void Su2Parser::read_statement() {
  const std::string_view keyword = scanner_.word("keyword");
  if (keyword == "NDIME") read_dimension();
  if (keyword == "NELEM") read_elements();
  if (keyword == "NPOIN") read_points();
  if (keyword == "MARKER_TAG") begin_boundary(scanner_.rest_of_line());
  if (keyword == "MARKER_ELEMS") read_boundary();
  if (keyword == "NZONE" && scanner_.integer("number of zones") != 1)
    scanner_.fail(ErrorCode::kUnreadable, "several zones are not understood");
}

Result<Geometry> Su2Parser::parse() {
  geometry_.dimension = 3;
  while (scanner_.next_line()) read_statement();
  if (dimension_ == 0) scanner_.fail(ErrorCode::kUnreadable, "NDIME is missing");
  if (geometry_.solid.points.size() != points_)
    scanner_.fail(ErrorCode::kUnreadable, "the points are listed more than once");
  if (!scanner_.ok()) return scanner_.error();
  for (MarkerName& known : geometry_.marker_names)
    known.dimension = static_cast<int>(dimension_) - 1;
  lay_in_plane(geometry_);
  return std::move(geometry_);
}

class Su2Writer {
 public:
  Su2Writer(TextWriter& out, const Geometry& lifted, int dimension)
      : out_(out), geometry_(lifted), dimension_(dimension) {}

  void write();

 private:
  void write_element(int type, std::span<const Index> corners) {
    out_ << type;
    for (const Index v : corners) out_ << ' ' << v;
    out_ << '\n';
  }
  template <class Element, class Write>
  void write_boundaries(const std::vector<Element>& elements, Write write_one);

  TextWriter& out_;
  const Geometry& geometry_;
  int dimension_;
};

template <class Element, class Write>
void Su2Writer::write_boundaries(const std::vector<Element>& elements, Write write_one) {
  std::map<int, std::size_t> counts;
  for (const Element& element : elements) ++counts[element.marker];
  out_ << "NMARK= " << counts.size() << '\n';
  for (const auto& [marker, count] : counts) {
    out_ << "MARKER_TAG= " << marker_name(geometry_, dimension_ - 1, marker)
         << "\nMARKER_ELEMS= " << count << '\n';
    for (const Element& element : elements)
      if (element.marker == marker) write_one(element);
  }
}

void Su2Writer::write() {
  const TetMesh& solid = geometry_.solid;
  out_.comment("%", geometry_.remark);
  out_ << "NDIME= " << dimension_
       << "\nNELEM= " << (dimension_ == 2 ? solid.facets.size() : solid.tets.size()) << '\n';
  if (dimension_ == 2)
    for (const TetMesh::Facet& facet : solid.facets) write_element(kSu2Triangle, facet.points);
  for (const auto& tet : solid.tets) write_element(kSu2Tet, tet);
  out_ << "NPOIN= " << solid.points.size() << '\n';
  for (const Point3& p : solid.points) {
    out_ << p.x << ' ' << p.y;
    if (dimension_ == 3) out_ << ' ' << p.z;
    out_ << '\n';
  }
  if (dimension_ == 2)
    write_boundaries(solid.segments, [this](const Segment& s) {
      write_element(kSu2Line, std::array{s.a, s.b});
    });
  if (dimension_ == 3)
    write_boundaries(solid.facets,
                     [this](const TetMesh::Facet& f) { write_element(kSu2Triangle, f.points); });
}

}  // namespace

Result<Geometry> parse_su2(std::string_view text, const TextSource& source) {
  return Su2Parser(text, source).parse();
}

bool recognise_su2(std::string_view text) {
  Scanner scanner(text, "", kSu2Rules);
  if (!scanner.next_line()) return false;
  const std::string_view keyword = scanner.word("keyword");
  return keyword == "NDIME" || keyword == "NZONE" || keyword == "NELEM" || keyword == "NPOIN";
}

Status write_su2(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (Status status = refuse_polygons(geometry, path, "an SU2 file"); !status) return status;
  const Geometry lifted = lift_to_space(geometry);
  return outputs.add(path,
                     [&](TextWriter& out) { Su2Writer(out, lifted, geometry.dimension).write(); });
}

}  // namespace wellspaced
