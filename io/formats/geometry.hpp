// What a geometry file holds, whatever its format.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Rows of real numbers that go with points, triangles or tetrahedra.
struct Attributes {
  Index columns = 0;
  std::vector<double> values;  ///< row by row
};

/// What a file calls the elements of one dimension that have a marker: Gmsh's physical groups,
/// SU2's boundaries.
struct MarkerName {
  int dimension = 0;
  int marker = 0;
  std::string name;
  friend bool operator==(const MarkerName&, const MarkerName&) = default;
};

/// Points, and what joins them: a point set, a domain (a planar straight-line graph or a piecewise
/// linear system) or a mesh.
///
/// dimension 2: everything is in `mesh`, `holes` and `regions`.
/// dimension 3: in `solid`, `polygons`, `volume_holes` and `volume_regions`. Facets that are
///   triangles, as of a mesh or a triangulated surface, are in solid.facets; if a single one is
///   not, all are in `polygons` instead, in the order of the file.
/// A mesh is not checked beyond index ranges and finite coordinates: prepare_mesh() does the rest.
struct Geometry {
  int dimension = 2;
  TriangleMesh mesh;
  TetMesh solid;
  std::vector<Point2> holes;
  std::vector<Pslg::Region> regions;
  std::vector<Pls::Facet> polygons;
  std::vector<Point3> volume_holes;
  std::vector<Pls::Region> volume_regions;
  Attributes point_attributes;
  Attributes cell_attributes;  ///< of the triangles (in the plane) or tetrahedra
  std::vector<MarkerName> marker_names;
  Index index_base = 0;            ///< the number of the first point in the file, and of all else
  std::vector<std::string> notes;  ///< what a user should know: one line each
  /// One line without markup that goes into the files as a comment: Triangle's, VTU, VTK, Gmsh,
  /// Medit, MFEM, SU2, OFF, OBJ. Other formats have no place for it; readers skip comments.
  std::string remark;

  // Compiled once, not wherever a reader or a command may end.
  Geometry();
  Geometry(const Geometry&);
  Geometry(Geometry&&) noexcept;
  Geometry& operator=(const Geometry&);
  Geometry& operator=(Geometry&&) noexcept;
  ~Geometry();

  std::size_t point_count() const {
    return dimension == 2 ? mesh.points.size() : solid.points.size();
  }
  bool has_cells() const { return !mesh.triangles.empty() || !solid.tets.empty(); }
  bool has_facets() const { return !solid.facets.empty() || !polygons.empty(); }
  const std::vector<int>& point_markers() const {
    return dimension == 2 ? mesh.point_markers : solid.point_markers;
  }
};

// Most formats know points in space only, and elements of all dimensions over them. Their readers
// fill `solid` and `polygons`, then lay flat what lies in the plane; their writers lift it.

/// Adds a facet that may have any number of corners.
void add_facet(Geometry& geometry, Pls::Facet facet);

/// Turns a geometry in space without tetrahedra and polygons whose points all have z = 0 into one
/// in the plane: its facets become triangles. Leaves any other as it is.
void lay_in_plane(Geometry& geometry);

/// The geometry as one of dimension 3: triangles in the plane become facets with z = 0. What only
/// a domain in the plane has (holes, regions) is left out.
Geometry lift_to_space(Geometry geometry);

/// kUsage if the geometry has facets that are no triangles, for formats without a place for them;
/// `what` names the format: "an STL file".
Status refuse_polygons(const Geometry& geometry, const std::string& path, const std::string& what);

/// `markers`, or nothing where all are 0.
std::vector<int> without_zeros(std::vector<int> markers);
/// The distinct markers of `elements`, ascending.
template <class Element>
std::vector<int> distinct_markers(const std::vector<Element>& elements) {
  std::set<int> markers;
  for (const Element& element : elements) markers.insert(element.marker);
  return {markers.begin(), markers.end()};
}

/// The markers of the triangles or tetrahedra: the only column of cell_attributes, if it holds
/// nothing but ints; else zeros.
std::vector<int> cell_markers(const Geometry& geometry);
/// Makes `markers` the only column of cell_attributes; none where all are 0.
void set_cell_markers(Geometry& geometry, const std::vector<int>& markers);

/// The name of the elements of that dimension and marker, or the marker's digits.
std::string marker_name(const Geometry& geometry, int dimension, int marker);

/// Gives markers to names, for formats that have only names: a name that is a number of 32 bits
/// keeps it, unless another name came to have it; others are numbered from 1 in the order of their
/// appearance.
class MarkerNumbering {
 public:
  /// The names go into geometry.marker_names, as of that dimension.
  MarkerNumbering(Geometry& geometry, int dimension) : geometry_(geometry), dimension_(dimension) {}
  int marker_of(std::string_view name);

 private:
  Geometry& geometry_;
  int dimension_;
  int next_ = 1;
  std::map<std::string, int, std::less<>> known_;
  std::set<int> used_;
};

}  // namespace wellspaced
