// The meshes of section 8.1: the original ones from files, or generated ones in their place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wellspaced/algorithms/coarsening/repeated_coarsening.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A mesh of Table 8.1, or what stands in for it. is_original: whether it is the thesis' own.
/// fixed: its special points; none: automatic ones. make: the mesh of a run.
struct SuiteMesh {
  std::string name, title;
  std::string origin = {};    ///< where it comes from, for readers
  std::string identity = {};  ///< tells meshes apart
  bool is_original = false;
  std::optional<std::vector<Index>> fixed = {};
  MeshOfSeed make = {};
};

/// The mesh of that name: "crack", "airfoil1", "airfoil3" as the thesis coarsened them, "grid1",
/// "grid10", "grid20" of 1000 * scale nodes a side; "crack_triangulated", "airfoil3_triangulated"
/// as it measured them for Table 8.1 (CHOICES 5).
/// data: the folder with the files of the original meshes; empty: generated ones stand in.
/// Errors: those of read_mesh, of a file that is not there; those of the generators.
[[gnu::cold]] Result<SuiteMesh> make_suite_mesh(const std::string& name, const std::string& data,
                                                double scale, const Progress& progress);

}  // namespace wellspaced
