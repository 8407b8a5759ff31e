#include "wellspaced/io/formats/formats.hpp"

#include <gtest/gtest.h>

#include "tests/support/data.hpp"
#include "tests/support/temporary_directory.hpp"

namespace wellspaced {
namespace {

using test::data_path;
using test::TemporaryDirectory;

constexpr const char* kNode = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";

Result<Geometry> mesh_with(const TemporaryDirectory& directory, std::string_view ele) {
  directory.write("a.node", kNode);
  directory.write("a.ele", ele);
  return read_mesh(directory / "a.ele");
}

TEST(ReadGeometry, KnowsFormatsByExtensionByNameAndByContent) {
  const TemporaryDirectory directory;
  EXPECT_EQ(read_geometry(directory.write("a.xyz", "1 2\n"))->mesh.points.size(), 1u);
  EXPECT_EQ(read_geometry(directory.write("a.node", kNode))->mesh.points.size(), 4u);
  EXPECT_EQ(read_geometry(directory.write("b", kNode))->mesh.points.size(), 4u);
  EXPECT_EQ(read_geometry(directory.write("c.txt", "1 2 3\n"))->dimension, 3);
  EXPECT_EQ(read_geometry(directory.write("d.txt", std::string(kNode) + "1 0\n1 1 2\n0\n"))
                ->mesh.segments.size(),
            1u);
  EXPECT_EQ(read_geometry(directory.write("e.txt", "7 8\n"), {.format = "xyz"})->mesh.points.size(),
            1u);
  EXPECT_EQ(read_geometry(directory / "a")->mesh.points.size(), 4u) << "the set without extension";
}

TEST(ReadGeometry, RefusesWhatItCannotRead) {
  const TemporaryDirectory directory;
  EXPECT_EQ(read_geometry(directory.write("a.svg", "")).error().code, ErrorCode::kUsage);
  EXPECT_EQ(read_geometry(directory.write("b", "1 2"), {.format = "exe"}).error().code,
            ErrorCode::kUsage);
  EXPECT_EQ(
      read_geometry(directory.write("c", "{\"json\": 1, \"is\": [\"no\", \"mesh\"]}")).error().code,
      ErrorCode::kUnreadable);
}

TEST(ReadMesh, SaysThatItTurnedAClockwiseMesh) {
  const TemporaryDirectory directory;
  const auto g = mesh_with(directory, "2 3 0\n1 1 3 2\n2 1 4 3\n");
  ASSERT_TRUE(g.ok()) << g.error().message;
  ASSERT_EQ(g->notes.size(), 1u);
  EXPECT_NE(g->notes[0].find("clockwise and have been turned"), std::string::npos);
  EXPECT_EQ(g->mesh.segments.size(), 4u);
}

TEST(ReadMesh, NamesFileAndItemOfInvalidMeshes) {
  const TemporaryDirectory directory;
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"2 3 0\n1 1 2 3\n2 1 4 3\n", "a.ele: triangle 2 (1, 4, 3) is clockwise"},
      {"2 3 0\n1 1 2 3\n2 1 1 3\n", "a.ele: triangle 2 (1, 1, 3) has no area"},
      {"2 3 0\n1 1 2 3\n2 1 2 4\n", "a.ele: edge 1-2 has triangles 1 and 2 on the same side"},
      {"2 3 0\n1 1 2 3\n2 1 2 5\n", "a.ele:3: point 5 is not among the points"}};
  for (const auto& [ele, message] : cases) {
    const auto g = mesh_with(directory, ele);
    ASSERT_FALSE(g.ok()) << message;
    EXPECT_EQ(g.error().code, ErrorCode::kInvalidGeometry);
    EXPECT_NE(g.error().message.find(message), std::string::npos) << g.error().message;
  }
}

TEST(ReadMesh, RefusesFilesWithoutTriangles) {
  const TemporaryDirectory directory;
  const auto g = read_mesh(directory.write("a.node", kNode));
  ASSERT_FALSE(g.ok());
  EXPECT_EQ(g.error().code, ErrorCode::kUnreadable);
  EXPECT_NE(g.error().message.find("holds no triangles"), std::string::npos);
}

TEST(WriteGeometry, RefusesUnknownFormats) {
  const TemporaryDirectory directory;
  OutputSet outputs;
  EXPECT_EQ(write_geometry(outputs, directory / "a.exe", "", {}).error().code, ErrorCode::kUsage);
  EXPECT_EQ(write_geometry(outputs, directory / "a", "exe", {}).error().code, ErrorCode::kUsage);
  Geometry solid;
  solid.dimension = 3;
  EXPECT_EQ(write_geometry(outputs, directory / "a.svg", "", solid).error().code,
            ErrorCode::kUsage);
}

// A square of two triangles with one marked edge.
Geometry square() {
  Geometry g;
  g.mesh.points = {{0.1, 0.2}, {3, -0.0}, {2.5, 1e30}, {5e-324, 3}};
  g.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  g.mesh.segments = {{0, 1, 5}};
  return g;
}

TEST(Formats, WriteMeshesThatTheyReadBack) {
  for (const Format& format : formats()) {
    if (!format.readable() || format.write == nullptr || format.extensions.empty()) continue;
    const TemporaryDirectory directory;
    const std::string extension(format.extensions.substr(0, format.extensions.find(' ')));
    const std::string path = directory / ("a" + extension);
    OutputSet outputs;
    const Status status = write_geometry(outputs, path, std::string(format.name), square());
    if (!status.ok()) {
      EXPECT_EQ(status.error().code, ErrorCode::kUsage) << format.name;
      continue;
    }
    ASSERT_TRUE(outputs.commit().ok());
    const auto back = read_geometry(path);
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(back->dimension, 2) << format.name;
    EXPECT_EQ(back->mesh.points, square().mesh.points) << format.name;
    const bool points_only = format.name == "f64" || format.name == "xyz";
    const bool no_triangles = points_only || format.name == "metis";
    EXPECT_EQ(back->mesh.triangles.empty(), no_triangles) << format.name;
  }
}

// ---- Real meshes ---------------------------------------------------------------------------

TEST(RealMeshes, HaveTheSizesOfTheirDescription) {
  struct Expected {
    const char* name;
    std::size_t nodes, triangles;
  };
  for (const auto& [name, nodes, triangles] :
       {Expected{"thesis/airfoil1", 4253, 8034}, Expected{"thesis/airfoil3", 15606, 30269},
        Expected{"thesis/airfoil3_original", 15606, 30269}, Expected{"thesis/crack", 10183, 20141},
        Expected{"thesis/crack_float32", 10183, 20141},
        Expected{"thesis/crack_merged", 10183, 20141}, Expected{"thesis/crack_slit", 10240, 20141},
        Expected{"graded/su2_naca0012_inv", 5233, 10216},
        Expected{"graded/adcirc_shinnecock", 3070, 5780},
        Expected{"graded/thetis_north_sea_demo", 13192, 23067}}) {
    WELLSPACED_REQUIRE_DATA(std::string(name) + ".ele");
    const auto g = read_mesh(data_path(std::string(name) + ".ele"));
    ASSERT_TRUE(g.ok()) << g.error().message;
    EXPECT_EQ(g->mesh.points.size(), nodes) << name;
    EXPECT_EQ(g->mesh.triangles.size(), triangles) << name;
    EXPECT_TRUE(g->notes.empty()) << name;
  }
}

TEST(RealMeshes, HaveFiftySevenPairsAlongTheSlitOfCrack) {
  WELLSPACED_REQUIRE_DATA("thesis/crack_slit.ele");
  auto g = read_geometry(data_path("thesis/crack_slit.ele"));
  ASSERT_TRUE(g.ok());
  const auto found = prepare_mesh(g->mesh, g->index_base);
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_EQ(found->slit_points, 2u * 57);
  EXPECT_EQ(found->recovered_segments, 0u);
}

TEST(RealMeshes, HaveTheBoundaryThatTheirTrianglesTell) {
  WELLSPACED_REQUIRE_DATA("graded/thetis_north_sea_demo.ele");
  auto listed = read_geometry(data_path("graded/thetis_north_sea_demo.ele"));
  ASSERT_TRUE(listed.ok());
  Geometry bare = *listed;
  bare.mesh.segments.clear();
  ASSERT_TRUE(prepare_mesh(listed->mesh).ok());
  ASSERT_TRUE(prepare_mesh(bare.mesh).ok());
  EXPECT_EQ(bare.mesh.segments.size(), listed->mesh.segments.size());
}

TEST(RealMeshes, ComeBackBitForBit) {
  WELLSPACED_REQUIRE_DATA("thesis/airfoil1.ele");
  const TemporaryDirectory directory;
  const auto g = read_mesh(data_path("thesis/airfoil1.ele"));
  ASSERT_TRUE(g.ok());
  OutputSet outputs;
  ASSERT_TRUE(write_geometry(outputs, directory / "a.node", "", *g).ok());
  ASSERT_TRUE(outputs.commit().ok());
  const auto back = read_mesh(directory / "a.poly");
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(back->mesh.points, g->mesh.points);
  EXPECT_EQ(back->mesh.triangles, g->mesh.triangles);
  EXPECT_EQ(back->mesh.segments, g->mesh.segments);
  EXPECT_EQ(back->mesh.point_markers, g->mesh.point_markers);
  EXPECT_EQ(back->holes, g->holes);
  EXPECT_EQ(back->index_base, 1u);
}

}  // namespace
}  // namespace wellspaced
