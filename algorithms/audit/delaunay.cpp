#include "wellspaced/algorithms/audit/delaunay.hpp"

#include "wellspaced/algorithms/audit/exact_tests.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::audit {
namespace {

class DelaunayAudit {
 public:
  DelaunayAudit(const TriangleMesh& mesh, const HalfEdges& half_edges,
                const std::vector<std::int8_t>& orientation)
      : mesh_(mesh), half_edges_(half_edges), orientation_(orientation) {
    find_obtuse_corners();
  }

  void audit_circumcircles(Report& report) const {
    Check constrained = check("constrained_delaunay"), all = check("delaunay");
    for (Index t = 0; t < mesh_.triangles.size(); ++t)
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        if (!apex_beyond_is_inside(t, h)) continue;
        all.violate({from(h), to(h)});
        if (half_edges_.constrained[h] == 0) constrained.violate({from(h), to(h)});
      }
    report.checks.push_back(std::move(constrained));
    report.checks.push_back(std::move(all));
  }

  void audit_diametral_circles(Report& report) const {
    Check all = check("gabriel"), boundary = check("boundary_gabriel");
    for (Index t = 0; t < mesh_.triangles.size(); ++t) {
      const Index h = 3 * t + obtuse_edge_[t];
      if (obtuse_edge_[t] == kNone || counted_from_twin(h)) continue;
      all.violate({from(h), to(h)});
      if (half_edges_.twin[h] == kNoIndex || half_edges_.constrained[h] != 0)
        boundary.violate({from(h), to(h)});
    }
    report.checks.push_back(std::move(all));
    report.checks.push_back(std::move(boundary));
  }

  void audit_circumcentres(Report& report) const {
    Check& check = report.add_check("circumcentres_inside", Item::kTriangle, false);
    std::uint64_t budget = 32 * std::uint64_t{mesh_.triangles.size()}, undecided = 0;
    const bool all_delaunay = report.check("delaunay")->pass();
    for (Index t = 0; t < mesh_.triangles.size(); ++t) {
      if (obtuse_edge_[t] == kNone || (all_delaunay && faces_acute_neighbor(t))) continue;
      const Walk walk = walk_to_circumcentre(t, budget);
      if (walk == Walk::kLeft) check.violate({t});
      undecided += walk == Walk::kGivenUp;
    }
    if (undecided > 0)
      report.add_measure("circumcentres_undecided", static_cast<double>(undecided));
  }

 private:
  enum class Walk { kArrived, kLeft, kGivenUp };
  static constexpr std::uint8_t kNone = 3;

  static Check check(std::string_view name) {
    Check result;
    result.name = name;
    result.item = Item::kEdge;
    return result;
  }

  Index from(Index h) const { return origin(mesh_.triangles, h); }
  Index to(Index h) const { return target(mesh_.triangles, h); }
  Point2 from_point(Index h) const { return mesh_.points[from(h)]; }
  Point2 to_point(Index h) const { return mesh_.points[to(h)]; }
  Point2 apex_point(Index h) const { return mesh_.points[apex(mesh_.triangles, h)]; }

  // Whether the circumcircle of t contains the apex of the triangle beyond its half-edge h; each
  // edge is asked from its lower half-edge alone.
  bool apex_beyond_is_inside(Index t, Index h) const {
    const Index twin = half_edges_.twin[h];
    if (twin == kNoIndex || twin < h) return false;
    if (orientation_[t] <= 0 || orientation_[twin / 3] <= 0) return false;
    const auto& [a, b, c] = mesh_.triangles[t];
    return incircle(mesh_.points[a], mesh_.points[b], mesh_.points[c], apex_point(twin)) > 0;
  }

  // Both triangles on an edge may see it under an obtuse angle; it is one violation.
  bool counted_from_twin(Index h) const {
    const Index twin = half_edges_.twin[h];
    return twin != kNoIndex && twin < h && obtuse_edge_[twin / 3] == twin % 3;
  }

  // For each triangle the number of the edge opposite its obtuse corner.
  void find_obtuse_corners() {
    obtuse_edge_.assign(mesh_.triangles.size(), kNone);
    for (Index t = 0; t < obtuse_edge_.size(); ++t) {
      const auto& [i, j, k] = mesh_.triangles[t];
      const Point2 a = mesh_.points[i], b = mesh_.points[j], c = mesh_.points[k];
      if (orientation_[t] <= 0) continue;
      const bool at_c = angle_sign(c, a, b) < 0, at_a = angle_sign(a, b, c) < 0;
      const bool at_b = angle_sign(b, c, a) < 0;
      obtuse_edge_[t] = static_cast<std::uint8_t>(kNone - 3 * at_c - 2 * at_a - at_b);
    }
  }

  // On the bisector of an edge of a Delaunay mesh the two circumcentres come in the order of the
  // triangles. So if that of the neighbour lies in the neighbour, that of t lies there too.
  bool faces_acute_neighbor(Index t) const {
    const Index twin = half_edges_.twin[3 * t + obtuse_edge_[t]];
    return twin != kNoIndex && orientation_[twin / 3] > 0 && obtuse_edge_[twin / 3] == kNone;
  }

  // From the middle of the longest edge of t along its bisector to the circumcentre. The half-edge
  // kept, into the current triangle, always has the bisector between its ends: its origin no
  // farther from v, its target no farther from u.
  Walk walk_to_circumcentre(Index t, std::uint64_t& budget) const {
    const Index longest = 3 * t + obtuse_edge_[t];
    const Point2 u = from_point(longest), v = to_point(longest);
    Index exit = longest;
    while (budget > 0) {
      --budget;
      const Index entry = half_edges_.twin[exit];
      if (entry == kNoIndex) return Walk::kLeft;
      exit = exit_of(entry, u, v);
      if (circumcentre_side(from_point(exit), to_point(exit), u, v, apex_point(longest)) >= 0)
        return Walk::kArrived;
    }
    return Walk::kGivenUp;
  }

  // The edge through which the bisector of u and v leaves the triangle that it entered by `entry`;
  // if it leaves through the apex, an edge that leads on, if there is one.
  Index exit_of(Index entry, Point2 u, Point2 v) const {
    const Index left = HalfEdges::previous(entry), right = HalfEdges::next(entry);
    const int side = compare_distances(apex_point(entry), u, v);
    if (side == 0) return half_edges_.twin[left] != kNoIndex ? left : right;
    return side < 0 ? left : right;
  }

  const TriangleMesh& mesh_;
  const HalfEdges& half_edges_;
  const std::vector<std::int8_t>& orientation_;
  std::vector<std::uint8_t> obtuse_edge_;
};

}  // namespace

void audit_delaunay(const TriangleMesh& mesh, const HalfEdges& half_edges,
                    const std::vector<std::int8_t>& orientation, Report& report) {
  const DelaunayAudit audit(mesh, half_edges, orientation);
  audit.audit_circumcircles(report);
  audit.audit_diametral_circles(report);
  audit.audit_circumcentres(report);
}

}  // namespace wellspaced::audit
