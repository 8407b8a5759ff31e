// The runs of an experiment in a file, to go on where an interrupted program stopped.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wellspaced/algorithms/coarsening/repeated_coarsening.hpp"

namespace wellspaced {

/// The runs as a JSON text. parameters: all that they depend on.
[[gnu::cold]] std::string runs_json(const std::string& parameters,
                                    std::span<const RunStatistics> runs);

/// The runs in the file `path`, whose text runs_json made with the same parameters; every figure
/// reads back as it was (an infinite gradation as none).
/// Returns: nothing if there is no such file, or it was made with others, or it is damaged.
[[gnu::cold]] std::optional<std::vector<RunStatistics>> read_runs(const std::string& path,
                                                                  const std::string& parameters);

}  // namespace wellspaced
