// A program without any dependency that proves the predicates as they were compiled with it.
//
// usage: predicates_checker [LINES]
//
// Asks every rung of every predicate about LINES hard lines (10,000 if not given), compares each
// answer with integer arithmetic written in the tests, and the hash of the first 1,000 signs with
// the one below, which is the same on every compiler and machine. Exit code 0: all agree.
#include <cstdio>
#include <cstdlib>

#include "tests/support/predicate_cases.hpp"

namespace wellspaced::testing {
namespace {

constexpr int kHashed = 1000;

template <class Case>
bool all_rungs_agree(const typename Case::Coordinates& x, int expected) {
  const int filtered = Case::filter(x);
  return Case::sign(x) == expected && Case::big(x) == expected &&
         Case::fixed(x).value_or(expected) == expected && (filtered == 0 || filtered == expected);
}

template <class Case>
bool check(int lines, std::uint64_t expected_hash) {
  LineGenerator<Case> generator(1);
  std::uint64_t hash = 0;
  for (int i = 0; i < lines; ++i) {
    const auto x = generator.line(static_cast<Family>(i % kFamilies));
    const int expected = slow_sign<Case>(x);
    if (!all_rungs_agree<Case>(x, expected)) {
      std::printf("%s: wrong sign in line %d\n", Case::kName, i);
      return false;
    }
    if (i < kHashed) hash = splitmix64(hash + static_cast<std::uint64_t>(Case::sign(x) + 1));
  }
  std::printf("%s: %d lines, hash %016llx\n", Case::kName, lines,
              static_cast<unsigned long long>(hash));
  return lines < kHashed || hash == expected_hash;
}

}  // namespace
}  // namespace wellspaced::testing

int main(int argc, char** argv) {
  using namespace wellspaced::testing;
  const int lines = argc > 1 ? std::atoi(argv[1]) : 10000;
  bool ok = check<Orient2dCase>(lines, 0x88ea7946b214fc99u);
  ok = check<IncircleCase>(lines, 0x0b3ab0b60afd6e3bu) && ok;
  ok = check<Orient3dCase>(lines, 0x874437addefc47adu) && ok;
  ok = check<InsphereCase>(lines, 0x23e1bfe9df49de0au) && ok;
  return ok ? 0 : 1;
}
