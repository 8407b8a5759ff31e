#include "wellspaced/algorithms/coarsening/quality/refinement.hpp"

#include <cmath>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// A boundary edge is as coarse as a triangle whose circumradius is this part of its length: between
// that of an equilateral triangle on it, 0.58, and half its length.
constexpr double kRadiusOfWall = 0.6;

// A node stands in for a circumcentre within this part of the circumradius.
constexpr double kReach = 0.6;

// A node that mends an angle keeps from others this part of the shortest side of the triangle.
constexpr double kKeepOff = 0.7;

// A node is too near to a boundary edge inside its diametral circle and nearer than this part of
// its length: then the edge is split instead.
constexpr double kLens = 0.3;

// Pieces of a boundary edge have at least this part of its length.
constexpr double kLeastPiece = 0.25;

constexpr double kVariation = 0.05;

constexpr std::size_t kCandidatesBetweenCalls = 4096;

// Far more than a walk to the circumcentre of a triangle takes.
constexpr int kMostWalkSteps = 1000;

bool is_in_lens(Point2 p, Point2 a, Point2 b) {
  const double toward = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
  const double off = std::fabs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
  return toward < 0 && off < kLens * squared_distance(a, b);
}

}  // namespace

Index nearest_along_edges(const Graph& graph, std::span<const Point2> points, Index start,
                          Point2 place) {
  Index nearest = start;
  double least = squared_distance(points[start], place);
  for (Index before = kNoIndex; before != nearest;) {
    before = nearest;
    for (const Graph::Arc& arc : graph.arcs_of(before)) {
      const double d = squared_distance(points[arc.target], place);
      if (d < least) least = d, nearest = arc.target;
    }
  }
  return nearest;
}

Refinement::Refinement(const Graph& graph, EditableLevel& level, const RefinementGoals& goals)
    : graph_(graph), level_(level), goals_(goals) {
  const Triangulation2& topology = level_.triangulation().topology();
  for (Index t = 0; t < topology.size(); ++t) note_triangle(t);
  for (const EditableLevel::Wall wall : level_.walls()) note_wall(wall);
}

void Refinement::grow(std::size_t nodes, const KeepGoing& keep_going) {
  work_off(coarse_, Reason::kSize, nodes, keep_going);
}

void Refinement::mend(std::size_t nodes, const KeepGoing& keep_going) {
  work_off(thin_, Reason::kAngle, nodes, keep_going);
}

void Refinement::work_off(Queue& queue, Reason reason, std::size_t nodes,
                          const KeepGoing& keep_going) {
  for (std::size_t i = 0; level_.size() < nodes && !queue.empty(); ++i) {
    if (i % kCandidatesBetweenCalls == 0 && !keep_going()) return;
    const Candidate candidate = queue.top();
    queue.pop();
    if (is_there(candidate)) attend(candidate, reason);
  }
}

// ---- What there is to do

double Refinement::urgency(double radius, double spacing, Index node) const {
  const double variation = Random(goals_.seed ^ splitmix64(node)).uniform(1 - kVariation, 1);
  return radius / spacing * variation;
}

double Refinement::mean_spacing(std::span<const Index> vertices) const {
  double sum = 0;
  for (const Index v : vertices) sum += 1 / goals_.spacing[level_.node(v)];
  return static_cast<double>(vertices.size()) / sum;
}

// The node that the walks from the corners of a triangle to a place end at. From the boundary they
// may be led astray, by a slit to its other side: then all are tried.
Index Refinement::nearest_node(std::span<const Index> vertices, Point2 place) const {
  const auto walk_from = [&](Index node) {
    return nearest_along_edges(graph_, level_.finest_points(), node, place);
  };
  for (const Index v : vertices)
    if (!level_.is_on_boundary(level_.node(v))) return walk_from(level_.node(v));
  Index nearest = level_.node(vertices[0]);
  for (const Index v : vertices) {
    level_.for_each_twin(level_.node(v), [&](Index twin) {
      const Index end = walk_from(twin);
      if (squared_distance(level_.point(end), place) <
          squared_distance(level_.point(nearest), place))
        nearest = end;
    });
  }
  return nearest;
}

void Refinement::note_triangle(Index triangle) {
  if (!level_.is_inside(triangle)) return;
  const auto& vertices = level_.triangulation().topology().vertices(triangle);
  const TriangleShape shape = shape_of(level_.triangulation(), vertices);
  if (!std::isfinite(shape.circle.radius_sq)) return;
  const Index node = nearest_node(vertices, shape.circle.centre);
  const double spacing = std::min(goals_.spacing[node], mean_spacing(vertices));
  coarse_.push(
      {urgency(std::sqrt(shape.circle.radius_sq), spacing, node), node, triangle, vertices});
  const double sine_sq = shape.sine_sq();
  if (sine_sq < goals_.least_sine_sq) thin_.push({-sine_sq, node, triangle, vertices});
}

void Refinement::note_wall(EditableLevel::Wall wall) {
  const auto middle = level_.middle_of(wall, kLeastPiece);
  if (!middle) return;
  const auto& points = level_.triangulation().points();
  const double radius = kRadiusOfWall * distance(points[wall.a], points[wall.b]);
  const double spacing =
      std::min(goals_.spacing[*middle], mean_spacing(std::array{wall.a, wall.b}));
  coarse_.push({urgency(radius, spacing, *middle), *middle, kNoIndex, {wall.a, wall.b, 0}});
}

// Takes note of what the last edit made.
void Refinement::note_touched() {
  for (const Index t : level_.triangles_among(level_.touched())) note_triangle(t);
}

bool Refinement::is_there(const Candidate& candidate) const {
  const Triangulation2& topology = level_.triangulation().topology();
  if (candidate.triangle == kNoIndex) return !level_.has(candidate.node);
  return candidate.triangle < topology.size() &&
         topology.vertices(candidate.triangle) == candidate.vertices;
}

// ---- Doing it

void Refinement::attend(const Candidate& candidate, Reason reason) {
  if (candidate.triangle != kNoIndex) return attend_triangle(candidate, reason);
  split({candidate.vertices[0], candidate.vertices[1]});
}

void Refinement::attend_triangle(const Candidate& candidate, Reason reason) {
  const auto [circle, shortest_sq] = shape_of(level_.triangulation(), candidate.vertices);
  const Index node = candidate.node;
  const double reach = level_.is_on_boundary(node) ? 1 : kReach;
  const bool is_near =
      squared_distance(level_.point(node), circle.centre) <= reach * reach * circle.radius_sq;
  if (!is_near || level_.has(node)) {
    split_towards(circle.centre, candidate.triangle);
    return;
  }
  if (level_.is_on_boundary(node)) {
    const auto wall = level_.wall_over(node);
    if (!wall || !split(*wall)) split_towards(circle.centre, candidate.triangle);
    return;
  }
  const EditableLevel::Site site = level_.site_of(node, candidate.triangle);
  const Triangulation2& topology = level_.triangulation().topology();
  if (site.kind == EditableLevel::Site::Kind::kNone)
    split_towards(circle.centre, candidate.triangle);
  else if (site.kind == EditableLevel::Site::Kind::kWall)
    split({topology.origin(site.edge), topology.destination(site.edge)});
  else
    insert_at(candidate, site, reason == Reason::kAngle ? kKeepOff * kKeepOff * shortest_sq : 0);
}

// Adds the node unless another is nearer than allowed. A boundary edge that it would come too close
// to is split in its stead.
void Refinement::insert_at(const Candidate& candidate, const EditableLevel::Site& site,
                           double keep_off_sq) {
  const Point2 p = level_.point(candidate.node);
  const auto& points = level_.triangulation().points();
  std::optional<EditableLevel::Wall> approached;
  const auto accepts = [&](std::span<const Triangulation2::RimEdge> rim) {
    bool is_clear = true;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Index a = rim[i].origin, b = rim[i + 1 < rim.size() ? i + 1 : 0].origin;
      if (a == Triangulation2::kGhost || b == Triangulation2::kGhost) continue;
      is_clear = is_clear && squared_distance(points[a], p) >= keep_off_sq;
      if (Triangulation2::is_constrained_rim(rim[i]) && is_in_lens(p, points[a], points[b]))
        approached = {a, b};
    }
    return is_clear && !approached;
  };
  if (level_.add_inside(candidate.node, site.edge.triangle, accepts)) note_touched();
  if (approached) split(*approached);
}

bool Refinement::split(EditableLevel::Wall wall) {
  const auto middle = level_.middle_of(wall, kLeastPiece);
  if (!middle || !level_.add(*middle, 0)) return false;
  note_touched();
  note_wall({wall.a, level_.vertex(*middle)});
  note_wall({level_.vertex(*middle), wall.b});
  return true;
}

// Splits the boundary edge that hides a place from a triangle.
bool Refinement::split_towards(Point2 place, Index triangle) {
  const auto wall = first_wall_towards(place, triangle);
  return wall && split(*wall);
}

// A visibility walk: it takes each triangle's first edge with the place beyond it.
std::optional<EditableLevel::Wall> Refinement::first_wall_towards(Point2 place,
                                                                  Index triangle) const {
  const Triangulation2& topology = level_.triangulation().topology();
  const auto& points = level_.triangulation().points();
  for (int step = 0; step < kMostWalkSteps && !topology.is_ghost(triangle); ++step) {
    unsigned i = 0;
    for (; i < 3; ++i) {
      const Triangulation2::Edge e{triangle, i};
      if (orient2d(points[topology.origin(e)], points[topology.destination(e)], place) >= 0)
        continue;
      if (topology.is_constrained(e))
        return EditableLevel::Wall{topology.origin(e), topology.destination(e)};
      break;
    }
    if (i == 3) return std::nullopt;
    triangle = topology.neighbor(triangle, i);
  }
  return std::nullopt;
}

}  // namespace wellspaced
