// Table 8.1 and the table of section 6.1: what the meshes are like.
#pragma once

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Table 8.1: sizes, gradation and angles of the test suite. Errors: those of Laboratory::mesh.
[[gnu::cold]] Result<Exhibit> suite_exhibit(Laboratory& laboratory, Exhibit exhibit);

/// Section 6.1: the angles of the pattern of Figure 6.1, coarsened level by level as far as a mesh
/// of 1.7 million nodes reaches (of fewer nodes, by the laboratory's scale squared).
/// Errors: those of coarsen.
[[gnu::cold]] Result<Exhibit> degradation_exhibit(Laboratory& laboratory, Exhibit exhibit);

}  // namespace wellspaced
