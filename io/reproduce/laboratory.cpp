#include "wellspaced/io/reproduce/laboratory.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "wellspaced/io/reproduce/run_files.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr double kFullRuns = 30;

std::string parameters_of(const Experiment& experiment, const SuiteMesh& mesh, std::size_t runs,
                          const LaboratoryOptions& laboratory) {
  const CoarseningOptions& options = experiment.options;
  return concat({"wellspaced ", laboratory.version, "; ", mesh.identity, "; method ",
                 static_cast<int>(options.method), ", beta ", options.beta, ", factor ",
                 options.factor, ", R ", protection_ratio(options),
                 options.count_work ? ", work" : "", "; ", runs, " runs from seed ",
                 laboratory.seed});
}

CoarseningOptions options_of(const Experiment& experiment, const SuiteMesh& mesh,
                             std::uint64_t seed) {
  CoarseningOptions options = experiment.options;
  options.fixed = mesh.fixed;
  options.seed = seed;
  return options;
}

Status keep_runs(const std::string& path, const std::string& text, const std::string& directory,
                 OutputSet& outputs) {
  if (Status status = outputs.make_directory(concat({directory, "/runs"})); !status) return status;
  if (Status status = outputs.add(path, [&](TextWriter& out) { out << text; }); !status)
    return status;
  return outputs.commit();
}

}  // namespace

Result<const SuiteMesh*> Laboratory::mesh(const std::string& name) {
  if (const auto found = meshes_.find(name); found != meshes_.end()) return &found->second;
  auto made = make_suite_mesh(name, options_.data, options_.scale, options_.progress);
  if (!made) return made.error();
  return &meshes_.emplace(name, std::move(*made)).first->second;
}

std::size_t Laboratory::run_count(const Experiment& experiment) const {
  const double part = static_cast<double>(experiment.thesis_runs) / kFullRuns;
  return static_cast<std::size_t>(std::ceil(part * static_cast<double>(options_.runs)));
}

std::string Laboratory::runs_text(const Experiment& experiment) const {
  const std::size_t runs = run_count(experiment);
  const std::string first = std::to_string(options_.seed);
  if (runs == 1) return concat({"1 run, seed ", first});
  return concat({runs, " runs, seeds ", first, " to ", options_.seed + runs - 1});
}

Result<std::vector<RunStatistics>> Laboratory::make_runs(const Experiment& experiment,
                                                         const SuiteMesh& mesh) {
  RepeatOptions repeat{.runs = run_count(experiment), .threads = options_.threads};
  repeat.progress = [&](std::string_view, std::uint64_t done, std::uint64_t total) {
    return report(options_.progress, experiment.name, done, total);
  };
  return repeat_coarsening(mesh.make, options_of(experiment, mesh, options_.seed), repeat);
}

Result<std::span<const RunStatistics>> Laboratory::runs(const Experiment& experiment) {
  if (const auto found = runs_.find(experiment.name); found != runs_.end())
    return std::span<const RunStatistics>(found->second);
  const auto mesh = this->mesh(experiment.mesh);
  if (!mesh) return mesh.error();
  const std::string parameters = parameters_of(experiment, **mesh, run_count(experiment), options_);
  const std::string path = concat({options_.directory, "/runs/", experiment.name, ".json"});
  std::optional<std::vector<RunStatistics>> kept;
  if (!options_.directory.empty()) kept = read_runs(path, parameters);
  if (!kept) {
    auto made = make_runs(experiment, **mesh);
    if (!made) return made.error();
    kept = std::move(*made);
    if (!options_.directory.empty())
      if (Status status =
              keep_runs(path, runs_json(parameters, *kept), options_.directory, *options_.outputs);
          !status)
        return status.error();
  }
  return std::span<const RunStatistics>(
      runs_.emplace(experiment.name, std::move(*kept)).first->second);
}

Result<Hierarchy> Laboratory::first_hierarchy(const Experiment& experiment) {
  const auto mesh = this->mesh(experiment.mesh);
  if (!mesh) return mesh.error();
  auto made = (*mesh)->make(options_.seed);
  if (!made) return made.error();
  return coarsen(std::move(*made), options_of(experiment, **mesh, options_.seed));
}

}  // namespace wellspaced
