// wellspaced audit, as a CI job meets it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/data.hpp"
#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::run_program;
using test::TemporaryDirectory;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A square of two triangles, written by hand.
struct Square {
  TemporaryDirectory directory;
  std::string name = directory / "square.node";

  explicit Square(const std::string& triangles = "2 3 0\n1 1 2 3\n2 1 3 4\n") {
    directory.write("square.node", "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n");
    directory.write("square.ele", triangles);
  }
};

TEST(AuditCommand, PassesASoundMeshAndPrintsATable) {
  const Square square;
  const auto run = run_program({"audit", square.name});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("verdict: pass\n", 0), 0u);
  EXPECT_TRUE(contains(run.out, "no_overlap"));
  EXPECT_EQ(run.err, "");
}

TEST(AuditCommand, FailsWithExitCode1AndNamesTheOffenders) {
  const Square square("2 3 0\n1 1 2 3\n2 1 4 3\n");
  const auto run = run_program({"audit", square.name});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out.rfind("verdict: FAIL\n", 0), 0u);
  EXPECT_TRUE(contains(run.out, "FAIL: 1, triangles 1\n"));
}

TEST(AuditCommand, TurnsAMeshThatIsClockwiseThroughoutAndSaysSo) {
  const Square square("2 3 0\n1 1 3 2\n2 1 4 3\n");
  const auto run = run_program({"audit", square.name});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.err, "clockwise"));
}

TEST(AuditCommand, PrintsTheContractOfItsJson) {
  const Square square;
  const auto run = run_program({"audit", square.name, "--json", "-"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.rfind("{\"verdict\":\"pass\",\"checks\":[{\"name\":\"valid_indices\","
                          "\"required\":true,\"pass\":true,\"violations\":0,"
                          "\"item\":\"triangle\",\"first\":[],\"value\":null}",
                          0),
            0u)
      << run.out.substr(0, 200);
  EXPECT_TRUE(contains(run.out, "\"measures\":{"));
  EXPECT_TRUE(contains(run.out, "\"min_angle\":26.5650511770779"));
}

TEST(AuditCommand, CountsWhatTheUserRequires) {
  const Square square;
  EXPECT_EQ(run_program({"audit", square.name, "--require", "min_angle>=26"}).exit_code, 0);
  const auto run = run_program({"audit", square.name, "--require", "min_angle>=27", "--require",
                                "aspect_ratio<=3", "--json", "-"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.out,
                       "{\"name\":\"min_angle>=27\",\"required\":true,\"pass\":false,"
                       "\"violations\":2,\"item\":\"triangle\",\"first\":[0,1],"));
  const std::string file = square.directory.write("rules",
                                                  "# of the house\nmin_angle >= 20\n"
                                                  "max_angle<=89 # sharp\n");
  EXPECT_EQ(run_program({"audit", square.name, "--require", "@" + file}).exit_code, 1);
  EXPECT_EQ(run_program({"audit", square.name, "--require", "frobnicate"}).exit_code, 2);
  EXPECT_EQ(run_program({"audit", square.name, "--require", "a b"}).exit_code, 2);
}

TEST(AuditCommand, IsStrictWhenAsked) {
  const Square square("2 3 0\n1 1 2 3\n2 1 3 4\n");
  square.directory.write("square.poly", "0 2 0 0\n1 0\n1 1 2\n0\n");
  // Three boundary edges have no segment; the mesh fills a convex polygon, so it passes.
  EXPECT_EQ(run_program({"audit", square.name}).exit_code, 0);
  EXPECT_EQ(run_program({"audit", square.name, "--strict"}).exit_code, 1);
}

TEST(AuditCommand, JudgesConformityToADomain) {
  const Square square;
  const std::string good = square.directory.write("good.poly",
                                                  "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n"
                                                  "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  EXPECT_EQ(run_program({"audit", square.name, "--domain", good}).exit_code, 0);
  const std::string other =
      square.directory.write("other.poly", "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n1 0\n1 2 4\n0\n");
  const auto run = run_program({"audit", square.name, "--domain", other});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.out, "FAIL: 1, domain segments 0\n")) << run.out;
}

TEST(AuditCommand, JudgesConformityToADomainInSpace) {
  const TemporaryDirectory directory;
  const std::string nodes = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  const std::string mesh = directory.write("tet.node", nodes);
  directory.write("tet.ele", "1 4 0\n1 1 2 3 4\n");
  const std::string facets = "4 0\n1\n3 1 2 3\n1\n3 1 2 4\n1\n3 1 3 4\n1\n3 2 3 4\n0\n0\n";
  const std::string good = directory.write("good.poly", nodes + facets);
  EXPECT_EQ(run_program({"audit", mesh, "--domain", good}).exit_code, 0);
  const std::string other =
      directory.write("other.poly", nodes + "3 0\n1\n3 1 2 3\n1\n3 1 2 4\n1\n3 1 3 4\n0\n0\n");
  const auto open = run_program({"audit", mesh, "--domain", other});
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_TRUE(contains(open.out, "boundary_on_domain")) << open.out;
  const Square square;
  EXPECT_EQ(run_program({"audit", square.name, "--domain", good}).exit_code, 2);
}

TEST(AuditCommand, AllowsForRoundedNodesAsMuchAsAsked) {
  const TemporaryDirectory directory;
  const std::string mesh = directory.write("mesh.node",
                                           "4 2 0 0\n1 0 0\n2 3 1\n3 0 2\n"
                                           "4 1 0.33333333333333\n");
  directory.write("mesh.ele", "2 3 0\n1 1 4 3\n2 4 2 3\n");
  const std::string domain =
      directory.write("domain.poly", "3 2 0 0\n1 0 0\n2 3 1\n3 0 2\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  EXPECT_EQ(run_program({"audit", mesh, "--domain", domain}).exit_code, 1);
  EXPECT_EQ(run_program({"audit", mesh, "--domain", domain, "--allowance", "32"}).exit_code, 0);
  EXPECT_EQ(run_program({"audit", mesh, "--domain", domain, "--allowance", "-1"}).exit_code, 2);
}

TEST(AuditCommand, MarksTheOffendersInAPicture) {
  const Square square("2 3 0\n1 1 2 3\n2 1 4 3\n");
  const std::string picture = square.directory / "out.vtu";
  EXPECT_EQ(run_program({"audit", square.name, "--vtu", picture}).exit_code, 1);
  const std::string text = test::read_bytes(picture);
  EXPECT_TRUE(contains(text, "Name=\"no_inverted\""));
  EXPECT_TRUE(contains(text, "Name=\"consistent_orientation\""));
}

TEST(AuditCommand, JudgesSeveralFilesTogether) {
  const Square good;
  const Square bad("2 3 0\n1 1 2 3\n2 1 4 3\n");
  const auto run = run_program({"audit", good.name, bad.name, "--json", "-"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out.rfind("{\"verdict\":\"fail\",\"inputs\":[{\"input\":", 0), 0u);
  EXPECT_EQ(run_program({"audit", good.name, good.name}).exit_code, 0);
}

TEST(AuditCommand, FailsAMeshThatNamesNodesWhichDoNotExist) {
  const Square square("1 3 0\n1 1 2 9\n");
  const auto run = run_program({"audit", square.name, "--json", "-"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out.rfind("{\"verdict\":\"fail\",\"checks\":[{\"name\":\"valid_input\"", 0), 0u);
  EXPECT_TRUE(contains(run.err, "point 9"));
}

TEST(AuditCommand, ReportsWhatItCannotRead) {
  EXPECT_EQ(run_program({"audit", "/no/such/file.node"}).exit_code, 3);
  const Square square("1 3 0\n1 1 2\n");
  EXPECT_EQ(run_program({"audit", square.name}).exit_code, 3);
}

TEST(AuditCommand, JudgesTetrahedra) {
  const TemporaryDirectory directory;
  const std::string name = directory.write("tet.node",
                                           "5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                                           "4 0 0 1\n5 1 1 1\n");
  directory.write("tet.ele", "2 4 0\n1 1 2 3 4\n2 2 3 4 5\n");
  const auto run = run_program({"audit", name, "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_TRUE(contains(run.out, "\"tets\":2,"));
  const auto bound = run_program({"audit", name, "--require", "min_dihedral>=60", "--json", "-"});
  EXPECT_EQ(bound.exit_code, 1);
  EXPECT_TRUE(contains(bound.out, "\"item\":\"tet\",\"first\":[0],")) << bound.out;
  directory.write("tet.ele", "2 4 0\n1 1 2 3 4\n2 2 3 5 4\n");
  const std::string picture = directory / "out.vtu";
  EXPECT_EQ(run_program({"audit", name, "--vtu", picture}).exit_code, 1);
  EXPECT_TRUE(contains(test::read_bytes(picture), "Name=\"no_inverted\""));
  directory.write("tet.ele", "2 4 0\n1 1 2 4 3\n2 2 3 5 4\n");
  const auto turned = run_program({"audit", name});
  EXPECT_EQ(turned.exit_code, 0);
  EXPECT_TRUE(contains(turned.err, "turned"));
}

TEST(AuditCommand, JudgesADirectoryOfLevels) {
  const TemporaryDirectory directory;
  const std::string mesh = directory / "annulus", levels = directory / "levels";
  ASSERT_EQ(run_program({"generate", "annulus", "--nodes", "600", "-o", mesh}).exit_code, 0);
  ASSERT_EQ(run_program({"coarsen", mesh, "--profile", "thesis", "-o", levels}).exit_code, 0);
  const auto run = run_program({"audit", levels, "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.out;
  for (const char* part : {"{\"name\":\"node_nested\",\"required\":true,\"pass\":true",
                           "{\"name\":\"graph_spacing\",\"level\":1,", "\"levels\":[{\"level\":0,",
                           "\"hausdorff_to_finest\":"})
    EXPECT_TRUE(contains(run.out, part)) << part;
  EXPECT_TRUE(contains(run_program({"audit", levels}).out, "area kept"));
  EXPECT_EQ(run_program({"audit", levels, "--require", "min_angle>=59"}).exit_code, 1);

  // A node of level 1 moves: it is no longer nested.
  std::string nodes = test::read_bytes(levels + "/level_1.node");
  const auto line = nodes.find('\n') + 1;
  nodes.insert(nodes.find(' ', line) + 1, "1e-9");
  directory.write("levels/level_1.node", nodes);
  const auto broken = run_program({"audit", levels, "--json", "-"});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_TRUE(contains(broken.out, "{\"name\":\"node_nested\",\"required\":true,\"pass\":false"));
}

TEST(AuditCommand, PassesLevelsThatDoNotPromiseToBeNested) {
  const TemporaryDirectory directory;
  const std::string mesh = directory / "annulus", levels = directory / "levels";
  ASSERT_EQ(run_program({"generate", "annulus", "--nodes", "600", "-o", mesh}).exit_code, 0);
  ASSERT_EQ(run_program({"coarsen", mesh, "--scheme", "from-finest", "--beta", "4", "--factor", "2",
                         "-o", levels})
                .exit_code,
            0);
  const auto run = run_program({"audit", levels, "--json", "-"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.out,
                       "{\"name\":\"node_nested\",\"required\":false,\"pass\":false,"
                       "\"promised\":false,"));
  EXPECT_TRUE(contains(run_program({"audit", levels}).out, "not promised: "));
  EXPECT_EQ(run_program({"audit", levels, "--require", "node_nested"}).exit_code, 1);
}

// A square with its centre, as points alone.
TEST(AuditCommand, JudgesTheSpacingOfPoints) {
  const TemporaryDirectory directory;
  const std::string points =
      directory.write("points.node", "5 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n5 1 1\n");
  EXPECT_EQ(run_program({"audit", points}).exit_code, 3);
  const auto by_nn = run_program({"audit", points, "--spacing", "nn", "--json", "-"});
  EXPECT_EQ(by_nn.exit_code, 0) << by_nn.err;
  for (const char* part :
       {"\"gap_interior_lower\":", "\"gap\":", "\"witnesses\":{\"beta\":{\"centre\":[",
        "\"theorems\":[{\"name\":\"2.4.2\",\"statement\":\"beta <= 2\",\"applies\":true"})
    EXPECT_TRUE(contains(by_nn.out, part)) << part << "\n" << by_nn.out;
  const std::string f = directory.write("f.txt", "1\n1\n1\n1\n1\n");
  EXPECT_EQ(run_program({"audit", points, "--spacing", f, "--beta", "1.5", "--require",
                         "beta_spaced", "--require", "gap<=1.1"})
                .exit_code,
            0);
  const auto close =
      run_program({"audit", points, "--spacing", f, "--beta", "1.4", "--require", "beta_spaced"});
  EXPECT_EQ(close.exit_code, 1);
  EXPECT_TRUE(contains(close.out, "theorem 2.5.1(1)")) << close.out;
  EXPECT_EQ(run_program({"audit", points, "--spacing", f, "--require", "gap<=0.9"}).exit_code, 1);
  const std::string domain = directory.write(
      "domain.poly", "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  EXPECT_EQ(run_program({"audit", points, "--spacing", f, "--domain", domain}).exit_code, 0);
  const std::string few = directory.write("few.txt", "1\n1\n");
  EXPECT_EQ(run_program({"audit", points, "--spacing", few}).exit_code, 3);
}

// A shorter sequence is written where a longer one was.
TEST(AuditCommand, JudgesTheLevelsThatHierarchyJsonLists) {
  const TemporaryDirectory directory;
  const std::string mesh = directory / "annulus", levels = directory / "levels";
  ASSERT_EQ(run_program({"generate", "annulus", "--nodes", "600", "-o", mesh}).exit_code, 0);
  const std::vector<std::string> command = {"coarsen", mesh, "--profile", "thesis", "-o", levels};
  ASSERT_EQ(run_program(command).exit_code, 0);
  std::vector<std::string> shorter = command;
  shorter.insert(shorter.end(), {"--levels", "1", "--beta", "6", "--factor", "2"});
  ASSERT_EQ(run_program(shorter).exit_code, 0);
  ASSERT_TRUE(std::filesystem::exists(levels + "/level_2.node"));
  EXPECT_EQ(run_program({"audit", levels}).exit_code, 0);

  std::filesystem::remove(levels + "/level_1.node");
  std::filesystem::remove(levels + "/level_1.ele");
  std::filesystem::remove(levels + "/level_1.poly");
  const auto missing = run_program({"audit", levels});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(contains(missing.err, "level_1"));
}

TEST(AuditCommand, ReportsADirectoryWithoutLevels) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run_program({"audit", directory / "."}).exit_code, 3);
}

TEST(AuditCommand, StatesTheFactsOfTheRealMeshes) {
  WELLSPACED_REQUIRE_DATA("thesis/crack_merged.node");
  const std::string mesh = test::data_path("thesis/crack_merged.node");
  const auto run = run_program({"audit", mesh, "--json", "-"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.out,
                       "{\"name\":\"constrained_delaunay\",\"required\":false,\"pass\":false,"
                       "\"violations\":1749,"));
}

}  // namespace
}  // namespace wellspaced
