#include "wellspaced/io/formats/hierarchy_files.hpp"

#include <algorithm>
#include <string_view>

#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// ".node .ele .edge" -> ".node"
std::string first_extension(const Format& format) {
  return std::string(format.extensions.substr(0, format.extensions.find(' ')));
}

Result<std::string> extension_of(const std::string& name) {
  const auto all = formats();
  const auto found = std::ranges::find_if(all, [&](const Format& f) { return f.name == name; });
  if (found != all.end() && found->write != nullptr) return first_extension(*found);
  std::string names;
  for (const Format& format : all)
    if (format.write != nullptr) names.append(" ").append(format.name);
  return Error{ErrorCode::kUsage, {"cannot write levels as '", name, "'; there are", names}};
}

template <class T>
Status write_column(OutputSet& outputs, const std::string& path, const std::vector<T>& values) {
  return outputs.add(path, [&](TextWriter& out) {
    for (const T& value : values) out << value << '\n';
  });
}

// Level K, as a solver sees it.
void describe_for_solver(JsonWriter& json, const Hierarchy& hierarchy,
                         const SolverHierarchy& solver, std::size_t k) {
  const SolverLevel& level = solver.levels[k];
  json.field("level_from_coarsest", hierarchy.levels.size() - 1 - k);
  describe_solver_level(json, level);
  json.key("coarse").begin_array();
  if (k + 1 < hierarchy.levels.size())
    for (const Index v : hierarchy.levels[k + 1].parent) json.value(v);
  json.end_array();
}

void describe_level(JsonWriter& json, const Level& level, std::size_t number) {
  json.begin_object().field("level", number).field("nodes", level.mesh.points.size());
  json.field("triangles", level.mesh.triangles.size());
  json.field("boundary_edges", level.mesh.segments.size());
  json.field("reinstated", level.reinstated).field("dropped_outside", level.dropped_outside);
}

std::string describe(const Hierarchy& hierarchy, const CoarseningOptions& options,
                     const HierarchyFormat& format) {
  JsonWriter json;
  json.begin_object();
  describe_coarsening(json, options);
  json.field("node_nested", options.scheme != CoarseningScheme::kFromFinest);
  json.field("complete", hierarchy.complete).field("format", format.format);
  json.field("index_base", format.index_base);
  json.key("fixed").begin_array();
  for (const Index v : hierarchy.levels[0].mesh.fixed) json.value(v);
  json.end_array();
  json.key("levels").begin_array();
  for (std::size_t k = 0; k < hierarchy.levels.size(); ++k) {
    describe_level(json, hierarchy.levels[k], k);
    if (format.solver != nullptr) describe_for_solver(json, hierarchy, *format.solver, k);
    json.end_object();
  }
  json.end_array();
  if (format.solver != nullptr) {
    json.field("grid_complexity", format.solver->grid_complexity);
    json.field("operator_complexity", format.solver->operator_complexity);
  }
  json.end_object();
  return json.text();
}

}  // namespace

std::string_view name_of(CoarseningMethod method) {
  switch (method) {
    case CoarseningMethod::kFunction:
      return "function";
    case CoarseningMethod::kMis:
      return "mis";
    case CoarseningMethod::kThreshold:
      return "threshold";
    case CoarseningMethod::kQuasiUniform:
      return "quasi-uniform";
    case CoarseningMethod::kQuadtree:
      return "quadtree";
    case CoarseningMethod::kRefinement:
      return "refinement";
  }
  return "";
}

std::string_view name_of(CoarseningScheme scheme) {
  switch (scheme) {
    case CoarseningScheme::kFineToCoarse:
      return "fine-to-coarse";
    case CoarseningScheme::kFromFinest:
      return "from-finest";
    case CoarseningScheme::kCoarseToFine:
      return "coarse-to-fine";
  }
  return "";
}

std::string_view name_of(SpacingMetric metric) {
  switch (metric) {
    case SpacingMetric::kGraph:
      return "graph";
    case SpacingMetric::kEuclidean:
      return "euclidean";
    case SpacingMetric::kGeodesic:
      return "geodesic";
  }
  return "";
}

void describe_coarsening(JsonWriter& json, const CoarseningOptions& options) {
  json.field("method", name_of(options.method)).field("scheme", name_of(options.scheme));
  json.field("metric", name_of(options.metric));
  json.field("beta", options.beta);
  if (options.method == CoarseningMethod::kRefinement) {
    json.key("factor").null().key("protect").null().field("angle", options.angle_deg);
  } else {
    json.field("factor", options.factor).field("protect", protection_ratio(options));
  }
  json.field("seed", options.seed);
}

void describe_solver_level(JsonWriter& json, const SolverLevel& level) {
  json.key("intersection_max");
  level.intersection_max ? json.value(*level.intersection_max) : json.null();
  json.field("area_kept", level.area_kept).field("perimeter_kept", level.perimeter_kept);
  json.field("nodes_dropped", level.nodes_dropped);
  json.field("nodes_displaced", level.nodes_displaced);
  json.field("displacement_max", level.displacement_max);
  json.key("galerkin").begin_object().field("entries", level.galerkin.entries);
  json.field("row_mean", level.galerkin.row_mean).field("row_max", level.galerkin.row_max);
  json.end_object();
}

Status write_hierarchy(OutputSet& outputs, const std::string& directory, const Hierarchy& hierarchy,
                       const CoarseningOptions& options, const HierarchyFormat& format) {
  const auto extension = extension_of(format.format);
  if (!extension) return extension.error();
  if (Status status = outputs.make_directory(directory); !status) return status;
  for (std::size_t k = 0; k < hierarchy.levels.size(); ++k) {
    const Level& level = hierarchy.levels[k];
    const std::string name = concat({directory, "/level_", k});
    if (Status status = write_geometry(outputs, concat({name, *extension}), format.format,
                                       to_geometry(level.mesh, format.index_base));
        !status)
      return status;
    if (Status status = write_column(outputs, concat({name, ".origin"}), level.origin); !status)
      return status;
    if (Status status = write_column(outputs, concat({name, ".spacing"}), level.spacing); !status)
      return status;
    for (const MatrixFormat* matrix : format.matrices) {
      if (k == 0 || format.solver == nullptr) continue;
      const std::string path = concat({name, ".prolongation", matrix->extension});
      const SparseMatrix& prolongation = format.solver->transfers[k - 1].prolongation;
      if (Status status = write_matrix(outputs, path, *matrix, prolongation); !status)
        return status;
    }
  }
  const std::string json = describe(hierarchy, options, format);
  return outputs.add(concat({directory, "/hierarchy.json"}),
                     [&](TextWriter& out) { out << json << '\n'; });
}

}  // namespace wellspaced
