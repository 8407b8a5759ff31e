#include "wellspaced/io/reproduce/run_files.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"

namespace wellspaced {
namespace {

std::vector<RunStatistics> some_runs() {
  CoarseningOptions options;
  options.factor = 2;
  options.count_work = true;
  const auto mesh = [](std::uint64_t) { return generate_grid({.nx = 12, .ny = 9}); };
  return repeat_coarsening(mesh, options, {.runs = 2}).value();
}

TEST(RunFiles, ReadBackAsTheyWere) {
  const test::TemporaryDirectory directory;
  const auto runs = some_runs();
  const std::string text = runs_json("parameters", runs);
  const auto read = read_runs(directory.write("runs.json", text), "parameters");
  ASSERT_TRUE(read);
  EXPECT_EQ(runs_json("parameters", *read), text);
  EXPECT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[1][0].search->max, runs[1][0].search->max);
  EXPECT_FALSE((*read)[1].back().path_depth);
}

TEST(RunFiles, AreNotThoseOfOtherParameters) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.write("runs.json", runs_json("one", some_runs()));
  EXPECT_TRUE(read_runs(path, "one"));
  EXPECT_FALSE(read_runs(path, "other"));
  EXPECT_FALSE(read_runs(directory / "none.json", "one"));
}

TEST(RunFiles, AreNotReadWhenDamaged) {
  const test::TemporaryDirectory directory;
  const std::string text = runs_json("one", some_runs());
  for (std::size_t length = 0; length + 2 < text.size(); length += 97)
    EXPECT_FALSE(read_runs(directory.write("runs.json", text.substr(0, length)), "one")) << length;
  EXPECT_FALSE(read_runs(directory.write("r.json", R"({"parameters":"one"})"), "one"));
  EXPECT_FALSE(
      read_runs(directory.write("r.json", R"({"parameters":"one","runs":[[[1]]]})"), "one"));
}

}  // namespace
}  // namespace wellspaced
