#include "wellspaced/kernel/plane/delaunay2.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "tests/support/point_families.hpp"
#include "tests/support/triangulation_checks.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/point_order.hpp"

namespace wellspaced {
namespace {

using test::distinct;
using test::is_constrained_delaunay;
using test::point_families;
using test::triangles_of;

Delaunay2 built(const std::vector<Point2>& points) {
  Result<Delaunay2> result = Delaunay2::build(points);
  EXPECT_TRUE(result.ok());
  return std::move(*result);
}

TEST(Delaunay2, NoPointsHaveDimensionMinusOne) {
  EXPECT_EQ(built({}).dimension(), -1);
  EXPECT_TRUE(built({}).topology().empty());
}

TEST(Delaunay2, EqualPointsHaveDimensionZeroAndOneVertex) {
  const Delaunay2 dt = built({{1, 2}, {1, 2}, {1, 2}});
  EXPECT_EQ(dt.dimension(), 0);
  EXPECT_EQ(dt.duplicate_count(), 2u);
  for (Index i = 0; i < 3; ++i) EXPECT_EQ(dt.representative(i), 0u);
}

TEST(Delaunay2, PositiveAndNegativeZeroAreEqual) {
  EXPECT_EQ(built({{0.0, 1}, {-0.0, 1}, {1, 0}, {0, 0}}).duplicate_count(), 1u);
}

TEST(Delaunay2, CollinearPointsHaveDimensionOneAndNoTriangle) {
  const Delaunay2 dt = built({{0, 0}, {3, 3}, {1, 1}, {3, 3}, {2, 2}});
  EXPECT_EQ(dt.dimension(), 1);
  EXPECT_TRUE(dt.topology().empty());
  EXPECT_EQ(dt.representative(3), 1u);
  EXPECT_EQ(dt.edge_from(0).triangle, kNoIndex);
}

TEST(Delaunay2, NotFiniteCoordinatesAreErrorsThatNameThePoints) {
  const double inf = std::numeric_limits<double>::infinity();
  const auto result =
      Delaunay2::build(std::vector<Point2>{{0, 0}, {1, inf}, {2, 0}, {std::nan(""), 0}});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(result.error().ids, (std::vector<Index>{1, 3}));
}

TEST(Delaunay2, APointMayJoinThousandsAtOnce) {
  constexpr Index kRim = 5000;
  std::vector<Point2> points;
  for (Index i = 0; i < kRim; ++i) points.push_back(circle_point(static_cast<double>(i) / kRim));
  points.push_back({0x1p-10, 0x1p-11});
  // The hub goes in behind most of the rim.
  const std::vector<Index> order = insertion_order(points);
  ASSERT_GT(std::find(order.begin(), order.end(), kRim) - order.begin(), kRim / 2);
  const Delaunay2 dt = built(points);
  EXPECT_TRUE(dt.topology().is_valid());
  EXPECT_EQ(dt.topology().degree(dt.edge_from(kRim)), kRim);
}

TEST(Delaunay2, EveryOrderAlongACurveGivesTheDelaunayTriangulation) {
  const auto sorted_triangles = [](const Delaunay2& dt) {
    auto triangles = triangles_of(dt);
    for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  for (const auto& family : point_families(300, 12)) {
    std::vector<Index> backwards = hilbert_order(family.points);
    std::reverse(backwards.begin(), backwards.end());
    const auto dt = Delaunay2::build(family.points, backwards);
    ASSERT_TRUE(dt.ok());
    EXPECT_TRUE(is_constrained_delaunay(*dt)) << family.name;
    EXPECT_EQ(dt->duplicate_count(), built(family.points).duplicate_count()) << family.name;
    if (family.name == "uniform")
      EXPECT_EQ(sorted_triangles(*dt), sorted_triangles(built(family.points)));
  }
}

TEST(Delaunay2, EveryFamilyIsDelaunay) {
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (const int n : {3, 4, 5, 8, 20, 300})
      for (const auto& family : point_families(n, seed)) {
        const Delaunay2 dt = built(family.points);
        EXPECT_EQ(dt.duplicate_count(), family.points.size() - distinct(family.points));
        if (dt.dimension() == 2)
          EXPECT_TRUE(is_constrained_delaunay(dt) && dt.is_valid())
              << family.name << n << ' ' << seed;
      }
}

TEST(Delaunay2, DimensionIsTwoExactlyWhereThreePointsTurn) {
  for (std::uint64_t seed = 0; seed < 300; ++seed)
    for (const auto& family : point_families(4, seed)) {
      bool turns = false;
      for (const Point2 a : family.points)
        for (const Point2 b : family.points)
          for (const Point2 c : family.points) turns |= orient2d(a, b, c) != 0;
      EXPECT_EQ(built(family.points).dimension() == 2, turns) << family.name << seed;
    }
}

TEST(Delaunay2, TrianglesAreAmongThoseWithEmptyCircles) {
  for (std::uint64_t seed = 0; seed < 60; ++seed)
    for (const auto& family : point_families(9, seed)) {
      const auto all = test::empty_circle_triangles(family.points);
      for (const auto& t : triangles_of(built(family.points)))
        EXPECT_TRUE(std::binary_search(all.begin(), all.end(), t)) << family.name << seed;
    }
}

TEST(Delaunay2, RepresentativesAreTheLowestEqualPoints) {
  const auto points = test::lattice_points(500, 9, 7);
  const Delaunay2 dt = built(points);
  for (Index i = 0; i < points.size(); ++i) {
    const auto first = std::find(points.begin(), points.end(), points[i]) - points.begin();
    EXPECT_EQ(dt.representative(i), static_cast<Index>(first));
  }
}

TEST(Delaunay2, ScalingByPowersOfTwoChangesNothing) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = test::lattice_points(200, 1000, seed);
    const auto triangles = triangles_of(built(points));
    for (const int exponent : {-1074, -600, -52, 52, 600, 1013})
      EXPECT_EQ(triangles_of(built(test::scaled(points, exponent))), triangles) << exponent;
  }
}

TEST(Delaunay2, PermutationChangesNothingWhereThereAreNoTies) {
  const auto points = test::uniform_points(500, 3);
  std::vector<Point2> reversed(points.rbegin(), points.rend());
  auto expected = triangles_of(built(points));
  std::vector<std::array<Index, 3>> mapped;
  for (std::array<Index, 3> t : triangles_of(built(reversed))) {
    for (Index& v : t) v = static_cast<Index>(points.size()) - 1 - v;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    mapped.push_back(t);
  }
  std::sort(mapped.begin(), mapped.end());
  EXPECT_EQ(mapped, expected);
}

// Locations are checked by the definition of each place.
TEST(Delaunay2, LocateFindsFaceEdgeVertexAndOutside) {
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    for (const auto& family : point_families(30, seed)) {
      const Delaunay2 dt = built(family.points);
      if (dt.dimension() < 2) continue;
      const Triangulation2& mesh = dt.topology();
      const auto side = [&](Delaunay2::Edge e, Point2 p) {
        return orient2d(dt.points()[mesh.origin(e)], dt.points()[mesh.destination(e)], p);
      };
      Random random(seed);
      for (int k = 0; k < 200; ++k) {
        const Point2 a = family.points[random.below(family.points.size())];
        const Point2 b = family.points[random.below(family.points.size())];
        const Point2 p = k % 3 == 0 ? a : Point2{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
        const auto found = dt.locate(p, static_cast<Index>(random.below(mesh.size() + 3)));
        const Delaunay2::Edge e = found.edge, f{e.triangle, Triangulation2::next(e.i)},
                              g{e.triangle, Triangulation2::previous(e.i)};
        switch (found.place) {
          case Delaunay2::Place::kVertex:
            EXPECT_EQ(dt.points()[mesh.origin(e)], p);
            break;
          case Delaunay2::Place::kEdge:
            EXPECT_EQ(side(e, p), 0);
            EXPECT_GT(std::min(side(f, p), side(g, p)), 0);
            break;
          case Delaunay2::Place::kFace:
            EXPECT_GT(std::min({side(e, p), side(f, p), side(g, p)}), 0);
            break;
          case Delaunay2::Place::kOutside:
            EXPECT_EQ(mesh.apex(e), Triangulation2::kGhost);
            EXPECT_GT(side(e, p), 0);
        }
      }
    }
}

TEST(Delaunay2, ConstraintsBecomeChainsOfEdgesOrAreRefusedUnchanged) {
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (const auto& family : point_families(30, seed)) {
      Delaunay2 dt = built(family.points);
      if (dt.dimension() < 2) continue;
      Random random(seed);
      std::vector<std::vector<Index>> chains;
      for (int k = 0; k < 30; ++k) {
        const Index a = static_cast<Index>(random.below(30)),
                    b = static_cast<Index>(random.below(30));
        const auto before = triangles_of(dt);
        auto chain = dt.insert_constraint(a, b);
        if (chain.ok()) {
          EXPECT_EQ(chain->front(), dt.representative(a));
          EXPECT_EQ(chain->back(), dt.representative(b));
          chains.push_back(*chain);
        } else {
          EXPECT_EQ(chain.error().ids.size(), 4u);
          EXPECT_EQ(triangles_of(dt), before);
        }
      }
      EXPECT_TRUE(is_constrained_delaunay(dt)) << family.name << seed;
      for (const auto& chain : chains)
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
          const auto e = dt.find_edge(chain[i], chain[i + 1]);
          ASSERT_NE(e.triangle, kNoIndex);
          EXPECT_TRUE(dt.topology().is_constrained(e));
          EXPECT_EQ(orient2d(dt.points()[chain.front()], dt.points()[chain.back()],
                             dt.points()[chain[i]]),
                    0);
        }
    }
}

TEST(Delaunay2, RefusalNamesBothSegments) {
  Delaunay2 dt = built({{0, 0}, {2, 2}, {0, 2}, {2, 0}, {5, 1}});
  ASSERT_TRUE(dt.insert_constraint(0, 1).ok());
  const auto refused = dt.insert_constraint(2, 3);
  ASSERT_FALSE(refused.ok());
  const std::set<Index> ids(refused.error().ids.begin(), refused.error().ids.end());
  EXPECT_EQ(ids, (std::set<Index>{0, 1, 2, 3}));
}

// A random mix of all dynamic operations keeps every invariant after each step.
TEST(Delaunay2, StaysConstrainedDelaunayUnderRandomEdits) {
  for (std::uint64_t seed = 0; seed < 60; ++seed)
    for (const auto& family : point_families(16, seed)) {
      Delaunay2 dt = built(family.points);
      Random random(seed);
      const auto any = [&] { return static_cast<Index>(random.below(dt.points().size())); };
      for (int k = 0; k < 60; ++k) {
        const Index a = any(), b = any();
        const bool flat = dt.dimension() < 2;
        switch (random.below(4)) {
          case 0: {
            const Point2 p{dt.points()[a].x, dt.points()[b].y};
            const auto v = dt.insert(p, b);
            ASSERT_TRUE(v.ok());
            EXPECT_EQ(dt.points()[*v], p);
            EXPECT_TRUE(dt.is_vertex(*v));
            break;
          }
          case 1:
            if (dt.remove(a).ok()) EXPECT_FALSE(dt.is_vertex(a));
            break;
          case 2: {
            if (flat) break;
            const Delaunay2::Edge e{b % dt.topology().size(), a % 3};
            if (dt.topology().is_constrained(e)) dt.remove_constraint(e);
            break;
          }
          default:
            if (!flat && dt.is_vertex(a) && dt.is_vertex(b)) {
              const auto chain = dt.insert_constraint(a, b);
              if (chain.ok()) EXPECT_EQ(chain->back(), b);
            }
        }
        if (dt.dimension() == 2)
          ASSERT_TRUE(is_constrained_delaunay(dt)) << family.name << seed << " step " << k;
      }
    }
}

TEST(Delaunay2, InsertingOnAConstrainedEdgeSplitsIt) {
  Delaunay2 dt = built({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  ASSERT_TRUE(dt.insert_constraint(0, 2).ok());
  const Index v = *dt.insert({2, 2});
  EXPECT_TRUE(dt.topology().is_constrained(dt.find_edge(0, v)));
  EXPECT_TRUE(dt.topology().is_constrained(dt.find_edge(v, 2)));
  EXPECT_FALSE(dt.topology().is_constrained(dt.find_edge(v, 1)));
  EXPECT_FALSE(dt.remove(v).ok());
}

// A fan of constrained edges in a box: their midpoints are seldom doubles on them.
TEST(Delaunay2, SplitsAnEdgeAtAPointBesideItsLine) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Point2> points = test::uniform_points(30, seed);
    for (const Point2 p : {Point2{-9, -9}, Point2{9, -9}, Point2{9, 9}, Point2{-9, 9}})
      points.push_back(p);
    Delaunay2 dt = built(points);
    for (Index v = 1; v < 8; ++v) ASSERT_TRUE(dt.insert_constraint(0, v).ok());
    for (Index v = 1; v < 8; ++v) {
      const Point2 a = dt.points()[0], b = dt.points()[v];
      const Delaunay2::Edge e = dt.find_edge(0, v);
      if (e.triangle == kNoIndex) continue;  // another vertex lies on it
      const Result<Index> fresh = dt.split_edge(e, {(a.x + b.x) / 2, (a.y + b.y) / 2});
      ASSERT_TRUE(fresh.ok());
      for (const Index end : {Index{0}, v})
        EXPECT_TRUE(dt.topology().is_constrained(dt.find_edge(*fresh, end)));
      EXPECT_TRUE(dt.is_valid());
    }
  }
}

TEST(Delaunay2, RefusesToSplitAnEdgeFarFromIt) {
  Delaunay2 dt = built({{0, 0}, {4, 0}, {2, 3}, {2, -3}, {-9, -9}, {9, -9}, {9, 9}, {-9, 9}});
  ASSERT_TRUE(dt.insert_constraint(0, 1).ok());
  for (const Point2 p : {Point2{2, 4}, Point2{-1, 0}, Point2{0, 0}}) {
    const auto result = dt.split_edge(dt.find_edge(0, 1), p);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
    EXPECT_EQ(std::set<Index>(result.error().ids.begin(), result.error().ids.end()),
              (std::set<Index>{0, 1}));
    EXPECT_TRUE(dt.is_valid());
    EXPECT_TRUE(dt.topology().is_constrained(dt.find_edge(0, 1)));
    EXPECT_EQ(dt.points().size(), 8u);
  }
}

TEST(Delaunay2, InsertsIfTheRimIsAcceptable) {
  Delaunay2 dt = built({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Point2 p{2, 1};
  const Index t = dt.locate(p).edge.triangle;
  std::set<Index> rim_vertices;
  const auto look = [&](bool answer) {
    return [&rim_vertices, answer](std::span<const Triangulation2::RimEdge> rim) {
      for (const auto& edge : rim) rim_vertices.insert(edge.origin);
      return answer;
    };
  };
  EXPECT_EQ(dt.insert_if(p, t, look(false)), kNoIndex);
  EXPECT_EQ(rim_vertices, (std::set<Index>{0, 1, 2, 3}));
  EXPECT_EQ(dt.points().size(), 4u);
  EXPECT_EQ(dt.insert_if(p, t, look(true)), 4u);
  EXPECT_TRUE(dt.is_valid());
  EXPECT_NE(dt.find_edge(4, 2).triangle, kNoIndex);
}

TEST(Delaunay2, InsertingAllPointsOneByOneGivesTheSameTriangles) {
  const auto points = test::uniform_points(300, 11);
  Delaunay2 dt = built({});
  for (const Point2 p : points) ASSERT_TRUE(dt.insert(p).ok());
  EXPECT_EQ(triangles_of(dt), triangles_of(built(points)));
}

TEST(Delaunay2, RemovingAllVerticesEndsWithNone) {
  for (const auto& family : point_families(60, 5)) {
    Delaunay2 dt = built(family.points);
    for (Index v = 0; v < family.points.size(); ++v)
      if (dt.is_vertex(v)) ASSERT_TRUE(dt.remove(v).ok()) << family.name;
    EXPECT_EQ(dt.dimension(), -1) << family.name;
    EXPECT_FALSE(dt.remove(0).ok());
  }
}

TEST(Delaunay2, HullRunsCounterClockwiseThroughAllBoundaryPoints) {
  const Delaunay2 dt = built({{1, 0}, {0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}});
  EXPECT_EQ(dt.hull(), (std::vector<Index>{0, 2, 3, 5, 6, 1}));
  EXPECT_TRUE(built({{0, 0}, {1, 1}}).hull().empty());
}

TEST(Delaunay2, NearestVertexIsNearestOfAll) {
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    for (const auto& family : point_families(25, seed)) {
      const Delaunay2 dt = built(family.points);
      if (dt.dimension() < 2) continue;
      Random random(seed);
      const auto any = [&] { return family.points[random.below(family.points.size())]; };
      for (int k = 0; k < 50; ++k) {
        const Point2 a = any(), b = any(), p{a.x / 2 + b.x / 2, b.y};
        const Index nearest = dt.nearest_vertex(p, static_cast<Index>(random.below(50)));
        EXPECT_TRUE(dt.is_vertex(nearest));
        for (const Point2 q : family.points)
          EXPECT_LE(compare_distances(p, dt.points()[nearest], q), 0) << family.name << seed;
      }
    }
}

TEST(Delaunay2, VoronoiCellsOfALatticeAreSquaresInsideAndUnboundedOutside) {
  std::vector<Point2> points;
  for (int i = 0; i < 25; ++i) points.push_back({i % 5 * 2.0, i / 5 * 2.0});
  const Delaunay2 dt = built(points);
  for (Index v = 0; v < 25; ++v) {
    const auto cell = dt.voronoi_cell(v);
    ASSERT_TRUE(cell.ok());
    const Point2 p = points[v];
    const bool inner = p.x > 0 && p.x < 8 && p.y > 0 && p.y < 8;
    EXPECT_EQ(cell->bounded, inner);
    for (const Point2 c : cell->corners) {
      EXPECT_EQ(std::abs(c.x - p.x), 1);
      EXPECT_EQ(std::abs(c.y - p.y), 1);
    }
    for (std::size_t i = 0; i + 1 < cell->corners.size(); ++i)
      EXPECT_GE(orient2d(p, cell->corners[i], cell->corners[i + 1]), 0);
  }
  const auto corner = dt.voronoi_cell(0);
  EXPECT_EQ(corner->corners.front(), (Point2{1, 1}));
  EXPECT_EQ(corner->first_ray, (Point2{0, -2}));
  EXPECT_EQ(corner->last_ray, (Point2{-2, 0}));
}

TEST(Delaunay2, VoronoiCellsBeyondTheDoublesAreRefused) {
  const Delaunay2 dt = built({{0, 0}, {1e300, 0}, {0, 1e300}, {1e300, 1e300}});
  const auto cell = dt.voronoi_cell(0);
  ASSERT_FALSE(cell.ok());
  EXPECT_EQ(cell.error().ids.size(), 3u);
}

// A segment across n thin triangles, all crossed: a fan on each side.
TEST(Delaunay2, ALongSegmentAcrossManyTrianglesIsInserted) {
  std::vector<Point2> points{{-1, 0}, {20001, 0}};
  for (int i = 0; i <= 20000; ++i) {
    points.push_back({static_cast<double>(i), 1.0 + i % 7});
    points.push_back({static_cast<double>(i) + 0.5, -1.0 - i % 5});
  }
  Delaunay2 dt = built(points);
  ASSERT_TRUE(dt.insert_constraint(0, 1).ok());
  EXPECT_TRUE(is_constrained_delaunay(dt));
  EXPECT_TRUE(dt.topology().is_constrained(dt.find_edge(0, 1)));
}

}  // namespace
}  // namespace wellspaced
