#include "wellspaced/algorithms/mesh/delaunay_cells.hpp"

#include <gtest/gtest.h>

#include "wellspaced/kernel/sha256.hpp"

namespace wellspaced {
namespace {

using Cells = std::vector<std::vector<Index>>;
using Triangles = std::vector<std::array<Index, 3>>;

const std::vector<Point2> kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(DelaunayCells, MergesTrianglesOnOneCircleWhicheverWayTheyAreCut) {
  EXPECT_EQ(delaunay_cells(kSquare, Triangles{{0, 1, 2}, {0, 2, 3}}, {}), (Cells{{0, 1, 2, 3}}));
  EXPECT_EQ(delaunay_cells(kSquare, Triangles{{0, 1, 3}, {1, 2, 3}}, {}), (Cells{{0, 1, 2, 3}}));
}

TEST(DelaunayCells, KeepsTrianglesApartThatMissTheCircleByOneUlp) {
  std::vector<Point2> points = kSquare;
  points[2].x = 1 + 0x1p-52;
  EXPECT_EQ(delaunay_cells(points, Triangles{{0, 1, 3}, {1, 2, 3}}, {}),
            (Cells{{0, 1, 3}, {1, 2, 3}}));
}

TEST(DelaunayCells, DoesNotMergeAcrossSegments) {
  const std::vector<Segment> segments = {{2, 0, 0}};
  EXPECT_EQ(delaunay_cells(kSquare, Triangles{{0, 1, 2}, {0, 2, 3}}, segments),
            (Cells{{0, 1, 2}, {0, 2, 3}}));
}

TEST(DelaunayCells, MergesAWholeFan) {
  // Eight points of the circle of radius sqrt(65), which all are integers.
  const std::vector<Point2> points = {{8, 1}, {7, 4}, {4, 7}, {1, 8}, {-1, 8}, {-4, 7}, {-7, 4}};
  Triangles fan;
  for (Index i = 1; i + 1 < points.size(); ++i) fan.push_back({0, i, i + 1});
  EXPECT_EQ(delaunay_cells(points, fan, {}), (Cells{{0, 1, 2, 3, 4, 5, 6}}));
}

TEST(CellsSha256, HashesTheCanonicalText) {
  EXPECT_EQ(cells_sha256(kSquare, {{0, 1, 2, 3}}), sha256("0 1 2 3"));
  // In lexicographic order the corners are 0, 3, 1, 2.
  EXPECT_EQ(cells_sha256(kSquare, {{0, 1, 2}, {0, 2, 3}}), sha256("0 1 3\n0 2 3"));
  EXPECT_EQ(cells_sha256(kSquare, {}), sha256(""));
}

TEST(CellsSha256, SortsCellsAsNumbersNotAsText) {
  std::vector<Point2> points;
  for (int i = 0; i < 12; ++i) points.push_back({static_cast<double>(i), 0});
  EXPECT_EQ(cells_sha256(points, {{10, 11, 2}, {9, 3, 4}, {2, 3, 9}}),
            sha256("2 3 9\n2 10 11\n3 4 9"));
}

TEST(CellsSha256, DoesNotDependOnNumberingDuplicatesOrTheSignOfZero) {
  const std::string expected = cells_sha256(kSquare, {{0, 1, 2, 3}});
  const std::vector<Point2> shuffled = {{1, 1}, {0, 1}, {-0.0, 0}, {1, 0}, {1, 1}};
  EXPECT_EQ(cells_sha256(shuffled, {{4, 1, 2, 3}}), expected);
  EXPECT_EQ(cells_sha256(shuffled, {{3, 0, 2, 1}}), expected);
}

TEST(CellsSha256, NumbersPointsOfSpaceLexicographically) {
  const std::vector<Point3> points = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {0, 0, -0.0}};
  EXPECT_EQ(cells_sha256(points, {{0, 1, 2, 3}, {0, 1, 2, 4}}), sha256("0 1 2 3\n0 1 2 3"));
}

}  // namespace
}  // namespace wellspaced
