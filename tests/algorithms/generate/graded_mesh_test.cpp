#include "wellspaced/algorithms/generate/graded_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

constexpr GradedDomain kAll[] = {GradedDomain::kCrack, GradedDomain::kAnnulus,
                                 GradedDomain::kAirfoil};
constexpr double kPi = 3.14159265358979323846;

TriangleMesh make(GradedDomain domain, Index nodes) {
  return generate_graded_mesh(domain, {.nodes = nodes}).value();
}

double smallest_angle_deg(const TriangleMesh& mesh) {
  const AngleStatistics angles = angle_statistics(mesh);
  return std::min(angles.interior_min_deg.value(), angles.boundary_min_deg.value());
}

void expect_size_and_angles(Index nodes) {
  for (const GradedDomain domain : kAll) {
    const TriangleMesh mesh = make(domain, nodes);
    EXPECT_NEAR(static_cast<double>(mesh.points.size()) / nodes, 1, 0.02);
    EXPECT_GE(smallest_angle_deg(mesh), 25);
  }
}

TEST(GradedMesh, AThousandNodesMeetSizeAndAngle) { expect_size_and_angles(1000); }
TEST(GradedMesh, TwentyThousandNodesMeetSizeAndAngle) { expect_size_and_angles(20'000); }
TEST(GradedMesh, TwoHundredThousandNodesMeetSizeAndAngle) { expect_size_and_angles(200'000); }
TEST(GradedMesh, AMillionNodesMeetSizeAndAngle) { expect_size_and_angles(1'000'000); }

TEST(GradedMesh, SmallMeshesOfAnySizeHaveNoAngleBelow25Degrees) {
  for (const GradedDomain domain : kAll)
    for (Index nodes = 300; nodes < 3000; nodes += nodes / 7)
      EXPECT_GE(smallest_angle_deg(make(domain, nodes)), 25) << nodes;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    EXPECT_GT(orient2d(p, q, r), 0);
    sum += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
  }
  return sum;
}

TEST(GradedMesh, TrianglesAreCounterClockwiseAndFillTheDomain) {
  EXPECT_NEAR(area(make(GradedDomain::kCrack, 5000)), 1, 1e-12);
  EXPECT_NEAR(area(make(GradedDomain::kAnnulus, 20'000)), 63 * kPi, 0.5);
  EXPECT_NEAR(area(make(GradedDomain::kAirfoil, 20'000)), 64 * kPi - 0.082 * (1 + 0.32 * 0.32), 1);
}

// The triangles' edges, each with the corners opposite it.
std::map<std::pair<Index, Index>, std::vector<Index>> edges_of(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Index>> edges;
  for (const auto& t : mesh.triangles)
    for (unsigned i = 0; i < 3; ++i)
      edges[std::minmax({t[i], t[(i + 1) % 3]})].push_back(t[(i + 2) % 3]);
  return edges;
}

TEST(GradedMesh, SegmentsAreTheBoundaryEdgesAndTheCrack) {
  for (const GradedDomain domain : kAll) {
    const TriangleMesh mesh = make(domain, 3000);
    const auto edges = edges_of(mesh);
    std::set<std::pair<Index, Index>> segments;
    for (const Segment& s : mesh.segments) {
      const auto key = std::minmax(s.a, s.b);
      segments.insert(key);
      const bool is_crack = domain == GradedDomain::kCrack && s.marker == 2;
      ASSERT_TRUE(edges.count(key));
      EXPECT_EQ(edges.at(key).size(), is_crack ? 2u : 1u);
    }
    EXPECT_EQ(segments.size(), mesh.segments.size());
    for (const auto& [key, opposite] : edges)
      EXPECT_TRUE(opposite.size() == 2 || segments.count(key));
  }
}

TEST(GradedMesh, EdgesAreConstrainedDelaunay) {
  for (const GradedDomain domain : kAll) {
    const TriangleMesh mesh = make(domain, 3000);
    std::set<std::pair<Index, Index>> segments;
    for (const Segment& s : mesh.segments) segments.insert(std::minmax(s.a, s.b));
    for (const auto& [key, opposite] : edges_of(mesh)) {
      if (opposite.size() < 2 || segments.count(key)) continue;
      Point2 p = mesh.points[key.first], q = mesh.points[key.second];
      const Point2 apex = mesh.points[opposite[0]];
      if (orient2d(p, q, apex) < 0) std::swap(p, q);
      EXPECT_LE(incircle(p, q, apex, mesh.points[opposite[1]]), 0);
    }
  }
}

TEST(GradedMesh, EveryNodeIsInATriangle) {
  for (const GradedDomain domain : kAll) {
    const TriangleMesh mesh = make(domain, 2000);
    std::vector<bool> used(mesh.points.size());
    for (const auto& t : mesh.triangles)
      for (const Index v : t) used[v] = true;
    EXPECT_TRUE(std::find(used.begin(), used.end(), false) == used.end());
  }
}

TEST(GradedMesh, OctavesGradeTheMesh) {
  for (const double octaves : {0.0, 4.0, 8.0, 14.0}) {
    const auto mesh =
        generate_graded_mesh(GradedDomain::kCrack, {.nodes = 2000, .octaves = octaves});
    EXPECT_NEAR(gradation(mesh.value()).value(), octaves + 0.6, 0.6);
  }
}

TEST(GradedBoundary, HoldsTheSegmentsOfTheMeshAndAPointInEachHole) {
  const std::size_t holes[] = {0, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleMesh mesh = make(kAll[k], 2000);
    const Pslg boundary = generate_graded_boundary(kAll[k], {.nodes = 2000}).value();
    EXPECT_EQ(boundary.holes.size(), holes[k]);
    EXPECT_LT(boundary.points.size(), mesh.points.size() / 4);
    ASSERT_EQ(boundary.segments.size(), mesh.segments.size());
    for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
      const Segment &s = boundary.segments[i], &t = mesh.segments[i];
      ASSERT_LT(std::max(s.a, s.b), boundary.points.size());
      EXPECT_EQ(boundary.points[s.a], mesh.points[t.a]);
      EXPECT_EQ(boundary.points[s.b], mesh.points[t.b]);
      EXPECT_EQ(s.marker, t.marker);
    }
  }
}

TEST(GradedMesh, TheSameOptionsGiveTheSameMesh) {
  for (const GradedDomain domain : kAll) {
    const TriangleMesh one = make(domain, 2000), other = make(domain, 2000);
    EXPECT_EQ(one.points, other.points);
    EXPECT_EQ(one.triangles, other.triangles);
    EXPECT_EQ(one.segments, other.segments);
  }
}

TEST(GradedMesh, RefusesWhatItCannotMake) {
  const auto code = [](GradedDomain domain, GradedMeshOptions options) {
    return generate_graded_mesh(domain, options).error().code;
  };
  EXPECT_EQ(code(GradedDomain::kCrack, {.nodes = 0}), ErrorCode::kUsage);
  EXPECT_EQ(code(GradedDomain::kCrack, {.nodes = 299}), ErrorCode::kUsage);
  EXPECT_EQ(code(GradedDomain::kCrack, {.nodes = 0xFFFFFFFF}), ErrorCode::kUsage);
  EXPECT_EQ(code(GradedDomain::kCrack, {.nodes = 5000, .octaves = 17}), ErrorCode::kUsage);
  EXPECT_EQ(code(GradedDomain::kCrack, {.nodes = 5000, .octaves = 0.0 / 0.0}), ErrorCode::kUsage);
  EXPECT_EQ(code(GradedDomain::kAnnulus, {.nodes = 1000, .octaves = 12}), ErrorCode::kUsage);
  EXPECT_EQ(code(GradedDomain::kAirfoil, {.nodes = 1000, .octaves = 1}), ErrorCode::kUsage);
}

TEST(GradedMesh, StopsWhenAsked) {
  const auto stop = [](std::string_view, std::uint64_t, std::uint64_t) { return false; };
  const auto mesh = generate_graded_mesh(GradedDomain::kAirfoil, {.nodes = 50'000}, stop);
  EXPECT_EQ(mesh.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace wellspaced
