#include "wellspaced/algorithms/audit/hierarchy_audit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "wellspaced/algorithms/audit/boundary_distance.hpp"
#include "wellspaced/algorithms/audit/domain.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/intersection.hpp"
#include "wellspaced/algorithms/audit/level_spacing.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/spacing_tree.hpp"
#include "wellspaced/algorithms/audit/theorems.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// ---- How the nodes of the levels hang together

// For each node of `coarse` a node of `finest` at the same place, kNoIndex if there is none. Where
// several lie there, as across a slit, each is taken once, in order.
std::vector<Index> match_by_place(const TriangleMesh& coarse, const TriangleMesh& finest) {
  const auto sorted = [](const TriangleMesh& mesh) {
    std::vector<Index> nodes(mesh.points.size());
    std::iota(nodes.begin(), nodes.end(), Index{0});
    sort(nodes, [&](Index v, Index w) { return before(mesh.points[v], mesh.points[w]); });
    return nodes;
  };
  std::vector<Index> match(coarse.points.size(), kNoIndex);
  const std::vector<Index> candidates = sorted(finest);
  std::size_t next = 0;
  for (const Index v : sorted(coarse)) {
    const Point2 p = coarse.points[v];
    while (next < candidates.size() && before(finest.points[candidates[next]], p)) ++next;
    if (next < candidates.size() && finest.points[candidates[next]] == p)
      match[v] = candidates[next++];
  }
  return match;
}

// The nodes of a level, as nodes of the finest mesh: as given or by place. Where that makes no
// sense, kNoIndex.
std::vector<Index> origins_of(const HierarchyLevel& level, const TriangleMesh& finest) {
  if (level.origin.empty()) return match_by_place(level.mesh, finest);
  std::vector<Index> origins(level.mesh.points.size(), kNoIndex);
  for (std::size_t v = 0; v < std::min(origins.size(), level.origin.size()); ++v) {
    const Index origin = level.origin[v];
    if (origin < finest.points.size() && finest.points[origin] == level.mesh.points[v])
      origins[v] = origin;
  }
  return origins;
}

// ---- One level against the one before

struct Judged {
  const HierarchyLevel& level;
  Report report;
  std::vector<Index> origins;  // of the level's nodes, in the finest mesh
  std::vector<Index> numbers;  // for each node of the finest mesh its number in this level
  std::vector<Index> parents;  // of the level's nodes, in the level before

  const TriangleMesh& mesh() const { return level.mesh; }
  double measured(std::string_view name) const {
    const Measure* measure = report.measure(name);
    return measure == nullptr ? 0 : measure->value;
  }
  bool passes(std::string_view name) const {
    const Check* check = report.check(name);
    return check != nullptr && check->pass();
  }
  bool is_convex() const {
    const auto nodes = static_cast<Index>(mesh().points.size());
    return has_convex_boundary(mesh(), pair_half_edges(mesh().triangles, {}, nodes));
  }
  bool is_embedded() const {
    return passes("no_inverted") && passes("no_flat") && passes("no_overlap");
  }
};

std::vector<Index> inverse(const std::vector<Index>& origins, std::size_t finest_nodes) {
  std::vector<Index> numbers(finest_nodes, kNoIndex);
  for (Index v = 0; v < origins.size(); ++v)
    if (origins[v] != kNoIndex) numbers[origins[v]] = v;
  return numbers;
}

std::vector<Index> parents_of(const std::vector<Index>& origins, const Judged& finer) {
  std::vector<Index> parents;
  for (const Index origin : origins)
    parents.push_back(origin == kNoIndex ? kNoIndex : finer.numbers[origin]);
  return parents;
}

void mark_not_promised(Check& check) { check.required = check.promised = false; }

// holders: for each node of the level the one that it is in another mesh, kNoIndex if in none.
void audit_nodes_within(Judged& coarse, const std::vector<Index>& holders, std::string_view name) {
  Check& check = coarse.report.add_required_check(name, Item::kNode);
  for (Index v = 0; v < holders.size(); ++v) {
    const bool unique = coarse.origins[v] == kNoIndex || coarse.numbers[coarse.origins[v]] == v;
    if (holders[v] == kNoIndex || !unique) check.violate({v});
  }
}

void audit_nesting(Judged& coarse, Nesting nesting) {
  audit_nodes_within(coarse, coarse.parents, "node_nested");
  if (nesting == Nesting::kPromised) return;
  mark_not_promised(coarse.report.checks.back());
  audit_nodes_within(coarse, coarse.origins, "nodes_of_finest");
}

void audit_size(Judged& coarse, const Judged& finer) {
  const auto nodes = static_cast<double>(coarse.mesh().points.size());
  const auto finer_nodes = static_cast<double>(finer.mesh().points.size());
  Check& check = coarse.report.add_check("fewer_nodes", Item::kNone);
  if (nodes >= finer_nodes) check.violate({});
  coarse.report.add_measure("size_ratio", nodes > 0 ? finer_nodes / nodes : 0);
}

std::vector<std::uint8_t> boundary_flags(const TriangleMesh& mesh) {
  const auto nodes = static_cast<Index>(mesh.points.size());
  const HalfEdges half_edges = pair_half_edges(mesh.triangles, mesh.segments, nodes);
  std::vector<std::uint8_t> flags(nodes, 0);
  for (Index h = 0; h < half_edges.twin.size(); ++h)
    if (half_edges.twin[h] == kNoIndex || half_edges.constrained[h] != 0)
      flags[origin(mesh.triangles, h)] = flags[target(mesh.triangles, h)] = 1;
  for (const Segment& s : mesh.segments) flags[s.a] = flags[s.b] = 1;
  return flags;
}

std::vector<int> markers_of(const TriangleMesh& mesh) {
  std::vector<int> markers;
  for (const Segment& s : mesh.segments) markers.push_back(s.marker);
  sort_unique(markers);
  return markers;
}

void audit_boundary(Judged& coarse, const Judged& finer, const Judged& finest) {
  Report& report = coarse.report;
  Check& nested = report.add_check("boundary_nested", Item::kNode);
  const auto flags = boundary_flags(coarse.mesh()), finer_flags = boundary_flags(finer.mesh());
  for (Index v = 0; v < flags.size(); ++v) {
    const Index parent = coarse.parents[v];
    if (flags[v] != 0 && parent != kNoIndex && finer_flags[parent] == 0) nested.violate({v});
  }
  Check& holes = report.add_check("holes_kept", Item::kNone);
  for (const char* name : {"boundary_loops", "components"})
    holes.violations +=
        static_cast<std::uint64_t>(std::fabs(coarse.measured(name) - finer.measured(name)));
  Check& markers = report.add_check("markers_kept", Item::kNone);
  const auto alive = markers_of(coarse.mesh());
  for (const int marker : markers_of(finer.mesh())) markers.violations += !is_among(marker, alive);
  const auto lines = boundary_lines(coarse.mesh());
  report.add_measure("area_kept", coarse.measured("area") / finest.measured("area"));
  report.add_measure("perimeter_kept", coarse.measured("perimeter") / finest.measured("perimeter"));
  report.add_measure("hausdorff", hausdorff_distance(lines, boundary_lines(finer.mesh())));
  report.add_measure("hausdorff_to_finest",
                     hausdorff_distance(lines, boundary_lines(finest.mesh())));
}

void audit_fixed(Judged& coarse, std::span<const Index> fixed) {
  if (fixed.empty()) return;
  Check& check = coarse.report.add_check("fixed_nodes_kept", Item::kNode);
  for (const Index v : fixed)
    if (v >= coarse.numbers.size() || coarse.numbers[v] == kNoIndex) check.violate({v});
}

// If the triangles of two meshes are C-similar where they meet and have no angle below theta, those
// that meet one of longest edge E have longest edges of E / C or more, so areas of
// (E / C)^2 tan(theta) / 4 or more, and lie in a disc of radius E / sqrt 3 + C E.
void compare_with_lemma_5_1_7(Report& report, Index most, double min_angle) {
  const Point2 on_circle = circle_point(min_angle / 360);
  const double c = report.measure("similarity")->value, radius = c + std::sqrt(1.0 / 3);
  Theorem theorem;
  theorem.name = "5.1.7";
  theorem.statement = "intersections <= 4 pi C^2 (C + 1 / sqrt 3)^2 / tan(theta)";
  if (on_circle.y <= 0) theorem.missing_hypothesis = "no angle is 0";
  theorem.left = most;
  theorem.right = 4 * kPi * c * c * radius * radius * ratio(on_circle.x, on_circle.y);
  theorem.holds = theorem.left <= theorem.right;
  report.theorems.push_back(std::move(theorem));
}

void audit_intersections(Judged& coarse, const Judged& finer, ProgressParts& parts) {
  if (!coarse.is_embedded() || !finer.is_embedded()) return;
  const Intersections found =
      count_intersections(finer.mesh(), coarse.mesh(), coarse.parents, parts.part(1));
  if (parts.stopped()) return;
  coarse.report.add_measure("intersection_mean", found.mean_per_coarse());
  coarse.report.add_measure("intersection_max", found.max_per_coarse());
  coarse.report.add_measure("intersection_max_finer", found.max_per_fine());
  coarse.report.add_measure("similarity", found.similarity);
  compare_with_lemma_5_1_7(coarse.report, std::max(found.max_per_coarse(), found.max_per_fine()),
                           std::min(coarse.measured("min_angle"), finer.measured("min_angle")));
}

// The two checks list pairs of nodes of the level.
void add_pairs(Check& check, const std::vector<std::array<Index, 2>>& pairs,
               std::span<const Index> nodes) {
  for (const auto& [i, j] : pairs) check.violate({nodes[i], nodes[j]});
}

bool has_spacing(const Judged& coarse, const HierarchyAuditOptions& options) {
  const auto& spacing = coarse.level.spacing;
  return options.beta > 0 && spacing.size() == coarse.mesh().points.size() &&
         all_of(spacing, [](double f) { return f > 0 && std::isfinite(f); });
}

// In the metric of the graph that the nodes were selected from, along all of its paths.
void audit_graph_lipschitz(Report& report, const TriangleMesh& mesh, const SelectedNodes& selected,
                           std::span<const Index> level_nodes, ProgressParts& parts) {
  constexpr double kSlack = 1 + 0x1p-40;
  std::vector<double> values(mesh.points.size(), kInfinity);
  for (std::size_t i = 0; i < selected.nodes.size(); ++i)
    values[selected.nodes[i]] = selected.spacing[i];
  const std::vector<double> least = coarsened_in_graph(mesh, values, 1, parts.part(3));
  if (parts.stopped()) return;
  Check& check = report.add_check("graph_lipschitz", Item::kNode);
  for (std::size_t i = 0; i < selected.nodes.size(); ++i)
    if (least[selected.nodes[i]] * kSlack < selected.spacing[i]) check.violate({level_nodes[i]});
}

void audit_level_spacing(Judged& coarse, const Judged& selected_from,
                         const HierarchyAuditOptions& options, ProgressParts& parts) {
  if (!has_spacing(coarse, options)) return;
  std::vector<Index> fixed(options.fixed.begin(), options.fixed.end());
  sort(fixed);
  std::vector<Index> nodes, level_nodes;
  std::vector<double> spacing;
  std::vector<std::uint8_t> exempt;
  for (Index v = 0; v < coarse.origins.size(); ++v) {
    if (coarse.origins[v] == kNoIndex) continue;
    const Index node = selected_from.numbers[coarse.origins[v]];
    if (node == kNoIndex) continue;
    nodes.push_back(node);
    level_nodes.push_back(v);
    spacing.push_back(coarse.level.spacing[v]);
    exempt.push_back(std::binary_search(fixed.begin(), fixed.end(), coarse.origins[v]));
  }
  const SelectedNodes selected{nodes, spacing, options.beta, exempt};
  Check& graph = coarse.report.add_check("graph_spacing", Item::kEdge);
  graph.value = options.beta;
  add_pairs(graph, graph_spacing_violations(selected_from.mesh(), selected, parts.part(2)),
            level_nodes);
  if (parts.stopped()) return;
  audit_graph_lipschitz(coarse.report, selected_from.mesh(), selected, level_nodes, parts);
  Check& euclidean = coarse.report.add_check("euclidean_spacing", Item::kEdge);
  euclidean.value = options.beta;
  for (const auto& [v, w] :
       euclidean_spacing_violations(coarse.mesh(), coarse.level.spacing, options.beta))
    euclidean.violate({v, w});
}

// f_E <= f_M <= mu f_E for the values of a level, coarsened by C in the metric of its graph and in
// the Euclidean one. The dilation mu of a Delaunay triangulation is at most 2 pi / (3 cos(pi / 6)),
// if no boundary is in the way. Compared at some 4096 nodes at most, for where very many cones are
// nearly as low as the lowest f_E takes long.
void compare_with_lemma_7_1_4(const Judged& finer, double factor, ProgressParts& parts,
                              Report& report) {
  constexpr std::size_t kMostNodes = 4096;
  constexpr double kDilation = 2.4183991523122903, kSlack = 1 + 1e-9;
  std::vector<Vec<2>> places;
  std::vector<double> values;
  for (Index v = 0; v < finer.mesh().points.size(); ++v) {
    places.push_back(coordinates_of(finer.mesh().points[v]));
    values.push_back(factor * finer.level.spacing[v]);
  }
  const SpacingTree<2> euclidean(places, values);
  const std::vector<double> by_graph = coarsened_in_graph(finer.mesh(), values, 1, parts.part(6));
  double least = kInfinity, largest = 0;
  const std::size_t step = 1 + places.size() / kMostNodes;
  const Progress part = parts.part(7);
  ProgressMeter meter(part, "audit", kMostNodes, 16);  // a query may take very long
  for (std::size_t v = 0; v < places.size(); v += step) {
    if (parts.stopped() || !meter.step()) return;
    const double quotient = by_graph[v] / euclidean.at(places[v]).value;
    least = std::min(least, quotient), largest = std::max(largest, quotient);
  }
  Theorem lower;
  lower.name = "7.1.4";
  lower.statement = "f_E / f_M <= 1";
  lower.left = 1 / least, lower.right = 1;
  lower.holds = lower.left <= kSlack;
  Theorem upper = lower;
  upper.statement = "f_M / f_E <= mu <= 2.418";
  upper.left = largest, upper.right = kDilation;
  upper.holds = largest <= kDilation * kSlack;
  if (!finer.is_convex()) upper.missing_hypothesis = "the level before fills a convex polygon";
  if (!finer.passes("delaunay")) upper.missing_hypothesis = "the level before is Delaunay";
  report.theorems.push_back(std::move(lower));
  report.theorems.push_back(std::move(upper));
}

// By how much the values of a level differ from those of the level before, coarsened.
void measure_coarsening(Judged& coarse, const Judged& finer, double factor, ProgressParts& parts) {
  const auto coarsened =
      coarsened_in_graph(finer.mesh(), finer.level.spacing, factor, parts.part(5));
  if (parts.stopped()) return;
  double least = kInfinity, largest = 0;
  for (Index v = 0; v < coarse.parents.size(); ++v) {
    if (coarse.parents[v] == kNoIndex) continue;
    const double quotient = coarse.level.spacing[v] / coarsened[coarse.parents[v]];
    least = std::min(least, quotient), largest = std::max(largest, quotient);
  }
  coarse.report.add_measure("spacing_to_coarsened_min", least);
  coarse.report.add_measure("spacing_to_coarsened_max", largest);
  compare_with_lemma_7_1_4(finer, factor, parts, coarse.report);
}

// ---- The whole

// Whether the syntax was right, so that all else was judged.
bool is_readable(const Report& report) { return report.check("no_overlap") != nullptr; }

Judged judge_alone(const HierarchyLevel& level, const Pslg* domain, const Progress& progress) {
  MeshAuditOptions options;
  options.domain = domain;
  options.progress = progress;
  return {level, audit_mesh(level.mesh, options), {}, {}, {}};
}

void find_origins(Judged& level, const Judged& finest) {
  level.origins.assign(level.mesh().points.size(), kNoIndex);
  if (is_readable(level.report) && is_readable(finest.report))
    level.origins = origins_of(level.level, finest.mesh());
  level.numbers = inverse(level.origins, finest.mesh().points.size());
}

void require(Report& report, std::string_view name) {
  for (Check& check : report.checks)
    if (check.name == name) check.required = true;
}

void judge_against(Judged& coarse, const Judged& finer, const Judged& finest,
                   const HierarchyAuditOptions& options, const Progress& progress) {
  ProgressParts parts(progress, "audit", 8);
  coarse.parents = parents_of(coarse.origins, finer);
  require(coarse.report, "constrained_delaunay");
  if (finest.passes("boundary_has_segments")) require(coarse.report, "boundary_has_segments");
  audit_nesting(coarse, options.nesting);
  audit_size(coarse, finer);
  audit_fixed(coarse, options.fixed);
  if (!is_readable(coarse.report) || !is_readable(finer.report)) return;
  audit_boundary(coarse, finer, finest);
  audit_intersections(coarse, finer, parts);
  const bool from_finest = options.selected_from == SelectedFrom::kFinest;
  if (parts.go_on(2)) audit_level_spacing(coarse, from_finest ? finest : finer, options, parts);
  if (!parts.go_on(4)) return;
  if (options.well_spacing == WellSpacing::kMeasured && has_spacing(coarse, options)) {
    SpacingAuditOptions spacing{coarse.level.spacing, options.beta};
    spacing.progress = parts.part(4);
    audit_spacing(coarse.mesh(), spacing, coarse.report);
    if (parts.stopped()) return;
    compare_with_theorems(coarse.mesh(), SpacingKind::kGiven, coarse.report);
  }
  // From the values of level 0 the first level takes the factor C beta.
  const double factor = options.factor * (&finer == &finest ? options.beta : 1);
  if (factor > 0 && !from_finest && has_spacing(coarse, options) && has_spacing(finer, options))
    measure_coarsening(coarse, finer, factor, parts);
}

// A check without a level that counts the levels' violations of one name, level 0 apart, or of all
// required ones.
void sum_up(Report& report, std::string_view name, std::span<const Judged> levels,
            std::string_view of) {
  Check& check = report.add_required_check(name, Item::kNone);
  for (std::size_t k = of.empty() ? 0 : 1; k < levels.size(); ++k)
    for (const Check& part : levels[k].report.checks)
      if (of.empty() ? part.required : part.name == of) check.violations += part.violations;
}

void measure_worst(Report& report, std::string_view name, std::span<const Judged> levels) {
  double worst = -1;
  for (const Judged& level : levels)
    if (const Measure* measure = level.report.measure(name))
      worst = std::max(worst, measure->value);
  if (worst >= 0) report.add_measure(name, worst);
}

// Moves the findings on a level to the end of the report.
void append_level(Report& report, Report&& level, Index number) {
  for (Check& check : level.checks) {
    check.level = number;
    report.checks.push_back(std::move(check));
  }
  for (Measure& measure : level.measures) {
    measure.level = number;
    report.measures.push_back(std::move(measure));
  }
  for (Theorem& theorem : level.theorems) {
    theorem.level = number;
    report.theorems.push_back(std::move(theorem));
  }
  for (Witness& witness : level.witnesses) {
    witness.level = number;
    report.witnesses.push_back(std::move(witness));
  }
}

}  // namespace

Report audit_hierarchy(std::span<const HierarchyLevel> levels,
                       const HierarchyAuditOptions& options) {
  Report report;
  std::vector<Judged> judged;
  ProgressParts parts(options.progress, "audit", 2 * levels.size());
  for (const HierarchyLevel& level : levels) {
    judged.push_back(
        judge_alone(level, judged.empty() ? options.domain : nullptr, parts.part(judged.size())));
    report.complete = judged.back().report.complete;
    if (!report.complete) return report;
  }
  for (Judged& level : judged) find_origins(level, judged[0]);
  for (std::size_t k = 1; k < judged.size(); ++k) {
    report.complete = parts.go_on(levels.size() + k);
    if (report.complete)
      judge_against(judged[k], judged[k - 1], judged[0], options, parts.part(levels.size() + k));
    report.complete = !parts.stopped();
    if (!report.complete) return report;
  }
  sum_up(report, "levels_valid", judged, "");
  sum_up(report, "levels_constrained_delaunay", judged, "constrained_delaunay");
  sum_up(report, "node_nested", judged, "node_nested");
  if (options.nesting == Nesting::kNotPromised) mark_not_promised(report.checks.back());
  report.add_measure("levels", static_cast<double>(levels.size()));
  measure_worst(report, "similarity", judged);
  measure_worst(report, "intersection_max", judged);
  for (Index k = 0; k < judged.size(); ++k) append_level(report, std::move(judged[k].report), k);
  return report;
}

}  // namespace wellspaced::audit
