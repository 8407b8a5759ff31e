#include "wellspaced/algorithms/coarsening/quality/editable_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/algorithms/coarsening/contraction.hpp"
#include "wellspaced/algorithms/coarsening/special_points.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

struct Subject {
  TriangleMesh mesh;
  Skeleton skeleton;
  std::vector<Index> special;
};

Subject subject(TriangleMesh mesh) {
  Subject s;
  s.skeleton = skeleton_of(mesh);
  s.special = outline_special_points(mesh, s.skeleton);
  const auto& anchors = s.skeleton.boundary.anchors;
  s.special.insert(s.special.end(), anchors.begin(), anchors.end());
  sort_unique(s.special);
  s.mesh = std::move(mesh);
  return s;
}

// A bent grid with a round hole of twelve sides, and a slit.
Subject holed_grid() {
  TriangleMesh mesh = test::grid_mesh({.nx = 16, .ny = 12, .jitter = 0.2, .seed = 5});
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](Index v) {
      const double x = mesh.points[v].x - 5, y = mesh.points[v].y - 7;
      return x * x + y * y < 9;
    });
  });
  for (Point2& p : mesh.points) p.y += p.x * (16 - p.x) / 20;
  return subject(std::move(mesh));
}

Subject slit_grid() {
  TriangleMesh mesh = test::grid_mesh({.nx = 14, .ny = 9, .jitter = 0});
  test::cut_slit(mesh, 15, 4, 0, 8);
  return subject(std::move(mesh));
}

// What a level is: its triangles inside, by nodes, each from its lowest on; twins by one name.
std::vector<std::array<Point2, 3>> triangles_of(const EditableLevel& level) {
  std::vector<std::array<Point2, 3>> list;
  const Triangulation2& topology = level.triangulation().topology();
  for (Index t = 0; t < topology.size(); ++t) {
    if (!level.is_inside(t)) continue;
    std::array<Point2, 3> corners{};
    for (unsigned i = 0; i < 3; ++i)
      corners[i] = level.triangulation().points()[topology.vertex(t, i)];
    const auto less = [](Point2 a, Point2 b) { return std::pair{a.x, a.y} < std::pair{b.x, b.y}; };
    std::ranges::rotate(corners, std::ranges::min_element(corners, less));
    list.push_back(corners);
  }
  std::ranges::sort(list, {}, [](const auto& c) {
    return std::array{c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y};
  });
  return list;
}

double area_of(const EditableLevel& level) {
  double twice = 0;
  for (const auto& [a, b, c] : triangles_of(level))
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return twice / 2;
}

// The same level, made at once.
DomainTriangulation made_at_once(const Subject& s, const EditableLevel& level) {
  std::vector<std::uint8_t> survives(s.mesh.points.size(), 0);
  std::vector<Index> number(s.mesh.points.size(), kNoIndex);
  std::vector<Point2> points;
  for (const Index v : level.nodes()) {
    survives[v] = 1;
    number[v] = static_cast<Index>(points.size());
    points.push_back(s.mesh.points[v]);
  }
  const auto edges = contract_boundary(s.skeleton.boundary, s.mesh.points, survives);
  return triangulate_domain(points, constrained_edges(s.skeleton.boundary, edges, number)).value();
}

void expect_like_made_at_once(const Subject& s, const EditableLevel& level) {
  ASSERT_TRUE(level.triangulation().is_valid());
  ASSERT_EQ(level.size(), level.nodes().size());
  const DomainTriangulation fresh = made_at_once(s, level);
  ASSERT_EQ(triangles_of(level).size(), fresh.triangles.size());
  double twice = 0;
  const auto nodes = level.nodes();
  for (const auto& t : fresh.triangles) {
    const Point2 a = s.mesh.points[nodes[t[0]]], b = s.mesh.points[nodes[t[1]]],
                 c = s.mesh.points[nodes[t[2]]];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  ASSERT_NEAR(area_of(level), twice / 2, 1e-9 * twice);
}

class RandomEdits : public testing::TestWithParam<int> {};

TEST_P(RandomEdits, LeaveTheLevelAsIfMadeAtOnce) {
  const Subject s = GetParam() == 0 ? holed_grid() : slit_grid();
  auto level = EditableLevel::build(s.mesh, s.skeleton, s.special).value();
  const std::vector<Index> start = level.nodes();
  expect_like_made_at_once(s, level);
  Random random(7);
  std::size_t added = 0, removed = 0, refused = 0;
  for (int step = 0; step < 1500; ++step) {
    const auto v = static_cast<Index>(random.below(s.mesh.points.size()));
    if (s.skeleton.corners.at(v).empty() || std::ranges::binary_search(start, v)) continue;
    const bool grows = step % 300 < 200;
    if (level.has(v) == grows) continue;
    const std::size_t before = level.size();
    const auto triangles = triangles_of(level);
    const bool done = grows ? level.add(v, 0) : level.remove(v);
    ASSERT_EQ(level.has(v), done == grows);
    (grows ? added : removed) += done;
    refused += !done;
    if (!done) {
      ASSERT_EQ(level.size(), before);
      ASSERT_EQ(triangles_of(level).size(), triangles.size());
    }
    if (step % 50 == 0) expect_like_made_at_once(s, level);
  }
  expect_like_made_at_once(s, level);
  EXPECT_GT(added, 200u);
  EXPECT_GT(removed, 50u);
  RecordProperty("refused", static_cast<int>(refused));
}

TEST_P(RandomEdits, TellWhichTrianglesTheyMade) {
  const Subject s = GetParam() == 0 ? holed_grid() : slit_grid();
  auto level = EditableLevel::build(s.mesh, s.skeleton, s.special).value();
  Random random(8);
  for (int step = 0; step < 400; ++step) {
    const auto v = static_cast<Index>(random.below(s.mesh.points.size()));
    if (s.skeleton.corners.at(v).empty()) continue;
    const auto before = triangles_of(level);
    if (level.has(v) || !level.add(v, 0)) continue;
    const auto touched = level.touched();
    const auto told = level.triangles_among(touched);
    std::size_t known = 0;
    const Triangulation2& topology = level.triangulation().topology();
    for (const Index t : told) known += level.is_inside(t);
    std::size_t fresh = 0;
    const auto key = [](const auto& c) {
      return std::array{c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y};
    };
    for (const auto& t : triangles_of(level))
      fresh += !std::ranges::binary_search(before, key(t), {}, key);
    EXPECT_GE(known, fresh);
    for (const Index t : told)
      for (const Index corner : topology.vertices(t))
        EXPECT_TRUE(std::ranges::binary_search(touched, corner));
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, RandomEdits, testing::Values(0, 1));

TEST(EditableLevel, TakesTheTwinsOfASlitTogether) {
  const Subject s = slit_grid();
  auto level = EditableLevel::build(s.mesh, s.skeleton, s.special).value();
  const Index lip = 4 * 15 + 3;  // row 4, column 3
  ASSERT_TRUE(s.skeleton.boundary.twins.has_twin(lip));
  const Index twin = s.skeleton.boundary.twins.next[lip];
  const std::size_t before = level.size();
  ASSERT_TRUE(level.add(lip, 0));
  EXPECT_TRUE(level.has(twin));
  EXPECT_EQ(level.size(), before + 2);
  EXPECT_EQ(level.vertex(lip), level.vertex(twin));
  ASSERT_TRUE(level.remove(twin));
  EXPECT_FALSE(level.has(lip));
  EXPECT_EQ(level.size(), before);
}

TEST(EditableLevel, RefusesToBendItsBoundaryOverANode) {
  // The lower side of a square sags; a node inside lies above the chain, and below its middle.
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}, {1, 0.25}, {3, 0.25}};
  mesh.triangles = {{0, 5, 3}, {5, 4, 3}, {4, 2, 3}, {4, 6, 2}, {6, 1, 2}};
  const Skeleton skeleton = skeleton_of(mesh);
  const std::vector<Index> special = {0, 1, 2, 3};
  auto level = EditableLevel::build(mesh, skeleton, special).value();
  EXPECT_NEAR(area_of(level), 16, 1e-12);
  ASSERT_TRUE(level.add(4, 0));  // cuts off the chain's ends
  EXPECT_NEAR(area_of(level), 14, 1e-12);
  ASSERT_TRUE(level.add(5, 0));
  EXPECT_NEAR(area_of(level), 14.25, 1e-12);
  ASSERT_TRUE(level.remove(4));
  EXPECT_NEAR(area_of(level), 16 - 0.5, 1e-12);
}

TEST(EditableLevel, HasNoTrianglesOfIsolatedPoints) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}};
  const Skeleton skeleton = skeleton_of(mesh);
  const std::vector<Index> all = {0, 1, 2};
  EXPECT_FALSE(EditableLevel::build(mesh, skeleton, all)->has_triangles());
}

}  // namespace
}  // namespace wellspaced
