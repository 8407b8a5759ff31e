// A domain in space, closed up: its polytopes of dimension 0, 1 and 2, and what contains what.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "wellspaced/algorithms/packing/coplanar_facets.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/space/plane_frame.hpp"

namespace wellspaced {

/// The polytopes of a piecewise linear system (Definition 4.2.1) but for the solids.
///
/// Facets need not be convex, nor need solids: nothing is cut, and no face is added. Where the
/// thesis needs convex faces, a facet that is not convex counts as the triangles that cover it
/// (FeatureSize3); solids need not be convex at all, for one Delaunay triangulation holds them all,
/// and what is near a face is known from every side.
///
/// points: the domain's, in order. is_vertex: 0 for points that are none: those that coincide with
///   others, and those inside merged facets that nothing names.
/// segments: each once, a < b, ascending: the edges of facets and the domain's own segments, whose
///   markers they have.
struct PolyhedralComplex {
  /// source: the lowest facet of the domain that it is made of. points, segments: those in it, on
  /// its edges and inside, ascending. triangles: which cover it, of its points, all turning alike.
  struct Facet {
    Index source = 0;
    int marker = 0;
    PlaneFrame frame;
    std::vector<Index> points, segments;
    std::vector<std::array<Index, 3>> triangles;
    bool is_convex = true;
  };
  std::vector<Point3> points;
  std::vector<std::uint8_t> is_vertex;
  std::vector<Segment> segments;
  std::vector<Facet> facets;
  std::vector<std::string> notes;  ///< what a user should know, one line each
};

/// Makes coincident points one, merges coplanar facets and triangulates each in its plane.
///
/// Errors: kInvalidGeometry for a coordinate that is not finite (ids: points, facets), a number
///   that names no point (ids: facets or segments), a facet that is not flat, encloses nothing, or
///   whose edges cross (ids: facets); those of merge_coplanar_facets.
/// Requires: 0 <= flatness < 1. Cost: O(n log n).
Result<PolyhedralComplex> build_complex(const Pls& domain, double flatness = kFlatness,
                                        const Progress& progress = {});

}  // namespace wellspaced
