#include "wellspaced/algorithms/audit/boundary_distance.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced::audit {
namespace {

constexpr double kRelativeError = 1e-6;
constexpr double kNegligible = 0x1p-40;  // where the largest coordinate is about 1

Point2 middle(Point2 p, Point2 q) { return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2}; }

double distance_to(const Line& line, Point2 p) {
  const double dx = line[1].x - line[0].x, dy = line[1].y - line[0].y;
  const double length_sq = dx * dx + dy * dy;
  const double along = (p.x - line[0].x) * dx + (p.y - line[0].y) * dy;
  const double t = length_sq > 0 ? std::clamp(along / length_sq, 0.0, 1.0) : 0;
  return distance(p, {line[0].x + t * dx, line[0].y + t * dy});
}

double distance_to(const Box<2>& box, Point2 p) {
  return distance(
      p, {std::clamp(p.x, box.low[0], box.high[0]), std::clamp(p.y, box.low[1], box.high[1])});
}

// A set of lines that answers which is nearest.
class LineSet {
 public:
  explicit LineSet(std::span<const Line> lines) : lines_(lines), tree_(boxes_of(lines)) {}

  // guess: a line to beat, likely a near one.
  Index nearest(Point2 p, Index guess) const {
    Index best = guess;
    double least = distance_to(lines_[guess], p);
    tree_.search([&](const Box<2>& box) { return distance_to(box, p) < least; },
                 [&](Index i) {
                   const double d = distance_to(lines_[i], p);
                   if (d < least) least = d, best = i;
                   return true;
                 });
    return best;
  }
  double distance_from(Index line, Point2 p) const { return distance_to(lines_[line], p); }

 private:
  static std::vector<Box<2>> boxes_of(std::span<const Line> lines) {
    std::vector<Box<2>> boxes;
    for (const Line& line : lines) boxes.push_back(box_of(line[0], line[1]));
    return boxes;
  }

  std::span<const Line> lines_;
  BoxTree<2> tree_;
};

double largest_coordinate(std::span<const Line> lines) {
  double largest = 0;
  for (const Line& line : lines)
    for (const Point2 p : line) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

std::vector<Line> scaled(std::span<const Line> lines, double scale) {
  std::vector<Line> result(lines.begin(), lines.end());
  for (Line& line : result)
    for (Point2& p : line) p = {scale * p.x, scale * p.y};
  return result;
}

// The largest distance of a point of `from` from `to`; no coordinate is larger than about 1. The
// distance from one line is convex, so over a piece of a segment it is largest at an end: an upper
// bound on the distance from all. It exceeds the distance of the middle by half the piece at most,
// so pieces are not halved far below kNegligible.
double one_sided_distance(std::span<const Line> from, std::span<const Line> to) {
  const LineSet set(to);
  std::vector<Line> pieces;
  double largest = 0;
  Index near = 0;
  const auto distance_of = [&](Point2 p) {
    near = set.nearest(p, near);
    return set.distance_from(near, p);
  };
  for (const Line& line : from) {
    largest = std::max({largest, distance_of(line[0]), distance_of(line[1])});
    pieces.assign(1, line);
    while (!pieces.empty()) {
      const auto [p, q] = pieces.back();
      pieces.pop_back();
      const Point2 half = middle(p, q);
      largest = std::max(largest, distance_of(half));
      const double bound = std::max(set.distance_from(near, p), set.distance_from(near, q));
      if (bound <= largest + std::max(largest * kRelativeError, kNegligible)) continue;
      pieces.push_back({p, half});
      pieces.push_back({half, q});
    }
  }
  return largest;
}

}  // namespace

std::vector<Line> boundary_lines(const TriangleMesh& mesh) {
  const auto nodes = static_cast<Index>(mesh.points.size());
  const HalfEdges half_edges = pair_half_edges(mesh.triangles, mesh.segments, nodes);
  std::vector<Line> lines;
  for (Index h = 0; h < half_edges.twin.size(); ++h)
    if (half_edges.twin[h] == kNoIndex && half_edges.constrained[h] == 0)
      lines.push_back(
          {mesh.points[origin(mesh.triangles, h)], mesh.points[target(mesh.triangles, h)]});
  for (const Segment& s : mesh.segments) lines.push_back({mesh.points[s.a], mesh.points[s.b]});
  return lines;
}

double hausdorff_distance(std::span<const Line> a, std::span<const Line> b) {
  if (a.empty() != b.empty()) return kInfinity;
  if (a.empty()) return 0;
  const double largest = std::max(largest_coordinate(a), largest_coordinate(b));
  if (largest == 0) return 0;
  const double scale = scale_to_one(largest);
  const std::vector<Line> p = scaled(a, scale), q = scaled(b, scale);
  return std::max(one_sided_distance(p, q), one_sided_distance(q, p)) / scale;
}

}  // namespace wellspaced::audit
