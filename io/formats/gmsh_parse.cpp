#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "wellspaced/io/formats/gmsh.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// The numbers of a file: fields of its text, or bytes after the line that announces them.
class GmshNumbers {
 public:
  explicit GmshNumbers(Scanner& scanner) : scanner_(scanner) {}

  void become_binary() { binary_ = true; }
  void set_order(std::endian order) { order_ = order; }
  bool binary() const { return binary_; }

  /// 32 bits in binary files.
  std::int64_t integer(std::string_view what) {
    return binary_ ? bytes<std::int32_t>(what) : scanner_.integer(what);
  }
  /// 64 bits in binary files.
  std::int64_t wide(std::string_view what) {
    return binary_ ? bytes<std::int64_t>(what) : scanner_.integer(what);
  }
  double real(std::string_view what);
  /// A wide() number of records that follow, with at least so many numbers each.
  std::int64_t count(std::string_view what, std::uint64_t numbers);

 private:
  template <class T>
  T bytes(std::string_view what) {
    const std::string_view raw = scanner_.bytes_after_line(sizeof(T), what);
    return raw.empty() ? T{} : read_bytes<T>(raw, 0, order_);
  }

  Scanner& scanner_;
  bool binary_ = false;
  std::endian order_ = std::endian::little;
};

double GmshNumbers::real(std::string_view what) {
  if (!binary_) return scanner_.number(what);
  const auto value = bytes<double>(what);
  if (std::isfinite(value)) return value;
  scanner_.fail(ErrorCode::kInvalidGeometry, {"a binary ", what, " is not finite"});
  return 0;
}

std::int64_t GmshNumbers::count(std::string_view what, std::uint64_t numbers) {
  const std::int64_t value = wide(concat({"number of ", what}));
  if (value < 0) scanner_.fail(ErrorCode::kUnreadable, {"the number of ", what, " is negative"});
  if (value >= kNoIndex) scanner_.fail(ErrorCode::kLimit, {"more than 4294967294 ", what});
  const bool fits =
      scanner_.ok() && scanner_.has_room_for(static_cast<std::uint64_t>(value), numbers, what);
  return fits ? value : 0;
}

class GmshParser {
 public:
  GmshParser(std::string_view bytes, const TextSource& source)
      : scanner_(bytes, source, {.comment = 0, .across_lines = true}) {}

  Result<Geometry> parse();

 private:
  void read_section();
  void read_format();
  void read_names();
  void read_entities();
  void read_entity(int dimension);
  void read_nodes_2();
  void read_nodes_4();
  void read_node_block();
  void read_elements_2();
  void read_element_block_2();
  void read_elements_4();
  void pass_to_end_of(std::string_view section);

  void add_node(std::int64_t tag, const Point3& p);
  void sort_nodes();
  Index find_node(std::int64_t tag);
  std::size_t corners_of(std::int64_t type);
  void add_element(std::int64_t type, int marker, const std::array<Index, 4>& corners);
  void read_element(std::int64_t type, std::size_t corners, int marker);
  void drop_repeated_elements();
  Point3 read_place();
  int as_marker(std::int64_t value);

  Scanner scanner_;
  GmshNumbers numbers_{scanner_};
  bool version_4_ = false;
  std::size_t elements_read_ = 0;
  bool has_format_ = false, has_nodes_ = false;
  Geometry geometry_;
  std::vector<std::pair<std::int64_t, Index>> nodes_;  // by tag, once they are sorted
  std::vector<int> tet_markers_, point_markers_;
  std::map<std::pair<int, std::int64_t>, int> physical_;  // of an entity (dimension, tag)
  std::set<std::pair<int, int>> unmarked_;                // physical groups (dimension, tag)
};

void GmshParser::read_format() {
  const std::string_view version = scanner_.word("version");
  version_4_ = version == "4.1";
  if (scanner_.ok() && !version_4_ && version.substr(0, 1) != "2")
    scanner_.fail(ErrorCode::kUnreadable, {"version ", in_quotes(version),
                                           " is not understood, only 2 and 4.1; convert it "
                                           "with gmsh -format msh41"});
  const std::int64_t type = scanner_.integer("file type");
  if (scanner_.integer("data size") != 8 && version_4_)
    scanner_.fail(ErrorCode::kUnreadable, "the data size is not 8");
  has_format_ = true;
  if (type == 0 || !scanner_.ok()) return;
  numbers_.become_binary();
  const std::string_view one = scanner_.bytes_after_line(4, "binary number 1");
  if (one.empty()) return;
  const bool little = read_bytes<std::int32_t>(one, 0, std::endian::little) == 1;
  const bool big = read_bytes<std::int32_t>(one, 0, std::endian::big) == 1;
  numbers_.set_order(big ? std::endian::big : std::endian::little);
  if (!little && !big)
    scanner_.fail(ErrorCode::kUnreadable, "the binary number 1, which tells the order, is missing");
}

void GmshParser::read_names() {
  const Index count = scanner_.count("physical names", 3);
  for (Index i = 0; i < count && scanner_.next_record(count, "physical names"); ++i) {
    MarkerName name;
    const std::int64_t dimension = scanner_.integer("dimension");
    name.dimension = static_cast<int>(std::clamp<std::int64_t>(dimension, 0, 3));
    name.marker = scanner_.marker();
    std::string_view text = scanner_.rest_of_line();
    if (!text.empty() && text.front() == '"') text.remove_prefix(1);
    if (!text.empty() && text.back() == '"') text.remove_suffix(1);
    name.name = text;
    if (name.name == kGmshUnmarked) {
      unmarked_.emplace(name.dimension, name.marker);
    } else {
      geometry_.marker_names.push_back(std::move(name));
    }
  }
}

int GmshParser::as_marker(std::int64_t value) {
  if (value == static_cast<int>(value)) return static_cast<int>(value);
  scanner_.fail(ErrorCode::kUnreadable, {"the tag ", value, " is beyond 32 bits"});
  return 0;
}

Point3 GmshParser::read_place() {
  const double x = numbers_.real("x coordinate");
  const double y = numbers_.real("y coordinate");
  return {x, y, numbers_.real("z coordinate")};
}

void GmshParser::read_entity(int dimension) {
  const std::int64_t tag = numbers_.integer("entity");
  const int places = dimension == 0 ? 1 : 2;
  for (int i = 0; i < places; ++i) read_place();
  const std::int64_t groups = numbers_.count("physical groups", 1);
  for (std::int64_t i = 0; i < groups && scanner_.ok(); ++i) {
    const int group = as_marker(numbers_.integer("physical group"));
    physical_.emplace(std::pair(dimension, tag), group);  // the first one stays
  }
  if (dimension == 0) return;
  const std::int64_t bounds = numbers_.count("bounding entities", 1);
  for (std::int64_t i = 0; i < bounds && scanner_.ok(); ++i) numbers_.integer("bounding entity");
}

void GmshParser::read_entities() {
  std::array<std::int64_t, 4> counts{};
  for (std::int64_t& count : counts) count = numbers_.count("entities", 5);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dimension)] && scanner_.ok(); ++i)
      read_entity(dimension);
}

void GmshParser::add_node(std::int64_t tag, const Point3& p) {
  nodes_.emplace_back(tag, static_cast<Index>(geometry_.solid.points.size()));
  geometry_.solid.points.push_back(p);
}

void GmshParser::sort_nodes() {
  has_nodes_ = true;
  sort(nodes_);
  const auto twice =
      std::adjacent_find(nodes_.begin(), nodes_.end(),
                         [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != nodes_.end())
    scanner_.fail(ErrorCode::kUnreadable, {"node ", twice->first, " occurs twice"});
  if (nodes_.size() >= kNoIndex) scanner_.fail(ErrorCode::kLimit, "more than 4294967294 nodes");
}

void GmshParser::read_nodes_2() {
  const Index count = scanner_.count("nodes", 4);
  for (Index i = 0; i < count && scanner_.ok(); ++i) {
    const std::int64_t tag = numbers_.integer("node number");
    add_node(tag, read_place());
  }
  sort_nodes();
}

// All tags of a block come before its coordinates.
void GmshParser::read_node_block() {
  const std::int64_t dimension = numbers_.integer("dimension of an entity");
  numbers_.integer("entity");
  const bool parametric = numbers_.integer("mark of parametric nodes") != 0;
  const std::int64_t parameters = parametric ? std::clamp<std::int64_t>(dimension, 0, 3) : 0;
  const std::int64_t count = numbers_.count("nodes of a block", 4);
  std::vector<std::int64_t> tags;
  for (std::int64_t i = 0; i < count && scanner_.ok(); ++i)
    tags.push_back(numbers_.wide("node number"));
  for (const std::int64_t tag : tags) {
    if (!scanner_.ok()) return;
    add_node(tag, read_place());
    for (std::int64_t k = 0; k < parameters; ++k) numbers_.real("parameter of a node");
  }
}

void GmshParser::read_nodes_4() {
  const std::int64_t blocks = numbers_.count("node blocks", 4);
  for (const char* what : {"number of nodes", "smallest node", "largest node"}) numbers_.wide(what);
  for (std::int64_t i = 0; i < blocks && scanner_.ok(); ++i) read_node_block();
  sort_nodes();
}

Index GmshParser::find_node(std::int64_t tag) {
  const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), std::pair(tag, Index{0}));
  if (found != nodes_.end() && found->first == tag) return found->second;
  scanner_.fail(ErrorCode::kInvalidGeometry,
                {"node ", tag, " does not exist", has_nodes_ ? "" : " before $Nodes"});
  return 0;
}

// 0, after a failure, for what is no simplex.
std::size_t GmshParser::corners_of(std::int64_t type) {
  switch (type) {
    case 15:
      return 1;
    case 1:
      return 2;
    case 2:
      return 3;
    case 4:
      return 4;
    default:
      scanner_.fail(ErrorCode::kUnreadable,
                    {"elements of type ", type,
                     " are not understood, only points (15), lines (1), triangles (2) and "
                     "tetrahedra (4) with straight edges"});
      return 0;
  }
}

void GmshParser::add_element(std::int64_t type, int marker, const std::array<Index, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  TetMesh& solid = geometry_.solid;
  const int dimension = type == 1 ? 1 : type == 2 ? 2 : type == 4 ? 3 : 0;
  if (unmarked_.contains({dimension, marker})) marker = 0;
  if (type == 15 && marker != 0) {
    point_markers_.resize(solid.points.size());
    point_markers_[a] = marker;
  }
  if (type == 1) solid.segments.push_back({a, b, marker});
  if (type == 2) solid.facets.push_back({{a, b, c}, marker});
  if (type == 4) solid.tets.push_back(corners);
  if (type == 4) tet_markers_.push_back(marker);
}

void GmshParser::read_element(std::int64_t type, std::size_t corners, int marker) {
  std::array<Index, 4> nodes{};
  for (std::size_t i = 0; i < corners && scanner_.ok(); ++i)
    nodes[i] = find_node(version_4_ ? numbers_.wide("node") : numbers_.integer("node"));
  ++elements_read_;
  if (scanner_.ok()) add_element(type, marker, nodes);
}

// Text has blocks of one element each: number, type and tags are in another order, though.
void GmshParser::read_element_block_2() {
  if (!numbers_.binary()) numbers_.integer("element number");
  const std::int64_t type = numbers_.integer("element type");
  const std::int64_t elements = numbers_.binary() ? numbers_.integer("number of elements") : 1;
  const std::int64_t tags = numbers_.integer("number of tags");
  const std::size_t corners = corners_of(type);
  if (elements < 1 || tags < 0)
    scanner_.fail(ErrorCode::kUnreadable, "the header of a block makes no sense");
  for (std::int64_t i = 0; i < elements && scanner_.ok(); ++i) {
    if (numbers_.binary()) numbers_.integer("element number");
    int marker = 0;
    for (std::int64_t k = 0; k < tags && scanner_.ok(); ++k) {
      const std::int64_t tag = numbers_.integer("tag");
      if (k == 0) marker = as_marker(tag);
    }
    read_element(type, corners, marker);
  }
}

void GmshParser::read_elements_2() {
  const Index count = scanner_.count("elements", 4);
  while (scanner_.ok() && elements_read_ < count) read_element_block_2();
}

void GmshParser::read_elements_4() {
  const std::int64_t blocks = numbers_.count("element blocks", 4);
  for (const char* what : {"number of elements", "smallest element", "largest element"})
    numbers_.wide(what);
  for (std::int64_t b = 0; b < blocks && scanner_.ok(); ++b) {
    const std::int64_t dimension = numbers_.integer("dimension of an entity");
    const std::int64_t entity = numbers_.integer("entity");
    const std::int64_t type = numbers_.integer("element type");
    const std::int64_t count = numbers_.count("elements of a block", 2);
    const std::size_t corners = count > 0 ? corners_of(type) : 0;
    const auto group = physical_.find({static_cast<int>(dimension), entity});
    for (std::int64_t i = 0; i < count && scanner_.ok(); ++i) {
      numbers_.wide("element number");
      read_element(type, corners, group == physical_.end() ? 0 : group->second);
    }
  }
}

void GmshParser::pass_to_end_of(std::string_view section) {
  const std::string end = concat({"$End", section});
  while (scanner_.next_line())
    if (scanner_.word("keyword") == end) return;
  scanner_.fail(ErrorCode::kUnreadable, {"the file ends before ", in_quotes(end)});
}

void GmshParser::read_section() {
  std::string_view section = scanner_.word("section");
  if (section[0] != '$')
    return scanner_.fail(ErrorCode::kUnreadable,
                         {in_quotes(section), " where a section should begin"});
  section.remove_prefix(1);
  if (!has_format_ && section != "MeshFormat" && section != "Comments")
    scanner_.fail(ErrorCode::kUnreadable, "$MeshFormat should stand first");
  if (section == "MeshFormat") read_format();
  if (section == "PhysicalNames") read_names();
  if (section == "Entities" && version_4_) read_entities();
  if (section == "Nodes") version_4_ ? read_nodes_4() : read_nodes_2();
  if (section == "Elements") version_4_ ? read_elements_4() : read_elements_2();
  if (scanner_.ok()) pass_to_end_of(section);
}

// Corners in ascending order; unused ones are kNoIndex.
using SortedCorners = std::array<Index, 4>;

// Which of the elements have the corners of an earlier one.
std::vector<bool> find_repeated(std::span<const SortedCorners> elements) {
  std::vector<Index> order(elements.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order, [&](Index i, Index j) { return elements[i] < elements[j]; });
  std::vector<bool> repeated(elements.size());
  for (std::size_t k = 1; k < order.size(); ++k)
    repeated[order[k]] = elements[order[k]] == elements[order[k - 1]];
  return repeated;
}

// Keeps the elements that are not repeated. Returns how many it drops.
template <class Element>
std::size_t drop_repeated(std::vector<Element>& elements, const std::vector<bool>& repeated) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (!repeated[i]) elements[kept++] = elements[i];
  const std::size_t dropped = elements.size() - kept;
  elements.resize(kept);
  return dropped;
}

template <class Element, class CornersOf>
std::vector<bool> find_repeated(const std::vector<Element>& elements, CornersOf corners_of) {
  std::vector<SortedCorners> corners;
  corners.reserve(elements.size());
  for (const Element& element : elements) {
    corners.push_back(corners_of(element));
    sort(corners.back());
  }
  return find_repeated(corners);
}

void GmshParser::drop_repeated_elements() {
  TetMesh& solid = geometry_.solid;
  std::size_t dropped =
      drop_repeated(solid.segments, find_repeated(solid.segments, [](const Segment& s) {
                      return SortedCorners{s.a, s.b, kNoIndex, kNoIndex};
                    }));
  dropped += drop_repeated(solid.facets, find_repeated(solid.facets, [](const TetMesh::Facet& f) {
                             return SortedCorners{f.points[0], f.points[1], f.points[2], kNoIndex};
                           }));
  const std::vector<bool> tets =
      find_repeated(solid.tets, [](const SortedCorners& tet) { return tet; });
  drop_repeated(tet_markers_, tets);
  dropped += drop_repeated(solid.tets, tets);
  if (dropped > 0)
    geometry_.notes.push_back(
        concat({scanner_.file(), ": ", dropped,
                " elements are listed again; their first physical group counts"}));
}

Result<Geometry> GmshParser::parse() {
  geometry_.dimension = 3;
  geometry_.index_base = 1;
  do {
    read_section();
  } while (scanner_.ok() && scanner_.more());
  if (!scanner_.ok()) return scanner_.error();
  drop_repeated_elements();
  if (!point_markers_.empty()) point_markers_.resize(geometry_.solid.points.size());
  geometry_.solid.point_markers = std::move(point_markers_);
  set_cell_markers(geometry_, tet_markers_);
  lay_in_plane(geometry_);
  return std::move(geometry_);
}

}  // namespace

Result<Geometry> parse_gmsh(std::string_view bytes, const TextSource& source) {
  return GmshParser(bytes, source).parse();
}

bool recognise_gmsh(std::string_view bytes) {
  Scanner scanner(bytes, "");
  if (!scanner.next_line()) return false;
  const std::string_view first = scanner.word("section");
  return first == "$MeshFormat" || first == "$Comments";
}

}  // namespace wellspaced
