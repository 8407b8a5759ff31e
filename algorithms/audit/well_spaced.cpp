#include "wellspaced/algorithms/audit/well_spaced.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/circumcentre.hpp"
#include "wellspaced/algorithms/audit/domain.hpp"
#include "wellspaced/algorithms/audit/gaps.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/algorithms/audit/tet_topology.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced::audit {
namespace {

constexpr double kRounding = 1 + 0x1p-48;

// ---- The places of the nodes

// place_of: for each node its place. node_at: for each place the lowest node there.
template <std::size_t D>
struct Places {
  std::vector<Vec<D>> at;
  std::vector<Index> place_of, node_at;
};

template <std::size_t D, class Point>
Places<D> places_of(std::span<const Point> points, double scale) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order, [&](Index v, Index w) { return before(points[v], points[w]); });
  Places<D> places;
  places.place_of.resize(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index v = order[i];
    if (i == 0 || points[order[i - 1]] != points[v]) {
      places.node_at.push_back(v);
      places.at.push_back(step(Vec<D>{}, scale, coordinates_of(points[v])));
    }
    places.place_of[v] = static_cast<Index>(places.node_at.size() - 1);
  }
  return places;
}

// ---- The boundary

// Simplices at one place are one: the two lips of a slit, which the domain lies on both sides of.
template <std::size_t D>
std::vector<BoundarySimplex<D>> united(std::vector<BoundarySimplex<D>> all) {
  for (auto& simplex : all) sort(simplex.nodes);
  sort(all, [](const auto& a, const auto& b) { return a.nodes < b.nodes; });
  std::vector<BoundarySimplex<D>> result;
  for (const auto& simplex : all) {
    if (result.empty() || result.back().nodes != simplex.nodes) {
      result.push_back(simplex);
    } else {
      result.back().closed = result.back().closed != simplex.closed;
    }
  }
  return result;
}

std::vector<BoundarySimplex<2>> boundary_of(const TriangleMesh& mesh, const Places<2>& places) {
  const HalfEdges half_edges =
      pair_half_edges(mesh.triangles, mesh.segments, static_cast<Index>(mesh.points.size()));
  std::vector<BoundarySimplex<2>> simplices;
  for (Index h = 0; h < half_edges.twin.size(); ++h) {
    const Index twin = half_edges.twin[h];
    const bool inner = twin != kNoIndex;
    if (inner && (half_edges.constrained[h] == 0 || twin < h)) continue;
    simplices.push_back(
        {{places.place_of[origin(mesh.triangles, h)], places.place_of[target(mesh.triangles, h)]},
         !inner,
         places.place_of[apex(mesh.triangles, h)]});
  }
  return united(std::move(simplices));
}

std::vector<BoundarySimplex<3>> boundary_of(const TetMesh& mesh, const Places<3>& places) {
  const TetFaces faces =
      pair_tet_faces(mesh.tets, mesh.facets, static_cast<Index>(mesh.points.size()));
  std::vector<BoundarySimplex<3>> simplices;
  for (Index f = 0; f < faces.twin.size(); ++f) {
    const Index twin = faces.twin[f];
    const bool inner = twin != kNoIndex;
    if (inner && (faces.constrained[f] == 0 || twin < f)) continue;
    Face nodes = face_nodes(mesh.tets, f);
    for (Index& v : nodes) v = places.place_of[v];
    simplices.push_back({nodes, !inner, places.place_of[face_apex(mesh.tets, f)]});
  }
  return united(std::move(simplices));
}

using Edges = std::vector<std::array<Index, 2>>;

Edges segments_of(const TriangleMesh&, const Places<2>&, const BoundaryPieces<2>& boundary) {
  Edges edges;
  for (Index s = 0; s < boundary.size(); ++s) edges.push_back(boundary.nodes(s));
  return edges;
}

// The segments given, and the edges where faces of the domain meet.
Edges segments_of(const TetMesh& mesh, const Places<3>& places, const BoundaryPieces<3>& boundary) {
  std::vector<std::array<Index, 3>> sides;  // two nodes, a piece
  for (Index s = 0; s < boundary.size(); ++s)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = boundary.nodes(s)[i], b = boundary.nodes(s)[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), boundary.piece(s)});
    }
  sort_unique(sides);
  Edges edges;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i][0] == sides[i - 1][0] && sides[i][1] == sides[i - 1][1])
      edges.push_back({sides[i][0], sides[i][1]});
  for (const Segment& s : mesh.segments) {
    const Index a = places.place_of[s.a], b = places.place_of[s.b];
    edges.push_back({std::min(a, b), std::max(a, b)});
  }
  sort_unique(edges);
  return edges;
}

// ---- The triangulation in which gaps are sought

// All points and their Delaunay triangulation as a mesh; without elements where they have no area.
TriangleMesh delaunay_mesh(const Places<2>& places, const Progress& progress) {
  TriangleMesh mesh;
  for (const Vec<2>& p : places.at) mesh.points.push_back(point_at(p));
  const auto delaunay = Delaunay2::build(mesh.points, {.progress = progress});
  if (!delaunay) return mesh;
  const Triangulation2& topology = delaunay->topology();
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) mesh.triangles.push_back(topology.vertices(t));
  return mesh;
}

TetMesh delaunay_mesh(const Places<3>& places, const Progress& progress) {
  TetMesh mesh;
  for (const Vec<3>& p : places.at) mesh.points.push_back(point_at(p));
  const auto delaunay = Delaunay3::build(mesh.points, {.progress = progress});
  if (!delaunay) return mesh;
  const Triangulation3& topology = delaunay->topology();
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) mesh.tets.push_back(topology.vertices(t));
  return mesh;
}

// Whether an embedded mesh is the Delaunay triangulation of all its points: locally Delaunay, and
// its boundary convex.
bool is_delaunay(const TriangleMesh& mesh, const Progress& progress) {
  const Report report = audit_mesh(mesh, {.progress = progress});
  if (!report.complete) return false;
  const HalfEdges half_edges =
      pair_half_edges(mesh.triangles, {}, static_cast<Index>(mesh.points.size()));
  return report.pass() && report.check("delaunay")->pass() &&
         report.check("no_unused_node")->pass() && has_convex_boundary(mesh, half_edges);
}

// Whether no two boundary faces that share an edge meet at a reentrant angle.
bool is_convex_along_edges(const TetMesh& mesh) {
  const TetFaces faces = pair_tet_faces(mesh.tets, {}, static_cast<Index>(mesh.points.size()));
  struct Side {
    Index low, high;
    Face face;
    Index far;
  };
  std::vector<Side> sides;
  for (const auto& t : boundary_surface(mesh, faces).triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, t[(i + 2) % 3]});
    }
  sort(sides, [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.far) < std::tie(b.low, b.high, b.far);
  });
  const auto& p = mesh.points;
  for (std::size_t i = 1; i < sides.size(); i += 2) {
    const auto& [a, b, c] = sides[i].face;
    if (sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high) return false;
    if (orient3d(p[a], p[b], p[c], p[sides[i - 1].far]) < 0) return false;
  }
  return sides.size() % 2 == 0;
}

bool is_delaunay(const TetMesh& mesh, const Progress& progress) {
  const Report report = audit_tet_mesh(mesh, {.progress = progress});
  return report.pass() && report.check("delaunay")->pass() &&
         report.check("no_unused_node")->pass() &&
         report.measure("boundary_components")->value == 1 && is_convex_along_edges(mesh);
}

const std::vector<std::array<Index, 3>>& cells_of(const TriangleMesh& mesh) {
  return mesh.triangles;
}
const std::vector<std::array<Index, 4>>& cells_of(const TetMesh& mesh) { return mesh.tets; }

double volume_of(const std::array<Vec<2>, 3>& t) {
  const Vec<2> u = difference(t[1], t[0]), v = difference(t[2], t[0]);
  return std::fabs(u[0] * v[1] - u[1] * v[0]) / 2;
}
double volume_of(const std::array<Vec<3>, 4>& t) {
  const Vec<3> u = difference(t[1], t[0]), v = difference(t[2], t[0]), w = difference(t[3], t[0]);
  return std::fabs(product(u, cross_product(v, w))) / 6;
}

// ---- The audit

template <std::size_t D, class Mesh>
class SpacingAudit {
 public:
  SpacingAudit(const Mesh& mesh, const SpacingAuditOptions& options, Report& report)
      : mesh_(mesh),
        options_(options),
        report_(report),
        parts_(options.progress, "audit", kParts),
        scale_(scale_of(mesh.points)),
        places_(places_of<D>(std::span(mesh.points), scale_)) {}

  void run() {
    if (places_.at.size() >= 2) judge();
    report_.complete = report_.complete && parts_.go_on(kParts);
  }

 private:
  static constexpr std::uint64_t kParts = 13;  // at most so many calls of next_part()

  void judge() {
    const std::vector<double> none(places_.at.size(), 0.0);
    nearest_ = distances_to_nearest(SpacingTree<D>(places_.at, none));
    if (!find_values()) return;
    const SpacingTree<D> spacing(places_.at, values_);
    const bool lipschitz = audit_lipschitz(spacing);
    audit_beta(spacing);
    audit_spheres(spacing);
    measure_ratios();
    measure_density();
    measure_integral(spacing);
    if (parts_.stopped()) return;
    const BoundaryPieces<D> boundary(places_.at, boundary_of(mesh_, places_));
    measure_boundary_distance(boundary);
    if (parts_.stopped()) return;
    const double gap = measure_gaps(spacing, boundary);
    Check& check = report_.add_check("well_spaced", Item::kNone);
    check.value = gap;
    if (!lipschitz || !std::isfinite(gap)) check.violate({});
  }

  Progress next_part() { return parts_.part(part_++); }

  // Unless it is told to stop.
  template <class Visit>
  void for_each(std::size_t count, Visit visit) {
    if (parts_.stopped()) return;
    const Progress part = next_part();
    ProgressMeter meter(part, "audit", count, 1 << 12);
    for (Index i = 0; i < count && meter.step(); ++i) visit(i);
  }

  std::vector<double> distances_to_nearest(const SpacingTree<D>& tree) {
    std::vector<double> distances(places_.at.size(), kInfinity);
    for_each(places_.at.size(),
             [&](Index i) { distances[i] = tree.nearest(places_.at[i], i).value; });
    return distances;
  }

  // The values by place; returns whether they make sense.
  bool find_values() {
    Check& check = report_.add_check("spacing_positive", Item::kNode);
    values_ = nearest_;
    if (options_.spacing.empty()) return true;
    values_.assign(places_.at.size(), kInfinity);
    for (Index v = 0; v < options_.spacing.size(); ++v) {
      const double f = options_.spacing[v];
      if (!(f > 0) || !std::isfinite(f)) check.violate({v});
      double& value = values_[places_.place_of[v]];
      value = std::min(value, f * scale_);
    }
    return check.pass();
  }

  void violate(Check& check, Index p, Index q) const {
    check.violate({places_.node_at[p], places_.node_at[q]});
  }

  bool audit_lipschitz(const SpacingTree<D>& spacing) {
    Check& check = report_.add_check("lipschitz", Item::kEdge);
    for_each(values_.size(), [&](Index p) {
      const auto found = spacing.at(places_.at[p]);
      if (found.value * kRounding < values_[p]) violate(check, p, found.node);
    });
    return check.pass();
  }

  void audit_beta(const SpacingTree<D>& spacing) {
    double beta = 0;
    Index first = 0, second = 0;
    for_each(values_.size(), [&](Index p) {
      const auto found = spacing.most_crowded(places_.at[p], values_[p], p, beta);
      if (found.node != kNoIndex) beta = found.value, first = p, second = found.node;
    });
    report_.add_measure("beta", beta);
    add_witness("beta", places_.at[first], places_.at[second]);
    if (options_.beta <= 0) return;
    Check& check = report_.add_check("beta_spaced", Item::kEdge);
    check.value = options_.beta;
    for_each(values_.size(), [&](Index p) {
      const auto found =
          spacing.most_crowded(places_.at[p], values_[p], p, options_.beta * kRounding);
      if (found.node != kNoIndex) violate(check, p, found.node);
    });
  }

  void measure_ratios() {
    double least = kInfinity, largest = 0;
    for (Index p = 0; p < values_.size(); ++p) {
      const double ratio_to_nn = values_[p] / nearest_[p];
      least = std::min(least, ratio_to_nn), largest = std::max(largest, ratio_to_nn);
    }
    report_.add_measure("spacing_to_nn_min", least);
    report_.add_measure("spacing_to_nn_max", largest);
  }

  void measure_density() {
    double largest = 0;
    for (const auto& element : cells_of(mesh_))
      for (const Index v : element)
        for (const Index w : element) {
          const Index p = places_.place_of[v], q = places_.place_of[w];
          largest = std::max(largest, distance_of(places_.at[p], places_.at[q]) / nearest_[p]);
        }
    report_.add_measure("density_graph_constant", largest);
  }

  std::array<Vec<D>, D + 1> corners_of(const std::array<Index, D + 1>& element) const {
    std::array<Vec<D>, D + 1> corners;
    for (std::size_t i = 0; i <= D; ++i) corners[i] = places_.at[places_.place_of[element[i]]];
    return corners;
  }

  // Flat elements, of which no centre is known, are not judged.
  void audit_spheres(const SpacingTree<D>& spacing) {
    Check& check = report_.add_check("spheres_empty", D == 2 ? Item::kTriangle : Item::kTet);
    for_each(cells_of(mesh_).size(), [&](Index e) {
      const auto corners = corners_of(cells_of(mesh_)[e]);
      const auto [centre, error] = circumcentre<D>(corners);
      double radius = kInfinity;
      for (const auto& corner : corners) radius = std::min(radius, distance_of(centre, corner));
      if (spacing.nearest(centre).value * kRounding < radius - 2 * error) check.violate({e});
    });
  }

  // By the midpoint rule: one place an element.
  void measure_integral(const SpacingTree<D>& spacing) {
    double integral = 0;
    for_each(cells_of(mesh_).size(), [&](Index e) {
      const auto corners = corners_of(cells_of(mesh_)[e]);
      Vec<D> centre{};
      for (const auto& corner : corners) centre = step(centre, 1.0 / (D + 1), corner);
      const double f = spacing.at(centre).value;
      integral += volume_of(corners) / (D == 2 ? f * f : f * f * f);
    });
    report_.add_measure("spacing_integral", integral);
  }

  void measure_boundary_distance(const BoundaryPieces<D>& boundary) {
    double least = kInfinity;
    Index node = kNoIndex;
    Vec<D> place{};
    for_each(values_.size(), [&](Index p) {
      const double bound = std::isfinite(least) ? least * values_[p] : 0x1p200;
      const auto found = boundary.nearest_elsewhere(p, bound);
      if (found.distance >= bound) return;
      least = found.distance / values_[p], node = p, place = found.place;
    });
    if (node == kNoIndex) return;
    report_.add_measure("boundary_distance", least);
    add_witness("boundary_distance", places_.at[node], place);
  }

  // Returns the largest upper end of all brackets.
  double measure_gaps(const SpacingTree<D>& spacing, const BoundaryPieces<D>& boundary) {
    const Mesh delaunay = delaunay_mesh(places_, next_part());
    if (parts_.stopped()) return kInfinity;
    Check& check = report_.add_check("gaps_certified", Item::kNone);
    if (!is_delaunay(delaunay, next_part())) check.violate({});
    if (parts_.stopped()) return kInfinity;
    SpacedPoints<D> points{places_.at,         spacing,    cells_of(delaunay), boundary,
                           options_.tolerance, next_part()};
    double gap = add_bracket("gap_interior", interior_gap(points));
    if (parts_.stopped()) return kInfinity;
    points.progress = next_part();
    gap = std::max(gap, add_bracket("gap_segment",
                                    segment_gap(points, segments_of(mesh_, places_, boundary))));
    if (parts_.stopped()) return kInfinity;
    points.progress = next_part();
    if constexpr (D == 3) gap = std::max(gap, add_bracket("gap_face", face_gap(points)));
    report_.add_measure("gap", gap);
    return gap;
  }

  double add_bracket(const std::string& name, const GapBracket<D>& bracket) {
    report_.add_measure(concat({name, "_lower"}), bracket.lower);
    report_.add_measure(concat({name, "_upper"}), bracket.upper);
    add_witness(name, bracket.centre, bracket.at);
    return bracket.upper;
  }

  void add_witness(const std::string& name, Vec<D> centre, Vec<D> at) {
    Witness witness;
    witness.name = name;
    for (const double x : centre) witness.centre.push_back(x / scale_);
    for (const double x : at) witness.at.push_back(x / scale_);
    report_.witnesses.push_back(std::move(witness));
  }

  const Mesh& mesh_;
  const SpacingAuditOptions& options_;
  Report& report_;
  ProgressParts parts_;
  std::uint64_t part_ = 0;
  double scale_;
  Places<D> places_;
  std::vector<double> nearest_, values_;
};

}  // namespace

void audit_spacing(const TriangleMesh& mesh, const SpacingAuditOptions& options, Report& report) {
  SpacingAudit<2, TriangleMesh>(mesh, options, report).run();
}

void audit_spacing(const TetMesh& mesh, const SpacingAuditOptions& options, Report& report) {
  SpacingAudit<3, TetMesh>(mesh, options, report).run();
}

}  // namespace wellspaced::audit
