// The point sets of chapter 1 and the steps of Figure 5.4, drawn.
#pragma once

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

// Each adds to an exhibit that has its name and title. Errors: those of the generators.

/// Figure 1.1: well-spaced points beside uniformly distributed ones.
[[gnu::cold]] Result<Exhibit> contrast_exhibit(Laboratory& laboratory, Exhibit exhibit);
/// Figure 1.2: two maximal sets with their balls.
[[gnu::cold]] Result<Exhibit> maximal_exhibit(Laboratory& laboratory, Exhibit exhibit);
/// Figure 1.3: well-spaced points that converge at the centre.
[[gnu::cold]] Result<Exhibit> graded_exhibit(Laboratory& laboratory, Exhibit exhibit);
/// Figures 1.4 and 1.5.
[[gnu::cold]] Result<Exhibit> hammersley_exhibit(Laboratory& laboratory, Exhibit exhibit);
[[gnu::cold]] Result<Exhibit> halton_exhibit(Laboratory& laboratory, Exhibit exhibit);
/// Figure 5.4: mesh, spacing function, coarsening function, nodes selected by it, their mesh.
[[gnu::cold]] Result<Exhibit> function_exhibit(Laboratory& laboratory, Exhibit exhibit);

}  // namespace wellspaced
