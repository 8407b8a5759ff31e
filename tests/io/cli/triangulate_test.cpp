#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/data.hpp"
#include "tests/support/json.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sanitizer.hpp"

namespace wellspaced {
namespace {

using test::JsonView;
using test::read_bytes;
using test::run_program;
using test::TemporaryDirectory;

constexpr const char* kSquare = "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n";
// A square with a square hole that no seed names.
constexpr const char* kFrame =
    "8 2 0 1\n1 0 0 1\n2 9 0 1\n3 9 9 1\n4 0 9 1\n5 3 3 2\n6 6 3 2\n7 6 6 2\n8 3 6 2\n"
    "8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n0\n";

// What the command says as JSON.
class Answer {
 public:
  explicit Answer(const std::vector<std::string>& words, const std::string& input = "") {
    std::vector<std::string> all = {"triangulate"};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"--json", "-"});
    const auto run = run_program(all, input);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto tree = parse_json(run.out, "stdout");
    EXPECT_TRUE(tree.ok()) << run.out;
    if (tree.ok()) tree_ = *tree;
  }
  JsonView operator[](std::string_view name) const { return JsonView(&tree_)[name]; }

 private:
  JsonValue tree_;
};

// Two triangles, marked 7 and 9, and a point in one of them.
constexpr const char* kMarkedMesh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
    "5 .3 .4 0\n$EndNodes\n$Elements\n2\n1 2 2 7 7 1 2 3\n2 2 2 9 9 1 3 4\n$EndElements\n";

// They were written beside the new triangles, and beyond their end whatever memory held.
TEST(Triangulate, LeavesOutTheAttributesOfTrianglesThatAreGone) {
  const TemporaryDirectory directory;
  const auto run = run_program({"triangulate", "-", "-o", directory / "t"}, kMarkedMesh);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("attributes of its elements are left out"), std::string::npos);
  EXPECT_EQ(read_bytes(directory / "t.ele").substr(0, 6), "4 3 0\n");
}

// The result is a mesh, which other commands read.
TEST(Triangulate, WritesNoSegmentsOutsideTheDomain) {
  const TemporaryDirectory directory;
  const std::string tail =
      "6 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 6 0\n6 8 3\n"
      "6 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 2 5 2\n6 5 6 2\n0\n";
  const auto run = run_program({"triangulate", "-", "-o", directory / "t"}, tail);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("2 segments lie outside the domain"), std::string::npos) << run.err;
  EXPECT_EQ(run_program({"coarsen", directory / "t"}).exit_code, 0);
  EXPECT_EQ(run_program({"audit", directory / "t"}).exit_code, 0);
}

TEST(Triangulate, ListsNoSeedsOfHolesThatAreNone) {
  const TemporaryDirectory directory;
  const auto run = run_program({"triangulate", "-", "-o", directory / "t"},
                               "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n0 0\n1\n0 1 1\n");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("1 hole seed lies in the mesh"), std::string::npos) << run.err;
  EXPECT_EQ(run_program({"audit", directory / "t"}).exit_code, 0);
}

TEST(Triangulate, PrintsTheKeysOfItsContract) {
  const Answer json({"-", "--cells-hash"}, kSquare);
  for (const char* key : {"points", "distinct_points", "dimension", "triangles", "tets",
                          "hull_points", "added_points", "constrained_edges", "duplicates",
                          "cells_sha256", "seconds", "cpu_seconds", "peak_bytes"})
    EXPECT_TRUE(json[key].exists()) << key;
  for (const char* key : {"read", "triangulate", "write"}) {
    EXPECT_GE(json["seconds"][key].number(), 0) << key;
    EXPECT_GE(json["cpu_seconds"][key].number(), 0) << key;
  }
  EXPECT_EQ(json["triangles"].number(), 2);
  EXPECT_TRUE(json["tets"].is_null());
  EXPECT_EQ(json["cells_sha256"].text().size(), 64u);
  EXPECT_TRUE(Answer({"-"}, kSquare)["cells_sha256"].is_null());
}

TEST(Triangulate, CountsDuplicatesAndSaysTheDimension) {
  const Answer square({"-"}, "0 0\n1 0\n0 1\n1 0\n-0 0\n");
  EXPECT_EQ(square["points"].number(), 5);
  EXPECT_EQ(square["distinct_points"].number(), 3);
  EXPECT_EQ(square["duplicates"].number(), 2);
  EXPECT_EQ(square["dimension"].number(), 2);
  const std::vector<std::pair<const char*, int>> cases = {
      {"", -1}, {"1 1\n1 1\n", 0}, {"0 0\n1 1\n3 3\n", 1}};
  for (const auto& [points, dimension] : cases) {
    const Answer json({"-"}, points);
    EXPECT_EQ(json["dimension"].number(), dimension) << points;
    EXPECT_EQ(json["triangles"].number(), 0) << points;
    EXPECT_EQ(json["hull_points"].number(), dimension + 1) << points;
  }
}

TEST(Triangulate, ObeysTheHoleRules) {
  const TemporaryDirectory directory;
  const std::string bare = directory.write("a.poly", kFrame);
  EXPECT_EQ(Answer({bare})["triangles"].number(), 8) << "parity, as there are no seeds";
  EXPECT_EQ(Answer({bare, "--holes", "none"})["triangles"].number(), 10);
  EXPECT_EQ(Answer({bare, "--holes", "outer"})["triangles"].number(), 10);
  EXPECT_EQ(Answer({bare, "--holes", "seeds"})["triangles"].number(), 10);
  std::string seeded = kFrame;
  seeded.replace(seeded.size() - 2, 2, "1\n1 1 1\n");  // the frame, not the window, is the hole
  const Answer json({directory.write("b.poly", seeded)});
  EXPECT_EQ(json["triangles"].number(), 2);
  EXPECT_EQ(json["constrained_edges"].number(), 8);
}

TEST(Triangulate, WritesTheSetWithTheIndexBaseOfItsInput) {
  const TemporaryDirectory directory;
  const std::string poly = directory.write("a.poly", kFrame);
  for (const char* name : {"b", "c.node"})
    EXPECT_EQ(run_program({"triangulate", poly, "-o", directory / name}).exit_code, 0);
  for (const char* extension : {".node", ".ele", ".poly"}) {
    EXPECT_EQ(read_bytes(directory / ("b" + std::string(extension))),
              read_bytes(directory / ("c" + std::string(extension))));
  }
  EXPECT_EQ(read_bytes(directory / "b.node").rfind("8 2 0 1\n1 0 0 1\n", 0), 0u);
  EXPECT_EQ(read_bytes(directory / "b.ele").rfind("8 3 0\n1 ", 0), 0u);
  EXPECT_EQ(read_bytes(directory / "b.poly").rfind("0 2 0 1\n8 1\n1 1 2 1\n", 0), 0u);
  const auto run = run_program({"convert", directory / "b.ele", directory / "b.svg"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(Triangulate, WritesAllThreeFilesEvenWithoutATriangle) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run_program({"triangulate", "-", "-o", directory / "a"}, "0 0\n1 1\n").exit_code, 0);
  EXPECT_EQ(directory.count_files(), 3u);
  EXPECT_EQ(read_bytes(directory / "a.ele"), "0 3 0\n");
}

TEST(Triangulate, TriangulatesSpace) {
  const TemporaryDirectory directory;
  const Answer json({"-", "-o", directory / "a"}, "0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 2 2\n");
  EXPECT_EQ(json["dimension"].number(), 3);
  EXPECT_EQ(json["tets"].number(), 2);
  EXPECT_TRUE(json["triangles"].is_null());
  EXPECT_EQ(json["hull_points"].number(), 5);
  EXPECT_EQ(read_bytes(directory / "a.ele").rfind("2 4 0\n0 ", 0), 0u);
}

TEST(Triangulate, WritesTheSameBytesWithTwoThreads) {
  const TemporaryDirectory directory;
  const std::string points = directory / "points.f64";
  ASSERT_EQ(run_program({"generate", "box3", "--nodes", "33000", "-o", points}).exit_code, 0);
  for (const char* const threads : {"1", "2"})
    ASSERT_EQ(run_program({"triangulate", points, "--threads", threads, "-o",
                           directory / (std::string("t") + threads + ".ele")})
                  .exit_code,
              0);
  const std::string one = read_bytes(directory / "t1.ele");
  EXPECT_GT(one.size(), 1000000u);
  EXPECT_TRUE(one == read_bytes(directory / "t2.ele"));
}

TEST(Triangulate, PrintsOneLineWithoutJsonAndNothingWhenQuiet) {
  EXPECT_EQ(run_program({"triangulate", "-"}, kSquare).out,
            "4 points, dimension 2, 2 triangles, 4 hull points\n");
  EXPECT_EQ(run_program({"triangulate", "-", "--quiet"}, kSquare).out, "");
}

TEST(Triangulate, RefusesBadOptionsAndBadData) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run_program({"triangulate", "-", "--holes", "all"}, kSquare).exit_code, 2);
  EXPECT_EQ(run_program({"triangulate", "-", "--intersections", "ask"}, kSquare).exit_code, 2);
  EXPECT_EQ(run_program({"triangulate", "-"}, "1 2\n3 nan\n").exit_code, 4);
  EXPECT_EQ(run_program({"triangulate", "-"}, "1 2\n3 x\n").exit_code, 3);
  EXPECT_EQ(run_program({"triangulate", directory / "none.node"}).exit_code, 3);
  const std::string cross =
      directory.write("x.poly", "4 2 0 0\n0 0 0\n1 1 1\n2 0 1\n3 1 0\n2 0\n0 0 1\n1 2 3\n0\n");
  const auto refused = run_program({"triangulate", cross, "--intersections", "refuse", "-o",
                                    directory / "y", "--json", directory / "j"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_NE(refused.err.find("cross"), std::string::npos);
  EXPECT_EQ(directory.count_files(), 1u);
}

TEST(Triangulate, StopsAtItsTimeLimit) {
  const TemporaryDirectory directory;
  const auto run =
      run_program({"triangulate", "-", "--time-limit", "1e-9", "-o", directory / "a"}, kFrame);
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_NE(run.err.find("--time-limit"), std::string::npos);
  EXPECT_EQ(directory.count_files(), 0u);
}

TEST(Triangulate, RunsOutOfMemoryInGoodOrder) {
  if (!test::kMemoryCanBeLimited) GTEST_SKIP() << "the sanitizer needs more than the limit";
  const TemporaryDirectory directory;
  std::string points;
  for (int i = 0; i < 200000; ++i)
    points += std::to_string(i % 997) + ' ' + std::to_string(i % 1009) + '\n';
  const auto run =
      run_program({"triangulate", "-", "--max-memory", "8", "-o", directory / "a"}, points);
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(directory.count_files(), 0u);
}

// ---- The public bug reports ----------------------------------------------------------------

void check_counts(const std::string& name, JsonView truth, const Answer& json) {
  const auto check = [&](const char* mine, const char* theirs) {
    if (!truth[theirs].exists()) return;
    EXPECT_EQ(json[mine].number(), truth[theirs].number()) << name << ' ' << mine;
  };
  check("points", "input_points");
  check("distinct_points", "distinct_points");
  check("dimension", "dimension");
  check("hull_points", "hull_boundary_points");
  if (!name.ends_with(".poly")) {
    check("triangles", "dt_triangles");
    if (truth["dt_unique"].is_true()) check("tets", "dt_tets");
    return;
  }
  check("triangles", "cdt_triangles");
  check("added_points", "cdt_added_vertices");
  check("constrained_edges", "cdt_constrained_subsegments");
}

void check_case(const std::string& name, JsonView truth) {
  const std::string path = test::data_path("issues/" + name);
  const Answer json({path, "--holes", "none", "--cells-hash"});
  const std::string hash = name.ends_with(".poly") ? "cdt_cells_sha256" : "dt_cells_sha256";
  if (truth[hash].exists()) {
    EXPECT_EQ(json["cells_sha256"].text(), truth[hash].text()) << name;
  }
  check_counts(name, truth, json);
}

TEST(Triangulate, AgreesWithTheTruthOnPublicBugReports) {
  WELLSPACED_REQUIRE_DATA("issues/truth.json");
  const auto tree = parse_json(read_bytes(test::data_path("issues/truth.json")), "truth.json");
  ASSERT_TRUE(tree.ok());
  int checked = 0;
  for (const auto& [name, entry] : tree->find("cases")->members) {
    const JsonView truth = JsonView(&entry)["truth"];
    if (truth["cdt_added_vertices"].number() > 0) continue;  // rounded crossings: elsewhere
    check_case(name, truth);
    ++checked;
  }
  EXPECT_GE(checked, 190);
}

// Where crossings must be rounded, the result has the vertices and sub-segments of the exact one.
TEST(Triangulate, RoundsCrossingsOfPublicBugReportsWithoutChangingTheTopology) {
  WELLSPACED_REQUIRE_DATA("issues/truth.json");
  const auto tree = parse_json(read_bytes(test::data_path("issues/truth.json")), "truth.json");
  ASSERT_TRUE(tree.ok());
  int rounded = 0;
  for (const auto& [name, entry] : tree->find("cases")->members) {
    const JsonView truth = JsonView(&entry)["truth"];
    if (!(truth["cdt_added_vertices"].number() > 0)) continue;
    check_counts(name, truth, Answer({test::data_path("issues/" + name), "--holes", "none"}));
    ++rounded;
  }
  EXPECT_GE(rounded, 28);
}

}  // namespace
}  // namespace wellspaced
