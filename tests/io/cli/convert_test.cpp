#include <gtest/gtest.h>

#include "tests/support/json.hpp"
#include "tests/support/program.hpp"
#include "wellspaced/io/formats/formats.hpp"

namespace wellspaced {
namespace {

using test::read_bytes;
using test::run_program;
using test::TemporaryDirectory;

constexpr const char* kNode = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
constexpr const char* kEle = "2 3 0\n1 1 2 3\n2 1 3 4\n";

std::string write_square(const TemporaryDirectory& directory) {
  directory.write("a.node", kNode);
  return directory.write("a.ele", kEle);
}

TEST(Convert, WritesAMeshInEveryFormat) {
  const TemporaryDirectory directory;
  const std::string mesh = write_square(directory);
  for (const char* name : {"b.vtu", "b.vtk", "b.svg", "b.xyz", "b.f64", "b.node", "b.edge"}) {
    const auto run = run_program({"convert", mesh, directory / name});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const bool points_alone = name == std::string("b.xyz") || name == std::string("b.f64");
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.find("triangles") != std::string::npos, points_alone) << run.err;
    EXPECT_GT(read_bytes(directory / name).size(), 10u) << name;
  }
  EXPECT_EQ(read_bytes(directory / "b.ele"), kEle) << "the index base is kept";
  EXPECT_EQ(read_bytes(directory / "b.poly"),
            "0 2 0 0\n4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n");
}

// Two triangles, an inner segment, and all that can be said of them.
std::string write_laden_square(const TemporaryDirectory& directory) {
  directory.write("a.node", "4 2 1 1\n1 0 0 .5 3\n2 1 0 .5 0\n3 1 1 .5 0\n4 0 1 .5 0\n");
  directory.write("a.poly",
                  "0 2 0 1\n5 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n5 1 3 -5\n1\n1 9 9\n"
                  "1\n1 .7 .2 7 .1\n");
  return directory.write("a.ele", "2 3 1\n1 1 2 3 7\n2 1 3 4 8\n");
}

// Nothing was said: holes, regions, attributes and markers vanished on the way.
TEST(Convert, SaysWhatTheFormatHasNoPlaceFor) {
  const TemporaryDirectory directory;
  const std::string mesh = write_laden_square(directory);
  const std::pair<const char*, const char*> notes[] = {
      {"b.node", ""},
      {"b.vtu", "holes and regions: left out"},
      {"b.msh", "attributes of points, holes and regions: left out"},
      {"b.mesh", "attributes of points, holes and regions: left out"},
      {"b.mfem", "attributes of points, markers of points, markers below 1, holes and regions"},
      {"b.su2",
       "attributes of points, markers of points, attributes of triangles or tetrahedra, holes"},
      {"b.off",
       "attributes of triangles or tetrahedra, segments, markers of segments, markers below 1"},
      {"b.xyz", "attributes of points, markers of points, triangles or tetrahedra"},
      {"b.svg", ""}};
  for (const auto& [name, words] : notes) {
    const auto run = run_program({"convert", mesh, directory / name});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err.empty(), *words == 0) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << name << ": " << run.err;
  }
}

// What a format is said to keep comes back.
TEST(Convert, BringsBackWhatIsSaidToBeKept) {
  const TemporaryDirectory directory;
  const std::string mesh = write_laden_square(directory);
  for (const Format& format : formats()) {
    if (format.write == nullptr || !format.readable()) continue;
    SCOPED_TRACE(format.name);
    const std::string name(format.name);
    const std::string extension(format.extensions.substr(0, format.extensions.find(' ')));
    const std::string path = directory / (name + (extension.empty() ? ".x" : extension));
    const auto there = run_program({"convert", mesh, path, "--format", name});
    if (there.exit_code == 2) continue;  // for domains in space alone
    const auto geometry = read_geometry(
        path, {.format = name == "metis" || name == "triangle" || name == "poly" ? "" : name});
    ASSERT_TRUE(geometry.ok()) << geometry.error().message;
    const auto original = read_geometry(mesh);
    ASSERT_TRUE(original.ok());
    const unsigned left_out = format.keeps & parts_of(*original) & ~parts_of(*geometry);
    EXPECT_EQ(left_out, 0u);
  }
}

TEST(Convert, RefusesPolygonsInSpaceWhereTheFormatHasNoPlaceForThem) {
  constexpr const char* kPolygon =
      "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 1\n4 0 1 1\n1 0\n1 0\n4 1 2 3 4\n0\n";
  const TemporaryDirectory directory;
  const std::string domain = directory.write("a.poly", kPolygon);
  for (const char* name : {"b.vtu", "b.vtk", "b.msh"})
    EXPECT_EQ(run_program({"convert", domain, directory / name}).exit_code, 2) << name;
  EXPECT_EQ(run_program({"convert", domain, directory / "b.off"}).exit_code, 0);
}

TEST(Convert, WritesTrianglesFilesWhereTheNameSaysNothing) {
  const TemporaryDirectory directory;
  const std::string mesh = write_square(directory);
  EXPECT_EQ(run_program({"convert", mesh, "-o", directory / "b"}).exit_code, 0);
  EXPECT_EQ(read_bytes(directory / "b.ele"), kEle);
}

// They became hidden files: "dir/.node".
// A tetrahedral mesh as b.poly came out as b.node, b.ele, b.face and b.edge alone.
TEST(Convert, WritesTheFileOfASetThatWasNamed) {
  const TemporaryDirectory directory;
  const std::string tet =
      directory.write("a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  const std::string cloud = directory.write("c.xyz", "0 0\n1 0\n0 1\n");
  directory.write("a.ele", "1 4 0\n1 1 2 3 4\n");
  directory.write("a.face", "2 1\n1 1 2 3 7\n2 1 2 4 8\n");
  directory.write("a.edge", "1 1\n1 1 2 5\n");
  EXPECT_EQ(run_program({"convert", tet, directory / "b.poly"}).exit_code, 0);
  EXPECT_EQ(run_program({"convert", directory / "b.poly", directory / "d.node"}).exit_code, 0);
  for (const char* extension : {".node", ".ele", ".face", ".edge"})
    EXPECT_EQ(read_bytes(directory / (std::string("a") + extension)),
              read_bytes(directory / (std::string("d") + extension)))
        << extension;
  EXPECT_EQ(read_bytes(directory / "b.poly").substr(0, 14), "0 3 0 0\n3 1\n1 ");
  EXPECT_EQ(run_program({"convert", cloud, directory / "e.ele"}).exit_code, 0);
  EXPECT_EQ(run_program({"convert", directory / "e.ele", directory / "f.xyz"}).exit_code, 0);
}

TEST(Convert, RefusesTheNameOfAFolderForASetOfFiles) {
  const TemporaryDirectory directory;
  const std::string mesh = write_square(directory);
  for (const char* name : {"", ".", "..", ".node"}) {
    const auto run = run_program({"convert", mesh, "-o", directory / name, "--format", "triangle"});
    EXPECT_EQ(run.exit_code, 2) << name;
    EXPECT_NE(run.err.find("names a folder"), std::string::npos) << run.err;
    EXPECT_EQ(run_program({"triangulate", directory / "a.node", "-o", directory / name}).exit_code,
              2)
        << name;
  }
}

TEST(Convert, PassesDataThroughTheStandardStreams) {
  const auto run = run_program({"convert", "-", "-", "--format", "xyz"}, kNode);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "0 0\n1 0\n1 1\n0 1\n");
  EXPECT_EQ(run_program({"convert", "-", "-o", "-", "--format=xyz"}, "1 2\n").out, "1 2\n");
}

TEST(Convert, ReportsCountsAsJson) {
  const TemporaryDirectory directory;
  const auto run = run_program(
      {"convert", write_square(directory), "/dev/null", "--format", "vtu", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto tree = parse_json(run.out, "stdout");
  ASSERT_TRUE(tree.ok()) << run.out;
  const test::JsonView json(&*tree);
  EXPECT_EQ(json["points"].number(), 4);
  EXPECT_EQ(json["triangles"].number(), 2);
  EXPECT_EQ(json["segments"].number(), 4);
}

TEST(Convert, WritesNothingOnAnError) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  const std::string mesh = directory.write("a.ele", "2 3 0\n1 1 2 3\n2 1 4 3\n");
  const auto run = run_program({"convert", mesh, directory / "b.vtu", "--json", directory / "j"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.err.find("is clockwise"), std::string::npos);
  EXPECT_EQ(directory.count_files(), 2u);
  EXPECT_EQ(run_program({"convert", mesh}).exit_code, 2);
  EXPECT_EQ(run_program({"convert", mesh, "x.vtu", "-o", "y.vtu"}).exit_code, 2);
  EXPECT_EQ(run_program({"convert", directory / "a.node", directory / "no/b.xyz"}).exit_code, 4);
  EXPECT_EQ(run_program({"convert", "-", directory / "no/b.xyz"}, "1 2").exit_code, 2);
  EXPECT_EQ(directory.count_files(), 2u);
}

TEST(Convert, SaysOnTheStandardErrorWhatItChanged) {
  const TemporaryDirectory directory;
  directory.write("a.node", kNode);
  const std::string mesh = directory.write("a.ele", "2 3 0\n1 3 2 1\n2 4 3 1\n");
  EXPECT_NE(run_program({"convert", mesh, directory / "b.node"}).err.find("note: "),
            std::string::npos);
  EXPECT_EQ(run_program({"convert", mesh, directory / "b.node", "--quiet"}).err, "");
}

}  // namespace
}  // namespace wellspaced
