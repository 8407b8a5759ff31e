#include "wellspaced/algorithms/audit/theorems.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/shape.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/tet_shape.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

constexpr double kSlack = 1 + 1e-9;  // rounding of the measures

class TheoremList {
 public:
  explicit TheoremList(Report& report) : report_(report) {}

  double measure(std::string_view name) const {
    const Measure* found = report_.measure(name);
    return found == nullptr ? kInfinity : found->value;
  }
  bool passes(std::string_view name) const {
    const Check* found = report_.check(name);
    return found != nullptr && found->pass();
  }

  // The hypotheses of the theorems that follow; the first that fails is kept.
  void suppose() { fails_.clear(); }
  void suppose(bool holds, const char* hypothesis) {
    if (!holds && fails_.empty()) fails_ = hypothesis;
  }

  void compare(const char* name, const char* statement, double left, double right) {
    Theorem theorem;
    theorem.name = name;
    theorem.statement = statement;
    theorem.missing_hypothesis = fails_;
    theorem.left = left, theorem.right = right;
    theorem.holds = left <= right * kSlack;
    report_.theorems.push_back(std::move(theorem));
  }

 private:
  Report& report_;
  std::string fails_;
};

void suppose_well_spaced(TheoremList& list) {
  list.suppose();
  list.suppose(list.passes("lipschitz"), "f is 1-Lipschitz");
  list.suppose(list.passes("well_spaced"), "the gaps are bounded");
}

void compare_spacing(TheoremList& list, SpacingKind kind) {
  list.suppose();
  list.suppose(kind == SpacingKind::kNearestNeighbour, "the spacing function is NN");
  list.compare("2.4.2", "beta <= 2", list.measure("beta"), 2);
  suppose_well_spaced(list);
  const double gap = list.measure("gap"), d = gap * (3 + 2 * gap);
  list.compare("2.5.2 upper", "f / NN <= beta + 1", list.measure("spacing_to_nn_max"),
               list.measure("beta") + 1);
  list.compare("2.5.2 lower", "NN / f <= D (2 + D), D = L (3 + 2 L)",
               1 / list.measure("spacing_to_nn_min"), d * (2 + d));
}

// What a gap is at most by f where all spheres are empty, K as in the header.
double bound_on_gaps(double corners, double k) { return 2 * (1 - 1 / corners) * k * k + 0.5; }

void suppose_empty_spheres(TheoremList& list, SpacingKind kind) {
  list.suppose();
  list.suppose(kind == SpacingKind::kNearestNeighbour, "the spacing function is NN");
  list.suppose(list.passes("spheres_empty"),
               "no node lies inside the circle or sphere of an element");
}

// ---- The plane

// The largest 1/sin of the smallest angle, twice the radius-edge ratio: of all triangles, and of
// those with an empty circle, if they see its centre and if not.
struct WorstAngles {
  double any = 0, seeing = 0, blind = 0;
};

std::vector<std::uint8_t> marks_of(std::size_t count, const Check* check) {
  std::vector<std::uint8_t> marks(count, 0);
  if (check != nullptr)
    for (const Index id : check->ids) marks[id] = 1;
  return marks;
}

WorstAngles worst_angles(const TriangleMesh& mesh, const Report& report) {
  const auto is_blind = marks_of(mesh.triangles.size(), report.check("circumcentres_inside"));
  const auto is_full = marks_of(mesh.triangles.size(), report.check("spheres_empty"));
  WorstAngles worst;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double ratio =
        2 * triangle_shape(mesh.points[a], mesh.points[b], mesh.points[c]).radius_edge;
    worst.any = std::max(worst.any, ratio);
    if (is_full[t] != 0) continue;
    double& kept = is_blind[t] != 0 ? worst.blind : worst.seeing;
    kept = std::max(kept, ratio);
  }
  return worst;
}

// rho of the corrected Theorem 2.5.1(2). The boundary gap is an interval: a segment's end is at
// most so far, by f, from a place on it.
double bound_on_blind_circles(double b, double interior_gap, double segment_gap) {
  const double interval = 2 * segment_gap;
  const auto at = [&](double t) {
    return t / 2 + (1 + t) * (1 + t) * interval * interval / (2 * t);
  };
  return std::max(at(b), at(interior_gap));
}

// ---- Space

double distance_between(const TetMesh& mesh, Index v, Index w) {
  return distance_of(coordinates_of(mesh.points[v]), coordinates_of(mesh.points[w]));
}

// Over all nodes: the longest edge by the shortest, the degree, the circumradius of a tet by the
// shortest edge. In a Delaunay mesh the shortest edge of a node leads to its nearest node.
struct NodeFigures {
  double density = 0, degree = 0, radius_to_nn = 0, nn_to_radius = 0;
};

NodeFigures node_figures(const TetMesh& mesh) {
  std::vector<std::array<Index, 2>> arcs;
  for (const auto& tet : mesh.tets)
    for (const Index v : tet)
      for (const Index w : tet)
        if (v != w) arcs.push_back({v, w});
  sort_unique(arcs);
  NodeFigures figures;
  std::vector<double> nearest(mesh.points.size(), kInfinity);
  for (std::size_t i = 0, end = 0; i < arcs.size(); i = end) {
    double longest = 0, &shortest = nearest[arcs[i][0]];
    for (; end < arcs.size() && arcs[end][0] == arcs[i][0]; ++end) {
      const double length = distance_between(mesh, arcs[end][0], arcs[end][1]);
      shortest = std::min(shortest, length), longest = std::max(longest, length);
    }
    figures.density = std::max(figures.density, ratio(longest, shortest));
    figures.degree = std::max(figures.degree, static_cast<double>(end - i));
  }
  for (const auto& t : mesh.tets) {
    const auto& p = mesh.points;
    const TetShape shape = tet_shape({p[t[0]], p[t[1]], p[t[2]], p[t[3]]});
    const double radius = shape.radius_edge * shape.shortest_edge;
    for (const Index v : t) {
      figures.radius_to_nn = std::max(figures.radius_to_nn, ratio(radius, nearest[v]));
      figures.nn_to_radius = std::max(figures.nn_to_radius, ratio(nearest[v], radius));
    }
  }
  return figures;
}

// log2 of the constant of Theorem 3.4.4. C3, the number of patches of diameter theta that cover a
// sphere, is at most 1 / sin^2(theta / 8).
double log2_of_density_bound(double rho) {
  const double sine = 1 / (2 * rho);  // of 2 theta
  const double degrees = arccotangent_deg(std::sqrt(1 - sine * sine) / sine) / 2;
  const auto sine_of = [](double angle) { return circle_point(angle / 360).y; };
  const double c1 = 1 / sine_of(degrees), c2 = std::max(2 * c1 * rho, 4 * rho * rho);
  const double patch = sine_of(degrees / 8), c3 = 1 / (patch * patch);
  return (2 * c3 - 1) * binary_logarithm(c2);
}

void compare_packing(TheoremList& list, const Report& report, SpacingKind kind) {
  list.suppose();
  list.suppose(kind == SpacingKind::kLocalFeatureSize, "the mesh is a packing by lfs");
  list.suppose(
      report.check("domain_facets_are_faces") == nullptr || list.passes("domain_facets_are_faces"),
      "the mesh conforms to its domain (4.3.5)");
  const Check* spaced = report.check("beta_spaced");
  list.suppose(spaced != nullptr && spaced->pass(), "the nodes are beta-spaced by lfs");
  const double beta = spaced != nullptr && spaced->value ? *spaced->value : 0;
  list.suppose(beta > 3 + 2 * std::sqrt(2.0), "beta > 3 + 2 sqrt 2");
  const auto violations = [&](std::string_view name) {
    const Check* check = report.check(name);
    return check == nullptr ? kInfinity : static_cast<double>(check->violations);
  };
  list.compare("4.3.4", "nodes inside spheres of boundary faces <= 0",
               violations("boundary_gabriel"), 0);
  list.compare("4.3.6", "circumcentres outside the domain <= 0", violations("circumcentres_inside"),
               0);
  // Of the ball of radius f / beta around a node an eighth or more lies in the domain, and f is at
  // most (1 + 1 / beta) times as large there.
  const double sum = beta + 1, constant = 6 / kPi * sum * sum * sum;
  list.compare("4.4.1", "nodes <= 6 / pi (beta + 1)^3 times the integral of 1 / lfs^3",
               list.measure("nodes"), constant * list.measure("spacing_integral"));
  const double room = beta - 7 - 2 * std::sqrt(2.0);
  list.suppose(room > 0, "beta > 7 + 2 sqrt 2");
  list.compare("4.3.7", "rho <= 2 beta / (beta - 7 - 2 sqrt 2)", list.measure("radius_edge"),
               room > 0 ? 2 * beta / room : kInfinity);
}

}  // namespace

void compare_with_theorems(const TriangleMesh& mesh, SpacingKind kind, Report& report) {
  TheoremList list(report);
  compare_spacing(list, kind);
  const WorstAngles worst = worst_angles(mesh, report);
  const double b = list.measure("boundary_distance"), beta = list.measure("beta");
  list.suppose();
  list.suppose(kind == SpacingKind::kNearestNeighbour, "the spacing function is NN");
  list.compare("2.4.6", "sin(theta) <= b", 1 / worst.any, b);
  suppose_empty_spheres(list, kind);
  const double k = list.measure("density_graph_constant") * (1 + 3 * worst.any);
  list.compare("2.4.1", "L <= 4/3 C^2 (1 + 3/sin(theta))^2 + 1/2", list.measure("gap"),
               bound_on_gaps(3, k));
  suppose_well_spaced(list);
  list.suppose(list.passes("constrained_delaunay"), "the mesh is constrained Delaunay");
  const double interior = list.measure("gap_interior_upper");
  list.compare("2.5.1(1)", "1/sin(theta) <= L (2 + beta)", worst.seeing, interior * (2 + beta));
  list.suppose(b > 0, "no node lies on a segment of the boundary that is not its own");
  const double rho = bound_on_blind_circles(b, interior, list.measure("gap_segment_upper"));
  list.compare("2.5.1(2)", "1/sin(theta) <= (2 + beta) rho(L, b)", worst.blind, (2 + beta) * rho);
}

void compare_with_theorems(const TetMesh& mesh, SpacingKind kind, Report& report) {
  TheoremList list(report);
  compare_spacing(list, kind);
  const NodeFigures figures = node_figures(mesh);
  const double rho = list.measure("radius_edge"), c = list.measure("density_graph_constant");
  list.suppose();
  list.suppose(list.passes("delaunay"), "the mesh is Delaunay");
  list.compare("3.4.3", "E / e <= 2 rho", list.measure("edge_ratio"), 2 * rho);
  list.compare("3.4.4", "log2(E / e) <= (2 C3 - 1) log2 C2", binary_logarithm(figures.density),
               log2_of_density_bound(rho));
  list.compare("3.4.5", "degree <= (2 C^2 + 1)^3", figures.degree,
               (2 * c * c + 1) * (2 * c * c + 1) * (2 * c * c + 1));
  list.compare("3.5.1", "R / NN <= rho C", figures.radius_to_nn, rho * c);
  list.compare("3.5.2 lower", "NN / R <= 2", figures.nn_to_radius, 2);
  list.compare("3.5.2 upper", "R / NN <= 1 + rho C", figures.radius_to_nn, 1 + rho * c);
  suppose_empty_spheres(list, kind);
  list.compare("3.6.2(1)", "L <= C (1 + 4 rho) / 2 on segments", list.measure("gap_segment_upper"),
               c * (1 + 4 * rho) / 2);
  list.compare("3.6.2(2)", "L <= 4/3 C^2 (1 + 6 rho)^2 + 1/2 on faces",
               list.measure("gap_face_upper"), bound_on_gaps(3, c * (1 + 6 * rho)));
  list.compare("3.6.2(3)", "L <= 3/2 C^2 (1 + 8 rho)^2 + 1/2 inside",
               list.measure("gap_interior_upper"), bound_on_gaps(4, c * (1 + 8 * rho)));
  compare_packing(list, report, kind);
}

}  // namespace wellspaced::audit
