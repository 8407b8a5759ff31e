// Proves that tetrahedra do not overlap, by the winding number of their common boundary.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/contact.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// A face of the boundary of a set of positive tets: its nodes, counter-clockwise seen from outside
/// its tet, and the fourth corner of that tet.
struct ChainFace {
  std::array<Index, 3> nodes{};
  Point3 apex;
};

/// improper_contacts: pairs of faces (positions in the list) that meet in more than common corners
///   or a common edge. If there are any, nothing is said about overlap: at_most_once is false.
struct SolidVerdict {
  bool at_most_once = true;
  std::vector<std::array<Index, 2>> improper_contacts;
};

/// Decides, exactly, whether tets overlap, from their boundary chain alone.
///
/// The claim is that of winding.hpp, one dimension up: the number d(x) of positive tets that
/// contain a point x is the winding number about x of the sum of their boundaries, less what
/// cancels. So the interiors are pairwise disjoint if and only if it is at most 1 everywhere.
///
/// The proof on the instance.
/// 1. Nodes at one place become one; faces that coincide with opposite orientation cancel.
/// 2. No two of the faces left meet improperly: a search tree finds all pairs that could.
/// 3. Around every edge the faces, sorted by angle, open and close the solid by turns (else two
///    wedges overlap). Each opening face is joined to the one that closes its wedge; no face lies
///    between them, so d is the same just inside both.
/// 4. So d is constant just inside each set of joined faces. For one face of each set it is counted
///    along a ray from a point displaced symbolically: from a corner of the face along one of its
///    edges, then much less into the face, then much less into the tet. So the point is just inside
///    the face, and the ray passes through no edge. d must be 1.
/// That suffices: were d(x) > 1 somewhere, a path from x to infinity would cross a face where d
/// falls from 2 to 1, and d would be 2 inside that face's set.
///
/// points: the places of the nodes. Requires: indices in range; finite coordinates; no flat face;
///   the faces are a sum of boundaries of positive tets less cancelling pairs.
/// Cost: O(n log n) for n faces of bounded overlap of boxes; a ray for each set of joined faces.
SolidVerdict cover_at_most_once(std::span<const Point3> points, std::span<const ChainFace> faces);

}  // namespace wellspaced::audit
