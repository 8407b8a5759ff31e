// A program of a user who has the kernel as two files.
#include "wellspaced_kernel.hpp"

#include <cstdio>

using namespace wellspaced;

namespace {

// Sixteen points on a circle: every triangulation is Delaunay, and every in-circle test a tie.
std::vector<Point2> cocircular() {
  std::vector<Point2> points;
  for (const auto& [x, y] : {Point2{16, 63}, Point2{33, 56}, Point2{39, 52}, Point2{63, 16}})
    for (const double sx : {-x, x})
      for (const double sy : {-y, y}) points.push_back({sx, sy});
  return points;
}

bool signs_are_exact() {
  const Point2 a{0, 0}, b{3, 3}, c{1, 0x1.0000000000001p0};  // by one unit in the last place
  return orient2d(a, b, c) != 0 && orient2d(a, b, c) == orient2d(b, c, a) &&
         orient2d(a, c, b) == -orient2d(a, b, c) &&
         orient2d(Point2{0, 0}, Point2{1, 0}, Point2{0.5, 5e-324}) == 1 &&
         incircle({16, 63}, {-16, 63}, {-63, -16}, {63, 16}) == 0;
}

}  // namespace

int main() {
  if (!signs_are_exact()) return std::puts("a sign is wrong"), 1;
  const auto plane = Delaunay2::build(cocircular());
  if (!plane || plane->topology().size() != 14 + 16) return std::puts("the plane is wrong"), 1;
  std::vector<Point3> cube;
  for (int i = 0; i < 27; ++i) cube.push_back({double(i % 3), double(i / 3 % 3), double(i / 9)});
  const auto space = Delaunay3::build(cube);
  if (!space || real_tets(*space).size() < 8 * 5) return std::puts("space is wrong"), 1;
  Pslg crossing;
  crossing.points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}};
  crossing.segments = {{0, 1, 1}, {2, 3, 2}};
  const auto split = triangulate(crossing, {.holes = HoleRule::kNone, .progress = {}});
  if (!split || split->added_points != 1) return std::puts("the crossing is wrong"), 1;
  return 0;
}
