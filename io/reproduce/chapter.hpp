// The tables and figures of the thesis that can be made again.
#pragma once

#include <span>
#include <string_view>

#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/io/reproduce/laboratory.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// make: runs the experiments that are not kept, and assembles the exhibit.
struct ExhibitKind {
  std::string_view name;   ///< as on the command line
  std::string_view title;  ///< as in the thesis
  Result<Exhibit> (*make)(const ExhibitKind& kind, Laboratory& laboratory);
};

/// All of them, in the order of the thesis.
std::span<const ExhibitKind> exhibit_kinds();

}  // namespace wellspaced
