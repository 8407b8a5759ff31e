// A coarsening sequence as a directory of files.
#pragma once

#include <string>
#include <vector>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/transfer/solver_levels.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/matrix_files.hpp"
#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

struct HierarchyFormat {
  std::string format = "triangle";                 ///< of the meshes: one that formats() can write
  Index index_base = 0;                            ///< of the meshes' files
  const SolverHierarchy* solver = nullptr;         ///< null: nothing for solvers is written
  std::vector<const MatrixFormat*> matrices = {};  ///< those to write the transfers in
};

/// Writes, for each level K, the mesh level_K (in the files of its format), level_K.origin (for
/// each node its 0-based number in the input) and level_K.spacing (its value), one a line; and
/// hierarchy.json with the parameters, whether the levels are nested by promise (`node_nested`,
/// what the auditor goes by), the special points and the sizes of the levels. No file holds a time,
/// so that the same input and options give the same bytes.
///
/// For solvers: level_K.prolongation, for each level K but the finest, the matrix from level K to
/// level K - 1 in each of the formats; and in hierarchy.json, for each level, its number counted
/// from the coarsest, what SolverLevel says, and `coarse`: those of its nodes, by their numbers in
/// the level, that the next one keeps (all others are fine).
/// Errors: kUsage for a format that does not exist or cannot be written; those of OutputSet.
[[gnu::cold]] Status write_hierarchy(OutputSet& outputs, const std::string& directory,
                                     const Hierarchy& hierarchy, const CoarseningOptions& options,
                                     const HierarchyFormat& format);

/// The names of methods, schemes and metrics on the command line and in files.
std::string_view name_of(CoarseningMethod method);
std::string_view name_of(CoarseningScheme scheme);
std::string_view name_of(SpacingMetric metric);

/// The parameters of a sequence as fields of the open JSON object: method, scheme, metric, beta,
/// factor, protect, seed.
void describe_coarsening(JsonWriter& json, const CoarseningOptions& options);

/// A level as a solver sees it, as fields of the open JSON object.
void describe_solver_level(JsonWriter& json, const SolverLevel& level);

}  // namespace wellspaced
