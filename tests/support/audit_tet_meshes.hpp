// Tetrahedral meshes for the auditors: clean ones of many kinds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

struct NamedTetMesh {
  std::string name;
  TetMesh mesh;
};

// Coordinates are small multiples of 2^-20, so that midpoints are exact.

// The Delaunay tets of random points; its hull faces are the facets.
TetMesh random_tet_mesh(std::size_t nodes, std::uint64_t seed);

// The unit cubes (x, y, z), 0 <= x < nx and so on, of which keep(x, y, z) is true, each cut into
// six tets around the diagonal from its lowest to its highest corner. Boundary faces are the
// facets.
TetMesh cubes(Index nx, Index ny, Index nz, const std::function<bool(Index, Index, Index)>& keep);

// b beside a, as another component; b is moved by `offset`.
TetMesh side_by_side(const TetMesh& a, const TetMesh& b, Point3 offset);

// Facets with marker 1 on all faces of one tet only.
void add_boundary_facets(TetMesh& mesh);

// A box, one with a cavity, a ring, two components, one in the cavity of another, random points.
std::vector<NamedTetMesh> clean_tet_meshes();

}  // namespace wellspaced::test
