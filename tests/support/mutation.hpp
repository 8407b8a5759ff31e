// Plants faults in clean inputs of an auditor: each must be found by exactly the checks that should
// find it. Prints a table, headed by the name of the test suite: planted, found, false alarms.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::test {

using Names = std::set<std::string>;

inline Names operator+(Names a, const Names& b) {
  a.insert(b.begin(), b.end());
  return a;
}

inline Names failing(const audit::Report& report) {
  Names names;
  for (const auto& check : report.checks)
    if (!check.pass()) names.insert(check.name);
  return names;
}

inline Index any(std::size_t count, Random& random) {
  return static_cast<Index>(random.below(count));
}

// plant: returns false where this input has no place for the fault.
// must: the checks that have to fail; may: those that can fail with them, as a true consequence.
template <class Input>
struct Fault {
  std::string name;
  std::function<bool(Input&, Random&)> plant;
  Names must, may;
};

template <class Input>
class MutationTest {
 public:
  using Audit = std::function<audit::Report(const Input&)>;

  // optional: checks that a clean input may fail.
  MutationTest(Audit audit, Names optional)
      : audit_(std::move(audit)), optional_(std::move(optional)) {
    const char* suite = ::testing::UnitTest::GetInstance()->current_test_suite()->name();
    std::printf("%-55s %8s %8s %12s\n", suite, "planted", "found", "false alarms");
  }

  // Each fault will be planted so many times in this input.
  void add_clean(std::string name, Input input, int plants) {
    Names before = failing(audit_(input));
    for (const auto& check : before)
      EXPECT_EQ(optional_.count(check), 1u) << "clean " << name << ": " << check;
    clean_.push_back({std::move(name), std::move(input), std::move(before), plants});
  }

  void run(const std::vector<Fault<Input>>& faults, int at_least) {
    for (const auto& fault : faults) {
      Tally tally;
      for (const Clean& clean : clean_) plant(fault, clean, tally);
      std::printf("%-55s %8d %8d %12d\n", fault.name.c_str(), tally.planted, tally.found,
                  tally.false_alarms);
      EXPECT_GE(tally.planted, at_least) << fault.name;
      EXPECT_EQ(tally.found, tally.planted) << fault.name;
      EXPECT_EQ(tally.false_alarms, 0) << fault.name;
    }
  }

 private:
  struct Clean {
    std::string name;
    Input input;
    Names before;
    int plants;
  };
  struct Tally {
    int planted = 0, found = 0, false_alarms = 0;
  };

  void plant(const Fault<Input>& fault, const Clean& clean, Tally& tally) const {
    Random random(7);
    const Names legal = clean.before + fault.must + fault.may;
    for (int i = 0; i < clean.plants; ++i) {
      Input input = clean.input;
      if (!fault.plant(input, random)) continue;
      ++tally.planted;
      const Names after = failing(audit_(input));
      tally.found += contains(after, fault.must);
      tally.false_alarms += !contains(legal, after);
      for (const auto& check : fault.must)
        EXPECT_EQ(after.count(check), 1u) << fault.name << " on " << clean.name << ": " << check;
      for (const auto& check : after)
        EXPECT_EQ(legal.count(check), 1u) << fault.name << " on " << clean.name << ": " << check;
    }
  }

  static bool contains(const Names& all, const Names& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  }

  Audit audit_;
  Names optional_;
  std::vector<Clean> clean_;
};

}  // namespace wellspaced::test
