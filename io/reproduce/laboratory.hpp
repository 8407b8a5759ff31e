// The meshes and runs behind the tables of chapter 8: made once, kept, and found again.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "wellspaced/algorithms/coarsening/repeated_coarsening.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/reproduce/suite_mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// runs: how many are made where the thesis made 30; where it made fewer, as many fewer.
/// scale: of the grids, > 0: they have 1000 * scale nodes a side.
/// data: the folder of the original meshes; empty: stand-ins are generated.
/// directory: where runs are kept and looked for, in runs/; empty: nowhere.
/// outputs: what writes there; needed with a directory, and empty whenever an experiment begins.
/// version: of the program; what another version has kept is made anew.
struct LaboratoryOptions {
  std::size_t runs = 30;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double scale = 1;
  std::string data = {}, directory = {}, version = {};
  Progress progress = {};
  OutputSet* outputs = nullptr;
};

/// One line of the program of experiments. mesh: as published_sequence names them, and "grid20".
/// thesis_runs: how many the thesis made.
struct Experiment {
  std::string name = {};  ///< of its file
  std::string mesh = {};
  CoarseningOptions options = {};
  std::size_t thesis_runs = 30;
};

class Laboratory {
 public:
  explicit Laboratory(LaboratoryOptions options) : options_(std::move(options)) {}

  const LaboratoryOptions& options() const { return options_; }
  /// A mesh by its name, made once. Errors: those of make_suite_mesh.
  Result<const SuiteMesh*> mesh(const std::string& name);
  /// How many runs are made of an experiment.
  std::size_t run_count(const Experiment& experiment) const;
  /// "30 runs, seeds 1 to 30".
  std::string runs_text(const Experiment& experiment) const;
  /// The runs of an experiment: those kept in the folder, if their parameters are the same and
  /// their file is whole, else new ones, which are kept.
  /// Errors: those of repeat_coarsening; kUsage and kLimit if they cannot be kept.
  Result<std::span<const RunStatistics>> runs(const Experiment& experiment);
  /// The hierarchy of the first seed, for pictures.
  Result<Hierarchy> first_hierarchy(const Experiment& experiment);

 private:
  Result<std::vector<RunStatistics>> make_runs(const Experiment& experiment, const SuiteMesh& mesh);

  LaboratoryOptions options_;
  std::map<std::string, SuiteMesh> meshes_;
  std::map<std::string, std::vector<RunStatistics>> runs_;
};

}  // namespace wellspaced
