#include "wellspaced/algorithms/audit/tet_embedding.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/check_lists.hpp"
#include "wellspaced/algorithms/audit/contact.hpp"
#include "wellspaced/algorithms/audit/solid_winding.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

int sign_of_tet(const TetMesh& mesh, const std::array<Index, 4>& t) {
  const auto& p = mesh.points;
  return -orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
}

TetCorners corners_of(const TetMesh& mesh, Index t) {
  const auto& [a, b, c, d] = mesh.tets[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]};
}

// The sum of the boundaries of all tets that are not flat, made positive, less the faces that
// cancel because two tets of the same orientation share them; and the tets of these faces.
struct Chain {
  std::vector<ChainFace> faces;
  std::vector<Index> tets;
};

Chain boundary_chain(const TetMesh& mesh, const TetFaces& faces,
                     const std::vector<std::int8_t>& orientation) {
  Chain chain;
  for (Index f = 0; f < faces.twin.size(); ++f) {
    const int sign = orientation[f / 4];
    const Index twin = faces.twin[f];
    if (sign == 0 || (twin != kNoIndex && orientation[twin / 4] == sign)) continue;
    ChainFace face{face_nodes(mesh.tets, f), mesh.points[face_apex(mesh.tets, f)]};
    if (sign < 0) std::swap(face.nodes[1], face.nodes[2]);
    chain.faces.push_back(face);
    chain.tets.push_back(f / 4);
  }
  return chain;
}

// Lists pairs of tets that overlap.
class TetOverlapSearch {
 public:
  TetOverlapSearch(const TetMesh& mesh, const std::vector<std::int8_t>& orientation)
      : mesh_(mesh), orientation_(orientation), boxes_(boxes_of(mesh)), tree_(boxes_) {}

  // Returns whether all pairs were looked at.
  bool run(Check& check) {
    std::uint64_t budget = 1000000 + 64 * std::uint64_t{mesh_.tets.size()};
    for (Index t = 0; t < mesh_.tets.size() && budget > 0; ++t)
      if (orientation_[t] != 0) list_overlaps_of(t, budget, check);
    return budget > 0;
  }

 private:
  static std::vector<Box<3>> boxes_of(const TetMesh& mesh) {
    std::vector<Box<3>> boxes;
    boxes.reserve(mesh.tets.size());
    for (Index t = 0; t < mesh.tets.size(); ++t) {
      const TetCorners c = corners_of(mesh, t);
      boxes.push_back(box_of(c[0], c[1], c[2], c[3]));
    }
    return boxes;
  }

  void list_overlaps_of(Index t, std::uint64_t& budget, Check& check) {
    const TetCorners corners = corners_of(mesh_, t);
    tree_.search([&](const Box<3>& box) { return overlap(box, boxes_[t]); },
                 [&](Index u) {
                   if (u <= t || orientation_[u] == 0 || !overlap(boxes_[u], boxes_[t]))
                     return true;
                   if (interiors_overlap(corners, corners_of(mesh_, u))) check.violate({t, u});
                   return --budget > 0;
                 });
  }

  const TetMesh& mesh_;
  const std::vector<std::int8_t>& orientation_;
  std::vector<Box<3>> boxes_;
  BoxTree<3> tree_;
};

// The tets of pairs of faces, each pair once.
std::vector<std::array<Index, 2>> pairs_of_tets(const Chain& chain,
                                                const std::vector<std::array<Index, 2>>& faces) {
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& [f, g] : faces) {
    const auto [t, u] = std::minmax(chain.tets[f], chain.tets[g]);
    pairs.push_back({t, u});
  }
  sort_unique(pairs);
  return pairs;
}

std::uint64_t count_coincident(const TetMesh& mesh) {
  std::vector<std::array<double, 3>> places;
  places.reserve(mesh.points.size());
  for (const Point3& p : mesh.points) places.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  sort(places);
  const auto distinct = std::unique(places.begin(), places.end()) - places.begin();
  return places.size() - static_cast<std::size_t>(distinct);
}

}  // namespace

std::vector<std::int8_t> tet_orientations(const TetMesh& mesh) {
  std::vector<std::int8_t> signs;
  signs.reserve(mesh.tets.size());
  for (const auto& t : mesh.tets) signs.push_back(static_cast<std::int8_t>(sign_of_tet(mesh, t)));
  return signs;
}

bool is_negative(const TetMesh& mesh) {
  return !mesh.tets.empty() &&
         all_of(mesh.tets, [&](const auto& t) { return sign_of_tet(mesh, t) < 0; });
}

void audit_tet_embedding(const TetMesh& mesh, const TetFaces& faces,
                         const std::vector<std::int8_t>& orientation, Report& report) {
  check_orientations(report, Item::kTet, orientation);
  const Chain chain = boundary_chain(mesh, faces, orientation);
  const SolidVerdict verdict = cover_at_most_once(mesh.points, chain.faces);
  Check& check = report.add_required_check("no_overlap", Item::kTetPair);
  if (!verdict.at_most_once) {
    const bool complete = TetOverlapSearch(mesh, orientation).run(check);
    // Improper contacts alone say nothing; anything else has refuted the mesh.
    const bool settled = complete && !verdict.improper_contacts.empty();
    if (check.pass() && !settled) check.violate({});
  }
  Check& contacts = report.add_required_check("no_improper_contact", Item::kTetPair);
  for (const auto& [t, u] : pairs_of_tets(chain, verdict.improper_contacts))
    contacts.violate({t, u});
  report.add_measure("coincident_nodes", static_cast<double>(count_coincident(mesh)));
}

}  // namespace wellspaced::audit
