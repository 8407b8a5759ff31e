// What levels keep of the theory of coarsening, as a table for the terminal.
#pragma once

#include <span>
#include <string>

#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"

namespace wellspaced {

/// A row for each level from level 1 on.
[[gnu::cold]] std::string selection_table(std::span<const SelectionCheck> levels);

}  // namespace wellspaced
