// The audit of a hierarchy of meshes: every level by itself, and each against the one before.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// A level, whoever made it.
///
/// origin: for each node the node of the finest mesh that it is; empty: not known, nodes are then
///   matched by place.
/// spacing: for each node the value of the function that selected it; empty: not known.
struct HierarchyLevel {
  TriangleMesh mesh;
  std::vector<Index> origin;
  std::vector<double> spacing;
};

/// The mesh that a level's nodes were selected from, in whose graph metric they are spaced.
enum class SelectedFrom { kLevelBefore, kFinest };

/// Whether audit_spacing() judges the levels from 1 on that have a spacing function, too, and what
/// it finds is compared with the theorems.
enum class WellSpacing { kLeftOut, kMeasured };

/// Whether a hierarchy claims that every level is made of nodes of the one before. Levels that are
/// each selected from the finest mesh by itself are made of its nodes alone.
enum class Nesting { kPromised, kNotPromised };

/// beta: the spacing constant; 0: not known, spacing is then not judged.
/// factor: C of the coarsening functions in the graph metric, C beta for the first level; 0: not
///   known, Lemma 7.1.4 is then not compared.
/// fixed: the special points, as nodes of the finest mesh.
/// domain: what level 0 is judged against; null: not known.
struct HierarchyAuditOptions {
  double beta = 0;
  double factor = 0;
  SelectedFrom selected_from = SelectedFrom::kLevelBefore;
  Nesting nesting = Nesting::kPromised;
  std::span<const Index> fixed = {};
  const Pslg* domain = nullptr;
  WellSpacing well_spacing = WellSpacing::kLeftOut;
  Progress progress = {};
};

/// Judges a hierarchy, finest level first. Its checks without a level sum up those of the levels:
///   levels_valid           (required) every required check of every level passes
///   levels_constrained_delaunay  (required) as constrained_delaunay, over levels 1 and up
///   node_nested            (required where promised) as below, over all levels
/// Then, for each level, the checks of audit_mesh. Level 0 is judged as an input; from level 1 on
/// constrained_delaunay counts too, as does boundary_has_segments if level 0 passes it. And from
/// level 1 on, against the level before:
///   node_nested            (required where promised) every node is, exactly at its place, a node
///                          of the level before and of the finest, and no two are the same one
///   nodes_of_finest        (required; only where nesting is not promised) every node is one of the
///                          finest, and no two are the same one
///   fewer_nodes            the level is smaller (violations: 1)
///   boundary_nested        every boundary node is one in the level before
///   holes_kept             it has as many boundary loops as the level before, and as many
///                          components (violations: how many more or fewer)
///   markers_kept           every segment marker of the level before is alive (violations: lost)
///   fixed_nodes_kept       every special point is there (node: of the finest mesh)
///   graph_spacing          the nodes are beta-spaced in the graph metric of the mesh selected
///                          from; pairs of special points are exempt (edge: two nodes of the level)
///   graph_lipschitz        their values are 1-Lipschitz in that metric (node: of the level)
///   euclidean_spacing      the edges of the level are no shorter than beta-spacing asks (edge)
/// Measures of each level: those of audit_mesh; from level 1 on also size_ratio (nodes of the level
///   before by nodes), area_kept and perimeter_kept (by those of the finest), hausdorff and
///   hausdorff_to_finest (distance of the boundaries), and, if both levels are embedded,
///   intersection_mean and intersection_max (triangles of the level before that a triangle meets),
///   intersection_max_finer (triangles that one of the level before meets), similarity (the
///   constant of Definition 5.1.5). Without a level: levels, and the worst of similarity and
///   intersection_max over all levels. If the factor is known, spacing_to_coarsened_min and _max:
///   the level's values by what the values of the level before become in its graph metric; 1 and 1
///   for the coarsening function itself, less where it was bounded otherwise.
/// Where well-spacing is measured, what audit_spacing() finds about the levels from 1 on, with its
/// witnesses, in the Euclidean metric.
/// Theorems, for each pair of levels: 5.1.7, local similarity bounds the intersections; 7.1.4, the
///   graph metric changes coarsening functions by at most the dilation, compared at some 4096 nodes
///   at most. For each level whose well-spacing is measured those of compare_with_theorems().
/// Cost: that of audit_mesh on all levels, of count_intersections and of graph_spacing_violations.
/// See: Definitions 5.1.1 to 5.1.8; ERRATA "For the auditor".
Report audit_hierarchy(std::span<const HierarchyLevel> levels,
                       const HierarchyAuditOptions& options = {});

}  // namespace wellspaced::audit
