// Every operation, failed at each of its allocations in turn: nothing leaks, nothing is left half
// done, and the error is a clean one.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/support/failing_memory.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/grid_meshes.hpp"
#include "tests/support/temporary_directory.hpp"
#include "wellspaced/io/c/wellspaced.h"
#include "wellspaced/io/cli/program.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/kernel/memory.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced {
namespace {

using test::Failure;
using test::TemporaryDirectory;

constexpr std::uint64_t kMostAllocations = 200000;

// Thousands of files come and go: in memory, where the system has a place for that.
const bool kInMemory =
    std::filesystem::is_directory("/dev/shm") && setenv("TMPDIR", "/dev/shm", 1) == 0;

// What is to be failed. `run` returns whether it succeeded, and may only where an allocation did
// not matter; `before` and `after` have all the memory they want.
struct Operation {
  std::function<bool()> run;
  std::function<void()> before = [] {};
  std::function<void(bool succeeded)> after = [](bool) {};
  std::uint64_t stride = 1;  // 1: each allocation is failed; 2: each second one; ...
};

bool run(const Operation& operation, std::uint64_t which, Failure failure) {
  operation.before();
  const std::int64_t before = test::blocks_in_use();
  test::fail_allocation(which, failure);
  const bool succeeded = operation.run();
  const bool failed = test::stop_failing_allocations();
  EXPECT_EQ(test::blocks_in_use(), before) << "a leak after allocation " << which;
  EXPECT_TRUE(succeeded || failed) << "allocation " << which;
  operation.after(succeeded);
  return failed;
}

// Runs the operation with each of its allocations failing in turn. Returns how many there were.
std::uint64_t fail_each(Failure failure, const Operation& operation) {
  operation.before();
  EXPECT_TRUE(operation.run()) << "with all the memory it wants";  // fills what stays for ever
  operation.after(true);
  for (std::uint64_t which = 1; which < kMostAllocations; which += operation.stride) {
    if (!run(operation, which, failure)) return which - 1;
    if (::testing::Test::HasFailure()) return 0;
  }
  ADD_FAILURE() << "too many allocations";
  return 0;
}

// Fails each allocation alone, and then each with all that follow.
void expect_clean_failures(const Operation& operation, std::uint64_t least) {
  EXPECT_GE(fail_each(Failure::kOnce, operation), least);
  EXPECT_GE(fail_each(Failure::kForever, operation), least);
}

// An operation of the library.
Operation library(const std::function<Status()>& operation) {
  return {.run = [operation] {
    const Status status = within_memory(operation);
    if (status.ok()) return true;
    EXPECT_EQ(status.error().code, ErrorCode::kLimit);
    EXPECT_EQ(status.error().message, "out of memory");
    return false;
  }};
}

template <class T>
Status status_of(const Result<T>& result) {
  if (!result) return result.error();
  return Ok{};
}

TEST(Exhaustion, TheKernelUnwindsFromEveryAllocation) {
  Pslg crossing;
  crossing.points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}, {1, 0.5}};
  crossing.segments = {{0, 1, 1}, {2, 3, 2}};
  expect_clean_failures(library([&] { return status_of(triangulate(crossing, {})); }), 10);
  std::vector<Point3> cube;
  for (int i = 0; i < 27; ++i) cube.push_back({double(i % 3), double(i / 3 % 3), double(i / 9)});
  expect_clean_failures(library([&] { return status_of(Delaunay3::build(cube)); }), 5);
  expect_clean_failures(library([&] { return status_of(Delaunay3::build(cube, {.threads = 2})); }),
                        5);
}

TEST(Exhaustion, EveryFormatIsReadAndWrittenOrNothingIs) {
  const Geometry plane = to_geometry(test::grid_mesh({.nx = 2, .ny = 2}));
  const Geometry space = test::random_surface(1);
  const TemporaryDirectory directory;
  for (const Format& format : formats()) {
    if (format.write == nullptr) continue;
    SCOPED_TRACE(format.name);
    const std::string name(format.name);
    const std::string path =
        directory / "x" + std::string(format.extensions.substr(0, format.extensions.find(' ')));
    const Geometry& geometry = name == "smesh" || name == "poly" ? space : plane;
    OutputSet outputs;
    ASSERT_TRUE(format.write(outputs, path, geometry).ok());
    ASSERT_TRUE(outputs.commit().ok());
    const std::size_t files = directory.count_files();
    const auto write = [&]() -> Status {
      OutputSet attempt;
      Status status = write_geometry(attempt, path, name, geometry);
      return status.ok() ? attempt.commit() : status;
    };
    expect_clean_failures(library(write), 2);
    EXPECT_EQ(directory.count_files(), files);
    if (format.readable())
      expect_clean_failures(
          library([&] { return status_of(read_geometry(path, {.format = name})); }), 2);
    std::filesystem::remove_all(directory.path());
    std::filesystem::create_directory(directory.path());
  }
}

// A context of the C interface; every call fails cleanly and leaves in it what it held.
struct CContext {
  wellspaced_context* context = wellspaced_create();
  ~CContext() { wellspaced_destroy(context); }
  operator wellspaced_context*() const { return context; }
};

const double kSquare[] = {0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.25};
const uint32_t kTriangles[] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};

bool c_call(wellspaced_context* context, wellspaced_status status) {
  if (status == WELLSPACED_OK) return true;
  EXPECT_EQ(status, WELLSPACED_LIMIT);
  EXPECT_STREQ(wellspaced_message(context), "out of memory");
  return false;
}

TEST(Exhaustion, TheCInterfaceReturnsAStatus) {
  expect_clean_failures({.run = [] { return CContext().context != nullptr; }}, 1);
  const auto triangulates = [] {
    const CContext c;
    return c != nullptr && c_call(c, wellspaced_triangulate2(c, kSquare, 5, nullptr, nullptr, 0,
                                                             nullptr, 0, WELLSPACED_HOLES_NONE));
  };
  expect_clean_failures({.run = triangulates}, 10);
  const auto coarsens = [] {
    const CContext c;
    return c != nullptr &&
           c_call(c, wellspaced_set_mesh(c, kSquare, 5, kTriangles, 4, nullptr, nullptr, 0)) &&
           c_call(c, wellspaced_coarsen(c, 0, 0, 1));
  };
  expect_clean_failures({.run = coarsens}, 50);
}

TEST(Exhaustion, TheCInterfaceKeepsWhatItHeld) {
  const CContext c;
  ASSERT_EQ(wellspaced_set_mesh(c, kSquare, 5, kTriangles, 4, nullptr, nullptr, 0), WELLSPACED_OK);
  const double far_away[] = {5, 5, 6, 5, 5, 6};
  for (std::uint64_t which = 1; which < 1000; ++which) {
    test::fail_allocation(which, Failure::kOnce);
    const auto status = wellspaced_triangulate2(c, far_away, 3, nullptr, nullptr, 0, nullptr, 0,
                                                WELLSPACED_HOLES_NONE);
    if (!test::stop_failing_allocations()) return;
    if (status == WELLSPACED_OK) break;
    EXPECT_EQ(wellspaced_get_points(c, nullptr, 0), 10u);
    EXPECT_EQ(wellspaced_get_cells(c, nullptr, 0), 12u);
  }
  FAIL() << "triangulated without memory, or for ever";
}

// Sends the standard error nowhere, as long as it lives.
class Silence {
 public:
  Silence() : saved_(dup(STDERR_FILENO)), nowhere_(open("/dev/null", O_WRONLY)) {
    dup2(nowhere_, STDERR_FILENO);
  }
  ~Silence() {
    dup2(saved_, STDERR_FILENO);
    close(saved_);
    close(nowhere_);
  }

 private:
  int saved_, nowhere_;
};

// Whether there are levels, and it is said that they are not all that was asked for.
bool is_marked_incomplete(const std::string& levels) {
  return test::read_bytes(levels + "/hierarchy.json").find("\"complete\":false") !=
         std::string::npos;
}

// Runs the program without memory; expects exit code 5 and no new file in `directory`, but for
// levels that were finished.
void expect_program_survives(const TemporaryDirectory& directory,
                             const std::vector<std::string>& words, std::uint64_t least,
                             std::uint64_t stride = 1) {
  const Silence silence;
  const std::size_t files = directory.count_files();
  const std::string out = directory / "out";
  int code = -1;
  const auto clear = [&] {
    std::filesystem::remove_all(out);
    std::filesystem::create_directory(out);
  };
  const auto check = [&](bool succeeded) {
    EXPECT_EQ(code, succeeded ? 0 : 5);
    EXPECT_TRUE(std::filesystem::is_empty(out)
                    ? !succeeded
                    : succeeded || is_marked_incomplete(out + "/levels"));
  };
  expect_clean_failures({.run = [&] { return (code = cli::run_program(words)) == 0; },
                         .before = clear,
                         .after = check,
                         .stride = stride},
                        least);
  EXPECT_EQ(directory.count_files(), files + 1);
  std::filesystem::remove_all(out);
}

class ProgramExhaustion : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_.write(
        "square.poly",
        "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 6\n3 3 4 7\n4 4 1 8\n0\n");
    directory_.write("tet.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n.2 .2 .2\n");
    directory_.write("signs", "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n0 0 0 1 0 0 0 1 0 0 0 1 2 1 1\n");
    directory_.write("cube.off",
                     "OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                     "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n");
    ASSERT_EQ(cli::run_program(std::vector<std::string>{"generate", "grid", "--nx", "4", "--ny",
                                                        "4", "-o", directory_ / "grid", "--quiet"}),
              0);
  }
  TemporaryDirectory directory_;
};

TEST_F(ProgramExhaustion, LeavesNothingOfATriangulation) {
  const std::string json = directory_ / "out/json";
  expect_program_survives(
      directory_,
      {"triangulate", directory_ / "square.poly", "-o", directory_ / "out/a", "--json", json}, 50);
  expect_program_survives(
      directory_, {"triangulate", directory_ / "tet.xyz", "-o", directory_ / "out/a.vtu"}, 50);
}

TEST_F(ProgramExhaustion, LeavesNothingOfAGeneratedOrConvertedMesh) {
  expect_program_survives(
      directory_, {"generate", "grid", "--nx", "3", "--ny", "3", "-o", directory_ / "out/a.msh"},
      50);
  expect_program_survives(
      directory_, {"mesh", directory_ / "square.poly", "--size", "0.6", "-o", directory_ / "out/a"},
      50);
  expect_program_survives(directory_,
                          {"convert", directory_ / "grid.ele", directory_ / "out/a.mesh"}, 50);
}

// Too many allocations to fail each of them: each 97th.
TEST_F(ProgramExhaustion, LeavesNothingOfAMeshInSpace) {
  expect_program_survives(directory_,
                          {"mesh", directory_ / "cube.off", "-o", directory_ / "out/a.vtu",
                           "--quiet", "--json", directory_ / "out/json"},
                          1000, 97);
}

TEST_F(ProgramExhaustion, LeavesNothingOfPredicates) {
  expect_program_survives(
      directory_, {"predicate", "insphere", directory_ / "signs", "-o", directory_ / "out/signs"},
      5);
}

TEST_F(ProgramExhaustion, LeavesNothingOfATable) {
  expect_program_survives(directory_,
                          {"reproduce", "table-8.3", "--scale", "0.004", "--runs", "1", "--quiet",
                           "--json", directory_ / "out/json"},
                          500, 7);
}

TEST_F(ProgramExhaustion, LeavesFinishedLevelsOrNothing) {
  expect_program_survives(directory_,
                          {"coarsen", directory_ / "grid.ele", "-o", directory_ / "out/levels",
                           "--levels", "1", "--stats", "full", "--quiet"},
                          500);
  for (const char* method : {"mis", "quadtree", "threshold"})
    expect_program_survives(directory_,
                            {"coarsen", directory_ / "grid.ele", "-o", directory_ / "out/levels",
                             "--levels", "1", "--method", method, "--stats", "none", "--quiet"},
                            100);
}

TEST_F(ProgramExhaustion, LeavesNothingOfReports) {
  expect_program_survives(directory_,
                          {"coarsen", directory_ / "grid.ele", "--levels", "1", "--method",
                           "function", "--quiet", "--report", directory_ / "out/report.html"},
                          200);
}

TEST_F(ProgramExhaustion, LeavesNothingOfAnAudit) {
  expect_program_survives(
      directory_, {"audit", directory_ / "grid.ele", "--quiet", "--json", directory_ / "out/json"},
      100);
  ASSERT_EQ(
      cli::run_program(std::vector<std::string>{"coarsen", directory_ / "grid.ele", "--levels", "1",
                                                "-o", directory_ / "levels", "--quiet"}),
      0);
  expect_program_survives(
      directory_, {"audit", directory_ / "levels", "--quiet", "--json", directory_ / "out/json"},
      200);
}

}  // namespace
}  // namespace wellspaced
