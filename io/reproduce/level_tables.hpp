// The halves of Tables 8.3 to 8.8: a sequence, level by level, beside the published one.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The experiment of section 8.5 or 8.6 on a mesh: beta 25, C = 2 on grids and 8 on the others.
Experiment suite_experiment(const std::string& mesh, CoarseningMethod method);

/// A half of the table of that name. Where the mesh is lost (AIRFOIL 2), ours is empty.
/// Errors: those of Laboratory::runs.
[[gnu::cold]] Result<ExhibitTable> level_table(Laboratory& laboratory, const std::string& table,
                                               const std::string& mesh, CoarseningMethod method);

/// What is compared under the word `nodes`: means over the runs that have the level.
ExhibitCell mean_cell(const std::optional<RunSummary>& summary);

}  // namespace wellspaced
