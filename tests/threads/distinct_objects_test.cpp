// The whole library from several threads at once, on distinct objects: the same results as from
// one. The preset tsan runs this under ThreadSanitizer.
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/points3.hpp"
#include "tests/support/temporary_directory.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/repeated_coarsening.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

namespace wellspaced {
namespace {

// Everything, by the seed, as one text.
using Work = std::string (*)(std::uint64_t seed);

void write_numbers(TextWriter& out, const auto& rows) {
  for (const auto& row : rows)
    for (const auto value : row) out << value << ' ';
}

std::string coarsened(std::uint64_t seed) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 20, .seed = seed});
  TextWriter out;
  for (const auto method :
       {CoarseningMethod::kFunction, CoarseningMethod::kMis, CoarseningMethod::kThreshold,
        CoarseningMethod::kQuadtree, CoarseningMethod::kRefinement}) {
    CoarseningOptions options = theorem_options(method);
    options.seed = seed;
    const auto hierarchy = coarsen(mesh, options);
    EXPECT_TRUE(hierarchy.ok());
    if (!hierarchy) continue;
    for (const Level& level : hierarchy->levels) write_numbers(out, level.mesh.triangles);
    out << (audit::audit_mesh(hierarchy->levels.back().mesh).pass() ? "pass " : "fail ");
  }
  return out.text();
}

std::string triangulated(std::uint64_t seed) {
  Pslg crossing;
  crossing.points = test::grid_mesh({.nx = 20, .ny = 20, .seed = seed}).points;
  crossing.segments = {{0, 440, 1}, {20, 420, 2}, {3, 400, 3}};
  const auto plane = triangulate(crossing, {});
  const auto space = Delaunay3::build(test::uniform3(1000, seed));
  EXPECT_TRUE(plane.ok() && space.ok());
  if (!plane || !space) return {};
  TextWriter out;
  write_numbers(out, plane->triangles());
  write_numbers(out, real_tets(*space));
  return out.text();
}

std::string packed(std::uint64_t seed) {
  Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}};
  square.points.push_back({0.3, 0.1 * static_cast<double>(seed)});
  const auto mesh = pack_domain(square);
  EXPECT_TRUE(mesh.ok());
  if (!mesh) return {};
  TextWriter out;
  write_numbers(out, mesh->mesh.triangles);
  return out.text();
}

std::string written_and_read(std::uint64_t seed) {
  const Geometry geometry = to_geometry(test::grid_mesh({.nx = 5, .ny = 5, .seed = seed}));
  const test::TemporaryDirectory directory;
  TextWriter out;
  for (const Format& format : formats()) {
    if (format.write == nullptr || format.name == "smesh" || format.name == "poly") continue;
    const std::string path =
        directory / "x" + std::string(format.extensions.substr(0, format.extensions.find(' ')));
    OutputSet outputs;
    EXPECT_TRUE(write_geometry(outputs, path, std::string(format.name), geometry).ok());
    EXPECT_TRUE(outputs.commit().ok());
    if (!format.readable()) continue;
    const auto back = read_geometry(path, {.format = std::string(format.name)});
    EXPECT_TRUE(back.ok()) << back.error().message;
    if (back) write_numbers(out, back->mesh.triangles);
  }
  return out.text();
}

TEST(Threads, DistinctObjectsDoNotDisturbEachOther) {
  constexpr std::uint64_t kSeeds = 2;
  for (const Work work : {coarsened, triangulated, packed, written_and_read}) {
    std::vector<std::string> alone(kSeeds), together(2 * kSeeds);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) alone[seed] = work(seed + 1);
    std::vector<std::thread> threads;
    for (std::uint64_t i = 0; i < together.size(); ++i)
      threads.emplace_back([&, i] { together[i] = work(i % kSeeds + 1); });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < together.size(); ++i) EXPECT_EQ(together[i], alone[i % kSeeds]);
    EXPECT_GT(alone[0].size(), 100u);
  }
}

// Readers of one object need no lock.
TEST(Threads, OneMeshMayBeReadByAll) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 20});
  std::vector<std::size_t> levels(4);
  std::vector<std::thread> threads;
  for (std::size_t& count : levels)
    threads.emplace_back([&] { count = coarsen(mesh, {})->levels.size(); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(levels, std::vector<std::size_t>(4, coarsen(mesh, {})->levels.size()));
}

TEST(Threads, RepeatedRunsShareNothing) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 20});
  const auto nodes_of_levels = [&](unsigned threads) {
    std::vector<std::size_t> nodes;
    const auto runs =
        repeat_coarsening([&](std::uint64_t) { return mesh; }, {}, {.runs = 8, .threads = threads});
    EXPECT_TRUE(runs.ok());
    if (!runs) return nodes;
    for (const RunStatistics& run : *runs)
      for (const LevelStatistics& level : run) nodes.push_back(level.nodes);
    return nodes;
  };
  EXPECT_EQ(nodes_of_levels(4), nodes_of_levels(1));
  EXPECT_GE(nodes_of_levels(4).size(), 16u);
}

TEST(Threads, SpaceIsFilledByRegionsWithoutRaces) {
  const auto points = test::uniform3(40000, 1);
  const auto one = Delaunay3::build(points), four = Delaunay3::build(points, {.threads = 4});
  ASSERT_TRUE(one.ok() && four.ok());
  EXPECT_EQ(real_tets(*one), real_tets(*four));
}

}  // namespace
}  // namespace wellspaced
