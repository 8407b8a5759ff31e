// The boundary of a domain while it is packed: its vertices, then shells around its sharp corners,
// then its segments.
#pragma once

#include <array>
#include <vector>

#include "wellspaced/algorithms/packing/corner_shells.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/algorithms/packing/packed_boundary.hpp"
#include "wellspaced/algorithms/packing/segment_packing.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The first steps of pack_domain, in this order: cut_corners(), then pack().
class BoundaryPacking {
 public:
  /// Requires: the options outlive it.
  BoundaryPacking(const PlanarTriangulation& graph, const PackingOptions& options);

  /// Puts a shell around the apex of each corner below 30 degrees, and notes the others.
  /// corners: the sharp ones, by apex. lfs: the domain's.
  void cut_corners(const std::vector<Corner>& corners, const LocalFeatureSize& lfs);
  /// What is left of the domain, whose local feature size the balls follow.
  Pslg lopped() const;
  /// Packs the segments, or what shells leave of them. meter: asked at every radius.
  /// Errors: kUsage where a size is not positive; kInvalidGeometry where the local feature size is
  /// not; kCancelled.
  Status pack(const BallRadius& radius, ProgressMeter& meter);
  const PackedBoundary& boundary() const { return boundary_; }
  /// Whether no segment needed more points than the limit allows.
  bool is_complete() const { return is_complete_; }

 private:
  Index put_shell(Index apex, Index neighbour, double reach);
  Index segment_between(Index a, Index b) const;
  SegmentPart part_of(Index s) const {
    const Segment& segment = boundary_.segments[s];
    return {boundary_.points[segment.a], boundary_.points[segment.b], parts_[s][0], parts_[s][1]};
  }

  const PackingOptions& options_;
  PackedBoundary boundary_;
  // For each segment what is left between its shells, as fractions, and the points there.
  struct Fractions {
    double from = 0, to = 1;
    double operator[](int end) const { return end == 0 ? from : to; }
  };
  std::vector<Fractions> parts_;
  std::vector<std::array<Index, 2>> shell_;
  bool is_complete_ = true;
};

}  // namespace wellspaced
