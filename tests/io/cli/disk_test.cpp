// Every command on a disk that is full and where nothing may be written: one line, exit code, and
// no file, half-written or whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::ProgramRun;
using test::run_program;
using test::TemporaryDirectory;

struct Writing {
  std::vector<std::string> words;  // without -o
  std::string output;
};

class Disk : public ::testing::Test {
 protected:
  void SetUp() override {
    inputs_.write("square.poly",
                  "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    ASSERT_EQ(run_program({"generate", "grid", "--nx", "40", "--ny", "40", "-o", inputs_ / "grid"})
                  .exit_code,
              0);
    const std::string grid = inputs_ / "grid.ele", square = inputs_ / "square.poly";
    writings_ = {{{"generate", "random", "--nodes", "2000"}, "a.xyz"},
                 {{"generate", "grid", "--nx", "40", "--ny", "40"}, "a.msh"},
                 {{"triangulate", inputs_ / "grid.node"}, "a"},
                 {{"mesh", square, "--size", "0.05"}, "a.vtu"},
                 {{"coarsen", grid, "--report", inputs_ / "new/report.html"}, "levels"},
                 {{"audit", grid, "--vtu", inputs_ / "new/a.vtu"}, "a.txt"},
                 {{"convert", grid}, "a.su2"}};
    ASSERT_TRUE(std::filesystem::create_directory(inputs_ / "new"));
  }

  static void expect_refused(const ProgramRun& run, int code) {
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_EQ(run.err.rfind("wellspaced: ", 0), 0u) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
  }

  TemporaryDirectory inputs_;
  std::vector<Writing> writings_;
};

TEST_F(Disk, NothingRemainsOfAFileThatDoesNotFit) {
  for (const Writing& writing : writings_) {
    SCOPED_TRACE(writing.words[0]);
    const TemporaryDirectory directory;
    std::vector<std::string> words = writing.words;
    words.insert(words.end(), {"--quiet", "-o", directory / writing.output});
    const ProgramRun run = test::run_program_on_full_disk(words, 1000);
    expect_refused(run, 5);
    EXPECT_NE(run.err.find("cannot write: File too large"), std::string::npos) << run.err;
    EXPECT_EQ(directory.count_files(), 0u);
    EXPECT_TRUE(std::filesystem::is_empty(inputs_ / "new"));
  }
}

TEST_F(Disk, AFileThatWasThereStaysAsItWas) {
  const TemporaryDirectory directory;
  const std::string target = directory.write("a.msh", "precious");
  const ProgramRun run =
      test::run_program_on_full_disk({"convert", inputs_ / "grid.ele", target}, 1000);
  expect_refused(run, 5);
  EXPECT_EQ(test::read_bytes(target), "precious");
  EXPECT_EQ(directory.count_files(), 1u);
}

// /proc takes no new files, not even from root.
TEST_F(Disk, WhereNothingCanBeCreatedTheCommandSaysSo) {
  for (const Writing& writing : writings_) {
    SCOPED_TRACE(writing.words[0]);
    std::vector<std::string> words = writing.words;
    words.insert(words.end(), {"--quiet", "-o", "/proc/" + writing.output});
    const ProgramRun run = run_program(words);
    expect_refused(run, 2);
    EXPECT_NE(run.err.find("/proc/"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("cannot create"), std::string::npos) << run.err;
    EXPECT_TRUE(std::filesystem::is_empty(inputs_ / "new"));
  }
}

}  // namespace
}  // namespace wellspaced
