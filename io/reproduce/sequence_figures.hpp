// Figures 8.5 to 8.9 and the drawings at the end of chapter 8.
#pragma once

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

// Each adds to an exhibit that has its name and title. Errors: those of Laboratory::runs.

/// Adds charts of the sizes and angles to an exhibit of two tables by level_table, for its files.
[[gnu::cold]] void add_sequence_charts(Exhibit& exhibit);

/// Figure 8.5: C from 2 to 10 at beta 25, and beta from 5 to 50 at C 5, on AIRFOIL 1.
[[gnu::cold]] Result<Exhibit> parameter_exhibit(Laboratory& laboratory, Exhibit exhibit);

/// Figure 8.6: sizes and smallest angles on the grids.
[[gnu::cold]] Result<Exhibit> grid_figure_exhibit(Laboratory& laboratory, Exhibit exhibit);

/// Figures 8.7 and 8.8: sizes by level on the graded meshes, linear and logarithmic.
[[gnu::cold]] Result<Exhibit> size_figure_exhibit(Laboratory& laboratory, Exhibit exhibit);
[[gnu::cold]] Result<Exhibit> log_size_figure_exhibit(Laboratory& laboratory, Exhibit exhibit);

/// Figure 8.9: the smallest angle of a level over its size, on the graded meshes.
[[gnu::cold]] Result<Exhibit> angle_figure_exhibit(Laboratory& laboratory, Exhibit exhibit);

/// The last pages of chapter 8: the levels of CRACK, AIRFOIL 1 and AIRFOIL 3, both methods side by
/// side.
[[gnu::cold]] Result<Exhibit> drawings_exhibit(Laboratory& laboratory, Exhibit exhibit);

}  // namespace wellspaced
