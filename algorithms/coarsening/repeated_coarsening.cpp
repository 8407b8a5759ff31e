#include "wellspaced/algorithms/coarsening/repeated_coarsening.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "wellspaced/kernel/parallel.hpp"

namespace wellspaced {
namespace {

// What the threads of an experiment share. Only the caller's thread tells the listener.
class RunWatch {
 public:
  explicit RunWatch(const RepeatOptions& repeat) : repeat_(repeat) {}

  // For the coarsening of a run: whether to go on.
  Progress listener(unsigned worker) {
    return [this, worker](std::string_view, std::uint64_t done, std::uint64_t total) {
      if (worker == 0 && !tell(total == 0 ? 0 : kParts * done / total)) stopped_ = true;
      return !stopped_;
    };
  }
  bool stopped() const { return stopped_; }
  void finish_run() { ++finished_; }

 private:
  static constexpr std::uint64_t kParts = 1000;  // of a run

  // part: how much of its present run the caller's thread has done.
  bool tell(std::uint64_t part) const {
    return report(repeat_.progress, "coarsening", kParts * finished_ + part, kParts * repeat_.runs);
  }

  const RepeatOptions& repeat_;
  std::atomic<bool> stopped_ = false;
  std::atomic<std::uint64_t> finished_ = 0;
};

Result<RunStatistics> one_run(const MeshOfSeed& mesh_of_seed, const CoarseningOptions& options) {
  auto mesh = mesh_of_seed(options.seed);
  if (!mesh) return mesh.error();
  const auto hierarchy = coarsen(std::move(*mesh), options);
  if (!hierarchy) return hierarchy.error();
  if (!hierarchy->complete) return cancelled();
  return hierarchy_statistics(*hierarchy);
}

}  // namespace

Result<std::vector<RunStatistics>> repeat_coarsening(const MeshOfSeed& mesh_of_seed,
                                                     const CoarseningOptions& options,
                                                     const RepeatOptions& repeat) {
  RunWatch watch(repeat);
  std::vector<Result<RunStatistics>> results(repeat.runs, cancelled());
  run_parallel(repeat.threads, repeat.runs, [&](unsigned worker, std::size_t i) {
    if (watch.stopped()) return;
    CoarseningOptions run = options;
    run.seed = options.seed + i;
    run.progress = watch.listener(worker);
    results[i] = one_run(mesh_of_seed, run);
    watch.finish_run();
  });
  std::vector<RunStatistics> runs;
  for (auto& result : results) {
    if (!result) return result.error();
    runs.push_back(std::move(*result));
  }
  return runs;
}

std::optional<RunSummary> summarise_level(std::span<const RunStatistics> runs, std::size_t level,
                                          const LevelFigure& figure) {
  RunSummary summary;
  for (const RunStatistics& run : runs) {
    const auto value = level < run.size() ? figure(run[level]) : std::nullopt;
    if (!value) continue;
    summary.low = summary.count == 0 ? *value : std::min(summary.low, *value);
    summary.high = summary.count == 0 ? *value : std::max(summary.high, *value);
    summary.mean += *value;
    ++summary.count;
  }
  if (summary.count == 0) return std::nullopt;
  summary.mean /= static_cast<double>(summary.count);
  return summary;
}

}  // namespace wellspaced
