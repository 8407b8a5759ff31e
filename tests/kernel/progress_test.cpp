#include "wellspaced/kernel/progress.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wellspaced {
namespace {

using Told = std::vector<std::uint64_t>;

TEST(ProgressMeter, AsksAtEverySoManySteps) {
  Told told;
  const Progress listen = [&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(phase, "walk");
    EXPECT_EQ(total, 10u);
    told.push_back(done);
    return true;
  };
  ProgressMeter meter(listen, "walk", 10, 3);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(meter.step());
  EXPECT_EQ(told, (Told{3, 6, 9}));
}

TEST(ProgressMeter, CountsStepsThatAreTakenAtOnce) {
  Told told;
  const Progress listen = [&](auto, std::uint64_t done, auto) {
    told.push_back(done);
    return true;
  };
  ProgressMeter meter(listen, "walk", 0, 10);
  meter.step(25);
  meter.step(9);
  meter.step();
  EXPECT_EQ(told, (Told{25, 35}));
}

TEST(ProgressMeter, TellsOfNoMoreThanTheTotal) {
  std::uint64_t most = 0;
  const Progress listen = [&](auto, std::uint64_t done, auto) {
    most = done;
    return true;
  };
  ProgressMeter meter(listen, "walk", 5, 1);
  for (int i = 0; i < 9; ++i) meter.step();
  EXPECT_EQ(most, 5u);
}

TEST(ProgressMeter, DoesNotAskAgainOnceToldToStop) {
  int asked = 0;
  const Progress refuse = [&](auto, auto, auto) { return ++asked < 2; };
  ProgressMeter meter(refuse, "walk", 0, 2);
  int steps = 0;
  while (steps < 100 && meter.step()) ++steps;
  EXPECT_EQ(steps, 3);
  EXPECT_TRUE(meter.stopped());
  EXPECT_FALSE(meter.step());
  EXPECT_FALSE(meter.step(1000));
  EXPECT_EQ(asked, 2);
}

TEST(ProgressMeter, GoesOnWhereNobodyListens) {
  const Progress nobody;
  ProgressMeter meter(nobody, "walk", 0, 1);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(meter.step(1000));
  EXPECT_FALSE(meter.stopped());
}

TEST(ProgressParts, ArePlacedOneAfterTheOther) {
  std::vector<double> told;
  const Progress listen = [&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(phase, "whole");
    told.push_back(static_cast<double>(done) / static_cast<double>(total));
    return true;
  };
  ProgressParts parts(listen, "whole", 4);
  EXPECT_TRUE(parts.go_on(0));
  EXPECT_TRUE(parts.part(1)("part", 1, 2));
  EXPECT_TRUE(parts.part(2)("part", 7, 0));  // it is not known of how many
  EXPECT_TRUE(parts.part(3)("part", 2, 2));
  EXPECT_TRUE(parts.go_on(4));
  EXPECT_EQ(told, (std::vector<double>{0, 0.375, 0.5, 1, 1}));
}

TEST(ProgressParts, AskNobodyOnceToldToStop) {
  int asked = 0;
  const Progress refuse = [&](auto, auto, auto) { return ++asked < 2; };
  ProgressParts parts(refuse, "whole", 3);
  const Progress first = parts.part(0), second = parts.part(1);
  EXPECT_TRUE(first("part", 0, 1));
  EXPECT_FALSE(first("part", 1, 1));
  EXPECT_FALSE(second("part", 0, 1));
  EXPECT_FALSE(parts.go_on(3));
  EXPECT_TRUE(parts.stopped());
  EXPECT_EQ(asked, 2);
}

TEST(ProgressParts, HaveNoListenerWhereNobodyListens) {
  const Progress nobody;
  ProgressParts parts(nobody, "whole", 3);
  EXPECT_FALSE(parts.part(1));
  EXPECT_TRUE(parts.go_on(1));
}

}  // namespace
}  // namespace wellspaced
