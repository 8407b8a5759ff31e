#include "wellspaced/io/formats/triangle_files.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"
#include "wellspaced/io/formats/formats.hpp"

namespace wellspaced {
namespace {

using test::TemporaryDirectory;

constexpr const char* kNode = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
constexpr const char* kEle = "2 3 0\n1 1 2 3\n2 1 3 4\n";
constexpr const char* kPoly = "0 2 0 1\n1 1\n1 1 2 5\n0\n";

void expect_error(const Result<Geometry>& result, ErrorCode code, const std::string& part) {
  ASSERT_FALSE(result.ok()) << part;
  EXPECT_EQ(result.error().code, code) << result.error().message;
  EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
}

TEST(ReadTriangleSet, ReadsAllSiblingsByTheNameOfAny) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  directory.write("a.ele", kEle);
  directory.write("a.poly", kPoly);
  for (const char* name : {"a.node", "a.ele", "a.poly"}) {
    const auto g = read_triangle_set(directory / name);
    ASSERT_TRUE(g.ok()) << g.error().message;
    EXPECT_EQ(g->mesh.points.size(), 4u);
    EXPECT_EQ(g->mesh.triangles.size(), 2u);
    EXPECT_EQ(g->mesh.segments, (std::vector<Segment>{{0, 1, 5}}));
    EXPECT_EQ(g->index_base, 1u);
  }
}

TEST(ReadTriangleSet, TakesPointsFromThePolyWhereThereIsNoNode) {
  const TemporaryDirectory directory;
  directory.write("a.poly", std::string(kNode) + "1 0\n1 2 3\n0\n");
  directory.write("a.ele", kEle);
  const auto g = read_triangle_set(directory / "a.ele");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->mesh.triangles.size(), 2u);
  EXPECT_EQ(g->mesh.segments.size(), 1u);
}

TEST(ReadTriangleSet, ComparesThePointsOfPolyAndNode) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  directory.write("a.poly", "2 2 0 0\n0 0 0\n1 1 0\n1 0\n0 0 1\n0\n");
  const auto g = read_triangle_set(directory / "a.node");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->mesh.points.size(), 4u);
  EXPECT_EQ(g->mesh.segments, (std::vector<Segment>{{0, 1, 0}})) << "bases may differ";
  directory.write("a.poly", "2 2 0 0\n0 0 0\n1 2 0\n1 0\n0 0 1\n0\n");
  expect_error(read_triangle_set(directory / "a.node"), ErrorCode::kInvalidGeometry,
               "its point 1 is not that of");
}

TEST(ReadTriangleSet, TakesMarkedEdgesWhereThereIsNoPoly) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  directory.write("a.ele", kEle);
  directory.write("a.edge", "3 1\n1 1 2 4\n2 1 3 0\n3 2 3 5\n");
  const auto g = read_triangle_set(directory / "a.ele");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->mesh.segments, (std::vector<Segment>{{0, 1, 4}, {1, 2, 5}}));
}

TEST(ReadTriangleSet, NamesTheMissingFile) {
  const TemporaryDirectory directory;
  expect_error(read_triangle_set(directory / "a.node"), ErrorCode::kUnreadable, "a.node");
  directory.write("a.ele", kEle);
  expect_error(read_triangle_set(directory / "a.ele"), ErrorCode::kUnreadable, "a.node");
  directory.write("a.poly", kPoly);
  expect_error(read_triangle_set(directory / "a.ele"), ErrorCode::kUnreadable,
               "holds no points, and");
  expect_error(read_triangle_set(directory / "a.node"), ErrorCode::kUnreadable, "a.node");
}

TEST(ReadTriangleSet, ReadsTetrahedra) {
  const TemporaryDirectory directory;
  directory.write("a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  directory.write("a.ele", "1 4 0\n0 0 1 2 3\n");
  const auto g = read_triangle_set(directory / "a.ele");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->solid.tets.size(), 1u);
}

TEST(ReadTriangleFile, ReadsTheNamedFileAlone) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  directory.write("a.ele", "broken");
  directory.write("a.poly", kPoly);
  EXPECT_TRUE(read_triangle_file(directory / "a.node")->mesh.segments.empty());
  const auto g = read_triangle_file(directory / "a.poly");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->mesh.points.size(), 4u);
  EXPECT_TRUE(g->mesh.triangles.empty());
  expect_error(read_triangle_file(directory / "a.ele"), ErrorCode::kUnreadable, "holds no points");
}

TEST(ReadTriangleFile, StopsAtTheSizeLimit) {
  const TemporaryDirectory directory;
  expect_error(read_triangle_file(directory.write("a.node", kNode), 10), ErrorCode::kLimit,
               "more than the 10 bytes");
}

TEST(WriteTriangleSet, WritesWhatThereIsAndReadsItBack) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  directory.write("a.ele", kEle);
  directory.write("a.poly", kPoly);
  const auto g = read_triangle_set(directory / "a.node");
  ASSERT_TRUE(g.ok());
  for (const char* name : {"b", "c.node", "d.ele", "e.poly", "f.edge"}) {
    OutputSet outputs;
    ASSERT_TRUE(write_triangle_set(outputs, directory / name, *g).ok());
    ASSERT_TRUE(outputs.commit().ok());
    const std::string set = triangle_set_name(directory / name);
    EXPECT_EQ(test::read_bytes(set + ".node"), kNode);
    EXPECT_EQ(test::read_bytes(set + ".ele"), kEle);
    EXPECT_EQ(test::read_bytes(set + ".poly"), "0 2 0 0\n1 1\n1 1 2 5\n0\n");
  }
  EXPECT_EQ(directory.count_files(), 3u + 5 * 3 + 1) << "only .edge asks for an edge file";
}

TEST(WriteTriangleSet, LeavesEmptyFilesOutUnlessAsked) {
  const TemporaryDirectory directory;
  Geometry g;
  g.mesh.points = {{0, 0}};
  OutputSet outputs;
  ASSERT_TRUE(write_triangle_set(outputs, directory / "a", g).ok());
  ASSERT_TRUE(write_triangle_set(outputs, directory / "b", g, EmptyFiles::kWrite).ok());
  ASSERT_TRUE(outputs.commit().ok());
  EXPECT_EQ(directory.count_files(), 4u);
  const auto back = read_triangle_set(directory / "b.node");
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(back->mesh.points, g.mesh.points);
}

TEST(TriangleSetName, CutsKnownExtensionsOnly) {
  EXPECT_EQ(triangle_set_name("d.1/X.node"), "d.1/X");
  EXPECT_EQ(triangle_set_name("X.1.ele"), "X.1");
  EXPECT_EQ(triangle_set_name("X.vtu"), "X.vtu");
  EXPECT_EQ(triangle_set_name(".node"), ".node");
}

}  // namespace
}  // namespace wellspaced
