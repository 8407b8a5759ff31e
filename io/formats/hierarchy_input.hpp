// Reading a directory of levels, as `coarsen -o` or another program has written it.
#pragma once

#include <string>
#include <vector>

#include "wellspaced/algorithms/audit/hierarchy_audit.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// levels: from level 0 on. notes: what a user should know: one line each.
/// beta, factor, method, scheme, metric, fixed: from hierarchy.json; 0 and empty where it does not
/// tell. node_nested: false where it says that this is not promised.
struct HierarchyInput {
  std::vector<audit::HierarchyLevel> levels;
  std::vector<std::string> notes;
  double beta = 0, factor = 0;
  std::string method, scheme, metric;
  std::vector<Index> fixed;
  bool node_nested = true;
};

/// Reads level_0, level_1, ... as far as they exist, or as many as hierarchy.json lists where it
/// has an array "levels" (files beyond are of an earlier run), each in any format that holds
/// triangle meshes, with level_K.origin and level_K.spacing, and hierarchy.json, where they exist.
/// Errors: as read_geometry() and parse_json(); kUnreadable where there is no level_0 or none of
/// those listed, a level holds no triangles, or a column of numbers does not fit its mesh.
[[gnu::cold]] Result<HierarchyInput> read_hierarchy(const std::string& directory,
                                                    const Progress& progress = {});

}  // namespace wellspaced
