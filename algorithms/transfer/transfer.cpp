#include "wellspaced/algorithms/transfer/transfer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "wellspaced/algorithms/mesh/triangle_links.hpp"
#include "wellspaced/kernel/corner_table.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/local_search.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

constexpr double kFarthestDetour = 2;  // a path to a node may be so many times the straight way

// Weights of coarse nodes, up to 3, ascending by node, which add up to 1.
struct Stencil {
  std::array<double, 3> weights{};
  std::array<Index, 3> nodes{};
  unsigned size = 0;

  // A weight of 0 is no entry.
  void add(Index node, double weight) {
    if (!(weight > 0)) return;
    unsigned i = size++;
    for (; i > 0 && nodes[i - 1] > node; --i) {
      nodes[i] = nodes[i - 1];
      weights[i] = weights[i - 1];
    }
    nodes[i] = node;
    weights[i] = weight;
  }
  // Makes the weights add up to 1, the largest taking up what rounding leaves.
  void normalize() {
    double sum = 0, rest = 1;
    unsigned largest = 0;
    for (unsigned i = 0; i < size; ++i) {
      sum += weights[i];
      if (weights[i] > weights[largest]) largest = i;
    }
    for (unsigned i = 0; i < size; ++i) {
      weights[i] /= sum;
      if (i != largest) rest -= weights[i];
    }
    weights[largest] = rest;
  }
};

Stencil single(Index node) {
  Stencil stencil;
  stencil.add(node, 1);
  return stencil;
}

// Where a stretch of a line, from 0 to 1, comes nearest to p.
double nearest_parameter(Point2 a, Point2 b, Point2 p) {
  const double length = distance(a, b);
  if (!(length > 0)) return 0;
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
  return std::clamp(((p.x - a.x) / length) * ux + ((p.y - a.y) / length) * uy, 0.0, 1.0);
}

Point2 point_between(Point2 a, Point2 b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// The place on an edge of the coarser mesh that is nearest to a point.
struct EdgePlace {
  Index a = kNoIndex, b = kNoIndex;
  double t = 0;
  double distance = std::numeric_limits<double>::infinity();
};

// The coarser mesh, made ready for walking.
class CoarseMesh {
 public:
  explicit CoarseMesh(const TriangleMesh& mesh)
      : mesh_(mesh),
        links_(mesh.triangles, static_cast<Index>(mesh.points.size())),
        visited_(mesh.triangles.size(), 0) {}

  /// A triangle at a node, kNoIndex if there is none.
  Index triangle_at(Index node) const {
    const auto around = links_.around(node);
    return around.empty() ? kNoIndex : around[0];
  }

  /// Walks from a triangle towards p, to the one that contains it or to where the way ends.
  Index walk(Index triangle, Point2 p) const {
    for (int steps = 0; steps < kMostSteps; ++steps) {
      const Index next = step(triangle, p);
      if (next == kNoIndex) break;
      triangle = next;
    }
    return triangle;
  }

  bool contains(Index triangle, Point2 p) const {
    for (unsigned i = 0; i < 3; ++i)
      if (side(triangle, i, p) < 0) return false;
    return true;
  }

  /// The triangle about p that is joined to the given one by triangles no more than twice as far
  /// from p as it is, kNoIndex if there is none. nearest: then the place nearest to p on a boundary
  /// edge of these.
  Index flood(Index triangle, Point2 p, EdgePlace& nearest) {
    const double reach = 2 * distance_to(triangle, p);
    ++flood_;
    front_.assign(1, triangle);
    visited_[triangle] = flood_;
    for (std::size_t next = 0; next < front_.size(); ++next) {
      const Index t = front_[next];
      if (contains(t, p)) return t;
      for (unsigned i = 0; i < 3; ++i) {
        const Index other = links_.neighbor(t, i);
        if (other == kNoIndex) {
          keep_nearer(t, i, p, nearest);
        } else if (visited_[other] != flood_ && distance_to(other, p) <= reach) {
          visited_[other] = flood_;
          front_.push_back(other);
        }
      }
    }
    return kNoIndex;
  }

  /// The boundary edge of a triangle that p lies on, the triangle on its left: its corners, or
  /// kNoIndex.
  std::array<Index, 2> boundary_edge_at(Index triangle, Point2 p) const {
    const auto& corners = mesh_.triangles[triangle];
    for (unsigned i = 0; i < 3; ++i)
      if (links_.neighbor(triangle, i) == kNoIndex && side(triangle, i, p) == 0)
        return {corners[(i + 1) % 3], corners[(i + 2) % 3]};
    return {kNoIndex, kNoIndex};
  }

  /// The barycentric weights of p. Requires: the triangle contains p.
  Stencil stencil(Index triangle, Point2 p) const {
    Stencil result;
    for (unsigned i = 0; i < 3; ++i)
      if (side(triangle, i, p) > 0) result.add(mesh_.triangles[triangle][i], area(triangle, i, p));
    if (result.size == 0) return single(nearest_corner(triangle, p));
    result.normalize();
    return result;
  }

  Stencil stencil(const EdgePlace& place) const {
    Stencil result;
    result.add(place.a, 1 - place.t);
    result.add(place.b, place.t);
    if (result.size == 0) return single(place.a);
    result.normalize();
    return result;
  }

  EdgePlace place_on_edge(Index a, Index b, Point2 p) const {
    const double t = nearest_parameter(point(a), point(b), p);
    return {a, b, t, distance(p, point_between(point(a), point(b), t))};
  }

  Point2 point(Index v) const { return mesh_.points[v]; }

 private:
  static constexpr int kMostSteps = 1000;  // then flood() has to find it

  Point2 corner(Index triangle, unsigned i) const {
    return point(mesh_.triangles[triangle][i % 3]);
  }
  int side(Index triangle, unsigned i, Point2 p) const {
    return orient2d(corner(triangle, i + 1), corner(triangle, i + 2), p);
  }
  Index step(Index triangle, Point2 p) const {
    for (unsigned i = 0; i < 3; ++i) {
      const Index next = links_.neighbor(triangle, i);
      if (next != kNoIndex && side(triangle, i, p) < 0) return next;
    }
    return kNoIndex;
  }
  double distance_to(Index triangle, Point2 p) const {
    if (contains(triangle, p)) return 0;
    EdgePlace nearest;
    for (unsigned i = 0; i < 3; ++i) keep_nearer(triangle, i, p, nearest);
    return nearest.distance;
  }
  void keep_nearer(Index triangle, unsigned i, Point2 p, EdgePlace& nearest) const {
    const auto& corners = mesh_.triangles[triangle];
    const EdgePlace place = place_on_edge(corners[(i + 1) % 3], corners[(i + 2) % 3], p);
    if (place.distance < nearest.distance) nearest = place;
  }
  // Twice the area of the triangle with p in place of corner i, in squares of its extent.
  double area(Index triangle, unsigned i, Point2 p) const {
    const double unit = extent(triangle);
    const Point2 a = corner(triangle, i + 1), b = corner(triangle, i + 2);
    const double ax = (a.x - p.x) / unit, ay = (a.y - p.y) / unit;
    const double bx = (b.x - p.x) / unit, by = (b.y - p.y) / unit;
    return ax * by - ay * bx;
  }
  double extent(Index triangle) const {
    const Point2 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.x - c.x),
                     std::fabs(a.y - c.y), std::fabs(b.x - c.x), std::fabs(b.y - c.y)});
  }
  Index nearest_corner(Index triangle, Point2 p) const {
    const auto& corners = mesh_.triangles[triangle];
    return *std::min_element(corners.begin(), corners.end(), [&](Index v, Index w) {
      return compare_distances(p, point(v), point(w)) < 0;
    });
  }

  const TriangleMesh& mesh_;
  TriangleLinks links_;
  std::vector<Index> visited_;  // the number of the flood that came by
  std::vector<Index> front_;
  Index flood_ = 0;
};

// Whether graph paths between nodes of a mesh are not much longer than the straight way.
class Detours {
 public:
  Detours(const Graph& graph, std::span<const Point2> points) : graph_(graph), points_(points) {}

  bool are_near(Index from, Index to) {
    for (const Graph::Arc& arc : graph_.arcs_of(from))
      if (arc.target == to) return true;
    const double limit = kFarthestDetour * distance(points_[from], points_[to]);
    return finds_greedily(from, to, limit) || finds(from, to, limit);
  }

 private:
  // Most pairs are joined by a path that goes on, of the neighbours that are nearer to its end, to
  // that of the shortest way ahead.
  bool finds_greedily(Index from, Index to, double limit) const {
    double length = 0, left = distance(points_[from], points_[to]);
    for (Index at = from; at != to;) {
      double shortest = std::numeric_limits<double>::infinity(), left_then = left;
      const Graph::Arc* next = nullptr;
      for (const Graph::Arc& arc : graph_.arcs_of(at)) {
        const double rest = distance(points_[arc.target], points_[to]);
        if (!(rest < left) || !(arc.length + rest < shortest)) continue;
        shortest = arc.length + rest;
        left_then = rest;
        next = &arc;
      }
      if (next == nullptr || length + shortest > limit) return false;
      length += next->length;
      left = left_then;
      at = next->target;
    }
    return true;
  }
  bool finds(Index from, Index to, double limit) {
    if (!search_) search_.emplace(graph_);
    bool found = false;
    search_->run(std::array{from}, [&](Index v, double d) {
      if (found || d + distance(points_[v], points_[to]) > limit) return false;
      found = v == to;
      return true;
    });
    return found;
  }

  const Graph& graph_;
  std::span<const Point2> points_;
  std::optional<LocalSearch> search_;  // few need it
};

class TransferBuilder {
 public:
  TransferBuilder(const Level& finer, const Level& coarser, const Progress& progress)
      : finer_(finer.mesh),
        coarser_(coarser),
        corners_(corner_table(finer.mesh.triangles, static_cast<Index>(finer.mesh.points.size()))),
        graph_(mesh_graph(finer.mesh.points, corners_, finer.mesh.segments)),
        coarse_(coarser.mesh),
        detours_(graph_, finer.mesh.points),
        starts_(finer.mesh.points.size()),
        stencils_(finer.mesh.points.size()),
        meter_(progress, "transfer", finer.mesh.points.size(), 1 << 12) {}

  Result<Transfer> build() {
    keep_nodes();
    // In the order of memory; what is found behind it waits.
    for (Index v = 0; v < starts_.size() && !meter_.stopped(); ++v)
      if (starts_[v].node != kNoIndex) spread_from(v, v);
    for (std::size_t next = 0; next < waiting_.size() && !meter_.stopped(); ++next)
      spread_from(waiting_[next], static_cast<Index>(starts_.size()));
    if (meter_.stopped()) return cancelled();
    const auto unreached = std::ranges::find(starts_, kNoIndex, &Start::node);
    if (unreached != starts_.end()) return unreached_node(unreached - starts_.begin());
    assemble();
    return std::move(result_);
  }

 private:
  // Where to look for a node: a triangle of the coarser mesh near it, and a coarse node.
  struct Start {
    Index triangle = kNoIndex;
    Index node = kNoIndex;
  };

  static Error unreached_node(std::ptrdiff_t v) {
    return {ErrorCode::kInvalidGeometry,
            {"node ", v, " is joined to no node of the coarser level"},
            {static_cast<Index>(v)}};
  }

  void keep_nodes() {
    for (Index c = 0; c < coarser_.parent.size(); ++c) {
      const Index v = coarser_.parent[c];
      starts_[v] = {coarse_.triangle_at(c), c};
      stencils_[v] = single(c);
    }
  }

  // Neighbours not found yet start where v was found. Those below `end` wait to be spread from.
  void spread_from(Index v, Index end) {
    for (const Graph::Arc& arc : graph_.arcs_of(v)) {
      if (starts_[arc.target].node != kNoIndex) continue;
      starts_[arc.target] = starts_[v];
      interpolate(arc.target);
      if (!meter_.step()) return;
      if (arc.target < end) waiting_.push_back(arc.target);
    }
  }

  void interpolate(Index v) {
    const Point2 p = finer_.points[v];
    Start& start = starts_[v];
    if (start.triangle == kNoIndex) {
      displace(v, single(start.node));
      return;
    }
    EdgePlace nearest;
    Index triangle = locate(start.triangle, p, nearest);
    if (triangle != kNoIndex && is_across(triangle, v)) {
      start.triangle = triangle_beside(v, triangle);
      triangle = locate(start.triangle, p, nearest);
    }
    if (triangle == kNoIndex) {
      displace(v, nearest.a == kNoIndex ? single(start.node)
                                        : without_detours(v, coarse_.stencil(nearest)));
      return;
    }
    start.triangle = triangle;
    const Stencil found = coarse_.stencil(triangle, p), near = without_detours(v, found);
    if (near.size == found.size)
      stencils_[v] = found;
    else
      displace(v, near);
  }

  // The triangle about p near a given one, or kNoIndex and the nearest place on a boundary edge.
  Index locate(Index start, Point2 p, EdgePlace& nearest) {
    const Index triangle = coarse_.walk(start, p);
    return coarse_.contains(triangle, p) ? triangle : coarse_.flood(triangle, p, nearest);
  }

  // Whether v, on the boundary edge of a triangle, belongs to the other side of it: the other lip
  // of a slit.
  bool is_across(Index triangle, Index v) const {
    const auto edge = coarse_.boundary_edge_at(triangle, finer_.points[v]);
    if (edge[0] == kNoIndex) return false;
    return std::ranges::none_of(graph_.arcs_of(v), [&](const Graph::Arc& arc) {
      return orient2d(coarse_.point(edge[0]), coarse_.point(edge[1]), finer_.points[arc.target]) >
             0;
    });
  }

  // A coarser triangle at the middle of one of the finer triangles around v; `otherwise` if there
  // is none.
  Index triangle_beside(Index v, Index otherwise) {
    if (corners_.at(v).empty()) return otherwise;
    const auto [next, previous] = corners_.at(v)[0];
    const Point2 middle = point_between(finer_.points[next], finer_.points[previous], 0.5);
    EdgePlace nearest;
    const Index found =
        locate(otherwise, point_between(finer_.points[v], middle, 2.0 / 3), nearest);
    return found == kNoIndex ? otherwise : found;
  }

  // What is left of a stencil without the nodes that are far from v through the mesh.
  Stencil without_detours(Index v, const Stencil& stencil) {
    std::array<Index, 3> left{};
    unsigned size = 0;
    for (unsigned i = 0; i < stencil.size; ++i)
      if (detours_.are_near(v, coarser_.parent[stencil.nodes[i]])) left[size++] = stencil.nodes[i];
    if (size == stencil.size) return stencil;
    if (size == 2)
      return coarse_.stencil(coarse_.place_on_edge(left[0], left[1], finer_.points[v]));
    return single(size == 1 ? left[0] : starts_[v].node);
  }

  void displace(Index v, const Stencil& stencil) {
    stencils_[v] = stencil;
    Point2 place{0, 0};
    for (unsigned i = 0; i < stencil.size; ++i) {
      place.x += stencil.weights[i] * coarse_.point(stencil.nodes[i]).x;
      place.y += stencil.weights[i] * coarse_.point(stencil.nodes[i]).y;
    }
    result_.displaced.push_back({v, distance(finer_.points[v], place)});
  }

  void assemble() {
    SparseMatrix& matrix = result_.prolongation;
    matrix.columns = static_cast<Index>(coarser_.parent.size());
    std::size_t entries = 0;
    for (const Stencil& stencil : stencils_) entries += stencil.size;
    matrix.first.reserve(stencils_.size() + 1);
    matrix.column.reserve(entries);
    matrix.value.reserve(entries);
    for (const Stencil& stencil : stencils_) {
      for (unsigned i = 0; i < stencil.size; ++i) {
        matrix.column.push_back(stencil.nodes[i]);
        matrix.value.push_back(stencil.weights[i]);
      }
      matrix.end_row();
    }
    std::ranges::sort(result_.displaced, {}, &DisplacedNode::node);
  }

  const TriangleMesh& finer_;
  const Level& coarser_;
  CornerTable corners_;
  Graph graph_;
  CoarseMesh coarse_;
  Detours detours_;
  std::vector<Start> starts_;      // one a node of the finer mesh
  std::vector<Stencil> stencils_;  // likewise
  std::vector<Index> waiting_;
  ProgressMeter meter_;
  Transfer result_;
};

}  // namespace

Result<Transfer> transfer_between(const Level& finer, const Level& coarser,
                                  const Progress& progress) {
  if (std::ranges::find(coarser.parent, kNoIndex) != coarser.parent.end())
    return Error{ErrorCode::kUsage,
                 "there are no transfers between levels that are not nested (from-finest)",
                 {}};
  if (!report(progress, "transfer", 0, finer.mesh.points.size())) return cancelled();
  return TransferBuilder(finer, coarser, progress).build();
}

Result<std::vector<Transfer>> transfers_of(const Hierarchy& hierarchy, const Progress& progress) {
  const std::vector<Level>& levels = hierarchy.levels;
  std::vector<Transfer> transfers;
  ProgressParts parts(progress, "transfer", levels.size() - 1);
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    auto transfer = transfer_between(levels[k], levels[k + 1], parts.part(k));
    if (!transfer) return transfer.error();
    transfers.push_back(std::move(*transfer));
  }
  return transfers;
}

}  // namespace wellspaced
