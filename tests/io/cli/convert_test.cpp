#include <gtest/gtest.h>

#include "tests/support/json.hpp"
#include "tests/support/program.hpp"

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
    EXPECT_EQ(run.out + run.err, "");
    EXPECT_GT(read_bytes(directory / name).size(), 10u) << name;
  }
  EXPECT_EQ(read_bytes(directory / "b.ele"), kEle) << "the index base is kept";
  EXPECT_EQ(read_bytes(directory / "b.poly"),
            "0 2 0 0\n4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n");
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
