// Points that a rule makes one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {

/// make_point(0), ..., make_point(count - 1), called in this order; fewer if told to stop (phase
/// "generate").
template <class MakePoint>
std::vector<std::invoke_result_t<MakePoint, std::size_t>> make_points(std::size_t count,
                                                                      const Progress& progress,
                                                                      MakePoint make_point) {
  std::vector<std::invoke_result_t<MakePoint, std::size_t>> points;
  points.reserve(count);
  ProgressMeter meter(progress, "generate", count);
  for (std::size_t i = 0; i < count && meter.step(); ++i) points.push_back(make_point(i));
  return points;
}

/// Puts the points into random order, unless told to stop (phase "shuffle").
template <class Point>
void shuffle(std::vector<Point>& points, std::uint64_t seed, const Progress& progress) {
  Random random(seed);
  ProgressMeter meter(progress, "shuffle", points.size());
  for (std::size_t left = points.size(); left > 1 && meter.step(); --left)
    std::swap(points[left - 1], points[random.below(left)]);
}

}  // namespace wellspaced
