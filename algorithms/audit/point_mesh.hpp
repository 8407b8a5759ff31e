// A mesh of a point set, for auditors that want to know the domain.
#pragma once

#include <span>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::audit {

/// The constrained Delaunay triangulation of points in a domain; its nodes are the points. Without
/// a domain (null) that of their convex hull. Points beside a segment by no more than rounding (2
/// units in the last place) lie on it. Holes are the regions with a seed where the domain
/// has any, else by parity.
/// progress: the phases of triangulate().
/// Errors: those of triangulate(); kInvalidGeometry where points of the domain are not among the
///   points, or its segments cross elsewhere (ids: points of the domain).
Result<TriangleMesh> mesh_of_points(std::span<const Point2> points, const Pslg* domain,
                                    const Progress& progress = {});

/// The Delaunay tetrahedralization of points. progress, errors: those of Delaunay3::build().
Result<TetMesh> mesh_of_points(std::span<const Point3> points, const Progress& progress = {});

}  // namespace wellspaced::audit
