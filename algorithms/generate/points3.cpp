#include "wellspaced/algorithms/generate/points3.hpp"

#include <cmath>

#include "wellspaced/algorithms/generate/make_points.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {

// Braces fix the order of the draws; a function's arguments would leave it to the compiler.
std::vector<Point3> box_points3(std::size_t count, std::uint64_t seed, const Progress& progress) {
  Random random(seed);
  return make_points(count, progress, [&](std::size_t) {
    return Point3{random.uniform(), random.uniform(), random.uniform()};
  });
}

std::vector<Point3> lattice_points3(std::size_t nx, std::size_t ny, std::size_t nz,
                                    const Progress& progress) {
  return make_points(nx * ny * nz, progress, [=](std::size_t i) {
    return Point3{static_cast<double>(i / nz / ny), static_cast<double>(i / nz % ny),
                  static_cast<double>(i % nz)};
  });
}

// A cylinder around the sphere has its area, slice by slice (Archimedes).
std::vector<Point3> sphere_points3(std::size_t count, std::uint64_t seed,
                                   const Progress& progress) {
  Random random(seed);
  return make_points(count, progress, [&](std::size_t) {
    const double z = random.uniform(-1, 1), r = std::sqrt(1 - z * z);
    const Point2 turn = circle_point(random.uniform());
    return Point3{r * turn.x, r * turn.y, z};
  });
}

std::vector<Point3> moment_points3(std::size_t count, const Progress& progress) {
  return make_points(count, progress, [=](std::size_t i) {
    const double t = static_cast<double>(i) - static_cast<double>(count / 2);
    return Point3{t, t * t, t * t * t};
  });
}

std::vector<Point3> line_points3(std::size_t count, const Progress& progress) {
  return make_points(2 * count, progress, [=](std::size_t i) {
    return i < count ? Point3{static_cast<double>(i), 0, 0}
                     : Point3{0, static_cast<double>(i - count), 1};
  });
}

std::vector<Point3> helix_points3(std::size_t count, double per_turn, double rise,
                                  const Progress& progress) {
  return make_points(count, progress, [=](std::size_t i) {
    const double turns = static_cast<double>(i) / per_turn;
    const Point2 at = circle_point(turns);
    return Point3{at.x, at.y, rise * turns};
  });
}

void shuffle_points(std::vector<Point3>& points, std::uint64_t seed, const Progress& progress) {
  shuffle(points, seed, progress);
}

}  // namespace wellspaced
