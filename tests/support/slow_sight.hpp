// Lines of sight by brute force: what the closed triangles cover of a segment.
#pragma once

#include <algorithm>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

struct SegmentPart {
  double low, high;
};

/// The part of the segment from p to q inside a closed triangle.
inline SegmentPart part_inside(const TriangleMesh& mesh, Index t, Point2 p, Point2 q) {
  SegmentPart part{0, 1};
  for (int i = 0; i < 3; ++i) {
    const Point2 a = mesh.points[mesh.triangles[t][i]],
                 b = mesh.points[mesh.triangles[t][(i + 1) % 3]];
    const auto side = [&](Point2 x) {
      return (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x);
    };
    const double at_p = side(p), at_q = side(q);
    if (at_p < 0 && at_q < 0) return {1, 0};
    if (at_p < 0 && at_q >= 0) part.low = std::max(part.low, at_p / (at_p - at_q));
    if (at_p >= 0 && at_q < 0) part.high = std::min(part.high, at_p / (at_p - at_q));
  }
  return part;
}

/// Whether the triangles cover the segment. Requires: small whole coordinates; there no gap is below
/// 1e-6. Knows of no slits.
inline bool slow_sees(const TriangleMesh& mesh, Point2 p, Point2 q) {
  std::vector<SegmentPart> parts;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const SegmentPart part = part_inside(mesh, t, p, q);
    if (part.low <= part.high) parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end(), [](SegmentPart a, SegmentPart b) { return a.low < b.low; });
  double covered = 0;
  bool starts = false;
  for (const SegmentPart part : parts) {
    if (part.low > covered + 1e-9) return false;
    starts = starts || part.low == 0;
    covered = std::max(covered, part.high);
  }
  return starts && covered > 1 - 1e-9;
}

}  // namespace wellspaced::test
