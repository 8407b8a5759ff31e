// Which tetrahedra share a face, with everything that is wrong about the faces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

using Tets = std::span<const std::array<Index, 4>>;
using Face = std::array<Index, 3>;

/// The corners of the faces of a tet, by the corner that they lie opposite. Seen from outside a
/// positive tet they run counter-clockwise.
inline constexpr std::array<std::array<int, 3>, 4> kFaceCorners = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Face 4t + i of a mesh lies opposite corner i of tet t.
inline Face face_nodes(Tets tets, Index f) {
  const auto& tet = tets[f / 4];
  const auto& corners = kFaceCorners[f % 4];
  return {tet[corners[0]], tet[corners[1]], tet[corners[2]]};
}
/// The corner of its tet that is not on the face.
inline Index face_apex(Tets tets, Index f) { return tets[f / 4][f % 4]; }

/// twin: the same face of the tet on the other side, where there are exactly two and they run round
///   it in opposite directions; else kNoIndex: a boundary face, or one that is crowded or
///   disagreeing.
/// constrained: 1 where a facet of the mesh lies on the face.
/// facet_face: for each facet a face that it lies on, kNoIndex if it is none of the mesh.
/// faces: the number of faces.
struct TetFaces {
  std::vector<Index> twin;
  std::vector<std::uint8_t> constrained;
  std::vector<Index> facet_face;
  std::uint64_t faces = 0;

  std::vector<Index> crowded_faces;       ///< triples of nodes: more than two tets
  std::vector<Index> disagreeing_faces;   ///< triples of nodes: two tets, same direction
  std::vector<Index> duplicate_tets;      ///< tets with the nodes of an earlier one
  std::vector<Index> duplicate_facets;    ///< facets with the nodes of an earlier one
  std::vector<Index> conflicting_facets;  ///< those of them that have another marker
};

/// Pairs up the faces of a mesh.
/// Requires: indices in range, four distinct corners in every tet, three in every facet,
/// 4 * tets + facets < 2^32.
/// Cost: linear for bounded degrees, O(n log n) always; 120 bytes a tet.
TetFaces pair_tet_faces(Tets tets, std::span<const TetMesh::Facet> facets, Index nodes);

/// The number of edges. Cost: as pair_tet_faces.
std::uint64_t count_tet_edges(Tets tets, Index nodes);

}  // namespace wellspaced::audit
