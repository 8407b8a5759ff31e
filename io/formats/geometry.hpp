// What a geometry file holds, whatever its format.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Rows of real numbers that go with points, triangles or tetrahedra.
struct Attributes {
  Index columns = 0;
  std::vector<double> values;  ///< row by row
};

/// Points, and what joins them: a point set, a planar straight-line graph or a mesh.
///
/// dimension 2: everything is in `mesh`, `holes` and `regions`. dimension 3: in `solid`.
/// A mesh is not checked beyond index ranges and finite coordinates: prepare_mesh() does the rest.
struct Geometry {
  int dimension = 2;
  TriangleMesh mesh;
  TetMesh solid;
  std::vector<Point2> holes;
  std::vector<Pslg::Region> regions;
  Attributes point_attributes;
  Attributes cell_attributes;      ///< of the triangles or tetrahedra
  Index index_base = 0;            ///< the number of the first point in the file, and of all else
  std::vector<std::string> notes;  ///< what a user should know: one line each

  std::size_t point_count() const {
    return dimension == 2 ? mesh.points.size() : solid.points.size();
  }
  bool has_cells() const { return !mesh.triangles.empty() || !solid.tets.empty(); }
  const std::vector<int>& point_markers() const {
    return dimension == 2 ? mesh.point_markers : solid.point_markers;
  }
};

}  // namespace wellspaced
