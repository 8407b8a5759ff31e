// The built program as its users meet it: exit codes, streams, one-line errors.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <string>

#include "tests/support/data.hpp"
#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::ProgramRun;
using test::run_program;
using test::TemporaryDirectory;

// Exit code `code`, nothing on stdout, one line on stderr that mentions `what`.
void expect_one_line_error(const ProgramRun& run, int code, const std::string& what) {
  EXPECT_EQ(run.exit_code, code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("wellspaced: ", 0), 0u) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
}

TEST(Program, PrintsItsVersionAndHelpOnTheStandardOutput) {
  const ProgramRun version = run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("wellspaced ", 0), 0u);
  const ProgramRun help = run_program({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("\n  predicate "), std::string::npos);
  EXPECT_EQ(help.err, "");
}

TEST(Program, ShowsItsHelpAsAUsageErrorWithoutACommand) {
  const ProgramRun run = run_program({});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("commands:"), std::string::npos);
}

TEST(Program, HelpsWithEachCommand) {
  const std::string help = run_program({"--help"}).out;
  std::size_t commands = 0;
  for (std::size_t at = help.find("\n  "); at != std::string::npos;
       at = help.find("\n  ", at + 1)) {
    if (help[at + 3] == ' ') continue;  // a continued line
    const std::string name = help.substr(at + 3, help.find(' ', at + 3) - at - 3);
    const ProgramRun run = run_program({name, "--help"});
    EXPECT_EQ(run.exit_code, 0) << name;
    EXPECT_NE(run.out.find("--seed N"), std::string::npos) << name;
    ++commands;
  }
  EXPECT_GE(commands, 1u);
}

TEST(Program, RefusesUnknownCommandsAndOptions) {
  expect_one_line_error(run_program({"frobnicate"}), 2, "'frobnicate'");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--frob"}), 2, "'--frob'");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "-x"}), 2, "'-x'");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--seed"}), 2, "--seed");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--seed=x"}), 2, "--seed");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--seed=-1"}), 2, "at least 0");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--quiet=1"}), 2, "no value");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--quiet", "--quiet"}), 2,
                        "twice");
  expect_one_line_error(run_program({"predicate", "orient2d"}), 2, "KIND FILE");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "--time-limit", "0"}), 2,
                        "more than 0");
  expect_one_line_error(run_program({"predicate", "orient2d", "-", "-o", "-", "--json=-"}), 2,
                        "standard output");
}

TEST(Program, ReportsAMissingFile) {
  expect_one_line_error(run_program({"predicate", "orient2d", "/no/such\nfile"}), 3,
                        "/no/such?file: cannot read: No such file");
}

TEST(Program, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const ProgramRun run =
      run_program({"predicate", "orient2d", "-", "-o", "/dev/full"}, "0 0 1 0 0 1");
  expect_one_line_error(run, 5, "No space left on device");
}

TEST(Program, EndsCleanlyAtCtrlCWhileItReads) {
  const TemporaryDirectory directory, streams;
  const std::string pipe = streams / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const pid_t child = test::start_program(
      streams, {"triangulate", pipe, "-o", directory / "a", "--json", directory / "j"},
      "/dev/null");
  const int feed = open(pipe.c_str(), O_WRONLY);  // returns when the program has opened it
  ASSERT_EQ(write(feed, "3 2 0 0\n", 8), 8);
  kill(child, SIGINT);
  const ProgramRun run = test::wait_for_program(streams, child);
  close(feed);
  expect_one_line_error(run, 5, "interrupted");
  EXPECT_EQ(directory.count_files(), 0u);
}

TEST(Program, KeepsItsTimeLimitEvenWhereAPipeStaysSilent) {
  const TemporaryDirectory directory, streams;
  const std::string pipe = streams / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const pid_t child = test::start_program(
      streams, {"convert", pipe, directory / "a", "--time-limit", "0.3"}, "/dev/null");
  const int feed = open(pipe.c_str(), O_WRONLY);
  const ProgramRun run = test::wait_for_program(streams, child);
  close(feed);
  expect_one_line_error(run, 5, "the time limit was reached");
  EXPECT_EQ(directory.count_files(), 0u);
}

TEST(Predicate, PrintsOneSignALine) {
  const ProgramRun run =
      run_program({"predicate", "orient2d", "-"}, "# a comment\n0 0 1 0 0 1\r\n\n0,0 1\n");
  expect_one_line_error(run, 3, "<stdin>:4: the coordinate '0,0' is not a number");
  EXPECT_EQ(run_program({"predicate", "orient2d", "-"}, "0 0 1 0 0 1\n0 0 +1 1 0x1p1 2").out,
            "1\n0\n");
  EXPECT_EQ(run_program({"predicate", "incircle", "-"}, "0 0 1 0 0 1 .5 .5\n0 0 1 0 0 1 1 1").out,
            "1\n0\n");
  EXPECT_EQ(run_program({"predicate", "orient3d", "-"}, "0 0 0 1 0 0 0 1 0 0 0 -1").out, "1\n");
  EXPECT_EQ(
      run_program({"predicate", "insphere", "-"}, "0 0 0  1 0 0  0 1 0  0 0 -1  .1 .1 -.1\n").out,
      "1\n");
}

TEST(Predicate, RefusesLinesOfTheWrongLengthAndWritesNothing) {
  const TemporaryDirectory directory;
  for (const char* line : {"0 0 1 0 0", "0 0 1 0 0 1 7", "0 0 1 0 0 x", "0 0 1 0 0 1e400"}) {
    const std::string input = std::string("0 0 1 0 0 1\n") + line;
    expect_one_line_error(
        run_program({"predicate", "orient2d", "-", "-o", directory / "signs"}, input), 3, ":2: ");
  }
  expect_one_line_error(run_program({"predicate", "orient2d", "-"}, "0 0 1 0 0 nan"), 4, ":1: ");
  expect_one_line_error(run_program({"predicate", "inball", "-"}, ""), 2, "'inball'");
  EXPECT_EQ(directory.count_files(), 0u);
}

TEST(Predicate, DecidesThePublicCorpusRight) {
  WELLSPACED_REQUIRE_DATA("issues/predicates");
  for (const std::string kind : {"orient2d", "incircle", "orient3d", "insphere"}) {
    const std::string path = test::data_path("issues/predicates/" + kind + "_public_nanevski.txt");
    std::ifstream file(path);
    std::string expected;
    for (std::string line; std::getline(file, line);)
      expected += line.substr(0, line.find(' ')) + "\n";
    EXPECT_GT(expected.size(), 2000u);
    EXPECT_EQ(run_program({"predicate", kind, path, "--corpus"}).out, expected) << kind;
  }
}

}  // namespace
}  // namespace wellspaced
