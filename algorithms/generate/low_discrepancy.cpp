#include "wellspaced/algorithms/generate/low_discrepancy.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/algorithms/generate/make_points.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// The sides that boxes need be tried with: the coordinates of points, and 1.
std::vector<double> sides(std::span<const Point2> points, double Point2::*coordinate) {
  std::vector<double> values = {1};
  for (const Point2& p : points) values.push_back(p.*coordinate);
  sort_unique(values);
  return values;
}

// The largest difference over the boxes of width u. below: for each height the number of points on
// it left of the box's right side; up_to: also those on that side.
double largest_difference(double u, std::span<const double> heights,
                          std::span<const std::size_t> below, std::span<const std::size_t> up_to,
                          double count) {
  double largest = 0;
  std::size_t open = 0, closed = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double area = u * heights[i];
    closed += up_to[i];
    largest = std::fmax(largest, area - static_cast<double>(open) / count);
    largest = std::fmax(largest, static_cast<double>(closed) / count - area);
    open += below[i];
  }
  return largest;
}

}  // namespace

double radical_inverse(std::size_t n, std::size_t base) {
  std::size_t mirrored = 0, power = 1;
  for (; n > 0; n /= base) {
    mirrored = mirrored * base + n % base;
    power *= base;
  }
  return static_cast<double>(mirrored) / static_cast<double>(power);
}

std::vector<Point2> hammersley_points(std::size_t count, const Progress& progress) {
  return make_points(count, progress, [&](std::size_t n) {
    return Point2{radical_inverse(n, 2), static_cast<double>(n) / static_cast<double>(count)};
  });
}

std::vector<Point2> halton_points(std::size_t count, const Progress& progress) {
  return make_points(count, progress, [](std::size_t n) {
    return Point2{radical_inverse(n, 2), radical_inverse(n, 3)};
  });
}

double star_discrepancy(std::span<const Point2> points) {
  if (points.empty()) return 1;
  const std::vector<double> widths = sides(points, &Point2::x), heights = sides(points, &Point2::y);
  std::vector<Point2> by_x(points.begin(), points.end());
  std::ranges::sort(by_x);
  std::vector<std::size_t> below(heights.size()), up_to(heights.size());
  const auto count = static_cast<double>(points.size());
  double largest = 0;
  auto next = by_x.begin();
  for (const double u : widths) {
    for (; next != by_x.end() && next->x <= u; ++next)
      ++up_to[static_cast<std::size_t>(std::ranges::lower_bound(heights, next->y) -
                                       heights.begin())];
    largest = std::fmax(largest, largest_difference(u, heights, below, up_to, count));
    below = up_to;
  }
  return largest;
}

}  // namespace wellspaced
