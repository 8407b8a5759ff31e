#include "wellspaced/algorithms/spacing/local_feature_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/point_families.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

LocalFeatureSize size_of(const Pslg& graph, HoleRule holes = HoleRule::kParity) {
  auto built = LocalFeatureSize::build(graph, {holes, CrossingRule::kSplit, {}});
  EXPECT_TRUE(built.ok());
  return std::move(*built);
}

// A polygon, or several: each a loop of points.
Pslg loops(const std::vector<std::vector<Point2>>& polygons) {
  Pslg graph;
  for (const auto& polygon : polygons) {
    const Index first = static_cast<Index>(graph.points.size());
    const Index n = static_cast<Index>(polygon.size());
    graph.points.insert(graph.points.end(), polygon.begin(), polygon.end());
    for (Index i = 0; i < n; ++i) graph.segments.push_back({first + i, first + (i + 1) % n, 0});
  }
  return graph;
}

const std::vector<Point2> kSquare = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

// ---- By brute force ------------------------------------------------------------------------

double slow_distance(Point2 a, Point2 b, Point2 x) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = ((x.x - a.x) * dx + (x.y - a.y) * dy) / square;
  if (!(t > 0)) return std::hypot(x.x - a.x, x.y - a.y);
  if (t >= 1) return std::hypot(x.x - b.x, x.y - b.y);
  return std::fabs((x.x - a.x) * dy - (x.y - a.y) * dx) / std::sqrt(square);
}

struct SlowFeature {
  Index a, b;
  double distance;
};

// Definition 2.2.5 to the letter: the least over all pairs that are not incident.
double least_over_pairs(const std::vector<SlowFeature>& features) {
  double least = kInfinity;
  for (const auto& f : features)
    for (const auto& g : features)
      if (f.a != g.a && f.a != g.b && f.b != g.a && f.b != g.b)
        least = std::min(least, std::max(f.distance, g.distance));
  return least;
}

double slow_size(const PlanarTriangulation& graph, Point2 x) {
  const auto& points = graph.delaunay.points();
  std::vector<SlowFeature> features;
  for (Index v = 0; v < points.size(); ++v)
    if (graph.delaunay.is_vertex(v))
      features.push_back({v, v, slow_distance(points[v], points[v], x)});
  for (const Segment& s : graph.segments)
    features.push_back({s.a, s.b, slow_distance(points[s.a], points[s.b], x)});
  return least_over_pairs(features);
}

// Whether the straight way from x to y crosses no segment and runs inside, for points in general
// position.
bool slow_sees(const PlanarTriangulation& graph, const Pslg& input, Point2 x, Point2 y) {
  const auto& points = graph.delaunay.points();
  const auto side = [](Point2 a, Point2 b, Point2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double tiny = 1e-9;
  for (const Segment& s : graph.segments) {
    const Point2 a = points[s.a], b = points[s.b];
    if (side(x, y, a) * side(x, y, b) < -tiny && side(a, b, x) * side(a, b, y) < -tiny)
      return false;
  }
  const Point2 middle{(x.x + y.x) / 2, (x.y + y.y) / 2};
  bool inside = false, on_boundary = false;
  for (const Segment& s : input.segments) {
    const Point2 a = input.points[s.a], b = input.points[s.b];
    on_boundary = on_boundary || slow_distance(a, b, middle) < tiny;
    if ((a.y > middle.y) != (b.y > middle.y) &&
        middle.x < a.x + (b.x - a.x) * (middle.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside || on_boundary;
}

// Shortest paths over all pairs of vertices that see each other, then on to each feature's nearest
// point: more than the geodesic search ever looks at.
double slow_geodesic_size(const PlanarTriangulation& graph, const Pslg& input, Point2 x) {
  std::vector<Point2> sites = graph.delaunay.points();
  sites.push_back(x);
  std::vector<double> length(sites.size(), kInfinity);
  length.back() = 0;
  for (std::size_t round = 0; round < sites.size(); ++round)
    for (std::size_t i = 0; i < sites.size(); ++i)
      for (std::size_t j = 0; j < sites.size(); ++j)
        if (length[i] + distance(sites[i], sites[j]) < length[j] &&
            slow_sees(graph, input, sites[i], sites[j]))
          length[j] = length[i] + distance(sites[i], sites[j]);
  std::vector<SlowFeature> features;
  for (Index v = 0; v + 1 < sites.size(); ++v) features.push_back({v, v, length[v]});
  for (const Segment& s : graph.segments) {
    double nearest = std::min(length[s.a], length[s.b]);
    const Point2 a = sites[s.a], b = sites[s.b];
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      const double t =
          ((sites[i].x - a.x) * (b.x - a.x) + (sites[i].y - a.y) * (b.y - a.y)) / square;
      if (t <= 0 || t >= 1) continue;
      const Point2 foot{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      if (slow_sees(graph, input, sites[i], foot))
        nearest = std::min(nearest, length[i] + distance(sites[i], foot));
    }
    features.push_back({s.a, s.b, nearest});
  }
  return least_over_pairs(features);
}

Pslg random_graph_of_segments(int segments, int isolated, std::uint64_t seed) {
  Random random(seed);
  Pslg graph;
  for (int i = 0; i < segments; ++i) {
    const Point2 a{random.uniform(), random.uniform()};
    const double size = i % 3 == 0 ? 0.5 : 0.05;
    const Index k = static_cast<Index>(graph.points.size());
    graph.points.push_back(a);
    graph.points.push_back({a.x + random.uniform(-size, size), a.y + random.uniform(-size, size)});
    graph.segments.push_back({k, k + 1, 0});
  }
  for (const Point2 p : test::uniform_points(isolated, seed + 1)) graph.points.push_back(p);
  return graph;
}

// ---- The definition ------------------------------------------------------------------------

TEST(LocalFeatureSize, IsWhatTheDefinitionSaysOnASquare) {
  const LocalFeatureSize lfs = size_of(loops({kSquare}));
  EXPECT_EQ(lfs.at({5, 5}), 5) << "two opposite sides";
  EXPECT_EQ(lfs.at({0, 0}), 10) << "a corner is incident to the sides that end in it";
  EXPECT_EQ(lfs.at({3, 0}), 7) << "a side and an end of it are incident, its two ends are not";
  EXPECT_EQ(lfs.at({5, 1}), 5) << "left and right; the side below touches both";
  EXPECT_EQ(lfs.at({-3, 0}), 10.440306508910550) << "outside, too";
}

TEST(LocalFeatureSize, CountsIsolatedPoints) {
  Pslg graph = loops({kSquare});
  graph.points.push_back({5, 2});
  const LocalFeatureSize lfs = size_of(graph);
  EXPECT_EQ(lfs.at({5, 2}), 2);
  EXPECT_EQ(lfs.at({5, 1}), 1);
  EXPECT_EQ(lfs.at({5, 4}), 4) << "the point at 2, the side at 4";
}

TEST(LocalFeatureSize, OfPointsAloneIsTheDistanceToTheSecondNearest) {
  Pslg graph;
  graph.points = test::uniform_points(300, 4);
  const LocalFeatureSize lfs = size_of(graph);
  for (const Point2 x : test::uniform_points(100, 5)) {
    std::vector<double> distances;
    for (const Point2 p : graph.points) distances.push_back(distance(p, x));
    std::ranges::nth_element(distances, distances.begin() + 1);
    EXPECT_EQ(lfs.at(x), distances[1]);
  }
}

TEST(LocalFeatureSize, IsInfiniteWhereNoTwoFeaturesAreApart) {
  Pslg graph;
  EXPECT_EQ(size_of(graph).at({1, 2}), kInfinity);
  graph.points = {{0, 0}, {0, 0}};
  graph.segments = {{0, 1, 0}};
  EXPECT_EQ(size_of(graph).at({1, 2}), kInfinity) << "coincident points are one vertex";
  graph.points = {{0, 0}, {3, 0}};
  EXPECT_EQ(size_of(graph).at({0, 0}), 3) << "the two ends of a segment are apart";
  EXPECT_EQ(size_of(graph).geodesic_at({0, 0}), kInfinity) << "there is no domain";
}

TEST(LocalFeatureSize, TakesTheLipsOfASlitForOneChain) {
  Pslg graph = loops({{{0, 5}, {0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}, {5, 5}}});
  const LocalFeatureSize lfs = size_of(graph);
  EXPECT_EQ(lfs.at({5, 5}), 5);
  EXPECT_EQ(lfs.at({0, 5}), 5);
}

TEST(LocalFeatureSize, ClosesTheGraphUnderIntersection) {
  Pslg graph;
  graph.points = {{0, 0}, {4, 0}, {2, -2}, {2, 2}};
  graph.segments = {{0, 1, 0}, {2, 3, 0}};
  EXPECT_EQ(size_of(graph).at({2, 0}), 2) << "the crossing is a vertex, no feature is near it";
}

TEST(LocalFeatureSize, RefusesAnExtentThatIsNoDouble) {
  Pslg graph;
  graph.points = {{-1.7e308, 0}, {1.7e308, 0}, {0, 1}};
  auto built = LocalFeatureSize::build(graph);
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, ErrorCode::kInvalidGeometry);
}

// ---- Against brute force -------------------------------------------------------------------

TEST(LocalFeatureSize, AgreesWithAllPairsOnRandomGraphs) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Pslg graph = random_graph_of_segments(seed % 2 == 0 ? 6 : 40, 10, seed);
    const LocalFeatureSize lfs = size_of(graph);
    for (const Point2 x : test::uniform_points(60, seed + 50))
      EXPECT_NEAR(lfs.at(x), slow_size(lfs.graph(), x), 1e-13);
    for (const Point2 x : lfs.graph().delaunay.points())
      EXPECT_NEAR(lfs.at(x), slow_size(lfs.graph(), x), 1e-13);
  }
}

TEST(LocalFeatureSize, AgreesWithAllPairsOnDegeneratePoints) {
  std::vector<double> lattice(30);
  for (const auto& family : test::point_families(60, 3)) {
    Pslg graph;
    graph.points = family.points;
    for (Index i = 0; i + 1 < 20; ++i) graph.segments.push_back({i, i + 1, 0});
    auto lfs = LocalFeatureSize::build(graph);
    if (!lfs) continue;  // crossings that cannot be rounded
    for (Index i = 0; i < 30; ++i) {
      const double slow = slow_size(lfs->graph(), family.points[i]);
      // In units of 2^-1074 resp. 2^1018 the points are those of "lattice9".
      if (family.name == "tiny") {
        EXPECT_NEAR(lfs->at(family.points[i]) / std::ldexp(1, -1074), lattice[i], 2);
      } else if (family.name == "huge") {
        EXPECT_NEAR(std::ldexp(lfs->at(family.points[i]), -1018), lattice[i], 1e-12);
      } else {
        EXPECT_NEAR(lfs->at(family.points[i]), slow, 1e-13 * 65) << family.name;
        if (family.name == "lattice9") lattice[i] = slow;
      }
    }
  }
}

TEST(LocalFeatureSize, ScalesWithTheGraph) {
  Pslg graph = random_graph_of_segments(20, 5, 6);
  const LocalFeatureSize lfs = size_of(graph);
  for (const int exponent : {-600, 500}) {
    Pslg other = graph;
    other.points = test::scaled(graph.points, exponent);
    const LocalFeatureSize scaled_lfs = size_of(other);
    for (const Point2 x : test::uniform_points(20, 7))
      EXPECT_NEAR(std::ldexp(scaled_lfs.at({std::ldexp(x.x, exponent), std::ldexp(x.y, exponent)}),
                             -exponent),
                  lfs.at(x), 1e-13);
  }
}

TEST(LocalFeatureSize, IsTheSameFromNearBy) {
  const LocalFeatureSize lfs = size_of(random_graph_of_segments(30, 10, 21));
  LocalFeatureSize::Cursor cursor(lfs), bounded(lfs);
  Random random(22);
  Point2 x{0.5, 0.5};
  for (int step = 0; step < 5000; ++step) {
    const double size = lfs.at(x), bound = random.uniform(0, 0.2);
    EXPECT_EQ(cursor.at(x), size);
    EXPECT_EQ(lfs.at(x, bound), std::min(size, bound));
    EXPECT_EQ(bounded.at(x, bound), std::min(size, bound));
    const double stride = step % 100 == 0 ? 0.3 : 0.003;
    x = {x.x + random.uniform(-stride, stride), x.y + random.uniform(-stride, stride)};
  }
  const LocalFeatureSize nothing = size_of({});
  LocalFeatureSize::Cursor nowhere(nothing);
  EXPECT_EQ(nowhere.at({1, 2}), kInfinity);
}

// Lemma 2.2.7.
TEST(LocalFeatureSize, IsOneLipschitz) {
  const Pslg graph = random_graph_of_segments(50, 20, 9);
  const LocalFeatureSize lfs = size_of(graph);
  const auto points = test::uniform_points(400, 10);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_LE(std::fabs(lfs.at(points[i]) - lfs.at(points[j])),
                distance(points[i], points[j]) + 1e-14);
}

TEST(LocalFeatureSize, LooksPastTheSegmentsOfAHub) {
  Pslg graph;
  for (int i = 0; i < 2000; ++i) {
    graph.points.push_back(circle_point(i / 2000.0));
    graph.segments.push_back({static_cast<Index>(i), 2000, 0});
  }
  graph.points.push_back({0, 0});
  const LocalFeatureSize lfs = size_of(graph, HoleRule::kNone);
  EXPECT_NEAR(lfs.at({0, 0}), 1, 1e-15);
  EXPECT_NEAR(lfs.at({0.25, 0.25}), distance({0.25, 0.25}, circle_point(0.125)), 1e-15);
}

TEST(LocalFeatureSize, LooksAtFewFeaturesOfMany) {
  Pslg graph;
  graph.points = test::uniform_points(100'000, 13);
  const LocalFeatureSize lfs = size_of(graph);
  double sum = 0;  // would take minutes if every query looked at all
  for (const Point2 x : test::uniform_points(50'000, 14)) sum += lfs.at(x);
  EXPECT_NEAR(sum / 50'000 * std::sqrt(100'000), 0.75, 0.01) << "the mean for a Poisson process";
}

// ---- Inside the domain ---------------------------------------------------------------------

// A spiral corridor: beside the wall one is near the next turn of it, but a long way off.
Pslg corridor() {
  return loops({{{0, 0}, {10, 0}, {10, 4}, {1, 4}, {1, 5}, {10, 5}, {10, 9}, {0, 9}}});
}

TEST(GeodesicFeatureSize, WalksAroundWalls) {
  const LocalFeatureSize lfs = size_of(corridor());
  EXPECT_EQ(lfs.at({8, 4}), 1) << "the other lip of the notch";
  EXPECT_EQ(lfs.geodesic_at({8, 4}), 4) << "the outer wall";
  EXPECT_EQ(lfs.at({5, 4}), 1);
  EXPECT_EQ(lfs.geodesic_at({5, 4}), 4) << "the outer wall, the notch's inner corner";
  EXPECT_EQ(lfs.geodesic_at({5, 4.5}), kInfinity) << "outside the domain";
}

TEST(GeodesicFeatureSize, BendsAtTheTipOfACrack) {
  // A crack from (0, 5) to (5, 5); beside it, on its far side, an isolated point.
  Pslg graph = loops({{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}}});
  graph.points.push_back({5, 5});
  graph.points.push_back({4, 5.5});
  graph.segments.push_back({4, 5, 0});
  const LocalFeatureSize lfs = size_of(graph, HoleRule::kOuter);
  EXPECT_NEAR(lfs.at({4, 4.9}), 0.6, 1e-14);
  const double to_tip = std::hypot(1, 0.1), onwards = std::hypot(1, 0.5);
  EXPECT_NEAR(lfs.geodesic_at({4, 4.9}), to_tip + onwards, 1e-14);
}

TEST(GeodesicFeatureSize, AgreesWithShortestPathsOverAllVertices) {
  const std::vector<Pslg> graphs = {
      corridor(),
      loops({kSquare, {{2, 2}, {2.3, 8}, {8, 7.7}, {2.6, 7.5}}, {{4, 3}, {9, 3.3}, {9, 3.1}}}),
      loops(
          {{{0, 0}, {9, 0.5}, {8.5, 9}, {8, 1}, {6, 8}, {5.5, 1.2}, {3, 9}, {2.7, 1}, {0.5, 8}}})};
  for (const Pslg& graph : graphs) {
    const LocalFeatureSize lfs = size_of(graph);
    int bent = 0;
    std::vector<Point2> points = graph.points;
    for (const Point2 p : test::uniform_points(150, 12)) points.push_back({10 * p.x, 10 * p.y});
    for (const Point2 x : points) {
      const double geodesic = lfs.geodesic_at(x);
      if (geodesic == kInfinity) continue;
      EXPECT_NEAR(geodesic, slow_geodesic_size(lfs.graph(), graph, x), 1e-12) << x.x << " " << x.y;
      EXPECT_GE(geodesic, lfs.at(x));
      bent += geodesic > lfs.at(x);
    }
    EXPECT_GT(bent, 3);
  }
}

}  // namespace
}  // namespace wellspaced
