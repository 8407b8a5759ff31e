#include "wellspaced/algorithms/generate/point_sets.hpp"

#include "wellspaced/algorithms/generate/make_points.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// Braces fix the order of the two draws; a function's arguments would leave it to the compiler.
Point2 point_in_unit_square(Random& random) { return Point2{random.uniform(), random.uniform()}; }

// Irwin-Hall: twelve uniform deviates have variance 1; no logarithm is needed.
double normal_deviate(Random& random) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

Point2 point_in_disc(double radius, Random& random) {
  for (;;) {  // ends with probability 1; each round succeeds with probability pi/4
    const Point2 p{random.uniform(-1, 1), random.uniform(-1, 1)};
    if (p.x * p.x + p.y * p.y <= 1) return {radius * p.x, radius * p.y};
  }
}

}  // namespace

std::vector<Point2> random_points(std::size_t count, std::uint64_t seed, const Progress& progress) {
  Random random(seed);
  return make_points(count, progress, [&](std::size_t) { return point_in_unit_square(random); });
}

std::vector<Point2> clustered_points(std::size_t count, std::size_t clusters, std::uint64_t seed,
                                     const Progress& progress) {
  constexpr double kDeviation = 0.01;
  Random random(seed);
  const auto centres =
      make_points(clusters, {}, [&](std::size_t) { return point_in_unit_square(random); });
  return make_points(count, progress, [&](std::size_t) {
    const Point2 centre = centres[random.below(clusters)];
    const Point2 offset{normal_deviate(random), normal_deviate(random)};
    return Point2{centre.x + kDeviation * offset.x, centre.y + kDeviation * offset.y};
  });
}

std::vector<Point2> circle_points(std::size_t on_circle, std::size_t inside, std::uint64_t seed,
                                  const Progress& progress) {
  constexpr double kInnerRadius = 0.999;
  Random random(seed);
  return make_points(on_circle + inside, progress, [&](std::size_t i) {
    return i < on_circle ? circle_point(random.uniform()) : point_in_disc(kInnerRadius, random);
  });
}

std::vector<Point2> spiral_points(std::size_t count, double octaves, const Progress& progress) {
  constexpr double kGoldenTurn = 0.38196601125010515;
  const double step = count > 1 ? octaves / static_cast<double>(count - 1) : 0;
  return make_points(count, progress, [&](std::size_t i) {
    const double radius = power_of_two(step * static_cast<double>(i));
    const Point2 direction = circle_point(kGoldenTurn * static_cast<double>(i));
    return Point2{radius * direction.x, radius * direction.y};
  });
}

std::vector<Point2> grid_points(std::size_t nx, std::size_t ny, const Progress& progress) {
  return make_points(nx * ny, progress, [&](std::size_t k) {
    return Point2{static_cast<double>(k % nx), static_cast<double>(k / nx)};
  });
}

std::vector<Point2> parabola_points(std::size_t count, const Progress& progress) {
  return make_points(count, progress, [&](std::size_t k) {
    const double i = static_cast<double>(k) - static_cast<double>(count / 2);
    return Point2{i, i * i};
  });
}

std::vector<Point2> collinear_points_and_one(std::size_t count, const Progress& progress) {
  auto points = make_points(count, progress, [](std::size_t k) {
    const double i = static_cast<double>(k);
    return Point2{i, 3 * i};
  });
  points.push_back({0, 1});
  return points;
}

std::vector<Point2> repeated_points(std::size_t count, std::size_t distinct, std::uint64_t seed,
                                    const Progress& progress) {
  Random random(seed);
  const auto originals =
      make_points(distinct, {}, [&](std::size_t) { return point_in_unit_square(random); });
  return make_points(count, progress,
                     [&](std::size_t) { return originals[random.below(distinct)]; });
}

void shuffle_points(std::vector<Point2>& points, std::uint64_t seed, const Progress& progress) {
  shuffle(points, seed, progress);
}

}  // namespace wellspaced
