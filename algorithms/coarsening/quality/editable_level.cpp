#include "wellspaced/algorithms/coarsening/quality/editable_level.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"
#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using Link = BoundarySelection::Link;

}  // namespace

// ---- Building

EditableLevel::EditableLevel(const TriangleMesh& mesh, const Skeleton& skeleton)
    : points_(mesh.points),
      boundary_(skeleton.boundary),
      corners_(skeleton.corners),
      selection_(skeleton.boundary, mesh.points.size()),
      vertex_(mesh.points.size(), kNoIndex) {}

Result<EditableLevel> EditableLevel::build(const TriangleMesh& mesh, const Skeleton& skeleton,
                                           std::span<const Index> nodes) {
  EditableLevel level(mesh, skeleton);
  NodeSelection choice(static_cast<Index>(mesh.points.size()), skeleton.boundary.twins,
                       [](Index, std::vector<Conflict>&) {});
  choice.force(nodes);
  const ContractedBoundary contracted = contract_and_repair(skeleton.boundary, mesh.points, choice);
  const std::vector<Index> chosen = choice.selected();
  std::vector<Point2> points;
  for (const Index v : chosen) points.push_back(mesh.points[v]);
  auto delaunay = Delaunay2::build(points);
  if (!delaunay) return delaunay.error();
  level.delaunay_ = std::move(*delaunay);
  for (Index i = 0; i < chosen.size(); ++i) {
    level.node_.push_back(chosen[i]);
    level.vertex_[chosen[i]] = level.delaunay_.representative(i);
    if (level.is_on_boundary(chosen[i])) level.selection_.select(chosen[i]);
  }
  level.size_ = chosen.size();
  if (!level.has_triangles()) return level;
  for (const ContractedEdge& edge : contracted.edges()) {
    auto made = level.delaunay_.insert_constraint(level.vertex(edge.a), level.vertex(edge.b));
    if (!made) return made.error();
  }
  return level;
}

std::vector<Index> EditableLevel::nodes() const {
  std::vector<Index> nodes;
  for (Index v = 0; v < vertex_.size(); ++v)
    if (has(v)) nodes.push_back(v);
  return nodes;
}

// Lets a node and its twins be a vertex, or none (kNoIndex).
void EditableLevel::name(Index node, Index vertex) {
  if (vertex != kNoIndex) {
    node_.resize(std::size_t{vertex} + 1, kNoIndex);
    node_[vertex] = node;
  }
  boundary_.twins.for_each(node, [&](Index twin) {
    vertex == kNoIndex ? --size_ : ++size_;
    vertex_[twin] = vertex;
  });
}

// ---- The boundary

// The contracted edges between two vertices: two of them along a slit.
template <class Visit>
void EditableLevel::for_each_link(Wall wall, Visit visit) const {
  boundary_.twins.for_each(node_[wall.a], [&](Index v) {
    for (const std::size_t place : selection_.places_of(v)) {
      const auto leads_to_b = [&](std::size_t other) {
        return vertex_[selection_.node(other)] == wall.b;
      };
      if (selection_.has_next(place) && leads_to_b(selection_.next(place).to))
        visit(selection_.next(place));
      if (selection_.has_previous(place) && leads_to_b(selection_.previous(place).from))
        visit(selection_.previous(place));
    }
  });
}

std::vector<EditableLevel::Wall> EditableLevel::walls() const {
  std::vector<Wall> walls;
  for (std::size_t place = 0; place < selection_.places(); ++place) {
    if (!selection_.is_selected(place) || !selection_.has_next(place)) continue;
    const Index a = vertex_[selection_.node(place)];
    const Index b = vertex_[selection_.node(selection_.next(place).to)];
    if (a != b) walls.push_back({std::min(a, b), std::max(a, b)});
  }
  const auto ends = [](Wall wall) { return std::pair{wall.a, wall.b}; };
  const auto are_same = [&](Wall v, Wall w) { return ends(v) == ends(w); };
  std::ranges::sort(walls, {}, ends);
  walls.erase(std::unique(walls.begin(), walls.end(), are_same), walls.end());
  return walls;
}

std::optional<Index> EditableLevel::middle_of(Wall wall, double least_part) const {
  const Point2 a = delaunay_.points()[wall.a], b = delaunay_.points()[wall.b];
  const double least = least_part * distance(a, b);
  std::optional<Index> middle;
  double longer = 0;
  for_each_link(wall, [&](Link link) {
    selection_.for_each_hidden(link, [&](std::size_t place) {
      const Point2 p = points_[selection_.node(place)];
      const auto [near, far] = std::minmax({distance(p, a), distance(p, b)});
      if (near < least || (middle && far >= longer)) return;
      middle = selection_.node(place);
      longer = far;
    });
  });
  return middle;
}

EditableLevel::Wall EditableLevel::wall_of(Link link) const {
  return {vertex_[selection_.node(link.from)], vertex_[selection_.node(link.to)]};
}

std::optional<EditableLevel::Wall> EditableLevel::wall_over(Index node) const {
  const auto link = selection_.link_over(selection_.places_of(node)[0]);
  return link ? std::optional(wall_of(*link)) : std::nullopt;
}

// The one pair of vertices whose contracted edges hide a node and its twins.
std::optional<EditableLevel::Wall> EditableLevel::single_wall_over(Index node) const {
  const auto wall = wall_over(node);
  if (!wall || wall->a == wall->b) return std::nullopt;
  bool is_single = true;
  boundary_.twins.for_each(node, [&](Index twin) {
    for (const std::size_t place : selection_.places_of(twin)) {
      const auto link = selection_.link_over(place);
      if (!link) {
        is_single = false;
        continue;
      }
      const Wall other = wall_of(*link);
      is_single = is_single && std::minmax(other.a, other.b) == std::minmax(wall->a, wall->b);
    }
  });
  return is_single ? wall : std::nullopt;
}

// ---- Inside and outside

// Whether the domain is on the right of the edge from vertex a to vertex b; nothing if no domain
// curve runs along it.
std::optional<bool> EditableLevel::inside_right_of(Index a, Index b) const {
  std::optional<bool> inside;
  for_each_link({a, b}, [&](Link link) {
    if (!selection_.is_on_domain_curve(link.from)) return;
    const bool is_on_left = vertex_[selection_.node(link.from)] == a;
    inside = inside.value_or(false) || !is_on_left;
  });
  return inside;
}

// Whether the triangle of an edge that leaves a vertex is inside, by the next domain curve around
// the vertex; nothing where the vertex does not tell.
std::optional<bool> EditableLevel::inside_at(Edge corner) const {
  const Triangulation2& topology = delaunay_.topology();
  const Index node = node_[topology.origin(corner)];
  const bool has_triangles = !corners_.at(node).empty();
  if (!is_on_boundary(node)) return has_triangles ? std::optional(true) : std::nullopt;
  Edge e = corner;
  do {
    e = topology.next_around_origin(e);
    if (!topology.is_constrained(e)) continue;
    if (const auto inside = inside_right_of(topology.origin(e), topology.destination(e)))
      return inside;
  } while (e != corner);
  return has_triangles ? std::optional(true) : std::nullopt;
}

bool EditableLevel::is_inside(Index triangle) const {
  const Triangulation2& topology = delaunay_.topology();
  if (topology.is_ghost(triangle)) return false;
  for (const Index v : topology.vertices(triangle))
    if (!is_on_boundary(node_[v]) && !corners_.at(node_[v]).empty()) return true;
  for (unsigned i = 0; i < 3; ++i)
    if (const auto inside = inside_at({triangle, i})) return *inside;
  return false;
}

EditableLevel::Site EditableLevel::site_of(Index node, Index hint) const {
  using Place = Delaunay2::Place;
  const auto [place, edge] = delaunay_.locate(points_[node], hint);
  if (place == Place::kVertex || place == Place::kOutside) return {};
  if (place == Place::kEdge && delaunay_.topology().is_constrained(edge))
    return {Site::Kind::kWall, edge};
  return {is_inside(edge.triangle) ? Site::Kind::kInside : Site::Kind::kNone, edge};
}

// ---- Edits

// Adds the vertex and those around it to what was touched.
void EditableLevel::touch_star(Index vertex) {
  const Triangulation2& topology = delaunay_.topology();
  touched_.push_back(vertex);
  const Edge first = delaunay_.edge_from(vertex);
  Edge e = first;
  do {
    if (topology.destination(e) != Triangulation2::kGhost)
      touched_.push_back(topology.destination(e));
    e = topology.next_around_origin(e);
  } while (e != first);
}

std::vector<Index> EditableLevel::triangles_among(std::span<const Index> vertices) const {
  const Triangulation2& topology = delaunay_.topology();
  std::vector<Index> triangles;
  for (const Index v : vertices) {
    const Edge first = delaunay_.edge_from(v);
    if (first.triangle == kNoIndex) continue;
    Edge e = first;
    do {
      const Index b = topology.destination(e), c = topology.apex(e);
      if (b > v && c > v && std::ranges::binary_search(vertices, b) &&
          std::ranges::binary_search(vertices, c))
        triangles.push_back(e.triangle);
      e = topology.next_around_origin(e);
    } while (e != first);
  }
  return triangles;
}

bool EditableLevel::add_inside(Index node, Index triangle, const Delaunay2::RimTest& accepts) {
  const Index vertex = delaunay_.insert_if(points_[node], triangle, accepts);
  if (vertex == kNoIndex) return false;
  name(node, vertex);
  touched_.clear();
  touch_star(vertex);
  std::ranges::sort(touched_);
  return true;
}

bool EditableLevel::add(Index node, Index hint) {
  if (has(node)) return false;
  if (is_on_boundary(node)) return add_to_boundary(node);
  const Site site = site_of(node, hint);
  return site.kind == Site::Kind::kInside &&
         add_inside(node, site.edge.triangle, [](auto) { return true; });
}

bool EditableLevel::add_to_boundary(Index node) {
  const auto wall = single_wall_over(node);
  if (!wall) return false;
  const Triangulation2& topology = delaunay_.topology();
  const auto [place, edge] = delaunay_.locate(points_[node], delaunay_.edge_from(wall->a).triangle);
  if (place == Delaunay2::Place::kVertex) return false;
  if (place == Delaunay2::Place::kEdge && topology.is_constrained(edge) &&
      std::minmax(topology.origin(edge), topology.destination(edge)) !=
          std::minmax(wall->a, wall->b))
    return false;
  const auto x = delaunay_.insert(points_[node], edge.triangle);
  if (!x) return false;
  touched_.clear();
  if (!bend(*wall, *x)) {
    take_back(*wall, *x);
    return false;
  }
  name(node, *x);
  boundary_.twins.for_each(node, [&](Index twin) { selection_.select(twin); });
  touch_star(*x);
  sort_unique(touched_);
  return true;
}

// Replaces a boundary edge by those from its ends to x, with no vertex between old and new.
bool EditableLevel::bend(Wall wall, Index x) {
  if (!join(wall.a, x) || !join(wall.b, x)) return false;
  const Edge old = delaunay_.find_edge(wall.a, wall.b);
  if (old.triangle == kNoIndex) return true;  // x lay on it
  if (!is_between(wall, x)) return false;
  delaunay_.remove_constraint(old);
  return true;
}

// Makes the edge from an end to x a boundary edge, unless something is in its way.
bool EditableLevel::join(Index end, Index x) {
  const Triangulation2& topology = delaunay_.topology();
  crossed_.clear();
  if (delaunay_.walk_to_next_vertex(end, x, crossed_) != x) return false;
  if (std::ranges::any_of(crossed_, [&](Edge e) { return topology.is_constrained(e); }))
    return false;
  for (const Edge e : crossed_)
    touched_.insert(touched_.end(), {topology.origin(e), topology.destination(e)});
  return delaunay_.insert_constraint(end, x).ok();
}

// Whether x and the edge are the corners of a triangle.
bool EditableLevel::is_between(Wall wall, Index x) const {
  const Triangulation2& topology = delaunay_.topology();
  const Edge e = delaunay_.find_edge(wall.a, wall.b);
  return topology.apex(e) == x || topology.apex(topology.mirror(e)) == x;
}

// Removes x, and restores the boundary edge that it was to split.
void EditableLevel::take_back(Wall wall, Index x) {
  const Triangulation2& topology = delaunay_.topology();
  for (const Index end : {wall.a, wall.b}) {
    const Edge e = delaunay_.find_edge(end, x);
    if (e.triangle != kNoIndex && topology.is_constrained(e)) delaunay_.remove_constraint(e);
  }
  (void)delaunay_.remove(x);
  (void)delaunay_.insert_constraint(wall.a, wall.b);
}

bool EditableLevel::remove(Index node) {
  if (is_on_boundary(node)) return remove_from_boundary(node);
  const Index x = vertex(node);
  touched_.clear();
  touch_star(x);
  touched_.erase(touched_.begin());
  std::ranges::sort(touched_);
  if (!delaunay_.remove(x)) return false;
  name(node, kNoIndex);
  return true;
}

bool EditableLevel::remove_from_boundary(Index node) {
  const Index x = vertex(node);
  boundary_.twins.for_each(node, [&](Index twin) { selection_.unselect(twin); });
  touched_.clear();
  const auto wall = single_wall_over(node);
  if (wall && straighten(*wall, x)) {
    name(node, kNoIndex);
    sort_unique(touched_);
    return true;
  }
  boundary_.twins.for_each(node, [&](Index twin) { selection_.select(twin); });
  return false;
}

// Replaces the boundary edges from the ends of a new one to x by it, and removes x.
bool EditableLevel::straighten(Wall wall, Index x) {
  const auto& points = delaunay_.points();
  const bool is_straight = orient2d(points[wall.a], points[wall.b], points[x]) == 0;
  if (!is_straight) {
    const Edge known = delaunay_.find_edge(wall.a, wall.b);
    if (known.triangle != kNoIndex && delaunay_.topology().is_constrained(known)) return false;
    if (!join(wall.a, wall.b)) return false;
    if (!is_between(wall, x)) {
      delaunay_.remove_constraint(delaunay_.find_edge(wall.a, wall.b));
      return false;
    }
  }
  touch_star(x);
  std::erase(touched_, x);
  for (const Index end : {wall.a, wall.b}) delaunay_.remove_constraint(delaunay_.find_edge(end, x));
  if (!delaunay_.remove(x)) return false;
  return !is_straight || delaunay_.insert_constraint(wall.a, wall.b).ok();
}

}  // namespace wellspaced
