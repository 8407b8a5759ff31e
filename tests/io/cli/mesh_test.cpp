#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/data.hpp"
#include "tests/support/json.hpp"
#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::JsonView;
using test::read_bytes;
using test::run_program;
using test::TemporaryDirectory;

constexpr const char* kPlate =
    "8 2 0 1\n1 0 0 1\n2 9 0 1\n3 9 9 1\n4 0 9 1\n5 3 3 2\n6 6 3 2\n7 6 6 2\n8 3 6 2\n"
    "8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n1\n1 4 4\n";
constexpr const char* kWedge =
    "4 2 0 0\n0 0 0\n1 4 0\n2 4 1\n3 2 0.3\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";

struct Answer {
  test::ProgramRun run;
  JsonValue tree;
  JsonView operator[](std::string_view name) const { return JsonView(&tree)[name]; }
};

Answer mesh(std::vector<std::string> words, const std::string& input, int exit_code = 0) {
  words.insert(words.begin(), "mesh");
  words.insert(words.end(), {"--json", "-"});
  Answer answer{run_program(words, input), {}};
  EXPECT_EQ(answer.run.exit_code, exit_code) << answer.run.err;
  const auto tree = parse_json(answer.run.out, "stdout");
  EXPECT_TRUE(tree.ok()) << answer.run.out;
  if (tree.ok()) answer.tree = *tree;
  return answer;
}

int audit(const TemporaryDirectory& directory, const std::string& domain) {
  return run_program({"audit", directory / "m", "--domain", domain}).exit_code;
}

TEST(MeshCommand, MeshesADomainThatTheAuditPasses) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("plate.poly", kPlate);
  const Answer answer = mesh({domain, "-o", directory / "m", "--beta", "6"}, "");
  EXPECT_TRUE(answer["complete"].is_true());
  EXPECT_GE(answer["angles"]["boundary_min"].number(), 25);
  EXPECT_GT(answer["nodes"].number(), 90);
  for (const char* key :
       {"input", "triangles", "boundary_edges", "balls_packed", "beta", "smallest_angle", "maximal",
        "sharp_corners", "without_guarantee", "seconds", "peak_bytes"})
    EXPECT_TRUE(answer[key].exists()) << key;
  EXPECT_EQ(audit(directory, domain), 0);
  const std::string node = read_bytes(directory / "m.node");
  EXPECT_EQ(node.find("incomplete"), std::string::npos);
  EXPECT_NE(node.find("\n1 0 0"), std::string::npos) << "the input's points first, from 1";
}

TEST(MeshCommand, WritesTheSameBytesEveryTimeAndOtherFormats) {
  const TemporaryDirectory directory;
  for (const char* name : {"a.vtu", "b.vtu", "c.svg"})
    EXPECT_EQ(run_program({"mesh", "-", "-o", directory / name}, kPlate).exit_code, 0);
  EXPECT_EQ(read_bytes(directory / "a.vtu"), read_bytes(directory / "b.vtu"));
  EXPECT_GT(std::filesystem::file_size(directory / "c.svg"), 500u);
}

TEST(MeshCommand, StopsAtMaxPointsWithAValidMarkedMesh) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("plate.poly", kPlate);
  const Answer answer =
      mesh({domain, "-o", directory / "m", "--beta", "30", "--max-points", "500"}, "", 5);
  EXPECT_FALSE(answer["complete"].is_true());
  EXPECT_LE(answer["nodes"].number(), 500);
  EXPECT_EQ(audit(directory, domain), 0);
  for (const char* name : {"m.node", "m.ele", "m.poly"})
    EXPECT_EQ(read_bytes(directory / name).rfind("# incomplete: ", 0), 0u) << name;
}

TEST(MeshCommand, LeavesTheSpacingWhereAuditFindsIt) {
  const TemporaryDirectory directory;
  mesh({"-", "-o", directory / "m", "--beta", "3"}, kPlate, 0);
  EXPECT_EQ(read_bytes(directory / "m.spacing").rfind("# packing by size, beta 3\n", 0), 0u);
  for (const char* name : {"m.node", "m"}) {
    const auto run = run_program({"audit", directory / name, "--json", "-"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    for (const char* found : {"\"beta_spaced\"", "\"lipschitz\"", "\"gap_interior_upper\""})
      EXPECT_NE(run.out.find(found), std::string::npos) << name << ' ' << found;
  }
  std::filesystem::remove(directory / "m.spacing");
  const auto bare = run_program({"audit", directory / "m.node", "--json", "-"});
  EXPECT_EQ(bare.out.find("lipschitz"), std::string::npos);
}

// The points on its sides lie beside them by their rounding.
TEST(MeshCommand, PutsPointsThatAuditKnowsOnAnObliqueDomain) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write(
      "oblique.poly", "4 2 0 0\n0 0 0\n1 3 1\n2 2 4\n3 -1 3\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  mesh({domain, "-o", directory / "m", "--size", "0.2"}, "");
  EXPECT_EQ(run_program({"convert", directory / "m.node", directory / "p.xyz"}).exit_code, 0);
  const auto run = run_program(
      {"audit", directory / "p.xyz", "--spacing", directory / "m.spacing", "--domain", domain});
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("boundary_distance                 0\n"), std::string::npos);
}

TEST(MeshCommand, ListsWhatIsWithoutGuaranteeAtSmallAngles) {
  const auto refused = run_program({"mesh", "-"}, kWedge);
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_NE(refused.err.find("1 corner below 60 degrees, the sharpest at point 0 with 8.53"),
            std::string::npos)
      << refused.err;
  const Answer answer = mesh({"-", "--allow-small-angles"}, kWedge);
  EXPECT_EQ(answer.tree.find("sharp_corners")->items.size(), 1u);
  EXPECT_EQ(answer.tree.find("without_guarantee")->items.size(), 1u);
}

TEST(MeshCommand, LowersTheSpacingByASize) {
  const double coarse = mesh({"-"}, kPlate)["nodes"].number();
  const double fine = mesh({"-", "--size", "0.5"}, kPlate)["nodes"].number();
  EXPECT_GT(fine, coarse);
  EXPECT_NEAR(fine, 72 / (0.25 * 1.05), 60) << "an area of about 1.05 squared sizes a node";
  const TemporaryDirectory directory;
  const std::string background =
      directory.write("size.node", "4 2 1 0\n1 0 0 0.05\n2 9 0 2\n3 9 9 2\n4 0 9 2\n");
  const double graded = mesh({"-", "--size", background}, kPlate)["nodes"].number();
  EXPECT_GT(graded, coarse);
  EXPECT_EQ(run_program({"mesh", "-", "--size", "0"}, kPlate).exit_code, 2);
  EXPECT_EQ(run_program({"mesh", "-", "--size", directory / "none"}, kPlate).exit_code, 3);
  const std::string bare = directory.write("bare.node", "1 2 0 0\n1 0 0\n");
  EXPECT_EQ(run_program({"mesh", "-", "--size", bare}, kPlate).exit_code, 2);
}

TEST(MeshCommand, WritesTheSpacingFunction) {
  const TemporaryDirectory directory;
  const Answer answer = mesh({"-", "--spacing", directory / "f"}, kPlate);
  const std::string text = read_bytes(directory / "f");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + answer["nodes"].number());
}

TEST(MeshCommand, TakesABoundOnTheRadiusEdgeRatio) {
  EXPECT_NEAR(mesh({"-", "--radius-edge", "1"}, kPlate)["smallest_angle"].number(), 30, 1e-9);
  EXPECT_EQ(run_program({"mesh", "-", "--radius-edge", "1", "--angle", "20"}, kPlate).exit_code, 2);
  EXPECT_EQ(run_program({"mesh", "-", "--beta", "1"}, kPlate).exit_code, 2);
}

// The .poly listed the seeds as holes, and the audit of the mesh failed.
TEST(MeshCommand, ListsNoSeedsOfHolesThatAreNone) {
  const TemporaryDirectory directory;
  const std::string plate = directory.write("plate.poly", kPlate);  // a seed in its hole
  const std::string corner =
      directory.write("corner.poly", "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n0 0\n2\n0 9 9\n1 1 1\n");
  const std::string divided =
      directory.write("divided.poly",
                      "6 2 0 0\n0 0 0\n1 4 0\n2 8 0\n3 8 4\n4 4 4\n5 0 4\n"
                      "7 0\n0 0 1\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 0\n6 1 4\n1\n0 4 2\n");
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", directory / "m", "--allow-small-angles"});
    words.insert(words.begin(), "mesh");
    const auto meshed = run_program(words);
    EXPECT_EQ(meshed.exit_code, 0) << meshed.err;
    EXPECT_EQ(run_program({"audit", directory / "m"}).exit_code, 0);
    return meshed.err;
  };
  EXPECT_NE(run({plate, "--holes", "none"})
                .find("1 hole seed lies in the mesh and not in a hole, the first: seed 0 (counted "
                      "from 0); left out: only --holes seeds makes"),
            std::string::npos);
  EXPECT_NE(run({corner}).find("1 hole seed lies in the mesh and not in a hole, the first: seed 1"),
            std::string::npos);
  EXPECT_NE(read_bytes(directory / "m.poly").find("\n1\n0 9 9\n"), std::string::npos);
  EXPECT_NE(run({divided}).find("left out: seeds must lie off the segments"), std::string::npos);
  EXPECT_EQ(run({plate, "--holes", "parity"}).find("hole seed"), std::string::npos);
  EXPECT_NE(read_bytes(directory / "m.poly").find("\n1\n1 4 4\n"), std::string::npos);
}

TEST(MeshCommand, SaysInOneLineWhatIsNoDomain) {
  const char* open = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 0\n1 1 2\n2 2 3\n0\n";
  const char* crossing =
      "4 2 0 0\n1 0 0\n2 4 4\n3 4 0\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
  const char* flat = "3 2 0 0\n1 0 0\n2 1 1\n3 2 2\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
  for (const char* domain : {open, crossing, flat}) {
    const auto run = run_program({"mesh", "-"}, domain);
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_EQ(run_program({"mesh", "-", "--intersections", "split"}, crossing).exit_code, 4)
      << "its corners are 45 degrees";
}

}  // namespace
}  // namespace wellspaced
