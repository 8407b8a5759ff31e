// What a phase of a command costs: time, processor time, memory.
#pragma once

#include "wellspaced/io/cli/process.hpp"

namespace wellspaced::cli {

struct PhaseTime {
  double wall = 0, cpu = 0;  ///< seconds
};

/// Runs from its construction on.
class Stopwatch {
 public:
  PhaseTime elapsed() const { return {wall_seconds() - wall_, cpu_seconds() - cpu_}; }

 private:
  double wall_ = wall_seconds(), cpu_ = cpu_seconds();
};

/// Measures the most memory that is resident at once from its construction on, beyond what is
/// resident then.
class MemoryGauge {
 public:
  MemoryGauge() {
    release_free_memory();
    before_ = resident_bytes();
    reset_peak_resident();
  }
  std::uint64_t peak() const {
    const std::uint64_t now = peak_resident_bytes();
    return now > before_ ? now - before_ : 0;
  }

 private:
  std::uint64_t before_ = 0;
};

}  // namespace wellspaced::cli
