// The facets of a domain in space, each as large as it can be.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Points whose distance from a plane is at most this part of their extent (the diagonal of their
/// bounding box) count as points of it. In doubles, points of a plane in general position are
/// rounded off it by about 2^-52 of their coordinates; files with seven digits need 1e-6.
inline constexpr double kFlatness = 1e-6;

struct MergedFacets {
  /// The points and all else as before, but for the facets.
  Pls domain;
  /// For each facet of the input, the facet of `domain` that it became a part of.
  std::vector<Index> merged_into;
  /// Points of facets of the input that nothing in `domain` names any more; ascending.
  std::vector<Index> freed_points;
  /// The largest distance of a point from the plane of its facet, as a part of the facet's extent.
  double flatness = 0;
};

/// Joins facets in one plane, as the triangles of a surface are, into one facet each: the facets of
/// a piecewise linear system (Definition 4.2.1).
///
/// Two facets are joined across an edge if nothing else has the edge, no further facet and no
/// segment; they have one polygon each, no holes, and equal markers; they lie on different sides of
/// the edge, and together in one plane to within `flatness`. In which direction the corners of a
/// facet turn does not matter. What others have in common with the inside of a facet stays in it,
/// as polygons of two points and of one: edges between joined facets that others share, and points
/// that others use or that have a marker. The planes are those of the largest facets, so gentle
/// bends do not add up.
/// Requires: indices in range; 0 <= flatness < 1.
/// Errors: kInvalidGeometry for a facet that is not flat, encloses no area or has coordinates too
/// large to compute with (ids: the facets of that kind).
/// Cost: O(n log n) for n corners.
/// See: section 4.2.
Result<MergedFacets> merge_coplanar_facets(const Pls& domain, double flatness = kFlatness);

}  // namespace wellspaced
