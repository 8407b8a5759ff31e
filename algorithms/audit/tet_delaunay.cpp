#include "wellspaced/algorithms/audit/tet_delaunay.hpp"

#include <array>
#include <utility>

#include "wellspaced/algorithms/audit/exact_tests.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::audit {
namespace {

constexpr std::uint64_t kFacesAQuestion = 1 << 10;  // each may be decided by integers

class TetDelaunayAudit {
 public:
  TetDelaunayAudit(const TetMesh& mesh, const TetFaces& faces,
                   const std::vector<std::int8_t>& orientation)
      : mesh_(mesh), faces_(faces), orientation_(orientation) {}

  void audit_circumspheres(const Progress& progress, Report& report) const {
    Check constrained = face_check("constrained_delaunay"), all = face_check("delaunay");
    ProgressMeter meter(progress, "audit", faces_.twin.size(), kFacesAQuestion);
    for (Index f = 0; f < faces_.twin.size() && meter.step(); ++f) {
      const Index twin = faces_.twin[f];
      if (twin == kNoIndex || twin < f || !is_positive(f) || !is_positive(twin)) continue;
      if (!fails(f)) continue;
      violate(all, f);
      if (faces_.constrained[f] == 0) violate(constrained, f);
    }
    report.checks.push_back(std::move(constrained));
    report.checks.push_back(std::move(all));
  }

  void audit_smallest_spheres(const Progress& progress, Report& report) const {
    Check all = face_check("gabriel"), boundary = face_check("boundary_gabriel");
    ProgressMeter meter(progress, "audit", faces_.twin.size(), kFacesAQuestion);
    for (Index f = 0; f < faces_.twin.size() && meter.step(); ++f) {
      const Index twin = faces_.twin[f];
      if ((twin != kNoIndex && twin < f) || !is_encroached(f, twin)) continue;
      violate(all, f);
      if (twin == kNoIndex || faces_.constrained[f] != 0) violate(boundary, f);
    }
    report.checks.push_back(std::move(all));
    report.checks.push_back(std::move(boundary));
  }

  void audit_circumcentres(const Progress& progress, Report& report) const {
    Check& check = report.add_check("circumcentres_inside", Item::kTet);
    std::uint64_t budget = 32 * std::uint64_t{mesh_.tets.size()}, undecided = 0;
    ProgressMeter meter(progress, "audit", mesh_.tets.size(), kFacesAQuestion);
    for (Index t = 0; t < mesh_.tets.size() && meter.step(); ++t) {
      if (orientation_[t] <= 0) continue;
      const Walk walk = walk_to_circumcentre(t, budget);
      if (walk == Walk::kLeft) check.violate({t});
      undecided += walk == Walk::kGivenUp;
    }
    if (undecided > 0)
      report.add_measure("circumcentres_undecided", static_cast<double>(undecided));
  }

 private:
  enum class Walk { kArrived, kLeft, kGivenUp };

  static Check face_check(std::string_view name) {
    Check check;
    check.name = name;
    check.item = Item::kFace;
    return check;
  }

  void violate(Check& check, Index f) const {
    const Face nodes = face_nodes(mesh_.tets, f);
    check.violate({nodes[0], nodes[1], nodes[2]});
  }

  bool is_positive(Index f) const { return orientation_[f / 4] > 0; }
  Point3 apex(Index f) const { return mesh_.points[face_apex(mesh_.tets, f)]; }
  std::array<Point3, 3> corners(Index f) const {
    const Face nodes = face_nodes(mesh_.tets, f);
    return {mesh_.points[nodes[0]], mesh_.points[nodes[1]], mesh_.points[nodes[2]]};
  }

  bool fails(Index f) const {
    const auto [a, b, c] = corners(f);  // seen from outside, so above its apex
    return insphere(a, b, c, apex(f), apex(faces_.twin[f])) > 0;
  }

  bool is_encroached(Index f, Index twin) const {
    const auto [a, b, c] = corners(f);
    if (is_positive(f) && face_sphere_side(a, b, c, apex(f)) > 0) return true;
    return twin != kNoIndex && is_positive(twin) && face_sphere_side(a, b, c, apex(twin)) > 0;
  }

  Walk walk_to_circumcentre(Index t, std::uint64_t& budget) const {
    const auto& [a, b, c, d] = mesh_.tets[t];
    const Circumcentre3 centre(
        {mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[d]});
    Index entry = kNoIndex;
    for (Index at = t; budget > 0; at = entry / 4) {
      --budget;
      bool beyond = false;
      Index exit = kNoIndex;
      for (Index f = 4 * at; f < 4 * at + 4 && exit == kNoIndex; ++f) {
        if (f == entry || centre.side(corners(f)) <= 0) continue;
        beyond = true;
        if (faces_.twin[f] != kNoIndex) exit = f;
      }
      if (!beyond) return Walk::kArrived;
      if (exit == kNoIndex) return Walk::kLeft;
      entry = faces_.twin[exit];
    }
    return Walk::kGivenUp;
  }

  const TetMesh& mesh_;
  const TetFaces& faces_;
  const std::vector<std::int8_t>& orientation_;
};

}  // namespace

void audit_tet_delaunay(const TetMesh& mesh, const TetFaces& faces,
                        const std::vector<std::int8_t>& orientation, const Progress& progress,
                        Report& report) {
  const TetDelaunayAudit audit(mesh, faces, orientation);
  ProgressParts parts(progress, "audit", 3);
  audit.audit_circumspheres(parts.part(0), report);
  if (parts.go_on(1)) audit.audit_smallest_spheres(parts.part(1), report);
  if (parts.go_on(2)) audit.audit_circumcentres(parts.part(2), report);
}

}  // namespace wellspaced::audit
