// The edge length function el of a mesh (Definition 2.1.2).
#pragma once

#include <vector>

#include "wellspaced/algorithms/mesh/triangle_locator.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// el_M at the nodes: the longest edge of all triangles around each; 0 at a node in no triangle.
/// Not Lipschitz. Requires: triangle indices in range. Cost: linear.
std::vector<double> edge_length_spacing(const TriangleMesh& mesh);

/// el_M: at a place the longest edge of all triangles that contain it. Inside a triangle there is
/// one, on edges and at nodes there are several; so it jumps, and is not Lipschitz.
class EdgeLengthFunction {
 public:
  /// Requires: the mesh outlives the function; counter-clockwise triangles, indices in range.
  /// Cost: O(n log n).
  explicit EdgeLengthFunction(const TriangleMesh& mesh);

  /// el(x), exactly that of the triangles that hold x; 0 outside of all. Cost: TriangleLocator's.
  double operator()(Point2 x) const;

 private:
  const TriangleMesh& mesh_;
  TriangleLocator locator_;
};

}  // namespace wellspaced
