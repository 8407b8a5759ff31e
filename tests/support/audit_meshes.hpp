// Meshes for the auditors: clean ones of many kinds, and pieces to spoil them with.
#pragma once

#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

// Coordinates are small multiples of 2^-20, so that midpoints are exact.

// The Delaunay triangulation of random points; its hull edges are the segments.
TriangleMesh random_mesh(std::size_t nodes, std::uint64_t seed);

// Two rings of n nodes, the inner one the boundary of a hole; Delaunay.
TriangleMesh annulus(Index n);

// A square of 2n x 2n cells, slit along the middle row from the left edge to the centre: the nodes
// of the slit but its tip are there twice.
TriangleMesh slit_square(Index n);

// b beside a, as another component; b is moved by `offset`.
TriangleMesh side_by_side(const TriangleMesh& a, const TriangleMesh& b, Point2 offset);

// A strip of n quads around the origin, winding once a `period` quads, its inner radius growing by
// `growth` with every quad. With growth 0 and n > period it overlaps itself where it comes round,
// though nothing is wrong locally.
TriangleMesh spiral_strip(Index n, Index period, double growth);

// Segments with marker 1 on all edges with one triangle.
void add_boundary_segments(TriangleMesh& mesh);

// Clean, constrained Delaunay meshes of all these kinds, and real ones where they are found.
std::vector<NamedMesh> clean_meshes();

}  // namespace wellspaced::test
