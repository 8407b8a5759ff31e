// A mesh coarsened again and again, each time in another random order: the experiments of
// chapter 8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// One run: the statistics of its levels, finest first.
using RunStatistics = std::vector<LevelStatistics>;

/// runs: how many, > 0; run i has the seed options.seed + i. threads: how many runs are made at a
/// time, > 0; the result does not depend on it. progress: one phase, in thousandths of runs.
struct RepeatOptions {
  std::size_t runs = 30;
  unsigned threads = 1;
  Progress progress = {};
};

/// The mesh of a run: the same for all, or one of its own.
using MeshOfSeed = std::function<Result<TriangleMesh>(std::uint64_t seed)>;

/// Coarsens the meshes by `options`, whose seed is that of the first run and whose progress is not
/// used. mesh_of_seed may be called from several threads at a time.
/// Returns: the runs in the order of their seeds.
/// Errors: the first by seed of those of mesh_of_seed and coarsen; kCancelled.
/// Cost: that of the runs; memory for `threads` hierarchies at a time.
/// See: sections 8.3 to 8.6.
Result<std::vector<RunStatistics>> repeat_coarsening(const MeshOfSeed& mesh_of_seed,
                                                     const CoarseningOptions& options,
                                                     const RepeatOptions& repeat);

/// One figure of a level over several runs. count: how many runs have it.
struct RunSummary {
  double mean = 0, low = 0, high = 0;
  std::size_t count = 0;
};

/// What a level has of some figure, if it has it.
using LevelFigure = std::function<std::optional<double>(const LevelStatistics&)>;

/// The figure of level `level`, over the runs that reach it.
/// Returns: empty where no run has it. Cost: linear in the runs.
std::optional<RunSummary> summarise_level(std::span<const RunStatistics> runs, std::size_t level,
                                          const LevelFigure& figure);

}  // namespace wellspaced
