// Operations that can be watched and cancelled.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::test {

/// Runs `operation`, which takes a Progress, to its end, and then once for each time that it asks,
/// or some forty of them, when it is told to stop: it must return kCancelled, and not ask again.
/// Returns the phases that it told of.
template <class Operation>
std::set<std::string> phases_that_cancel(Operation operation) {
  std::set<std::string> phases;
  std::size_t questions = 0;
  EXPECT_TRUE(operation([&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
                EXPECT_TRUE(total == 0 || done <= total) << phase;
                phases.emplace(phase);
                ++questions;
                return true;
              }).ok());
  for (std::size_t last = 1; last <= questions; last += 1 + questions / 40) {
    std::size_t asked = 0;
    const auto result = operation([&](auto, auto, auto) { return ++asked < last; });
    EXPECT_FALSE(result.ok()) << "told to stop at question " << last;
    if (!result.ok()) {
      EXPECT_EQ(result.error().code, ErrorCode::kCancelled) << result.error().message;
    }
    EXPECT_EQ(asked, last);
  }
  return phases;
}

}  // namespace wellspaced::test
