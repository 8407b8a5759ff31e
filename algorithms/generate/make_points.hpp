// Points that a rule makes one by one.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

namespace wellspaced {

/// make_point(0), ..., make_point(count - 1), called in this order.
template <class MakePoint>
std::vector<std::invoke_result_t<MakePoint, std::size_t>> make_points(std::size_t count,
                                                                      MakePoint make_point) {
  std::vector<std::invoke_result_t<MakePoint, std::size_t>> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) points.push_back(make_point(i));
  return points;
}

}  // namespace wellspaced
