// The tables and figures of the thesis that can be made again.
#pragma once

#include <span>
#include <string_view>

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// fill: runs the experiments that are not kept, and adds to an exhibit that has its name and
/// title.
struct ExhibitKind {
  std::string_view name;   ///< as on the command line
  std::string_view title;  ///< as in the thesis
  Result<Exhibit> (*fill)(Laboratory& laboratory, Exhibit exhibit);
};

/// All of them, in the order of the thesis.
std::span<const ExhibitKind> exhibit_kinds();

/// One of them. Errors: those of Laboratory::runs and of the generators; kCancelled.
[[gnu::cold]] Result<Exhibit> make_exhibit(const ExhibitKind& kind, Laboratory& laboratory);

}  // namespace wellspaced
