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
#include "wellspaced/kernel/sort_unique.hpp"

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

// ---- The plane

// The largest 1/sin of the smallest angle: twice the radius-edge ratio.
struct WorstAngles {
  double seeing = 0, blind = 0;  // of triangles that see their circumcentre, and of the others
};

WorstAngles worst_angles(const TriangleMesh& mesh, const Report& report) {
  std::vector<std::uint8_t> is_blind(mesh.triangles.size(), 0);
  if (const Check* check = report.check("circumcentres_inside"))
    for (const Index t : check->ids) is_blind[t] = 1;
  WorstAngles worst;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double ratio =
        2 * triangle_shape(mesh.points[a], mesh.points[b], mesh.points[c]).radius_edge;
    double& kept = is_blind[t] != 0 ? worst.blind : worst.seeing;
    kept = std::max(kept, ratio);
  }
  return worst;
}

// The largest el / NN at a node; the nearest node is the end of its shortest edge.
double largest_edge_ratio(const TriangleMesh& mesh) {
  std::vector<double> longest(mesh.points.size(), 0), shortest(mesh.points.size(), kInfinity);
  for (const auto& t : mesh.triangles) {
    double el = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      const double length =
          distance_of(coordinates_of(mesh.points[a]), coordinates_of(mesh.points[b]));
      el = std::max(el, length);
      for (const Index v : {a, b}) shortest[v] = std::min(shortest[v], length);
    }
    for (const Index v : t) longest[v] = std::max(longest[v], el);
  }
  double largest = 1;
  for (std::size_t v = 0; v < longest.size(); ++v)
    largest = std::max(largest, longest[v] / shortest[v]);
  return largest;
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
  const double cosecant = std::max(worst.seeing, worst.blind), square = cosecant * cosecant;
  list.compare("2.4.6", "sin(theta) <= b", 1 / cosecant, b);
  list.suppose(list.passes("constrained_delaunay"), "the mesh is constrained Delaunay");
  list.compare("2.4.1", "log2 L <= (2 + 12 / sin^4(theta)) log2(1/sin(theta)) + log2 max(el / NN)",
               binary_logarithm(list.measure("gap")),
               (2 + 12 * square * square) * binary_logarithm(cosecant) +
                   binary_logarithm(largest_edge_ratio(mesh)));
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
  const double rho = list.measure("radius_edge"), c = figures.density;
  list.suppose();
  list.suppose(list.passes("delaunay"), "the mesh is Delaunay");
  list.compare("3.4.3", "E / e <= 2 rho", list.measure("edge_ratio"), 2 * rho);
  list.compare("3.4.4", "log2(E / NN) <= (2 C3 - 1) log2 C2", binary_logarithm(c),
               log2_of_density_bound(rho));
  list.compare("3.4.5", "degree <= (2 C^2 + 1)^3", figures.degree,
               (2 * c * c + 1) * (2 * c * c + 1) * (2 * c * c + 1));
  list.compare("3.5.1", "R / NN <= rho C", figures.radius_to_nn, rho * c);
  list.compare("3.5.2 lower", "NN / R <= 2", figures.nn_to_radius, 2);
  list.compare("3.5.2 upper", "R / NN <= 1 + rho C", figures.radius_to_nn, 1 + rho * c);
  list.suppose(kind == SpacingKind::kNearestNeighbour, "the spacing function is NN");
  list.suppose(list.passes("circumcentres_inside"), "the circumcentres lie in the domain");
  list.compare("3.6.2", "L <= 130 rho^2 C^2 for interior gaps", list.measure("gap_interior_upper"),
               130 * rho * rho * c * c);
  compare_packing(list, report, kind);
}

}  // namespace wellspaced::audit
