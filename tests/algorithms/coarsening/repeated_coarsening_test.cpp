#include "wellspaced/algorithms/coarsening/repeated_coarsening.hpp"

#include <gtest/gtest.h>

#include "wellspaced/algorithms/generate/grid.hpp"

namespace wellspaced {
namespace {

Result<TriangleMesh> small_grid(std::uint64_t seed) {
  return generate_grid({.nx = 20, .ny = 15, .diagonals = GridDiagonals::kMixed, .seed = seed});
}

std::vector<std::vector<std::size_t>> sizes_of(const std::vector<RunStatistics>& runs) {
  std::vector<std::vector<std::size_t>> sizes;
  for (const RunStatistics& run : runs) {
    sizes.emplace_back();
    for (const LevelStatistics& level : run) sizes.back().push_back(level.nodes);
  }
  return sizes;
}

CoarseningOptions mild_coarsening() {
  CoarseningOptions options;
  options.factor = 2;
  options.seed = 5;
  return options;
}

TEST(RepeatedCoarsening, RunIHasTheSeedOfTheFirstPlusI) {
  const auto runs = repeat_coarsening(small_grid, mild_coarsening(), {.runs = 3}).value();
  ASSERT_EQ(runs.size(), 3u);
  for (std::uint64_t i = 0; i < 3; ++i) {
    CoarseningOptions options = mild_coarsening();
    options.seed += i;
    const Hierarchy alone = coarsen(small_grid(options.seed).value(), options).value();
    EXPECT_EQ(sizes_of({hierarchy_statistics(alone)})[0], sizes_of(runs)[i]) << i;
  }
}

TEST(RepeatedCoarsening, IsTheSameOnSeveralThreads) {
  const auto one = repeat_coarsening(small_grid, mild_coarsening(), {.runs = 7}).value();
  for (const unsigned threads : {2u, 3u, 16u}) {
    const auto many =
        repeat_coarsening(small_grid, mild_coarsening(), {.runs = 7, .threads = threads}).value();
    EXPECT_EQ(sizes_of(one), sizes_of(many)) << threads;
  }
}

TEST(RepeatedCoarsening, StopsWhenItIsTold) {
  RepeatOptions repeat{.runs = 50, .threads = 2};
  repeat.progress = [](std::string_view, std::uint64_t done, std::uint64_t) { return done < 3000; };
  const auto runs = repeat_coarsening(small_grid, mild_coarsening(), repeat);
  ASSERT_FALSE(runs.ok());
  EXPECT_EQ(runs.error().code, ErrorCode::kCancelled);
}

TEST(RepeatedCoarsening, PassesTheErrorOfTheFirstBadRunOn) {
  const auto meshes = [](std::uint64_t seed) -> Result<TriangleMesh> {
    if (seed < 7) return small_grid(seed);
    return Error{ErrorCode::kUnreadable, "seed " + std::to_string(seed), {}};
  };
  const auto runs = repeat_coarsening(meshes, mild_coarsening(), {.runs = 6, .threads = 3});
  ASSERT_FALSE(runs.ok());
  EXPECT_EQ(runs.error().message, "seed 7");
}

TEST(RepeatedCoarsening, SummarisesTheRunsThatHaveTheFigure) {
  std::vector<RunStatistics> runs(3, RunStatistics(1));
  runs[0][0].nodes = 4;
  runs[1][0].nodes = 10;
  runs[2].clear();
  const auto nodes = [](const LevelStatistics& s) -> std::optional<double> {
    return static_cast<double>(s.nodes);
  };
  const auto summary = summarise_level(runs, 0, nodes);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->mean, 7);
  EXPECT_EQ(summary->low, 4);
  EXPECT_EQ(summary->high, 10);
  EXPECT_EQ(summary->count, 2u);
  EXPECT_FALSE(summarise_level(runs, 1, nodes));
}

}  // namespace
}  // namespace wellspaced
