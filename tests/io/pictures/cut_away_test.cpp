#include "wellspaced/io/pictures/cut_away.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "tests/support/solids.hpp"
#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

TetMesh packed(const Pls& domain) {
  auto result = pack_domain3(domain);
  EXPECT_TRUE(result.ok());
  return result.ok() ? std::move(result->mesh) : TetMesh{};
}

double area_of(const TetMesh& mesh, const SeenFace& face) {
  const Point3 a = mesh.points[face.corners[0]];
  return length(cross(mesh.points[face.corners[1]] - a, mesh.points[face.corners[2]] - a)) / 2;
}

std::string picture(const TetMesh& mesh, const CutAwayOptions& options = {}) {
  TextWriter out;
  write_cut_away_svg(out, mesh, options);
  return out.text();
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

// How near to the viewer the face is on the line of sight through x; none where it is beside it.
std::optional<double> nearness_at(const TetMesh& mesh, const SeenFace& face, Point3 x,
                                  Point3 viewer) {
  std::array<Point3, 3> p;
  for (int i = 0; i < 3; ++i) p[i] = mesh.points[face.corners[i]] - x;
  std::array<double, 3> share{};
  for (int i = 0; i < 3; ++i) share[i] = dot(viewer, cross(p[(i + 1) % 3], p[(i + 2) % 3]));
  const double whole = share[0] + share[1] + share[2];
  if (std::min({share[0], share[1], share[2]}) <= 1e-9 * whole) return std::nullopt;
  double nearness = 0;
  for (int i = 0; i < 3; ++i) nearness += share[i] / whole * dot(viewer, p[i]);
  return nearness;
}

TEST(CutAway, ShowsThreeSidesOfACube) {
  const TetMesh cube = packed(test::unit_cube());
  CutAwayOptions options;
  options.cut = 0;
  double area = 0;
  for (const SeenFace& face : seen_faces(cube, options)) {
    EXPECT_FALSE(face.is_cut);
    EXPECT_GT(dot(face.outwards, options.from), 0);
    area += area_of(cube, face);
  }
  EXPECT_NEAR(area, 3, 1e-9);
}

TEST(CutAway, TakesAwayWhatIsBeforeThePlane) {
  const TetMesh cube = packed(test::unit_cube());
  CutAwayOptions options;
  options.cut = 0.4;
  double cut_area = 0, others = 0;
  for (const SeenFace& face : seen_faces(cube, options)) {
    (face.is_cut ? cut_area : others) += area_of(cube, face) * face.outwards.x;
    for (const Index v : face.corners) EXPECT_LT(cube.points[v].x, 0.85);
  }
  EXPECT_NEAR(cut_area, 1, 0.15) << "what is cut open, seen along the normal";
  EXPECT_NEAR(others, 0, 1e-9);
  options.cut = 1;
  EXPECT_TRUE(seen_faces(cube, options).empty());
}

// On random lines of sight the faces come from back to front.
TEST(CutAway, GoesFromBackToFrontInDelaunayMeshes) {
  for (const Pls& domain : {test::unit_cube(), test::l_prism()}) {
    const TetMesh mesh = packed(domain);
    for (const Point3 from : {Point3{1, -0.6, 0.5}, Point3{0.3, 0.2, -1}, Point3{-1, 2, 0.1}}) {
      CutAwayOptions options;
      options.from = from;
      const std::vector<SeenFace> faces = seen_faces(mesh, options);
      Random random(4);
      int met = 0;
      for (int k = 0; k < 200; ++k) {
        const Point3 x{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)};
        double last = -1e9;
        for (const SeenFace& face : faces) {
          const auto nearness = nearness_at(mesh, face, x, from);
          if (!nearness) continue;
          EXPECT_GE(*nearness, last - 1e-9);
          last = *nearness;
          ++met;
        }
      }
      EXPECT_GT(met, 20);
    }
  }
}

TEST(CutAway, DrawsEachFaceOnce) {
  const TetMesh mesh = packed(test::unit_cube());
  const std::string text = picture(mesh);
  EXPECT_EQ(text, picture(mesh));
  EXPECT_EQ(text.rfind("<svg ", 0), 0u);
  EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
  const std::size_t faces = seen_faces(mesh, {}).size();
  EXPECT_LE(count_of(text, "<path"), faces);
  EXPECT_GT(count_of(text, "<path"), faces * 9 / 10);
}

TEST(CutAway, IsTheSameAtEveryScale) {
  const TetMesh mesh = packed(test::unit_cube());
  for (const double scale : {0x1p-1000, 0x1p1020}) {
    TetMesh scaled = mesh;
    for (Point3& p : scaled.points) p = scale * p;
    EXPECT_EQ(picture(scaled), picture(mesh));
  }
}

TEST(CutAway, TakesTetsThatAreInvertedOrFlat) {
  TetMesh mesh;
  EXPECT_EQ(count_of(picture(mesh), "<path"), 0u);
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  mesh.tets = {{0, 1, 2, 4}, {0, 1, 1, 2}};
  EXPECT_TRUE(seen_faces(mesh, {}).empty());
  mesh.tets = {{1, 0, 2, 3}};
  CutAwayOptions options;
  options.cut = 0;
  for (const SeenFace& face : seen_faces(mesh, options)) {
    Point3 middle;
    for (const Index v : face.corners) middle = middle + (1.0 / 3) * mesh.points[v];
    EXPECT_GT(dot(face.outwards, middle - Point3{0.2, 0.2, 0.2}), 0);
  }
  options.from = {0, 0, 1};
  EXPECT_EQ(seen_faces(mesh, options).size(), 1u);
}

}  // namespace
}  // namespace wellspaced
