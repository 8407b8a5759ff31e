#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/data.hpp"
#include "tests/support/json.hpp"
#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::JsonView;
using test::run_program;
using test::TemporaryDirectory;

// The corners of a cube of side 2, numbered from 1, x fastest.
constexpr const char* kCorners =
    "8 3 0 0\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 2 2 0\n5 0 0 2\n6 2 0 2\n7 0 2 2\n8 2 2 2\n";
constexpr const char* kSides[] = {"4 1 2 4 3", "4 5 6 8 7", "4 1 2 6 5",
                                  "4 3 4 8 7", "4 1 3 7 5", "4 2 4 8 6"};

// The cube's first `sides` sides, and more facets; a region with the attribute 7.
std::string cube(int sides = 6, const std::vector<std::string>& more = {},
                 const std::string& corners = kCorners) {
  std::string text = corners + std::to_string(sides + more.size()) + " 0\n";
  for (int i = 0; i < sides; ++i) text += std::string(kSides[i]) + "\n";
  for (const std::string& facet : more) text += facet + "\n";
  return text + "0\n1\n1 1 1 1 7 -1\n";
}

TEST(MeshCommandInSpace, MeshesACubeThatTheAuditPasses) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  for (const char* name : {"m.vtu", "m.mesh", "m"}) {
    const auto run = run_program({"mesh", domain, "-o", directory / name, "--spacing",
                                  directory / "f", "--json", directory / "j"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("slivers, which such a bound permits"), run.out.npos) << run.out;
    EXPECT_EQ(run_program({"audit", directory / name, "--domain", domain}).exit_code, 0);
  }
  const auto audit = run_program({"audit", directory / "m", "--domain", domain, "--lfs",
                                  directory / "f", "--beta", "10", "--require", "radius_edge<=117",
                                  "--require", "beta_spaced", "--require", "lipschitz", "--require",
                                  "circumcentres_inside", "--require", "boundary_gabriel"});
  EXPECT_EQ(audit.exit_code, 0) << audit.out;
  const auto tree = parse_json(test::read_bytes(directory / "j"), "j");
  ASSERT_TRUE(tree.ok());
  const JsonView json(&*tree);
  EXPECT_EQ(json["input"]["facets"].number(), 6);
  EXPECT_TRUE(json["complete"].is_true());
  EXPECT_NEAR(json["radius_edge"]["bound"].number(), 116.569, 0.001);
  for (const char* key :
       {"nodes", "tets", "boundary_faces", "boundary_edges", "segment_points", "facet_points",
        "balls_packed", "beta", "nodes_by_integral", "slivers", "edges", "seconds", "peak_bytes"})
    EXPECT_TRUE(json[key].exists()) << key;
  const std::string cells = test::read_bytes(directory / "m.ele");
  EXPECT_EQ(cells.substr(cells.find('\n') - 2, 2), " 1") << "the region's attribute";
  const std::string faces = test::read_bytes(directory / "m.face");
  for (const char* marker : {" 1\n", " 2\n", " 3\n", " 4\n", " 5\n", " 6\n"})
    EXPECT_NE(faces.find(marker), faces.npos) << "unmarked facets are numbered";
}

TEST(MeshCommandInSpace, MeshesTheRealDomains) {
  for (const char* name : {"cgal_cube", "cgal_beam", "cgal_corner"}) {
    SCOPED_TRACE(name);
    const std::string domain = test::data_path(std::string("domains3d/") + name + ".smesh");
    if (!std::filesystem::exists(domain)) GTEST_SKIP() << "no data";
    const TemporaryDirectory directory;
    const auto run = run_program({"mesh", domain, "-o", directory / "m.vtu"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto audit = run_program({"audit", directory / "m.vtu", "--domain", domain, "--require",
                                    "circumcentres_inside", "--require", "constrained_delaunay"});
    EXPECT_EQ(audit.exit_code, 0) << audit.out;
  }
}

TEST(MeshCommandInSpace, FindsTheLeastBetaForARatio) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  const auto run = run_program({"mesh", domain, "--radius-edge", "8", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto tree = parse_json(run.out, "stdout");
  ASSERT_TRUE(tree.ok());
  EXPECT_NEAR(JsonView(&*tree)["radius_edge"]["bound"].number(), 8, 1e-9);
  EXPECT_LE(JsonView(&*tree)["radius_edge"]["max"].number(), 8);
}

int nodes_of(const test::ProgramRun& run) {
  const auto tree = parse_json(run.out, "stdout");
  return tree.ok() ? static_cast<int>(JsonView(&*tree)["nodes"].number()) : 0;
}

TEST(MeshCommandInSpace, PacksInFullIfAskedTo) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  const auto usual = run_program({"mesh", domain, "--json", "-"});
  const auto full = run_program({"mesh", domain, "--maximal", "full", "--json", "-"});
  ASSERT_EQ(full.exit_code, 0) << full.err;
  EXPECT_NE(full.out.find("\"maximal\":\"full\""), full.out.npos) << full.out;
  EXPECT_GT(nodes_of(full), nodes_of(usual));
}

TEST(MeshCommandInSpace, FollowsSizesFromAFile) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  std::string graded = "8 3 1 0\n";
  for (int i = 0; i < 8; ++i)
    graded += std::to_string(i + 1) + (i & 1 ? " 2" : " 0") + (i & 2 ? " 2" : " 0") +
              (i & 4 ? " 2" : " 0") + (i & 1 ? " 0.25" : " 0.08") + "\n";
  const std::string sizes = directory.write("sizes.node", graded);
  const auto run = run_program(
      {"mesh", domain, "--size", sizes, "-o", directory / "m", "--json", directory / "j"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err.find("no guarantee"), run.err.npos) << run.err;
  const auto audit = run_program({"audit", directory / "m", "--domain", domain, "--require",
                                  "circumcentres_inside", "--require", "radius_edge<=117"});
  EXPECT_EQ(audit.exit_code, 0) << audit.out;
  const auto usual = run_program({"mesh", domain, "--json", "-"});
  const auto tree = parse_json(test::read_bytes(directory / "j"), "j");
  ASSERT_TRUE(tree.ok());
  EXPECT_GT(JsonView(&*tree)["nodes"].number(), 2 * nodes_of(usual));

  const std::string flat = directory.write("flat.node", "1 2 1 0\n1 0 0 1\n");
  const std::string bare = directory.write("bare.node", "1 3 0 0\n1 0 0 0\n");
  const std::string wrong = directory.write("wrong.node", "1 3 1 0\n1 0 0 0 -1\n");
  for (const std::string& file : {flat, bare, wrong})
    EXPECT_EQ(run_program({"mesh", domain, "--size", file}).exit_code, 2) << file;
}

TEST(MeshCommandInSpace, DrawsTheMesh) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  const auto run =
      run_program({"mesh", domain, "-o", directory / "m.svg", "--report", directory / "m.html"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string svg = test::read_bytes(directory / "m.svg");
  EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
  EXPECT_GT(std::count(svg.begin(), svg.end(), '\n'), 200);
  const std::string page = test::read_bytes(directory / "m.html");
  EXPECT_NE(page.find("<title>Mesh of cube.smesh</title>"), page.npos);
  const std::string nodes = run.out.substr(0, run.out.find(' '));
  EXPECT_NE(page.find("<dt>nodes</dt><dd>" + nodes + "</dd>"), page.npos) << run.out;

  const auto surface = run_program({"convert", domain, directory / "surface.svg"});
  EXPECT_EQ(surface.exit_code, 2) << "only tetrahedra can be drawn";
  const std::string flat =
      directory.write("flat.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  EXPECT_EQ(run_program({"mesh", flat, "--report", directory / "flat.html"}).exit_code, 2);
}

TEST(MeshCommandInSpace, SaysThatLargestVolumesAreNotKept) {
  const TemporaryDirectory directory;
  std::string text = cube();
  text.replace(text.rfind("-1"), 2, "0.001");
  const auto run = run_program({"mesh", directory.write("cube.smesh", text)});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("largest volumes"), run.err.npos) << run.err;
}

TEST(MeshCommandInSpace, SaysWhereThereIsNoGuarantee) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  const auto run = run_program({"mesh", domain, "--beta", "8"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("no guarantee"), run.err.npos) << run.err;
}

TEST(MeshCommandInSpace, ReportsWhatIsNoDomainAndWritesNothing) {
  const TemporaryDirectory directory;
  std::string nan = kCorners, flat = kCorners;
  nan.replace(nan.find("4 2 2 0"), 7, "4 nan 2 0");
  std::string crossing = kCorners;
  crossing.replace(0, 1, "11");
  crossing += "9 1 1 1\n10 3 1 1\n11 3 1.5 1\n";
  std::string inside = kCorners;
  inside.replace(0, 1, "12");
  inside += "9 0.5 0.5 0.5\n10 1 0.5 0.5\n11 0.5 1 0.5\n12 0.5 1 1\n";
  const std::pair<std::string, const char*> cases[] = {
      {cube(5), "the surface is open"},
      {cube(6, {"4 1 2 4 3"}), "overlap at point"},
      {cube(6, {"3 9 10 11", "3 9 10 12"}, inside), "meet at 30.00 degrees"},
      {cube(6, {"3 9 10 11"}, crossing), "intersect"},
      {cube(6, {"3 1 2 2"}), "encloses no area"},
      {cube(6, {}, nan), "nan"}};
  for (const auto& [text, what] : cases) {
    SCOPED_TRACE(what);
    const std::string domain = directory.write("bad.smesh", text);
    const auto run = run_program({"mesh", domain, "-o", directory / "m.vtu"});
    EXPECT_TRUE(run.exit_code == 4 || run.exit_code == 3) << run.exit_code;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(what), run.err.npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(directory / "m.vtu"));
  }
}

TEST(MeshCommandInSpace, RefusesOptionsForThePlane) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--angle", "20"},
                                                  {"--maximal", "most"},
                                                  {"--beta", "3"},
                                                  {"--radius-edge", "2"},
                                                  {"--beta", "12", "--radius-edge", "5"},
                                                  {"--size", "-1"}}) {
    std::vector<std::string> words{"mesh", domain};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(run_program(words).exit_code, 2) << options[0];
  }
}

TEST(MeshCommandInSpace, StopsAtALimitWithAValidMesh) {
  const TemporaryDirectory directory;
  const std::string domain = directory.write("cube.smesh", cube());
  const auto run = run_program(
      {"mesh", domain, "--beta", "20", "--max-points", "2500", "-o", directory / "m.vtu"});
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_EQ(run_program({"audit", directory / "m.vtu", "--domain", domain}).exit_code, 0);
}

}  // namespace
}  // namespace wellspaced
