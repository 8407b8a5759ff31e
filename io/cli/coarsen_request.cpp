#include "wellspaced/io/cli/coarsen_request.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/hierarchy_files.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

enum class Profile { kThesis, kMultigrid, kQuality };

constexpr std::array kMethods = {CoarseningMethod::kFunction,  CoarseningMethod::kMis,
                                 CoarseningMethod::kThreshold, CoarseningMethod::kQuasiUniform,
                                 CoarseningMethod::kQuadtree,  CoarseningMethod::kRefinement};

// One method, or several separated by commas.
std::vector<CoarseningMethod> read_methods(Arguments& arguments, const std::string& otherwise) {
  const std::string text = arguments.text("--method", otherwise);
  std::vector<CoarseningMethod> methods;
  for (const std::string& name : words_of(text)) {
    const auto found = std::ranges::find(kMethods, name, [](auto m) { return name_of(m); });
    if (found != kMethods.end() && std::ranges::count(methods, *found) == 0) {
      methods.push_back(*found);
      continue;
    }
    arguments.refuse(
        "--method",
        concat({in_quotes(text), " should be function, mis, threshold, quasi-uniform, quadtree or ",
                "refinement, or several of them, each once, separated by commas"}));
    break;
  }
  return methods;
}

// The profile where none is named: that of solvers, unless a choice of the thesis' is made.
Profile read_profile(Arguments& arguments) {
  const bool chooses = std::ranges::any_of(
      std::array{"--method", "--scheme", "--metric", "--beta", "--factor", "--protect"},
      [&](const char* name) { return arguments.has(name); });
  const bool sizes =
      arguments.has("--targets") || arguments.has("--ratio") || arguments.has("--angle");
  const Profile otherwise = chooses ? Profile::kThesis
                            : sizes ? Profile::kQuality
                                    : Profile::kMultigrid;
  return static_cast<Profile>(arguments.choice("--profile", static_cast<int>(otherwise),
                                               {"thesis", "multigrid", "quality"}));
}

// Numbers of nodes separated by commas; none where none are given.
std::vector<std::size_t> read_targets(Arguments& arguments) {
  std::vector<std::size_t> targets;
  if (!arguments.has("--targets")) return targets;
  const std::string list = arguments.text("--targets", "");
  for (const std::string& word : words_of(list)) {
    const char* const end = word.data() + word.size();
    std::uint64_t nodes = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, nodes);
    if (error != std::errc() || stop != end) {
      arguments.refuse("--targets",
                       concat({in_quotes(list), " should be numbers separated by commas"}));
      return {};
    }
    targets.push_back(nodes);
  }
  return targets;
}

std::vector<const MatrixFormat*> read_matrix_formats(Arguments& arguments,
                                                     const std::string& otherwise) {
  std::vector<const MatrixFormat*> formats;
  const std::string list = arguments.text("--transfers", otherwise);
  if (list == "none") return formats;
  for (const std::string& name : words_of(list)) {
    const MatrixFormat* format = find_matrix_format(name);
    if (format == nullptr) {
      arguments.refuse("--transfers",
                       concat({in_quotes(name), " should be mtx, petsc, npz or none"}));
      return {};
    }
    if (std::ranges::find(formats, format) == formats.end()) formats.push_back(format);
  }
  return formats;
}

// No option may be given that says nothing to any of the methods.
void refuse_idle_options(Arguments& arguments, std::span<const CoarseningMethod> methods) {
  const auto refinements = std::ranges::count(methods, CoarseningMethod::kRefinement);
  if (refinements == std::ssize(methods))
    for (const char* name : {"--factor", "--protect", "--order"})
      if (arguments.has(name)) arguments.refuse(name, "is not for levels of --profile quality");
  if (refinements == 0)
    for (const char* name : {"--targets", "--ratio", "--angle"})
      if (arguments.has(name)) arguments.refuse(name, "is for levels of --profile quality alone");
}

}  // namespace

CoarsenRequest read_coarsen_request(Arguments& arguments, std::uint64_t seed) {
  CoarsenRequest request;
  const Profile profile = read_profile(arguments);
  request.multigrid = profile == Profile::kMultigrid;
  if (request.multigrid) request.options = multigrid_profile();
  request.matrices = read_matrix_formats(arguments, request.multigrid ? "npz" : "none");
  request.for_solver = request.multigrid || !request.matrices.empty();
  CoarseningOptions& options = request.options;
  if (arguments.has("--scheme"))
    request.scheme = static_cast<CoarseningScheme>(
        arguments.choice("--scheme", 0, {"fine-to-coarse", "from-finest", "coarse-to-fine"}));
  if (arguments.has("--metric"))
    request.metric = static_cast<SpacingMetric>(
        arguments.choice("--metric", 0, {"graph", "euclidean", "geodesic"}));
  options.order = static_cast<SelectionOrder>(
      arguments.choice("--order", request.multigrid ? 1 : 0, {"random", "priority"}));
  options.limit_by_boundary = arguments.has("--boundary-lfs");
  options.limit_by_special_points = arguments.has("--special-lfs");
  request.methods =
      read_methods(arguments, profile == Profile::kQuality ? "refinement" : "function");
  refuse_idle_options(arguments, request.methods);
  options.targets = read_targets(arguments);
  options.ratio = arguments.number("--ratio", options.ratio, more_than(1));
  options.angle_deg = arguments.number("--angle", options.angle_deg, between(0, 30));
  request.statistics =
      static_cast<StatisticsDetail>(arguments.choice("--stats", 1, {"none", "basic", "full"}));
  options.count_work = request.statistics == StatisticsDetail::kFull;
  if (arguments.has("--beta")) request.beta = arguments.number("--beta", 0, more_than(1));
  if (arguments.has("--factor")) request.factor = arguments.number("--factor", 0, more_than(1));
  if (arguments.has("--protect")) options.protect = arguments.number("--protect", 0, at_least(0));
  options.max_levels = static_cast<std::size_t>(
      arguments.integer("--levels", std::int64_t{1} << 40, between(0, 0x1p40)));
  options.until_nodes = static_cast<std::size_t>(arguments.integer(
      "--until", static_cast<std::int64_t>(options.until_nodes), between(0, 0x1p40)));
  if (arguments.has("--keep-boundary"))
    options.keep_boundary = arguments.number("--keep-boundary", 0, at_least(0));
  options.seed = seed;
  return request;
}

CoarseningOptions options_of(const CoarsenRequest& request, CoarseningMethod method) {
  const bool of_profile = request.multigrid && method == CoarseningMethod::kFunction;
  const CoarseningOptions usual = of_profile ? multigrid_profile() : theorem_options(method);
  CoarseningOptions options = request.options;
  options.method = method;
  options.beta = request.beta.value_or(usual.beta);
  options.factor = request.factor.value_or(usual.factor);
  options.scheme = request.scheme.value_or(usual.scheme);
  options.metric = request.metric.value_or(usual.metric);
  if (method != CoarseningMethod::kRefinement) options.targets.clear();
  return options;
}

Result<std::vector<Index>> read_fixed_points(const std::string& path, std::size_t nodes) {
  const auto text = read_input(path);
  if (!text) return text.error();
  Scanner scanner(*text, display_name(path));
  std::vector<Index> fixed;
  while (scanner.next_line()) {
    while (scanner.ok() && scanner.more()) {
      const std::int64_t node = scanner.integer("fixed point");
      if (node < 0 || static_cast<std::uint64_t>(node) >= nodes)
        scanner.fail(ErrorCode::kInvalidGeometry,
                     {"fixed point ", node, " is out of range: the mesh has ", nodes,
                      " nodes, numbered from 0"});
      fixed.push_back(static_cast<Index>(node));
    }
  }
  if (!scanner.ok()) return scanner.error();
  return fixed;
}

Result<std::vector<double>> read_spacing(const std::string& path, std::size_t nodes) {
  const auto text = read_input(path);
  if (!text) return text.error();
  Scanner scanner(*text, display_name(path));
  std::vector<double> values;
  while (scanner.next_line() && values.size() < nodes)
    values.push_back(scanner.number("a spacing"));
  if (!scanner.ok()) return scanner.error();
  return values;
}

}  // namespace wellspaced::cli
