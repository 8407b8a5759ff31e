// `wellspaced coarsen` as its users meet it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/data.hpp"
#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::ProgramRun;
using test::run_program;
using test::TemporaryDirectory;

// The unit square, cut into 2 x side^2 triangles; numbers start at 1.
void write_square(const TemporaryDirectory& directory, int side) {
  std::string nodes = std::to_string((side + 1) * (side + 1)) + " 2 0 0\n";
  std::string triangles = std::to_string(2 * side * side) + " 3 0\n";
  int node = 0, triangle = 0;
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) {
      nodes += std::to_string(++node) + ' ' + std::to_string(x) + ' ' + std::to_string(y) + '\n';
      if (x == side || y == side) continue;
      const int above = node + side + 1;
      const auto add = [&](int a, int b, int c) {
        triangles += std::to_string(++triangle) + ' ' + std::to_string(a) + ' ' +
                     std::to_string(b) + ' ' + std::to_string(c) + '\n';
      };
      add(node, node + 1, above + 1);
      add(node, above + 1, above);
    }
  directory.write("square.node", nodes);
  directory.write("square.ele", triangles);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CoarsenCommand, WritesEveryLevelAndItsLinks) {
  const TemporaryDirectory directory;
  write_square(directory, 20);
  const ProgramRun run =
      run_program({"coarsen", directory / "square", "--factor", "2", "-o", directory / "out"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "\nlevel     nodes  triangles")) << run.out;
  const std::string summary = test::read_bytes(directory / "out/hierarchy.json");
  EXPECT_TRUE(contains(summary, "\"method\":\"function\"")) << summary;
  EXPECT_TRUE(contains(summary, "\"fixed\":[0,20,420,440]")) << summary;
  EXPECT_TRUE(contains(summary, "\"complete\":true")) << summary;
  EXPECT_FALSE(contains(summary, "seconds")) << summary;
  for (const char* name : {"level_0.node", "level_0.ele", "level_0.poly", "level_0.origin",
                           "level_0.spacing", "level_1.node", "level_1.ele", "level_1.poly"})
    EXPECT_FALSE(test::read_bytes(directory / (std::string("out/") + name)).empty()) << name;
  const std::string origin = test::read_bytes(directory / "out/level_1.origin");
  EXPECT_EQ(origin.substr(0, 2), "0\n");
  const auto nodes = std::to_string(std::count(origin.begin(), origin.end(), '\n'));
  EXPECT_EQ(test::read_bytes(directory / "out/level_1.node").rfind(nodes + " 2 ", 0), 0u);
}

TEST(CoarsenCommand, WritesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const TemporaryDirectory directory;
  write_square(directory, 20);
  for (const char* name : {"1", "1", "2"}) {
    static int number = 0;
    const std::string out = directory / ("out" + std::to_string(number++));
    ASSERT_EQ(run_program({"coarsen", directory / "square", "--profile", "thesis", "--seed", name,
                           "-o", out})
                  .exit_code,
              0);
  }
  for (const char* name : {"/hierarchy.json", "/level_1.ele", "/level_1.spacing"}) {
    const std::string first = test::read_bytes(directory / ("out0" + std::string(name)));
    EXPECT_EQ(first, test::read_bytes(directory / ("out1" + std::string(name)))) << name;
    EXPECT_NE(first, test::read_bytes(directory / ("out2" + std::string(name)))) << name;
  }
}

TEST(CoarsenCommand, PrintsTheContractOfItsJson) {
  const TemporaryDirectory directory;
  write_square(directory, 12);
  const ProgramRun run = run_program({"coarsen", directory / "square", "--profile", "thesis",
                                      "--json", "-", "--stats", "full", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("{\"input\":{\"nodes\":169,\"triangles\":288},\"method\":\"function\","
                          "\"scheme\":\"fine-to-coarse\",\"metric\":\"graph\",\"beta\":25,"
                          "\"factor\":8,",
                          0),
            0u)
      << run.out;
  for (const char* key :
       {"\"seed\":1",
        "\"levels\":[{\"level\":0,\"nodes\":169,\"triangles\":288,\"boundary_edges\":48",
        "\"angles\":{\"interior_min\":45,\"boundary_min\":45,\"max\":90,\"interior_le_10\":0,"
        "\"boundary_le_10\":0}",
        "\"intersection\":null", "\"path_depth\":{\"mean\":", "\"search\":{\"mean\":",
        "\"edge_search\":{\"mean\":", "\"node_nested\":true",
        "\"seconds\":{\"spacing\":", "\"seconds_total\":", "\"peak_bytes\":"})
    EXPECT_TRUE(contains(run.out, key)) << key << " in " << run.out;
}

TEST(CoarsenCommand, LeavesMeasuresNullWhereNoneAreAskedFor) {
  const TemporaryDirectory directory;
  write_square(directory, 12);
  const ProgramRun run =
      run_program({"coarsen", directory / "square", "--json", "-", "--stats", "none"});
  EXPECT_TRUE(contains(run.out,
                       "\"angles\":{\"interior_min\":null,\"boundary_min\":null,"
                       "\"max\":null,\"interior_le_10\":null,\"boundary_le_10\":null}"));
  EXPECT_TRUE(contains(run.out, "\"path_depth\":null"));
}

TEST(CoarsenCommand, RunsBothMethodsSideBySide) {
  const TemporaryDirectory directory;
  write_square(directory, 12);
  const ProgramRun run = run_program({"coarsen", directory / "square", "--method", "function,mis",
                                      "-o", directory / "out", "--format", "svg"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "function-based: beta 25, C 8, R 0.2, seed 1")) << run.out;
  EXPECT_TRUE(contains(run.out, "MIS-based: R 0.15, seed 1")) << run.out;
  for (const char* name : {"out/function/level_1.svg", "out/mis/level_1.svg"})
    EXPECT_TRUE(contains(test::read_bytes(directory / name), "<svg")) << name;
}

TEST(CoarsenCommand, StopsAfterTheLevelsOrAtTheNodesAskedFor) {
  const TemporaryDirectory directory;
  write_square(directory, 20);
  const auto levels = [&](const std::string& option, const std::string& value) {
    const ProgramRun run =
        run_program({"coarsen", directory / "square", "--factor", "2", option, value});
    return std::count(run.out.begin(), run.out.end(), '\n') - 3;
  };
  EXPECT_EQ(levels("--levels", "0"), 1);
  EXPECT_EQ(levels("--levels", "2"), 3);
  EXPECT_EQ(levels("--until", "441"), 1);
  EXPECT_EQ(levels("--until", "440"), 2);
}

TEST(CoarsenCommand, KeepsTheFixedPointsOfAFile) {
  const TemporaryDirectory directory;
  write_square(directory, 20);
  const std::string fixed = directory.write("fixed", "0 20\n# the far corners\n420 440 7\n");
  ASSERT_EQ(run_program({"coarsen", directory / "square", "--fixed", fixed, "--profile", "thesis",
                         "-o", directory / "out"})
                .exit_code,
            0);
  EXPECT_EQ(test::read_bytes(directory / "out/level_2.origin"), "0\n7\n20\n420\n440\n");
}

TEST(CoarsenCommand, PreparesSolversByDefault) {
  const TemporaryDirectory directory;
  write_square(directory, 30);
  const ProgramRun run = run_program({"coarsen", directory / "square", "--until", "50",
                                      "--transfers", "mtx,npz,petsc", "-o", directory / "out"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "function-based: beta 4, C 2, R 0.2, seed 1")) << run.out;
  EXPECT_TRUE(contains(run.out, "\ngrid complexity 1.")) << run.out;
  const std::string summary = test::read_bytes(directory / "out/hierarchy.json");
  for (const char* key : {"\"level_from_coarsest\":0", "\"coarse\":[0,", "\"area_kept\":1",
                          "\"intersection_max\":null", "\"operator_complexity\":1."})
    EXPECT_TRUE(contains(summary, key)) << key << " in " << summary;
  for (const char* name : {"level_1.prolongation.mtx", "level_1.prolongation.npz",
                           "level_1.prolongation.petsc", "level_2.prolongation.mtx"})
    EXPECT_TRUE(std::filesystem::exists(directory / (std::string("out/") + name))) << name;
  EXPECT_FALSE(std::filesystem::exists(directory / "out/level_0.prolongation.mtx"));
  EXPECT_EQ(test::read_bytes(directory / "out/level_1.prolongation.mtx").rfind("%%MatrixMarket", 0),
            0u);
}

TEST(CoarsenCommand, TakesTheThesisProfileWithAnyOfItsChoices) {
  const TemporaryDirectory directory;
  write_square(directory, 12);
  const ProgramRun run = run_program(
      {"coarsen", directory / "square", "--method", "function", "-o", directory / "out"});
  EXPECT_TRUE(contains(run.out, "function-based: beta 25, C 8, R 0.2, seed 1")) << run.out;
  EXPECT_FALSE(contains(run.out, "complexity")) << run.out;
  EXPECT_FALSE(std::filesystem::exists(directory / "out/level_1.prolongation.npz"));
  EXPECT_FALSE(contains(test::read_bytes(directory / "out/hierarchy.json"), "level_from_coarsest"));
}

TEST(CoarsenCommand, RefusesOptionsOutOfRangeInOneLineAndWritesNothing) {
  const TemporaryDirectory directory;
  write_square(directory, 3);
  const std::string fixed = directory.write("fixed", "0 1\n2 16\n");
  const std::string word = directory.write("word", "0 x\n");
  const auto expect_error = [&](const std::string& option, const std::string& value, int code,
                                const std::string& what) {
    const ProgramRun run =
        run_program({"coarsen", directory / "square", "-o", directory / "out", option, value});
    EXPECT_EQ(run.exit_code, code) << option << ' ' << value;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(contains(run.err, what)) << run.err;
  };
  for (const char* value : {"1", "0", "-3", "nan", "inf", "x"}) {
    expect_error("--beta", value, 2, "--beta");
    expect_error("--factor", value, 2, "--factor");
  }
  expect_error("--protect", "-0.1", 2, "--protect");
  expect_error("--method", "best", 2, "'best'");
  expect_error("--profile", "fast", 2, "'fast'");
  expect_error("--transfers", "npz,mat", 2, "'mat'");
  expect_error("--keep-boundary", "-1", 2, "--keep-boundary");
  expect_error("--levels", "-1", 2, "--levels");
  expect_error("--stats", "some", 2, "--stats");
  expect_error("--fixed", fixed, 4, "fixed:2: fixed point 16 is out of range");
  expect_error("--fixed", word, 3, "fixed point 'x'");
  expect_error("--fixed", directory / "missing", 3, "missing");
  expect_error("--format", "pdf", 2, "'pdf'");
  EXPECT_FALSE(std::filesystem::exists(directory / "out"));
}

// Some limit falls between the reading and the end: where it does depends on the machine.
TEST(CoarsenCommand, WritesTheLevelsThatAreDoneAtALimit) {
  const TemporaryDirectory directory;
  write_square(directory, 150);
  const std::string out = directory / "out";
  ProgramRun run;
  for (double limit = 0.01; limit < 100 && !std::filesystem::exists(out); limit *= 1.1) {
    run = run_program({"coarsen", directory / "square", "--profile", "thesis", "--time-limit",
                       std::to_string(limit), "--json", "-", "-o", out});
    if (run.exit_code == 0) {
      std::filesystem::remove_all(out);
      limit = 0.01;
    }
  }
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_TRUE(contains(run.out, "\"complete\":false")) << run.out;
  EXPECT_TRUE(contains(test::read_bytes(out + "/hierarchy.json"), "\"complete\":false"));
}

TEST(CoarsenCommand, RunsEverySchemeMetricAndMethod) {
  const TemporaryDirectory directory;
  write_square(directory, 24);
  for (const char* scheme : {"fine-to-coarse", "from-finest", "coarse-to-fine"}) {
    for (const char* metric : {"graph", "euclidean", "geodesic"}) {
      const ProgramRun run =
          run_program({"coarsen", directory / "square", "--scheme", scheme, "--metric", metric,
                       "--factor", "2", "--boundary-lfs", "-o", directory / "out"});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      const std::string summary = test::read_bytes(directory / "out/hierarchy.json");
      EXPECT_TRUE(contains(summary, std::string("\"scheme\":\"") + scheme)) << summary;
      EXPECT_TRUE(contains(summary, std::string("\"metric\":\"") + metric)) << summary;
    }
  }
}

TEST(CoarsenCommand, GivesTheMethodsOfChapterSixTheirConstants) {
  const TemporaryDirectory directory;
  write_square(directory, 24);
  const ProgramRun run =
      run_program({"coarsen", directory / "square", "--method", "threshold,quasi-uniform,mis"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "threshold, euclidean metric: beta 16, C 24, R 0.2, seed 1"))
      << run.out;
  EXPECT_TRUE(contains(run.out, "quasi-uniform, euclidean metric: beta 2, C 3, R 0.2, seed 1"))
      << run.out;
  EXPECT_EQ(run_program({"coarsen", directory / "square", "--method", "mis,mis"}).exit_code, 2);
}

TEST(CoarsenCommand, SelectsByQuadtreeWhatTheAuditPasses) {
  const TemporaryDirectory directory;
  write_square(directory, 24);
  const ProgramRun run = run_program(
      {"coarsen", directory / "square", "--method", "quadtree", "-o", directory / "out"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "quadtree, coarse-to-fine, euclidean metric: beta 2, C 2, R 0.2"))
      << run.out;
  EXPECT_FALSE(test::read_bytes(directory / "out/level_2.node").empty());
  EXPECT_EQ(run_program({"audit", directory / "out"}).exit_code, 0);
  EXPECT_EQ(run_program({"coarsen", directory / "square", "--method", "quadtree", "--scheme",
                         "fine-to-coarse"})
                .exit_code,
            2);
}

TEST(CoarsenCommand, KeepsAnglesAtSizesOfChoiceAndTheAuditPasses) {
  const TemporaryDirectory directory;
  write_square(directory, 30);
  const ProgramRun run =
      run_program({"coarsen", directory / "square", "--profile", "quality", "--targets", "60,300",
                   "--angle", "24", "-o", directory / "out", "--json", directory / "out.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "refinement: angle 24, beta 3.5, seed 1")) << run.out;
  EXPECT_TRUE(contains(run.out, "level  conflicts  largest  uncovered  largest")) << run.out;
  const std::string json = test::read_bytes(directory / "out.json");
  for (const char* part : {"\"method\":\"refinement\"", "\"factor\":null", "\"angle\":24",
                           "\"selection\":{\"conflicts\":0,"})
    EXPECT_TRUE(contains(json, part)) << part << json;
  EXPECT_EQ(run_program({"audit", directory / "out"}).exit_code, 0);

  const ProgramRun implied = run_program({"coarsen", directory / "square", "--ratio", "4"});
  EXPECT_TRUE(contains(implied.out, "refinement: angle 22")) << implied.out;
  for (const char* targets : {"60,", "a", "60,,70", "99999", "0"})
    EXPECT_EQ(run_program({"coarsen", directory / "square", "--targets", targets}).exit_code, 2)
        << targets;
}

TEST(CoarsenCommand, RefusesOptionsThatSayNothingToItsMethods) {
  const TemporaryDirectory directory;
  write_square(directory, 10);
  const auto refuses = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"coarsen", directory / "square"});
    const ProgramRun run = run_program(options);
    return run.exit_code == 2 && contains(run.err, "--profile quality");
  };
  EXPECT_TRUE(refuses({"--profile", "quality", "--factor", "3"}));
  EXPECT_TRUE(refuses({"--profile", "quality", "--protect", "0.1"}));
  EXPECT_TRUE(refuses({"--method", "refinement", "--order", "priority"}));
  EXPECT_TRUE(refuses({"--profile", "thesis", "--targets", "30"}));
  EXPECT_TRUE(refuses({"--method", "mis,function", "--ratio", "2"}));
  EXPECT_TRUE(refuses({"--profile", "multigrid", "--angle", "20"}));
  EXPECT_EQ(run_program({"coarsen", directory / "square", "--method", "function,refinement",
                         "--factor", "2", "--targets", "40"})
                .exit_code,
            0);
}

TEST(CoarsenCommand, SaysWhichSizesAreTooSmallForTheAngles) {
  const TemporaryDirectory directory;
  write_square(directory, 20);
  const ProgramRun large = run_program({"coarsen", directory / "square", "--targets", "100"});
  EXPECT_FALSE(contains(large.err, "cannot keep angles")) << large.err;
  const ProgramRun small = run_program({"coarsen", directory / "square", "--targets", "100,5"});
  EXPECT_EQ(small.exit_code, 0);
  EXPECT_TRUE(contains(small.err, "nodes cannot keep angles of 22 degrees")) << small.err;
  const ProgramRun until =
      run_program({"coarsen", directory / "square", "--targets", "100,50,5", "--until", "60"});
  EXPECT_FALSE(contains(until.err, "cannot keep angles")) << until.err;
  EXPECT_TRUE(contains(until.out, "\n    2        50 ")) << until.out;
}

// Two special points a tenth of an edge apart ask for small elements far and wide; with the option
// nodes stay near them.
TEST(CoarsenCommand, SpacesNodesAsTheSpecialPointsNearbyAreSpaced) {
  const TemporaryDirectory directory;
  write_square(directory, 20);
  directory.write("fixed", "0 20 420 440 220 221\n");
  const auto coarsest_nodes = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"coarsen", directory / "square", "--beta", "4", "--factor", "3", "--fixed",
                    directory / "fixed", "--levels", "2", "--json", directory / "out.json"});
    EXPECT_EQ(run_program(options).exit_code, 0);
    const std::string json = test::read_bytes(directory / "out.json");
    const auto at = json.rfind("\"nodes\":");
    return std::stoi(json.substr(at + 8));
  };
  EXPECT_GT(coarsest_nodes({"--special-lfs"}), coarsest_nodes({}));
  const ProgramRun mis =
      run_program({"coarsen", directory / "square", "--method", "mis", "--special-lfs"});
  EXPECT_EQ(mis.exit_code, 2);
  EXPECT_TRUE(contains(mis.err, "special points")) << mis.err;
}

TEST(CoarsenCommand, ReadsASpacing) {
  const TemporaryDirectory directory;
  write_square(directory, 4);
  std::string values;
  for (int v = 0; v < 25; ++v) values += "0.25\n";
  directory.write("spacing.txt", values);
  const ProgramRun run = run_program({"coarsen", directory / "square", "--spacing",
                                      directory / "spacing.txt", "-o", directory / "out"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(test::read_bytes(directory / "out/level_0.spacing"), values);
  directory.write("spacing.txt", "1\n2\n");
  EXPECT_EQ(run_program({"coarsen", directory / "square", "--spacing", directory / "spacing.txt"})
                .exit_code,
            2);
}

}  // namespace
}  // namespace wellspaced
