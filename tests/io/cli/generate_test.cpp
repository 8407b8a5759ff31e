// wellspaced generate as its users meet it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/program.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/io/formats/formats.hpp"

namespace wellspaced {
namespace {

using test::ProgramRun;
using test::run_program;
using test::TemporaryDirectory;

TEST(Generate, WritesTheGridOfTheLibrary) {
  const TemporaryDirectory directory;
  const ProgramRun run =
      run_program({"generate", "grid", "--nx", "7", "--ny=5", "--aspect", "10", "--diagonals",
                   "mixed:0.3", "--seed", "4", "-o", directory / "g.node"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "grid: 35 points, 48 triangles, 20 segments\n");
  const GridOptions options{
      .nx = 7, .ny = 5, .aspect = 10, .diagonals = GridDiagonals::kMixed, .mixed = 0.3, .seed = 4};
  const TriangleMesh expected = generate_grid(options).value();
  const Geometry written = read_mesh(directory / "g").value();
  EXPECT_EQ(written.mesh.points, expected.points);
  EXPECT_EQ(written.mesh.triangles, expected.triangles);
  EXPECT_EQ(written.mesh.segments.size(), expected.segments.size());
}

TEST(Generate, MakesAMeshOfEachGradedDomain) {
  const TemporaryDirectory directory;
  for (const std::string kind : {"crack", "annulus", "airfoil"}) {
    const ProgramRun run =
        run_program({"generate", kind, "--nodes", "2000", "-o", directory / kind});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Geometry written = read_mesh(directory / kind).value();
    EXPECT_NEAR(static_cast<double>(written.mesh.points.size()), 2000, 40);
    EXPECT_TRUE(written.notes.empty());
  }
}

TEST(Generate, WritesTheBoundaryAsADomainWithItsHoles) {
  const TemporaryDirectory directory;
  const ProgramRun run = run_program(
      {"generate", "airfoil", "--nodes", "2000", "--boundary", "-o", directory / "d.poly"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Geometry written = read_geometry(directory / "d.poly").value();
  EXPECT_EQ(written.holes.size(), 2u);
  EXPECT_EQ(written.mesh.segments.size(), written.mesh.points.size());
  EXPECT_TRUE(written.mesh.triangles.empty());
}

TEST(Generate, MakesEachPointSet) {
  for (const std::string kind : {"random", "clusters", "circle", "spiral", "parabola", "collinear",
                                 "hammersley", "halton", "copies"}) {
    const ProgramRun run =
        run_program({"generate", kind, "--nodes", "137", "-o", "-", "--format", "xyz"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 137) << kind;
  }
}

TEST(Generate, MakesEachPointSetOfSpace) {
  for (const std::string kind : {"box3", "sphere3", "moment3", "lines3", "helix3"}) {
    const ProgramRun run =
        run_program({"generate", kind, "--nodes", "60", "-o", "-", "--format", "xyz"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 60) << kind;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), ' '), 120) << kind;
  }
  const TemporaryDirectory directory;
  const ProgramRun run = run_program({"generate", "lattice3", "--nx", "2", "--ny", "3", "--nz", "4",
                                      "--shuffle", "-o", directory / "l.node"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Geometry written = read_geometry(directory / "l.node").value();
  EXPECT_EQ(written.dimension, 3);
  EXPECT_EQ(written.solid.points.size(), 24u);
}

TEST(Generate, ShufflesPointsBySeed) {
  const auto lattice = [](std::vector<std::string> more) {
    std::vector<std::string> words = {"generate", "lattice",  "--nx", "9",  "--ny",
                                      "8",        "--format", "xyz",  "-o", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words).out;
  };
  const std::string in_rows = lattice({}), shuffled = lattice({"--shuffle"});
  EXPECT_EQ(in_rows.rfind("0 0\n1 0\n2 0\n", 0), 0u);
  EXPECT_NE(in_rows, shuffled);
  EXPECT_EQ(in_rows.size(), shuffled.size());
  EXPECT_EQ(shuffled, lattice({"--shuffle", "--seed", "1"}));
  EXPECT_NE(shuffled, lattice({"--shuffle", "--seed", "2"}));
}

TEST(Generate, TellsWhatItMadeAsJson) {
  const TemporaryDirectory directory;
  const ProgramRun run = run_program({"generate", "random", "--nodes", "5", "--seed", "7", "-o",
                                      directory / "p.xyz", "--json", "-"});
  EXPECT_EQ(run.out,
            "{\"kind\":\"random\",\"points\":5,\"triangles\":0,\"segments\":0,\"seed\":7}\n");
}

TEST(Generate, RefusesWhatItCannotMakeAndWritesNothing) {
  const TemporaryDirectory directory;
  const std::string out = directory / "x";
  const auto expect_usage = [&](std::vector<std::string> words, const std::string& what) {
    words.insert(words.begin(), "generate");
    words.insert(words.end(), {"-o", out});
    const ProgramRun run = run_program(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(out + ".node"));
  };
  expect_usage({"heptagon"}, "'heptagon'");
  expect_usage({"random", "--nx", "4"}, "--nx is not for random");
  expect_usage({"random", "--nodes", "0"}, "--nodes");
  expect_usage({"random", "--nodes", "1e12"}, "--nodes");
  expect_usage({"grid", "--nx", "1"}, "2 nodes");
  expect_usage({"grid", "--aspect", "-1"}, "--aspect");
  expect_usage({"grid", "--diagonals", "backslash"}, "--diagonals");
  expect_usage({"grid", "--diagonals", "mixed:"}, "--diagonals");
  expect_usage({"grid", "--diagonals", "mixed:1.5"}, "--diagonals");
  expect_usage({"lattice", "--nx", "100000", "--ny", "100000"}, "2^28");
  expect_usage({"lattice3", "--nx", "1000", "--ny", "1000", "--nz", "1000"}, "2^28");
  expect_usage({"box3", "--nz", "3"}, "--nz is not for box3");
  expect_usage({"airfoil", "--nodes", "10"}, "300");
  expect_usage({"airfoil", "--grading", "99"}, "16 octaves");
  expect_usage({"annulus", "--nodes", "500", "--grading", "12"}, "grading");
}

TEST(Generate, NeedsAnOutput) {
  const ProgramRun run = run_program({"generate", "random"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("-o"), std::string::npos);
}

}  // namespace
}  // namespace wellspaced
