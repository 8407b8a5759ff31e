// The order in which points are inserted: biased randomized rounds, each along a Hilbert curve.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The most points that can be ordered, and so triangulated.
inline constexpr std::size_t kMaxOrderedPoints = std::size_t{1} << 28;

/// The point numbers along a Hilbert curve through the points' bounding square or cube.
///
/// Neighbours in the order are near each other, whatever the density: crowded cells are refined
/// with a curve of their own.
/// Requires: at most kMaxOrderedPoints points, all finite.
/// Degenerate: equal points keep their input order.
/// Cost: O(n) time but for crowded cells (O(n) a further factor 2^16 of scale, 2^10 in
/// space), 16 bytes a point.
std::vector<Index> hilbert_order(std::span<const Point2> points);
std::vector<Index> hilbert_order(std::span<const Point3> points);

/// The point numbers in a biased randomized insertion order: each round holds about seven times as
/// many points as all rounds before it (in space: three times), and runs along a Hilbert curve. The
/// rounds bound the expected number of structural changes for every input, however adversarial; the
/// curve keeps the walk to the next point short. The rounds are drawn by a hash of the point's
/// number, so the order depends on the input alone. See: Amenta, Choi and Rote, Incremental
/// constructions con BRIO (2003).
std::vector<Index> insertion_order(std::span<const Point2> points);
std::vector<Index> insertion_order(std::span<const Point3> points);

/// The same rounds for points of the plane that were brought into order along a curve before:
/// along_curve holds each point number once. Cost: linear, with no sort.
std::vector<Index> insertion_order(std::span<const Index> along_curve);

/// An insertion order whose rounds are cut into runs, one for each of several regions of space. The
/// regions are the same in all rounds: stretches of the curve that hold about as many points of the
/// last round each.
struct InsertionRuns {
  unsigned regions = 1;
  std::vector<Index> order;
  /// Where in the order runs end, those of the first round first; the first begins at 0.
  std::vector<Index> ends;
};

/// insertion_order, cut up. Requires: regions > 0.
/// Degenerate: where points are crowded beyond what the curve's grid resolves, runs may be empty.
InsertionRuns insertion_runs(std::span<const Point3> points, unsigned regions);

/// The same in the plane, sorted in memory that the caller needs later: 16 bytes a point, aligned
/// as a double. What they hold is overwritten.
InsertionRuns insertion_runs(std::span<const Point2> points, unsigned regions,
                             std::span<std::byte> memory);

}  // namespace wellspaced
