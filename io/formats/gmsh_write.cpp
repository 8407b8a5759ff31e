#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "wellspaced/io/formats/gmsh.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/kernel/space/box3.hpp"

namespace wellspaced {
namespace {

// Elements of one dimension, in order.
struct GmshElements {
  int dimension = 0;
  int type = 15;
  std::size_t corners = 1;
  std::vector<Index> nodes;
  std::vector<int> markers;

  std::size_t size() const { return markers.size(); }
  std::span<const Index> of(std::size_t i) const {
    return std::span(nodes).subspan(i * corners, corners);
  }
  void add(std::span<const Index> corners_of_one, int marker) {
    nodes.insert(nodes.end(), corners_of_one.begin(), corners_of_one.end());
    markers.push_back(marker);
  }
};

std::array<GmshElements, 4> gmsh_elements(const Geometry& geometry) {
  std::array<GmshElements, 4> all = {
      {{0, 15, 1, {}, {}}, {1, 1, 2, {}, {}}, {2, 2, 3, {}, {}}, {3, 4, 4, {}, {}}}};
  const TetMesh& solid = geometry.solid;
  for (Index v = 0; v < solid.point_markers.size(); ++v)
    if (solid.point_markers[v] != 0) all[0].add(std::array{v}, solid.point_markers[v]);
  for (const Segment& s : solid.segments) all[1].add(std::array{s.a, s.b}, s.marker);
  for (const TetMesh::Facet& f : solid.facets) all[2].add(f.points, f.marker);
  const std::vector<int> markers = cell_markers(geometry);
  for (std::size_t t = 0; t < solid.tets.size(); ++t) all[3].add(solid.tets[t], markers[t]);
  return all;
}

class GmshWriter {
 public:
  GmshWriter(TextWriter& out, const Geometry& lifted, GmshStyle style)
      : out_(out), geometry_(lifted), style_(style), elements_(gmsh_elements(lifted)) {
    for (const GmshElements& elements : elements_) {
      name_entities(elements);
      marked_ |= std::any_of(elements.markers.begin(), elements.markers.end(),
                             [](int marker) { return marker != 0; });
    }
  }

  void write();

 private:
  bool binary() const { return style_.encoding == GmshEncoding::kBinary; }
  template <class T>
  void number(T value);
  void integer(std::int64_t value) { number(static_cast<std::int32_t>(value)); }
  void wide(std::size_t value) { number(static_cast<std::int64_t>(value)); }
  void place(const Point3& p) { number(p.x), number(p.y), number(p.z); }
  void end_line() { out_ << (binary() ? "" : "\n"); }
  /// Ends what may be binary, so that a keyword can follow on a line of its own.
  void end_data() { out_ << (binary() ? "\n" : ""); }

  void name_entities(const GmshElements& elements);
  int group_of(int dimension, int marker) const;
  std::int64_t entity_of(int dimension, int marker) const {
    return entities_[static_cast<std::size_t>(dimension)].at(marker);
  }
  void write_format();
  void write_names();
  void write_entities();
  void write_entity(int dimension, int marker, std::int64_t tag);
  void write_nodes_2();
  void write_nodes_4();
  void write_elements_2();
  void write_elements_4();
  void write_run_4(const GmshElements& elements, std::size_t begin, std::size_t end);
  std::pair<int, std::int64_t> home_of_nodes() const;

  TextWriter& out_;
  const Geometry& geometry_;
  GmshStyle style_;
  std::array<GmshElements, 4> elements_;
  std::array<std::map<int, std::int64_t>, 4> entities_;  // marker to tag
  bool marked_ = false;                                  // whether an element has a marker
  std::size_t next_element_ = 1;
  std::string bytes_;
};

template <class T>
void GmshWriter::number(T value) {
  if (!binary()) {
    out_ << value << ' ';
    return;
  }
  bytes_.clear();
  append_bytes(bytes_, value);
  out_ << bytes_;
}

// An entity for each marker. Tags must be positive; a positive marker is its own.
void GmshWriter::name_entities(const GmshElements& elements) {
  auto& entities = entities_[static_cast<std::size_t>(elements.dimension)];
  const std::set<int> markers(elements.markers.begin(), elements.markers.end());
  std::int64_t next = markers.empty() ? 1 : std::max<std::int64_t>(0, *markers.rbegin()) + 1;
  for (const int marker : markers) entities[marker] = marker > 0 ? marker : next++;
}

// Where some elements are in a physical group, Gmsh drops those that are in none: then those
// without a marker get one that is called "unmarked".
int GmshWriter::group_of(int dimension, int marker) const {
  if (marker != 0 || !marked_) return marker;
  return static_cast<int>(entity_of(dimension, 0));
}

void GmshWriter::write_format() {
  out_ << "$MeshFormat\n"
       << (style_.version == GmshVersion::k22 ? "2.2 " : "4.1 ") << (binary() ? "1 8\n" : "0 8\n");
  if (binary()) integer(1);
  end_data();
  out_ << "$EndMeshFormat\n";
  if (!geometry_.remark.empty()) out_ << "$Comments\n" << geometry_.remark << "\n$EndComments\n";
}

void GmshWriter::write_names() {
  std::vector<MarkerName> names = geometry_.marker_names;
  for (int dimension = 1; dimension < 4 && marked_; ++dimension)
    if (entities_[static_cast<std::size_t>(dimension)].contains(0))
      names.push_back({dimension, group_of(dimension, 0), std::string(kGmshUnmarked)});
  if (names.empty()) return;
  out_ << "$PhysicalNames\n" << names.size() << '\n';
  for (MarkerName& known : names) {
    std::replace(known.name.begin(), known.name.end(), '"', '\'');
    out_ << known.dimension << ' ' << known.marker << " \"" << known.name << "\"\n";
  }
  out_ << "$EndPhysicalNames\n";
}

void GmshWriter::write_entity(int dimension, int marker, std::int64_t tag) {
  const std::vector<Point3>& points = geometry_.solid.points;
  const Box3 box = points.empty() ? Box3{} : Box3::around(points);
  integer(tag);
  place(box.low);
  if (dimension > 0) place(box.high);
  const int group = group_of(dimension, marker);
  wide(group == 0 ? 0 : 1);
  if (group != 0) integer(group);
  if (dimension > 0) wide(0);
  end_line();
}

// The entity that is said to hold all nodes: one of the highest dimension.
std::pair<int, std::int64_t> GmshWriter::home_of_nodes() const {
  for (int dimension = 3; dimension >= 0; --dimension) {
    const auto& entities = entities_[static_cast<std::size_t>(dimension)];
    if (!entities.empty()) return {dimension, entities.begin()->second};
  }
  return {0, 1};
}

void GmshWriter::write_entities() {
  if (home_of_nodes() == std::pair<int, std::int64_t>(0, 1)) entities_[0].emplace(0, 1);
  out_ << "$Entities\n";
  for (const auto& entities : entities_) wide(entities.size());
  end_line();
  for (int dimension = 0; dimension < 4; ++dimension)
    for (const auto& [marker, tag] : entities_[static_cast<std::size_t>(dimension)])
      write_entity(dimension, marker, tag);
  end_data();
  out_ << "$EndEntities\n";
}

void GmshWriter::write_nodes_2() {
  const auto& points = geometry_.solid.points;
  out_ << "$Nodes\n" << points.size() << '\n';
  for (std::size_t i = 0; i < points.size(); ++i) {
    integer(static_cast<std::int64_t>(i) + 1);
    place(points[i]);
    end_line();
  }
  end_data();
  out_ << "$EndNodes\n";
}

void GmshWriter::write_nodes_4() {
  const auto& points = geometry_.solid.points;
  out_ << "$Nodes\n";
  for (const std::size_t value : {std::size_t{1}, points.size(), std::size_t{1}, points.size()})
    wide(value);
  end_line();
  const auto [dimension, tag] = home_of_nodes();
  integer(dimension), integer(tag), integer(0), wide(points.size());
  end_line();
  for (std::size_t i = 0; i < points.size(); ++i) {
    wide(i + 1);
    end_line();
  }
  for (const Point3& p : points) {
    place(p);
    end_line();
  }
  end_data();
  out_ << "$EndNodes\n";
}

// The elementary tag, which must not be 0, is that of the marker's entity.
void GmshWriter::write_elements_2() {
  std::size_t count = 0;
  for (const GmshElements& elements : elements_) count += elements.size();
  out_ << "$Elements\n" << count << '\n';
  for (const GmshElements& elements : elements_) {
    if (binary() && elements.size() > 0)
      integer(elements.type), integer(static_cast<std::int64_t>(elements.size())), integer(2);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      integer(static_cast<std::int64_t>(next_element_++));
      if (!binary()) integer(elements.type), integer(2);
      integer(group_of(elements.dimension, elements.markers[i]));
      integer(entity_of(elements.dimension, elements.markers[i]));
      for (const Index v : elements.of(i)) integer(std::int64_t{v} + 1);
      end_line();
    }
  }
  end_data();
  out_ << "$EndElements\n";
}

void GmshWriter::write_run_4(const GmshElements& elements, std::size_t begin, std::size_t end) {
  integer(elements.dimension);
  integer(entity_of(elements.dimension, elements.markers[begin]));
  integer(elements.type), wide(end - begin);
  end_line();
  for (std::size_t i = begin; i < end; ++i) {
    wide(next_element_++);
    for (const Index v : elements.of(i)) wide(std::size_t{v} + 1);
    end_line();
  }
}

// A new block begins wherever the marker changes, so that the elements keep their order.
void GmshWriter::write_elements_4() {
  std::size_t count = 0, blocks = 0;
  const auto begins_block = [](const GmshElements& elements, std::size_t i) {
    return i == 0 || elements.markers[i] != elements.markers[i - 1];
  };
  for (const GmshElements& elements : elements_) {
    count += elements.size();
    for (std::size_t i = 0; i < elements.size(); ++i) blocks += begins_block(elements, i) ? 1 : 0;
  }
  out_ << "$Elements\n";
  for (const std::size_t value : {blocks, count, std::size_t{1}, count}) wide(value);
  end_line();
  for (const GmshElements& elements : elements_) {
    for (std::size_t begin = 0, end = 0; begin < elements.size(); begin = end) {
      for (end = begin + 1; end < elements.size() && !begins_block(elements, end);) ++end;
      write_run_4(elements, begin, end);
    }
  }
  end_data();
  out_ << "$EndElements\n";
}

void GmshWriter::write() {
  write_format();
  write_names();
  if (style_.version == GmshVersion::k22) {
    write_nodes_2();
    write_elements_2();
  } else {
    write_entities();
    write_nodes_4();
    write_elements_4();
  }
}

}  // namespace

Status write_gmsh(OutputSet& outputs, const std::string& path, const Geometry& geometry,
                  GmshStyle style) {
  if (Status status = refuse_polygons(geometry, path, "a Gmsh file"); !status) return status;
  const Geometry lifted = lift_to_space(geometry);
  return outputs.add(path, [&](TextWriter& out) { GmshWriter(out, lifted, style).write(); });
}

}  // namespace wellspaced
