#include "wellspaced/kernel/space/delaunay3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "tests/support/delaunay3_checks.hpp"
#include "tests/support/points3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

namespace wellspaced {
namespace {

using test::degenerate_sets3;
using test::expect_delaunay;

Delaunay3 built(const std::vector<Point3>& points) {
  auto result = Delaunay3::build(points);
  EXPECT_TRUE(result.ok());
  return result.ok() ? std::move(result).value() : Delaunay3();
}

std::set<std::vector<Index>> cell_set(const Delaunay3& d) {
  const auto cells = delaunay_cells(d);
  return {cells.begin(), cells.end()};
}

TEST(Delaunay3, IsDelaunayConvexAndCompleteForEveryDegenerateFamily) {
  for (const auto& [name, points] : degenerate_sets3()) {
    SCOPED_TRACE(name);
    const Delaunay3 d = built(points);
    ASSERT_EQ(d.dimension(), 3);
    expect_delaunay(d);
  }
}

TEST(Delaunay3, AgreesWithTheDefinitionOnSmallDegenerateSets) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t count = 4 + seed % 9;
    const std::vector<Point3> points = test::whole3(count, 2 + seed / 60, seed);
    const Delaunay3 d = built(points);
    if (d.dimension() < 3) continue;
    expect_delaunay(d, 0);
    EXPECT_EQ(cell_set(d), test::cells_by_definition(points));
  }
}

TEST(Delaunay3, CubeIsOneCellOfFiveOrSixTets) {
  const Delaunay3 d = built(test::lattice3(2, 2, 2));
  EXPECT_EQ(delaunay_cells(d).size(), 1u);
  const std::size_t tets = real_tets(d).size();
  EXPECT_TRUE(tets == 5 || tets == 6) << tets;
}

TEST(Delaunay3, SkewLinesGiveTheProductOfTheirSegments) {
  std::vector<Point3> points = test::skew_lines3(200);
  test::shuffle(points, 1);
  const Delaunay3 d = built(points);
  EXPECT_EQ(real_tets(d).size(), 39601u);
  test::expect_locally_delaunay(d);
}

TEST(Delaunay3, MomentCurveJoinsEveryTwoPoints) {
  const Delaunay3 d = built(test::moment_curve3(60));
  for (Index v = 0; v < 60; ++v) EXPECT_EQ(neighbors(d, v).size(), 59u);
}

TEST(Delaunay3, CellsDoNotDependOnTheOrderOfThePoints) {
  for (const auto& [name, points] : degenerate_sets3()) {
    SCOPED_TRACE(name);
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    Random random(11);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    std::vector<Point3> permuted;
    for (const Index i : order) permuted.push_back(points[i]);
    const Delaunay3 plain = built(points);
    std::set<std::vector<Index>> cells;
    for (std::vector<Index> cell : delaunay_cells(built(permuted))) {
      for (Index& v : cell) v = plain.representative(order[v]);
      std::sort(cell.begin(), cell.end());
      cells.insert(cell);
    }
    EXPECT_EQ(cells, cell_set(plain));
  }
}

TEST(Delaunay3, ScalingByAPowerOfTwoChangesNothing) {
  const std::vector<Point3> points = test::whole3(300, 12, 3);
  const auto tets = real_tets(built(points));
  for (const int k : {-1000, -300, -1, 1, 300, 1000})
    EXPECT_EQ(real_tets(built(test::scaled(points, std::ldexp(1.0, k)))), tets) << k;
}

TEST(Delaunay3, SamePointsGiveTheSameTets) {
  const std::vector<Point3> points = test::uniform3(2000, 5);
  EXPECT_EQ(real_tets(built(points)), real_tets(built(points)));
}

TEST(Delaunay3, DuplicatesStandForTheirLowestNumber) {
  std::vector<Point3> points = test::uniform3(50, 2);
  const std::size_t distinct = points.size();
  for (std::size_t i = 0; i < 3 * distinct; ++i) points.push_back(points[i % distinct]);
  points.push_back({0, 0, 0});
  points.push_back({-0.0, 0, -0.0});
  const Delaunay3 d = built(points);
  EXPECT_EQ(d.duplicate_count(), 3 * distinct + 1);
  for (Index i = 0; i < 4 * distinct; ++i) EXPECT_EQ(d.representative(i), i % distinct);
  EXPECT_EQ(d.representative(static_cast<Index>(4 * distinct + 1)), 4 * distinct);
  expect_delaunay(d);
}

TEST(Delaunay3, NoPointsHaveDimensionMinusOne) {
  const Delaunay3 d = built({});
  EXPECT_EQ(d.dimension(), -1);
  EXPECT_TRUE(d.topology().empty());
  EXPECT_TRUE(d.chain().empty());
}

TEST(Delaunay3, EqualPointsHaveDimensionZero) {
  const Delaunay3 d = built({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(d.dimension(), 0);
  EXPECT_EQ(d.chain(), std::vector<Index>{0});
  EXPECT_EQ(d.duplicate_count(), 2u);
  EXPECT_EQ(d.representative(2), 0u);
}

TEST(Delaunay3, CollinearPointsBecomeAChain) {
  std::vector<Point3> points;
  for (const double t : {3.0, 1.0, 2.0, 0.0, 1.0, -4.0}) points.push_back({t, 2 * t, -t});
  const Delaunay3 d = built(points);
  EXPECT_EQ(d.dimension(), 1);
  EXPECT_EQ(d.chain(), (std::vector<Index>{5, 3, 1, 2, 0}));
  EXPECT_EQ(d.representative(4), 1u);
}

// Exactly coplanar points of a tilted plane, and what must hold of their triangles.
TEST(Delaunay3, CoplanarPointsBecomeTheDelaunayTrianglesOfTheirPlane) {
  Random random(4);
  for (int axis = 0; axis < 4; ++axis) {
    std::vector<Point3> points;
    std::set<std::pair<double, double>> plane;
    for (int i = 0; i < 80; ++i) {
      const double u = static_cast<double>(random.below(12)),
                   v = static_cast<double>(random.below(12));
      plane.insert({u, v});
      points.push_back(axis == 0   ? Point3{5, u, v}
                       : axis == 1 ? Point3{u, 5, v}
                       : axis == 2 ? Point3{u, v, 5}
                                   : Point3{u + v, u - v, 7 * u + 3 * v});
    }
    const Delaunay3 d = built(points);
    ASSERT_EQ(d.dimension(), 2);
    EXPECT_TRUE(d.topology().empty());
    EXPECT_EQ(d.duplicate_count(), points.size() - plane.size());
    // Any point off the plane makes tets of the triangles; these must be locally Delaunay.
    const Point3 apex{0.5, 100, -300};
    std::set<int> turns;
    for (const auto& [a, b, c] : d.triangles()) {
      const int turn = orient3d(points[a], points[b], points[c], apex);
      turns.insert(turn);
      for (const Point3 p : points)
        EXPECT_LE(turn * insphere(points[a], points[b], points[c], apex, p), 0);
    }
    EXPECT_EQ(turns.size(), 1u);
    EXPECT_EQ(turns.count(0), 0u);
    EXPECT_EQ(d.triangles().size(), 2 * plane.size() - 2 - hull_vertices(d).size());
  }
}

TEST(Delaunay3, CoplanarPointsAtTheEndsOfTheRangeAreTriangulated) {
  for (const double size : {5e-324, 0x1p-1022, 0x1p1023}) {
    for (const double height : {0.0, size, -size, 1.0}) {
      const Delaunay3 d =
          built({{0, 0, height}, {size, 0, height}, {0, size, height}, {size, size, height}});
      EXPECT_EQ(d.dimension(), 2);
      EXPECT_EQ(d.triangles().size(), 2u);
    }
  }
}

TEST(Delaunay3, RefusesNumbersThatAreNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  const auto result = Delaunay3::build(std::vector<Point3>{{0, 0, 0}, {0, inf, 0}, {NAN, 1, 2}});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(result.error().ids, (std::vector<Index>{1, 2}));
}

TEST(Delaunay3, StopsAtTheLimitOfTets) {
  Delaunay3::Options options;
  options.max_tets = 1000;
  const auto result = Delaunay3::build(test::uniform3(1000, 1), options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kLimit);
}

TEST(Delaunay3, CanBeCancelled) {
  Delaunay3::Options options;
  options.progress = [](std::string_view, std::uint64_t, std::uint64_t) { return false; };
  const auto result = Delaunay3::build(test::uniform3(1000, 1), options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
}

// ---- Location ----------------------------------------------------------------------------------

TEST(Delaunay3, LocatesPointsInTetsFacetsEdgesVerticesAndOutside) {
  const Delaunay3 d = built({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  const auto place = [&](Point3 p) { return d.locate(p).place; };
  EXPECT_EQ(place({0.5, 0.5, 0.5}), Delaunay3::Place::kTet);
  EXPECT_EQ(place({1, 1, 0}), Delaunay3::Place::kFacet);
  EXPECT_EQ(place({1, 0, 0}), Delaunay3::Place::kEdge);
  EXPECT_EQ(place({0, 4, 0}), Delaunay3::Place::kVertex);
  EXPECT_EQ(place({3, 3, 3}), Delaunay3::Place::kOutside);
}

TEST(Delaunay3, LocationNamesTheCornersOfTheSmallestFace) {
  const Delaunay3 d = built(test::lattice3(4, 4, 4));
  for (int i = 0; i <= 12; ++i)
    for (int j = 0; j <= 12; ++j) {
      const Point3 p{i / 4.0, j / 4.0, (i + j) / 8.0};
      for (const Index hint : {0u, 17u, 4000000000u}) {
        const auto location = d.locate(p, hint);
        const auto& v = d.topology().vertices(location.tet);
        for (unsigned k = 0; k < 4; ++k) {
          std::array<Point3, 4> corner;
          for (unsigned m = 0; m < 4; ++m) corner[m] = m == k ? p : d.points()[v[m]];
          const int side = -orient3d(corner[0], corner[1], corner[2], corner[3]);
          EXPECT_EQ(side, static_cast<int>(location.corners >> k & 1));
        }
      }
    }
}

// ---- Insertion ---------------------------------------------------------------------------------

TEST(Delaunay3, InsertionKeepsItDelaunayForEveryDegenerateFamily) {
  for (const auto& [name, points] : degenerate_sets3()) {
    SCOPED_TRACE(name);
    const std::size_t half = points.size() / 2;
    Delaunay3 d = built({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half)});
    for (std::size_t i = half; i < points.size(); ++i) {
      const auto vertex = d.insert(points[i], static_cast<Index>(i));
      ASSERT_TRUE(vertex.ok());
      EXPECT_EQ(d.points()[*vertex], points[i]);
    }
    expect_delaunay(d);
    for (Index v = 0; v < d.points().size(); ++v) {
      if (d.representative(v) != v) continue;
      const auto& corners = d.topology().vertices(d.tet_of(v));
      EXPECT_NE(std::find(corners.begin(), corners.end(), v), corners.end());
    }
    EXPECT_EQ(cell_set(d), cell_set(built(points)));
  }
}

TEST(Delaunay3, InsertionRaisesTheDimensionStepByStep) {
  Delaunay3 d;
  const std::vector<Point3> points{{0, 0, 0}, {0, 0, 0}, {1, 0, 0},
                                   {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int dimensions[] = {0, 0, 1, 1, 2, 3};
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(d.insert(points[i]).ok());
    EXPECT_EQ(d.dimension(), dimensions[i]);
  }
  EXPECT_EQ(d.representative(1), 0u);
  expect_delaunay(d);
}

TEST(Delaunay3, RefusedInsertionChangesNothing) {
  Delaunay3 d = built(test::uniform3(20, 1));
  const auto before = real_tets(d);
  EXPECT_FALSE(d.insert({0, 0, NAN}).ok());
  EXPECT_EQ(d.points().size(), 20u);
  EXPECT_EQ(real_tets(d), before);
}

// Keeps a label with each tet, as clients do: the sum of its vertices.
class TetLabels {
 public:
  explicit TetLabels(const Delaunay3& d) {
    for (Index t = 0; t < d.topology().size(); ++t) labels_.push_back(label(d, t));
  }
  void follow(const Delaunay3& d, Index v) {
    const auto [changed, moves] = d.last_change();
    labels_.resize(std::max<std::size_t>(labels_.size(), d.topology().size()));
    for (const auto& [from, to] : moves) labels_[to] = labels_[from];
    labels_.resize(d.topology().size());
    for (const Index t : changed)
      if (const auto& w = d.topology().vertices(t); std::find(w.begin(), w.end(), v) != w.end())
        labels_[t] = label(d, t);
  }
  bool are_right(const Delaunay3& d) const {
    for (Index t = 0; t < d.topology().size(); ++t)
      if (labels_[t] != label(d, t)) return false;
    return true;
  }

 private:
  static std::uint64_t label(const Delaunay3& d, Index t) {
    std::uint64_t sum = 0;
    for (const Index v : d.topology().vertices(t)) sum += v;
    return sum;
  }
  std::vector<std::uint64_t> labels_;
};

TEST(Delaunay3, InsertsIfAcceptedAndTellsWhatBecameOfTheTets) {
  std::size_t all_moves = 0;
  for (const auto& [name, points] : degenerate_sets3()) {
    SCOPED_TRACE(name);
    const std::size_t half = points.size() / 2;
    auto result = Delaunay3::build(std::span(points).first(half));
    ASSERT_TRUE(result.ok());
    Delaunay3& d = *result;
    if (d.dimension() < 3) continue;
    TetLabels labels(d);
    for (std::size_t i = half; i < points.size(); ++i) {
      const auto location = d.locate(points[i]);
      if (location.place == Delaunay3::Place::kVertex) continue;
      const Index size = d.topology().size();
      ASSERT_EQ(*d.insert_if(points[i], location.tet, [](const auto&) { return false; }), kNoIndex);
      ASSERT_EQ(d.topology().size(), size);
      std::size_t removed = 0;
      const auto accept = [&](const Triangulation3::Cavity& cavity) {
        removed = cavity.tets.size() - cavity.rim.size();
        return true;
      };
      const Index v = *d.insert_if(points[i], location.tet, accept);
      ASSERT_EQ(v, d.points().size() - 1);
      ASSERT_EQ(size - d.topology().size(), static_cast<Index>(removed));
      all_moves += d.last_change().moves.size();
      labels.follow(d, v);
    }
    EXPECT_TRUE(labels.are_right(d));
    expect_delaunay(d);
  }
  EXPECT_GT(all_moves, 0u);
}

TEST(Delaunay3, RefusesToInsertFromATetWhoseSphereIsElsewhere) {
  Delaunay3 d = built({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}});
  const Index t = d.locate({0.1, 0.1, 0.1}).tet;
  const auto accept = [](const auto&) { return true; };
  EXPECT_EQ(*d.insert_if({7, 7, 7.5}, t, accept), kNoIndex);
  EXPECT_EQ(d.points().size(), 5u);
}

}  // namespace
}  // namespace wellspaced
