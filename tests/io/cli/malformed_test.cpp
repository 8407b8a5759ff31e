// Malformed and hostile files given to the program: each is read, or refused in one line that names
// the file, with the exit code of its kind and nothing written.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/sanitizer.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::run_program;
using test::TemporaryDirectory;

enum Exit { kRead = 0, kUnreadable = 3, kInvalid = 4 };

struct Case {
  const char* what;
  const char* file;
  std::string bytes;
  Exit expected;
};

std::string garbage(std::size_t size, std::uint64_t seed) {
  Random random(seed);
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(random.below(256));
  return bytes;
}

std::string little_endian(std::uint64_t value) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(value >> 8 * i & 255);
  return bytes;
}

std::string f64(std::uint64_t dimension, std::uint64_t count, const std::string& rest) {
  return little_endian(dimension) + little_endian(count) + rest;
}

void expect_outcome(const Case& c) {
  SCOPED_TRACE(std::string(c.file) + ": " + c.what);
  const TemporaryDirectory directory;
  const std::string path = directory.write(c.file, c.bytes);
  std::vector<std::string> words = {"triangulate", path, "-o", directory / "result"};
  words.insert(words.end(), {"--time-limit", "30"});
  if (test::kMemoryCanBeLimited) words.insert(words.end(), {"--max-memory", "2000"});
  const auto run = run_program(words);
  EXPECT_EQ(run.exit_code, c.expected) << run.err.substr(0, 300);
  EXPECT_EQ(directory.count_files(), c.expected == kRead ? 4u : 1u);
  if (c.expected == kRead) return;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err.substr(0, 300);
  EXPECT_NE(run.err.find("/a."), std::string::npos) << run.err.substr(0, 300);
  EXPECT_LT(run.err.size(), 500u);
}

void expect_outcomes(const std::vector<Case>& cases) {
  for (const Case& c : cases) expect_outcome(c);
}

const std::string kThree = "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n";

TEST(Malformed, NodeFilesAreReadOrRefusedInOneLine) {
  expect_outcomes({
      {"empty", "a.node", "", kUnreadable},
      {"only a comment", "a.node", "# 3 2 0 0\n", kUnreadable},
      {"no points", "a.node", "0 2 0 0\n", kRead},
      {"a count of 4e9", "a.node", "4000000000 2 0 0\n0 1 1\n", kUnreadable},
      {"a count beyond 64 bits", "a.node", "99999999999999999999999 2 0 0\n", kUnreadable},
      {"a negative count", "a.node", "-3 2 0 0\n0 1 1\n", kUnreadable},
      {"a count that is no number", "a.node", "three 2 0 0\n", kUnreadable},
      {"1e9 attributes", "a.node", "1 2 1000000000 0\n0 1 1\n", kUnreadable},
      {"dimension 4", "a.node", "1 4 0 0\n0 1 1 1 1\n", kUnreadable},
      {"dimension 0", "a.node", "1 0 0 0\n0\n", kUnreadable},
      {"one point short", "a.node", "4 2 0 0\n0 0 0\n1 4 0\n2 0 4\n", kUnreadable},
      {"cut within a point", "a.node", "3 2 0 0\n0 0 0\n1 4 0\n2 0", kUnreadable},
      {"one point more", "a.node", kThree + "3 1 1\n", kUnreadable},
      {"numbers that skip one", "a.node", "3 2 0 0\n0 0 0\n2 4 0\n3 0 4\n", kUnreadable},
      {"two index bases", "a.node", "3 2 0 0\n1 0 0\n0 4 0\n2 0 4\n", kUnreadable},
      {"NaN", "a.node", "3 2 0 0\n0 0 0\n1 nan 0\n2 0 4\n", kInvalid},
      {"infinity", "a.node", "3 2 0 0\n0 0 0\n1 -inf 0\n2 0 4\n", kInvalid},
      {"overflow", "a.node", "3 2 0 0\n0 0 0\n1 1e400 0\n2 0 4\n", kUnreadable},
      {"a word", "a.node", "3 2 0 0\n0 0 0\n1 O 0\n2 0 4\n", kUnreadable},
      {"a number with a tail", "a.node", "3 2 0 0\n0 0 0\n1 4x 0\n2 0 4\n", kUnreadable},
      {"a NUL", "a.node", kThree.substr(0, 12) + '\0' + kThree.substr(13), kUnreadable},
      {"4096 random bytes", "a.node", garbage(4096, 1), kUnreadable},
      {"another 4096", "a.node", garbage(4096, 2), kUnreadable},
  });
}

TEST(Malformed, NodeFilesThatAreOddButRightAreRead) {
  expect_outcomes({
      {"CRLF", "a.node", "3 2 0 0\r\n0 0 0\r\n1 4 0\r\n2 0 4\r\n", kRead},
      {"BOM", "a.node", "\xEF\xBB\xBF" + kThree, kRead},
      {"tabs", "a.node", "3\t2\t0\t0\n\t0\t0\t0\n1\t4\t0\n2 0 4", kRead},
      {"comments", "a.node", "# a\n3 2 0 0 # b\n\n0 0 0#c\n1 4 0\n#\n2 0 4\n#", kRead},
      {"signs and hex floats", "a.node", "3 2 0 0\n0 +0 -0\n1 0x1p2 0\n2 0 +4e0\n", kRead},
      {"short header", "a.node", "3 2\n0 0 0\n1 4 0\n2 0 4\n", kRead},
      {"1e-400 and the least subnormal", "a.node",
       "3 2 0 0\n0 1e-400 -1e-400\n1 4.9e-324 0\n2 0 5e-324\n", kRead},
      {"10^7 blanks", "a.node",
       "3 2 0 0\n0 0 0\n1 " + std::string(10'000'000, ' ') + "4 0\n2 0 4\n", kRead},
      {"10^7 digits", "a.node",
       "3 2 0 0\n0 0 0\n1 0." + std::string(10'000'000, '4') + " 0\n2 0 4\n", kRead},
      {"a comment of 10^7", "a.node", "#" + std::string(10'000'000, 'x') + "\n" + kThree, kRead},
  });
}

TEST(Malformed, PolyFilesAreReadOrRefusedInOneLine) {
  const std::string points = "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n";
  expect_outcomes({
      {"empty", "a.poly", "", kUnreadable},
      {"points elsewhere that are not there", "a.poly", "0 2 0 0\n1 0\n0 0 1\n0\n", kUnreadable},
      {"4e9 segments", "a.poly", points + "4000000000 0\n0 0 1\n", kUnreadable},
      {"negative segments", "a.poly", points + "-1 0\n0\n", kUnreadable},
      {"4e9 holes", "a.poly", points + "1 0\n0 0 1\n4000000000\n", kUnreadable},
      {"an end that is no point", "a.poly", points + "1 0\n0 0 4\n0\n", kInvalid},
      {"a negative end", "a.poly", points + "1 0\n0 -1 2\n0\n", kInvalid},
      {"segments counted from 1 over points from 0", "a.poly",
       points + "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n", kInvalid},
      {"cut within a segment", "a.poly", points + "1 0\n0 0", kUnreadable},
      {"cut within a hole", "a.poly", points + "1 0\n0 0 1\n1\n0 1", kUnreadable},
      {"a hole at NaN", "a.poly", points + "1 0\n0 0 1\n1\n0 nan 1\n", kInvalid},
      {"cut within a facet", "a.poly", "1 3 0 0\n0 0 0 0\n1 0\n1\n", kUnreadable},
      {"a marker beyond an int", "a.poly", points + "1 1\n0 0 1 99999999999\n0\n", kUnreadable},
      {"4096 random bytes", "a.poly", garbage(4096, 3), kUnreadable},
      {"without holes", "a.poly", points + "1 0\n0 0 1\n", kRead},
      {"without segments", "a.poly", points, kUnreadable},
      {"a segment without length", "a.poly", points + "1 0\n0 1 1\n0\n", kRead},
      {"a segment numbered anyhow", "a.poly", points + "1 0\n7 0 1\n0\n", kRead},
  });
}

TEST(Malformed, PointFilesAreReadOrRefusedInOneLine) {
  const std::string doubles = f64(2, 3, "") + std::string(48, '\0');
  expect_outcomes({
      {"lines of 2 and 3", "a.xyz", "0 0\n1 1 1\n", kUnreadable},
      {"a line of 1", "a.xyz", "1\n", kUnreadable},
      {"a line of 4", "a.xyz", "1 2 3 4\n", kUnreadable},
      {"NaN", "a.xyz", "0 0\n1 NaN\n", kInvalid},
      {"overflow", "a.xyz", "0 0\n1 -1e309\n", kUnreadable},
      {"4096 random bytes", "a.xyz", garbage(4096, 4), kUnreadable},
      {"empty", "a.xyz", "", kRead},
      {"1e-400", "a.xyz", "0 0\n1e-400 1\n1 0\n", kRead},
      {"10^7 blanks", "a.xyz", "0 0\n1" + std::string(10'000'000, ' ') + "1\n1 0", kRead},
      {"empty", "a.f64", "", kUnreadable},
      {"half a header", "a.f64", little_endian(2), kUnreadable},
      {"dimension 7", "a.f64", f64(7, 1, std::string(56, '\0')), kUnreadable},
      {"2^63 points", "a.f64", f64(2, std::uint64_t{1} << 63, ""), kUnreadable},
      {"a count whose bytes wrap around to 0", "a.f64", f64(2, std::uint64_t{1} << 60, ""),
       kUnreadable},
      {"a byte short", "a.f64", doubles.substr(0, doubles.size() - 1), kUnreadable},
      {"a byte more", "a.f64", doubles + 'x', kUnreadable},
      {"NaN", "a.f64", f64(2, 1, little_endian(0x7FF8000000000000u) + little_endian(0)), kInvalid},
      {"infinity", "a.f64", f64(2, 1, little_endian(0xFFF0000000000000u) + little_endian(0)),
       kInvalid},
      {"subnormals", "a.f64", f64(2, 1, little_endian(1) + little_endian(1)), kRead},
      {"three points in one place", "a.f64", doubles, kRead},
  });
}

TEST(Malformed, RandomGarbageNeverCrashesAReader) {
  const TemporaryDirectory directory;
  for (const char* file : {"a.node", "a.poly", "a.ele", "a.edge", "a.xyz", "a.f64"})
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const std::string path = directory.write(file, garbage(200 << seed % 4, seed));
      const auto run = run_program({"convert", path, directory / "out.vtu"});
      EXPECT_EQ(run.exit_code, kUnreadable) << file << ' ' << seed << ' ' << run.err;
    }
}

// What the program must make of two decimals: half way between 1 and the next double, and above.
TEST(Malformed, HalfwayDecimalsRoundToEven) {
  const std::string half = "1.00000000000000011102230246251565404236316680908203125";
  const auto said = [](const std::string& first, const std::string& second) {
    return run_program({"triangulate", "-"}, first + " 0\n" + second + " 0\n0 1\n").out;
  };
  EXPECT_NE(said("1", half).find("1 duplicates"), std::string::npos);
  EXPECT_EQ(said("1", half + "0000000001").find("duplicates"), std::string::npos);
  EXPECT_NE(said("0x1.0000000000001p0", half + "0000000001").find("1 dupl"), std::string::npos);
}

TEST(Malformed, PredicateLinesAreReadOrRefused) {
  const TemporaryDirectory directory;
  const auto exit_code = [&](const std::string& text) {
    return run_program({"predicate", "orient2d", directory.write("a.txt", text)}).exit_code;
  };
  EXPECT_EQ(exit_code("0 0 1 0 0 1\n"), kRead);
  EXPECT_EQ(exit_code("0 0 1 0 0x1p-1074 1e-400\n"), kRead);
  EXPECT_EQ(exit_code(std::string(10'000'000, ' ') + "0 0 1 0 0 1\n"), kRead);
  EXPECT_EQ(exit_code("0 0 1 0 0\n"), kUnreadable);
  EXPECT_EQ(exit_code("0 0 1 0 0 1 1\n"), kUnreadable);
  EXPECT_EQ(exit_code("0 0 1 0 0 nan\n"), kInvalid);
  EXPECT_EQ(exit_code("0 0 1 0 0 1e309\n"), kUnreadable);
  EXPECT_EQ(exit_code(garbage(4096, 5)), kUnreadable);
}

}  // namespace
}  // namespace wellspaced
