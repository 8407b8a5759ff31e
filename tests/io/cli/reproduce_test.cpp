// wellspaced reproduce as its users meet it.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/support/json.hpp"
#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::ProgramRun;
using test::read_bytes;
using test::run_program;
using test::TemporaryDirectory;

TEST(Reproduce, PutsATableBesideThePublishedOne) {
  const ProgramRun run = run_program(
      {"reproduce", "table-8.3", "--scale", "0.03", "--runs", "5", "--quiet", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = parse_json(run.out, "out");
  ASSERT_TRUE(json.ok());
  const JsonValue* exhibits = json->find("exhibits");
  ASSERT_TRUE(exhibits != nullptr && exhibits->items.size() == 1);
  const JsonValue& function = exhibits->items[0].find("tables")->items[0];
  EXPECT_EQ(function.find("comparable")->kind, JsonValue::Kind::kFalse);
  const JsonValue& nodes = function.find("rows")->items[0].find("cells")->items[0];
  EXPECT_EQ(nodes.find("ours")->number, 900);
  EXPECT_EQ(nodes.find("published")->number, 1e6);
}

TEST(Reproduce, TakesKeptRunsInsteadOfNewOnes) {
  const TemporaryDirectory directory;
  const std::vector<std::string> words = {"reproduce", "table-8.3", "--scale", "0.02",
                                          "--runs",    "5",         "-o",      directory / "o"};
  const ProgramRun first = run_program(words);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  const std::string path = directory / "o/runs/grid1-mis.json";
  std::string runs = read_bytes(path);
  const std::size_t nodes = runs.find("[400,");
  ASSERT_NE(nodes, runs.npos);
  directory.write("o/runs/grid1-mis.json", runs.replace(nodes, 4, "[401"));
  EXPECT_NE(run_program(words).out, first.out);
  std::filesystem::remove(path);
  EXPECT_EQ(run_program(words).out, first.out);
}

TEST(Reproduce, IsTheSameOnSeveralThreads) {
  const TemporaryDirectory one, two;
  const auto run = [](const TemporaryDirectory& directory, const char* threads) {
    return run_program({"reproduce", "table-8.4", "--scale", "0.02", "--runs", "12", "--threads",
                        threads, "-o", directory / "o"});
  };
  EXPECT_EQ(run(one, "1").out, run(two, "3").out);
  for (const std::string file :
       {"o/table-8.4.json", "o/table-8.4-mis.csv", "o/runs/grid10-mis.json"})
    EXPECT_EQ(read_bytes(one / file), read_bytes(two / file)) << file;
}

TEST(Reproduce, LabelsStandIns) {
  const ProgramRun run = run_program({"reproduce", "table-8.6", "--runs", "1"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("a stand-in, not the thesis' mesh"), run.out.npos) << run.out;
  EXPECT_EQ(run.out.find("beyond the spread"), run.out.npos);
}

// A clean stop: what was complete is kept and taken up.
TEST(Reproduce, GoesOnWhereItWasInterrupted) {
  const TemporaryDirectory directory;
  const std::vector<std::string> words = {"reproduce", "table-8.3", "--scale", "0.3",
                                          "--runs",    "30",        "-o",      directory / "o"};
  const pid_t child = test::start_program(directory, words, "/dev/null");
  while (!std::filesystem::exists(directory / "o/runs/grid1-function.json"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGINT);
  const ProgramRun run = test::wait_for_program(directory, child);
  if (run.exit_code == 0) GTEST_SKIP() << "it was done before the signal came";
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_NE(run.err.find("what was complete stays in"), run.err.npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(directory / "o/table-8.3.json"));
  EXPECT_TRUE(std::filesystem::exists(directory / "o/runs/grid1-function.json"));
  EXPECT_FALSE(std::filesystem::exists(directory / "o/runs/grid1-mis.json"));
}

TEST(Reproduce, AllMakesAPageOfEverything) {
  const TemporaryDirectory directory;
  const ProgramRun run = run_program(
      {"reproduce", "all", "--scale", "0.01", "--runs", "1", "-o", directory / "o", "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string html = read_bytes(directory / "o/index.html");
  for (const char* id : {"figure-1.1", "figure-1.5", "figure-5.4", "section-6.1", "table-8.1",
                         "figure-8.5", "section-8.4", "table-8.3", "table-8.8", "figure-8.9"}) {
    EXPECT_NE(html.find("<section id=\"" + std::string(id) + '"'), html.npos) << id;
    EXPECT_TRUE(std::filesystem::exists(directory / ("o/" + std::string(id) + ".json"))) << id;
  }
  for (const char* file : {"o/figure-1.1a.svg", "o/table-8.5-function.csv", "o/section-8.4.2.csv",
                           "o/drawings-crack-level-1.svg"})
    EXPECT_FALSE(read_bytes(directory / file).empty()) << file;
}

TEST(Reproduce, RefusesWhatItCannotMake) {
  EXPECT_EQ(run_program({"reproduce", "table-9.1"}).exit_code, 2);
  EXPECT_EQ(run_program({"reproduce", "all"}).exit_code, 2);
  EXPECT_EQ(run_program({"reproduce", "table-8.5", "-o", "-"}).exit_code, 2);
  EXPECT_EQ(run_program({"reproduce", "table-8.5", "--runs", "0"}).exit_code, 2);
  EXPECT_EQ(run_program({"reproduce", "table-8.5", "--scale", "0"}).exit_code, 2);
  EXPECT_EQ(run_program({"reproduce", "table-8.5", "--data", "/nowhere"}).exit_code, 3);
}

TEST(Reproduce, ShowsThePublishedTableAloneWhereTheMeshIsLost) {
  const ProgramRun run = run_program({"reproduce", "table-8.7"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("coordinates of this mesh are lost"), run.out.npos);
  EXPECT_EQ(run.out.find("beyond the spread"), run.out.npos);
}

}  // namespace
}  // namespace wellspaced
