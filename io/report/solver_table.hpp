// What a solver makes of a hierarchy, as a table for the terminal.
#pragma once

#include <string>

#include "wellspaced/algorithms/transfer/solver_levels.hpp"

namespace wellspaced {

/// A row for each level, then the complexities.
[[gnu::cold]] std::string solver_table(const SolverHierarchy& solver);

}  // namespace wellspaced
