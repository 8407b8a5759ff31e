#include "wellspaced/algorithms/packing/boundary_packing.hpp"

#include <algorithm>

#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

constexpr double kCosineOf30Degrees = 0.86602540378443864676;

Error no_room_beside(const Segment& s) {
  return {ErrorCode::kInvalidGeometry,
          {"the local feature size vanishes between points ", s.a, " and ", s.b,
           ": features of the domain are closer there than doubles can tell apart"},
          {s.a, s.b}};
}

}  // namespace

BoundaryPacking::BoundaryPacking(const PlanarTriangulation& graph, const PackingOptions& options)
    : options_(options) {
  boundary_.points = graph.delaunay.points();
  boundary_.segments = graph.segments;
  parts_.resize(graph.segments.size());
  shell_.resize(graph.segments.size(), {kNoIndex, kNoIndex});
}

Index BoundaryPacking::segment_between(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  const auto found = std::partition_point(
      boundary_.segments.begin(), boundary_.segments.end(),
      [&, l = low, h = high](const Segment& s) { return s.a < l || (s.a == l && s.b < h); });
  return static_cast<Index>(found - boundary_.segments.begin());
}

// The point at which the shell of radius `reach` around the apex meets the segment to `neighbour`.
Index BoundaryPacking::put_shell(Index apex, Index neighbour, double reach) {
  const Index s = segment_between(apex, neighbour);
  const Segment& segment = boundary_.segments[s];
  const int end = segment.a == apex ? 0 : 1;
  if (shell_[s][end] != kNoIndex) return shell_[s][end];
  const double fraction =
      reach / distance(boundary_.points[segment.a], boundary_.points[segment.b]);
  (end == 0 ? parts_[s].from : parts_[s].to) = end == 0 ? fraction : 1 - fraction;
  shell_[s][end] = static_cast<Index>(boundary_.points.size());
  boundary_.points.push_back(part_of(s).at(parts_[s][end]));
  boundary_.pieces.push_back({apex, shell_[s][end], s, true});
  return shell_[s][end];
}

// The radius of a shell is half the distance to the nearest feature that does not touch the apex,
// or less where the size is small.
void BoundaryPacking::cut_corners(const std::vector<Corner>& corners, const LocalFeatureSize& lfs) {
  for (const Corner& corner : corners) {
    if (boundary_.sharp.empty() || boundary_.sharp.back() != corner.apex)
      boundary_.sharp.push_back(corner.apex);
    if (corner.cosine <= kCosineOf30Degrees) continue;
    const Point2 apex = boundary_.points[corner.apex];
    double reach = lfs.at(apex) / 2;
    if (options_.size) reach = std::min(reach, options_.size(apex));
    const Index right = put_shell(corner.apex, corner.right, reach);
    const Index left = put_shell(corner.apex, corner.left, reach);
    boundary_.pieces.push_back({right, left, kNoIndex, true});
  }
}

Pslg BoundaryPacking::lopped() const {
  Pslg graph;
  graph.points = boundary_.points;
  for (const BoundaryPiece& piece : boundary_.pieces) graph.segments.push_back({piece.a, piece.b});
  for (Index s = 0; s < parts_.size(); ++s) {
    const Segment& segment = boundary_.segments[s];
    graph.segments.push_back({shell_[s][0] != kNoIndex ? shell_[s][0] : segment.a,
                              shell_[s][1] != kNoIndex ? shell_[s][1] : segment.b});
  }
  return graph;
}

// A radius that is none ends the packing of a segment.
Status BoundaryPacking::pack(const BallRadius& radius, ProgressMeter& meter) {
  const BallRadius asking = [&](Point2 p) { return meter.step() ? radius(p) : 0; };
  for (Index s = 0; s < parts_.size(); ++s) {
    const std::size_t room =
        options_.max_points - std::min(options_.max_points, boundary_.points.size());
    auto points = pack_segment(part_of(s), asking, room);
    if (meter.stopped()) return cancelled();
    if (!points && points.error().code != ErrorCode::kLimit)
      return options_.size ? points.error() : no_room_beside(boundary_.segments[s]);
    if (!points || points->size() > room) points = std::vector<Point2>(), is_complete_ = false;
    const Segment& segment = boundary_.segments[s];
    Index last = shell_[s][0] != kNoIndex ? shell_[s][0] : segment.a;
    for (const Point2 p : *points) {
      const Index next = static_cast<Index>(boundary_.points.size());
      boundary_.points.push_back(p);
      boundary_.pieces.push_back({last, next, s});
      last = next;
    }
    boundary_.pieces.push_back({last, shell_[s][1] != kNoIndex ? shell_[s][1] : segment.b, s});
  }
  return Ok{};
}

}  // namespace wellspaced
