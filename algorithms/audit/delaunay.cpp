#include "wellspaced/algorithms/audit/delaunay.hpp"

#include "wellspaced/algorithms/audit/exact_tests.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

class DelaunayAudit {
 public:
  DelaunayAudit(const TriangleMesh& mesh, const HalfEdges& half_edges,
                const std::vector<std::int8_t>& orientation)
      : mesh_(mesh), half_edges_(half_edges), orientation_(orientation) {
    find_obtuse_corners();
  }

  // The angles opposite an edge that fails add up to more than 180 degrees, so one is obtuse.
  void audit_circumcircles(Report& report) const {
    Check constrained = check("constrained_delaunay"), all = check("delaunay");
    for (const Index h : facing_obtuse_) {
      if (seen_from_twin(h) || !apex_beyond_is_inside(h)) continue;
      all.violate({from(h), to(h)});
      if (half_edges_.constrained[h] == 0) constrained.violate({from(h), to(h)});
    }
    report.checks.push_back(std::move(constrained));
    report.checks.push_back(std::move(all));
  }

  void audit_diametral_circles(Report& report) const {
    Check all = check("gabriel"), boundary = check("boundary_gabriel");
    all.ids.reserve(2 * facing_obtuse_.size());
    for (const Index h : facing_obtuse_) {
      if (seen_from_twin(h)) continue;
      all.violate({from(h), to(h)});
      if (half_edges_.twin[h] == kNoIndex || half_edges_.constrained[h] != 0)
        boundary.violate({from(h), to(h)});
    }
    report.checks.push_back(std::move(all));
    report.checks.push_back(std::move(boundary));
  }

  void audit_circumcentres(Report& report) const {
    Check& check = report.add_check("circumcentres_inside", Item::kTriangle);
    std::uint64_t budget = 32 * std::uint64_t{mesh_.triangles.size()}, undecided = 0;
    const bool all_delaunay = report.check("delaunay")->pass();
    for (const Index h : all_delaunay ? leading_out() : facing_obtuse_) {
      const Walk walk = walk_to_circumcentre(h, budget);
      if (walk == Walk::kLeft) check.violate({h / 3});
      undecided += walk == Walk::kGivenUp;
    }
    if (undecided > 0)
      report.add_measure("circumcentres_undecided", static_cast<double>(undecided));
  }

 private:
  enum class Walk { kArrived, kLeft, kGivenUp };

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

  // Whether the circumcircle on one side of an edge contains the apex on the other.
  bool apex_beyond_is_inside(Index h) const {
    const Index twin = half_edges_.twin[h];
    if (twin == kNoIndex || orientation_[twin / 3] <= 0) return false;
    return incircle(from_point(h), to_point(h), apex_point(h), apex_point(twin)) > 0;
  }

  bool faces_obtuse(Index h) const { return faces_obtuse_[h / 3] == h % 3; }

  // Both triangles on an edge may see it under an obtuse angle.
  bool seen_from_twin(Index h) const {
    const Index twin = half_edges_.twin[h];
    return twin != kNoIndex && faces_obtuse(twin) && twin < h;
  }

  // The half-edges opposite obtuse corners, of counter-clockwise triangles.
  void find_obtuse_corners() {
    const auto triangles = static_cast<Index>(mesh_.triangles.size());
    faces_obtuse_.resize(triangles);
    facing_obtuse_.resize(triangles + std::size_t{1});
    std::size_t count = 0;
    for (Index t = 0; t < triangles; ++t) {
      const auto& [i, j, k] = mesh_.triangles[t];
      const int edge = edge_facing_obtuse(mesh_.points[i], mesh_.points[j], mesh_.points[k]);
      faces_obtuse_[t] = static_cast<std::uint8_t>(orientation_[t] > 0 ? edge : 3);
      facing_obtuse_[count] = 3 * t + faces_obtuse_[t];  // without a branch: half have one
      count += faces_obtuse_[t] < 3;
    }
    facing_obtuse_.resize(count);
  }

  // In a Delaunay mesh, those of them that lead to the boundary: across the edge, and if the
  // neighbour is obtuse across its longest edge, and so on. All others have their circumcentres in
  // the mesh: on the bisector of an edge the two circumcentres come in the order of the triangles,
  // and if the second is obtuse, the way to its circumcentre from any place on the edge leaves it
  // by its longest edge; so by induction from the acute triangle at the end, the triangle between
  // the circumcentre and the edge that leads to it lies in the mesh.
  std::vector<Index> leading_out() const {
    std::vector<Index> out;
    for (const Index h : facing_obtuse_) {
      const Index twin = half_edges_.twin[h];
      if (twin == kNoIndex || orientation_[twin / 3] <= 0) out.push_back(h);
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (const Index side : {HalfEdges::next(out[i]), HalfEdges::previous(out[i])}) {
        const Index twin = half_edges_.twin[side];
        if (twin != kNoIndex && faces_obtuse(twin)) out.push_back(twin);
      }
    }
    sort(out);
    return out;
  }

  // From the middle of the longest edge of a triangle along its bisector to the circumcentre. The
  // half-edge kept, into the current triangle, always has the bisector between its ends: its origin
  // no farther from v, its target no farther from u.
  Walk walk_to_circumcentre(Index longest, std::uint64_t& budget) const {
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
  std::vector<Index> facing_obtuse_;        // half-edges, ascending
  std::vector<std::uint8_t> faces_obtuse_;  // for each triangle the number of its one, or 3
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
