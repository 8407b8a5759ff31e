// One run of the command coarsen, and what is said about it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/transfer/solver_levels.hpp"
#include "wellspaced/io/cli/process.hpp"
#include "wellspaced/io/cli/session.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

/// Where the time of a sequence went, by level and phase. It listens to the progress of coarsen().
class PhaseClock {
 public:
  static constexpr std::array<std::string_view, 4> kPhases = {"spacing", "boundary", "select",
                                                              "triangulate"};
  using Seconds = std::array<double, kPhases.size()>;

  void enter(std::string_view phase) {
    const double now = wall_seconds();
    levels_.back()[phase_] += now - last_;
    last_ = now;
    const auto found = std::ranges::find(kPhases, phase);
    if (found == kPhases.end()) return;  // before the first level
    const auto entered = static_cast<std::size_t>(found - kPhases.begin());
    if (entered < phase_ || levels_.size() == 1) levels_.emplace_back();
    phase_ = entered;
  }
  void stop() { enter(kPhases[phase_]); }

  double total() const { return last_ - start_; }
  /// Level 0: what came before the first phase.
  Seconds level(std::size_t k) const { return k < levels_.size() ? levels_[k] : Seconds{}; }

 private:
  double start_ = wall_seconds(), last_ = start_;
  std::size_t phase_ = 0;
  std::vector<Seconds> levels_{1};
};

/// One method's sequence and what was measured of it.
struct CoarsenRun {
  CoarseningOptions options;
  Hierarchy hierarchy;
  std::vector<LevelStatistics> statistics;
  std::vector<SelectionCheck> selection;  ///< of levels 1 and up, by refinement
  std::optional<SolverHierarchy> solver;
  PhaseClock clock;
  std::uint64_t peak_bytes = 0;
};

/// To the standard output.
void print_tables(std::span<const CoarsenRun> runs, Session& session);

/// One method: its object. Several: an object with a list of theirs.
Status write_run_summary(std::span<const CoarsenRun> runs, Session& session);

/// The web page on the runs, of which there is at least one. input: the mesh's name.
Status write_report(const std::string& path, const std::string& input,
                    std::span<const CoarsenRun> runs, Session& session);

}  // namespace wellspaced::cli
