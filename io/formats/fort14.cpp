#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "wellspaced/io/formats/solver_files.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr int kOpenBoundary = 1;
constexpr int kLandOffset = 2;

class Fort14Parser {
 public:
  Fort14Parser(std::string_view text, const TextSource& source)
      : scanner_(text, source, {.comment = 0}) {}

  Result<Geometry> parse();

 private:
  void read_nodes(Index count);
  void read_elements(Index count);
  void read_open_boundaries();
  void read_land_boundaries();
  void read_open_string();
  void read_land_string();
  void add_chain(const std::vector<Index>& nodes, int marker);
  Index read_node() { return scanner_.point(geometry_.mesh.points.size(), 1); }
  void note_degrees();
  void note_barriers();

  Scanner scanner_;
  Geometry geometry_;
  std::set<int> land_types_;
};

void Fort14Parser::read_nodes(Index count) {
  geometry_.mesh.points.reserve(count);
  geometry_.point_attributes.columns = 1;
  for (Index i = 0; i < count && scanner_.next_record(count, "nodes"); ++i) {
    if (const std::int64_t number = scanner_.integer("node number"); number != std::int64_t{i} + 1)
      scanner_.fail(ErrorCode::kUnreadable,
                    {"node number ", number, " where ", std::uint64_t{i} + 1, " should follow"});
    const double x = scanner_.number("x coordinate");
    geometry_.mesh.points.push_back({x, scanner_.number("y coordinate")});
    geometry_.point_attributes.values.push_back(scanner_.number("depth"));
  }
}

void Fort14Parser::read_elements(Index count) {
  geometry_.mesh.triangles.reserve(count);
  for (Index i = 0; i < count && scanner_.next_record(count, "elements"); ++i) {
    scanner_.integer("element number");
    if (scanner_.integer("number of corners") != 3)
      scanner_.fail(ErrorCode::kUnreadable, "an element that is no triangle");
    const Index a = read_node(), b = read_node();
    geometry_.mesh.triangles.push_back({a, b, read_node()});
  }
}

void Fort14Parser::add_chain(const std::vector<Index>& nodes, int marker) {
  for (std::size_t i = 1; i < nodes.size(); ++i)
    geometry_.mesh.segments.push_back({nodes[i - 1], nodes[i], marker});
}

void Fort14Parser::read_open_string() {
  const Index count = scanner_.count("nodes of a boundary", 1);
  std::vector<Index> nodes;
  for (Index i = 0; i < count && scanner_.next_record(count, "nodes of a boundary"); ++i)
    nodes.push_back(read_node());
  add_chain(nodes, kOpenBoundary);
}

bool is_barrier_type(std::int64_t type) {
  return type == 4 || type == 24 || type == 5 || type == 25;
}

// Islands are closed without saying so; the nodes of barriers come in pairs.
void Fort14Parser::read_land_string() {
  const Index count = scanner_.count("nodes of a boundary", 1);
  const std::int64_t type = scanner_.integer("boundary type");
  if (type < 0 || type > 1000)
    scanner_.fail(ErrorCode::kUnreadable, {"the boundary type ", type, " makes no sense"});
  std::vector<Index> nodes, across;
  for (Index i = 0; i < count && scanner_.next_record(count, "nodes of a boundary"); ++i) {
    nodes.push_back(read_node());
    if (is_barrier_type(type)) across.push_back(read_node());
  }
  if (!scanner_.ok()) return;
  const bool island = type == 1 || type == 11 || type == 21;
  if (island && nodes.size() > 2 && nodes.front() != nodes.back()) nodes.push_back(nodes.front());
  const int marker = static_cast<int>(type) + kLandOffset;
  land_types_.insert(static_cast<int>(type));
  add_chain(nodes, marker);
  add_chain(across, marker);
}

void Fort14Parser::read_open_boundaries() {
  if (!scanner_.next_line()) return;
  const Index strings = scanner_.count("open boundaries", 1);
  scanner_.next_record(strings, "number of nodes of open boundaries");
  for (Index i = 0; i < strings && scanner_.next_record(strings, "open boundaries"); ++i)
    read_open_string();
  if (strings > 0) geometry_.marker_names.push_back({1, kOpenBoundary, "open"});
}

void Fort14Parser::read_land_boundaries() {
  if (!scanner_.next_line()) return;
  const Index strings = scanner_.count("land boundaries", 1);
  scanner_.next_record(strings, "number of nodes of land boundaries");
  for (Index i = 0; i < strings && scanner_.next_record(strings, "land boundaries"); ++i)
    read_land_string();
  for (const int type : land_types_)
    geometry_.marker_names.push_back({1, type + kLandOffset, concat({"land ", type})});
}

void Fort14Parser::note_degrees() {
  const auto& points = geometry_.mesh.points;
  const bool degrees = std::all_of(points.begin(), points.end(), [](const Point2& p) {
    return std::abs(p.x) <= 360 && std::abs(p.y) <= 90;
  });
  if (degrees && !points.empty())
    geometry_.notes.push_back(concat({scanner_.file(),
                                      ": the coordinates may be longitude and latitude; "
                                      "angles mean little unless they are projected"}));
}

void Fort14Parser::note_barriers() {
  if (std::any_of(land_types_.begin(), land_types_.end(), is_barrier_type))
    geometry_.notes.push_back(
        concat({scanner_.file(),
                ": the nodes of barriers (types 4, 5, 24, 25) come in pairs, which "
                "coarsening tears apart unless --fixed names them"}));
}

Result<Geometry> Fort14Parser::parse() {
  geometry_.index_base = 1;
  scanner_.next_line_or_empty();  // the title
  scanner_.require_line("the number of elements and nodes");
  const Index elements = scanner_.count("elements", 5);
  const Index nodes = scanner_.count("nodes", 4);
  read_nodes(nodes);
  read_elements(elements);
  if (scanner_.ok()) read_open_boundaries();
  if (scanner_.ok()) read_land_boundaries();
  if (!scanner_.ok()) return scanner_.error();
  note_degrees();
  note_barriers();
  return std::move(geometry_);
}

}  // namespace

Result<Geometry> parse_fort14(std::string_view text, const TextSource& source) {
  return Fort14Parser(text, source).parse();
}

// A title, two counts, and a first node with number 1.
bool recognise_fort14(std::string_view text) {
  Scanner scanner(text, "", {.comment = 0});
  if (!scanner.next_line_or_empty() || !scanner.next_line()) return false;
  scanner.count("elements", 5);
  scanner.count("nodes", 4);
  if (!scanner.ok() || !scanner.next_line() || scanner.count_fields() < 4) return false;
  return scanner.integer("node number") == 1 && scanner.ok();
}

}  // namespace wellspaced
