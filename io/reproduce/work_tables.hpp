// Section 8.4: how deep and how wide the searches of a coarsening are.
#pragma once

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Sections 8.4.1 to 8.4.3 as tables of `exhibit`: C = 4 and 8 on the graded meshes.
/// Errors: those of Laboratory::runs.
[[gnu::cold]] Result<Exhibit> work_exhibit(Laboratory& laboratory, Exhibit exhibit);

}  // namespace wellspaced
