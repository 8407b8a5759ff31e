// --time-limit and --max-memory are kept by every command, whatever it is doing.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/sanitizer.hpp"

namespace wellspaced {
namespace {

using test::ProgramRun;
using test::run_program;
using test::TemporaryDirectory;

constexpr double kLimit = 0.2;  // seconds
constexpr double kSlack = 0.5;  // until a busy machine starts a process and notices its end

struct TimedRun {
  ProgramRun run;
  double seconds;
};

TimedRun run_within_limit(std::vector<std::string> words) {
  words.insert(words.end(), {"--time-limit", std::to_string(kLimit), "--quiet"});
  const auto start = std::chrono::steady_clock::now();
  ProgramRun run = run_program(words);
  return {std::move(run),
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

class Limits : public ::testing::Test {
 protected:
  void SetUp() override {
    grid_ = directory_ / "grid";
    ASSERT_EQ(
        run_program({"generate", "grid", "--nx", "400", "--ny", "400", "-o", grid_}).exit_code, 0);
    square_ = directory_.write("square.poly",
                               "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n"
                               "4 4 1\n0\n");
    std::filesystem::create_directory(directory_ / "out");
  }

  // Ends in time; where it is cut off, it says so, and leaves nothing half written.
  void expect_in_time(const std::vector<std::string>& words) {
    const auto [run, seconds] = run_within_limit(words);
    EXPECT_LT(seconds, 1.1 * kLimit + kSlack) << words[0];
    EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 5) << run.err;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory_.path()))
      EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }

  TemporaryDirectory directory_;
  std::string grid_, square_;
};

TEST_F(Limits, OfTimeAreKeptByEveryCommand) {
  expect_in_time({"generate", "random", "--nodes", "5000000", "-o", directory_ / "out/a.node"});
  expect_in_time({"generate", "box3", "--nodes", "5000000", "-o", directory_ / "out/a.vtu"});
  expect_in_time({"triangulate", grid_ + ".node", "-o", directory_ / "out/b"});
  expect_in_time({"mesh", square_, "--size", "0.001"});
  expect_in_time({"coarsen", grid_, "--stats", "full"});
  expect_in_time({"coarsen", grid_, "--method", "threshold"});
  expect_in_time({"audit", grid_});
  expect_in_time({"audit", grid_, "--spacing", "nn"});
  expect_in_time({"convert", grid_, directory_ / "out/c.vtu"});
  expect_in_time({"reproduce", "table-8.3", "-o", directory_ / "out/chapter"});
}

// In the middle of writing files of some hundred megabytes.
TEST_F(Limits, CtrlCEndsWhateverIsDoneAndLeavesNothing) {
  const TemporaryDirectory streams;
  const pid_t child = test::start_program(
      streams, {"generate", "random", "--nodes", "9000000", "-o", directory_ / "out/a.node"},
      "/dev/null");
  for (int i = 0; i < 10000 && !std::filesystem::exists(directory_ / "out/a.node.part0"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto start = std::chrono::steady_clock::now();
  kill(child, SIGINT);
  const ProgramRun run = test::wait_for_program(streams, child);
  const std::chrono::duration<double> reaction = std::chrono::steady_clock::now() - start;
  EXPECT_LT(reaction.count(), 0.5 + kSlack);
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_NE(run.err.find("interrupted"), run.err.npos) << run.err;
  EXPECT_TRUE(std::filesystem::is_empty(directory_ / "out"));
}

TEST_F(Limits, OfTimeThatPassInReadingAreNamed) {
  const ProgramRun run = run_program({"coarsen", grid_, "--time-limit", "1e-6"});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_NE(run.err.find("the time limit was reached"), run.err.npos) << run.err;
  EXPECT_NE(run.err.find("raise --time-limit"), run.err.npos) << run.err;
}

class MemoryLimits : public Limits {
 protected:
  void SetUp() override {
    if (!test::kMemoryCanBeLimited) GTEST_SKIP() << "the sanitizer needs more than the limits";
    Limits::SetUp();
  }
};

// So little that not even one level can be finished: what is finished at a limit is written.
TEST_F(MemoryLimits, EndInGoodOrder) {
  for (const char* megabytes : {"10", "20", "40"}) {
    const ProgramRun run = run_program(
        {"coarsen", grid_, "-o", directory_ / "out/levels", "--max-memory", megabytes, "--quiet"});
    EXPECT_TRUE(run.exit_code == 5) << megabytes << run.exit_code << run.err;
    EXPECT_NE(run.err.find("--max-memory"), run.err.npos) << run.err;
    EXPECT_TRUE(std::filesystem::is_empty(directory_ / "out"));
  }
}

// With more and more memory: what is written is whole levels, and enough stays enough.
TEST_F(MemoryLimits, LeaveTheLevelsThatWereFinished) {
  const std::string small = directory_ / "small";
  ASSERT_EQ(run_program({"generate", "grid", "--nx", "150", "--ny", "150", "-o", small}).exit_code,
            0);
  bool suffices = false;
  for (const std::string megabytes : {"12", "14", "16", "20", "30", "60"}) {
    const std::string levels = directory_ / ("out/levels" + megabytes);
    const ProgramRun run =
        run_program({"coarsen", small, "-o", levels, "--max-memory", megabytes, "--quiet"});
    EXPECT_TRUE(run.exit_code == 5 || run.exit_code == 0) << run.err;
    EXPECT_TRUE(run.exit_code == 0 || !suffices) << megabytes;
    suffices = run.exit_code == 0;
    if (std::filesystem::exists(levels)) {
      EXPECT_EQ(run_program({"audit", levels, "--quiet"}).exit_code, 0) << megabytes;
    }
  }
  EXPECT_TRUE(suffices);
}

TEST_F(MemoryLimits, LeaveTheMeshThatWasPacked) {
  for (const std::string megabytes : {"10", "14", "20"}) {
    const std::string mesh = directory_ / ("out/mesh" + megabytes);
    const ProgramRun run = run_program(
        {"mesh", square_, "--size", "0.003", "-o", mesh, "--max-memory", megabytes, "--quiet"});
    EXPECT_EQ(run.exit_code, 5) << run.err;
    EXPECT_EQ(run_program({"audit", mesh + ".node", "--quiet"}).exit_code, 0) << megabytes;
  }
  EXPECT_EQ(
      run_program({"mesh", square_, "--size", "0.003", "--max-memory", "100", "--quiet"}).exit_code,
      0);
}

}  // namespace
}  // namespace wellspaced
