// Coarsening: from one fine mesh to a sequence of ever coarser ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// How the nodes of a level are chosen: spaced by a function, or as a maximal independent set of
/// the mesh's edges.
enum class CoarseningMethod {
  kFunction,      ///< by the coarsening function f_{g,C,P} (chapters 5 and 7)
  kMis,           ///< section 5.2.1; fine to coarse alone
  kThreshold,     ///< by the threshold function t_{g,C,P} (section 6.3)
  kQuasiUniform,  ///< by one spacing for all nodes, C times the least of g (section 6.2)
  kRefinement,    ///< by Delaunay refinement towards given sizes and a least angle; coarse to fine
                  ///< in the graph metric alone. See coarsen_by_refinement.
  kQuadtree       ///< by the function of a quadtree, in linear time (section 5.8); coarse to fine
                  ///< and Euclidean alone, in the tree's order. See coarsen_by_quadtree.
};

/// What each level is selected from (section 5.3.4).
enum class CoarseningScheme {
  kFineToCoarse,  ///< the level before, with its function: node-nested (Figure 5.7)
  kFromFinest,    ///< the input, by factors C^i: no repeated degradation, not nested (Figure 5.8)
  kCoarseToFine   ///< the input, the coarsest level first, its nodes forced into the next: both
                  ///< (Figure 5.9)
};

/// The distances in the coarsening function and in conflicts.
enum class SpacingMetric {
  kGraph,      ///< along the edges of the mesh selected from (chapter 7)
  kEuclidean,  ///< chapter 5: conflicts between nodes that see each other (Definition 5.3.4)
  kGeodesic    ///< the same, but the function's cones go around holes and slits
};

/// In which order the nodes of a level are considered, boundary nodes before interior ones.
enum class SelectionOrder {
  kRandom,   ///< by the seed (CHOICES 13)
  kPriority  ///< the greatest priority first; of equal ones the lower node
};

struct CoarseningOptions {
  CoarseningMethod method = CoarseningMethod::kFunction;
  CoarseningScheme scheme = CoarseningScheme::kFineToCoarse;
  SpacingMetric metric = SpacingMetric::kGraph;
  double beta = 25;   ///< spacing constant, > 1: angles get better as it grows, levels more
  double factor = 8;  ///< C, > 1: how much the spacing grows from level to level; the first level's
                      ///< factor is C beta (section 8.3, CHOICES 3)
  /// R, >= 0: interior nodes keep a distance of R |e| from boundary edges e: in the graph metric
  /// within their diametral circles (section 7.4.1), in the others within the gamma protective
  /// zone, a rectangle (Definition 5.3.5, gamma = R). Default: 0.15 for kMis, otherwise 0.2.
  std::optional<double> protect = std::nullopt;
  /// Whether coarsened spacings stay below the local feature size of the boundary description,
  /// whose vertices then are special points: no level simplifies the boundary (section 5.5).
  bool limit_by_boundary = false;
  /// Whether nodes near a special point stay no farther apart than it is from the next special
  /// point. Otherwise boundary triangles between special points close together get flat on coarse
  /// levels. Costs nodes around all special points on all levels. Not for kMis.
  bool limit_by_special_points = false;
  /// The spacing g of the input, one value > 0 a node; default: see input_spacing().
  std::optional<std::vector<double>> spacing = std::nullopt;
  SelectionOrder order = SelectionOrder::kRandom;
  std::uint64_t seed = 1;  ///< of the random order
  /// For kPriority: one value a node of the input, no NaN; default: the level's spacing, so that
  /// nodes with large balls come first; for kMis none, so that nodes come by number.
  std::optional<std::vector<double>> priority = std::nullopt;
  /// The special points F; default: automatic_special_points, for kRefinement
  /// outline_special_points. Ends of inner curves, tips of slits and nodes in no edge are added,
  /// for the boundary hangs on them.
  std::optional<std::vector<Index>> fixed = std::nullopt;
  std::size_t max_levels = SIZE_MAX;  ///< levels after the input
  /// The part, >= 0, of its area by which the domain may change from the finest level to any other.
  /// Boundary nodes are taken back until it does. Default: no limit.
  std::optional<double> keep_boundary = std::nullopt;
  std::size_t until_nodes = 0;  ///< no further level once one has at most so many nodes
  /// For kRefinement alone: the nodes of the levels after the input, each less than the input's and
  /// more than 0. If there are none, each level has the nodes of the finer one by `ratio`, > 1,
  /// down to 1.5 times what the angles alone ask for around the special points.
  std::vector<std::size_t> targets = {};
  double ratio = 3;
  /// For kRefinement: the angle that triangles should have at least, > 0 and <= 30. Beyond 25
  /// levels fall short of it, with a few more nodes.
  double angle_deg = 22;
  bool count_work = false;  ///< fill Level::work
  /// Phase "prepare", then "spacing", "boundary", "select", "triangulate" of each level, in order,
  /// each at its start and some more often, at last "finish"; done: nodes of the input that are
  /// coarsened away (coarse to fine: nodes of the finest level so far), at last all; total: all.
  Progress progress = {};
};

/// What a multigrid solver is served best by: many mild steps (beta 4, C 2) down to at most 600
/// nodes. Convergence follows the largest number of triangles that a coarser one meets, and that
/// follows C; the angles matter little. Nodes are taken by priority, not at random: then that
/// number is smaller, at a few more nodes.
CoarseningOptions multigrid_profile();

/// Levels of given sizes whose triangles keep their angles to the end: kRefinement, with beta 3.5.
/// Spacing grows by up to 2 / beta a unit of length: with more than 4 levels of graded meshes are
/// coarsened less evenly, so that some triangles meet far more of the finer level than others.
/// Special points: outline_special_points.
CoarseningOptions quality_profile();

/// R: the one that options give, or else the method's default.
double protection_ratio(const CoarseningOptions& options);

/// The options of section 6: its theorems' constants, fine to coarse, Euclidean. kThreshold: C 24
/// and beta 16, which Theorem 6.3.3 (corrected) asks for where the input's gaps are bounded by
/// L = 2; otherwise beta must be at least max(8 L, 13 + 6 / L). kQuasiUniform: C 3, beta 2.
/// kQuadtree, which has no such constants: C 2 and beta 2, coarse to fine; there boxes are twice as
/// wide as nodes are apart. For the other methods the defaults above.
CoarseningOptions theorem_options(CoarseningMethod method);

/// The coarsening sequence of a mesh, finest level first. Each level is the constrained Delaunay
/// triangulation of nodes selected from the level before or from the input, by the scheme: special
/// points, then boundary nodes, then interior nodes, each a maximal set without conflicts in random
/// order. The sequence ends before the first level that would drop no node, or that special points
/// are too few for to keep a triangle; a threshold that drops none is raised on.
/// mesh: see TriangleMesh; boundary edges that are missing from its segments are added with marker
///   1. Holes, several components, inner segments, slits, dangling segments and isolated points
///   are all kept.
/// Requires: counter-clockwise triangles that do not overlap; coincident nodes only across slits.
/// Errors: kUsage for an option or special point out of range (ids: the points);
///   kInvalidGeometry for an index out of range, a coordinate that is not finite, points further
///   apart than the largest double, or a boundary that crosses itself; kLimit beyond 2^28 nodes.
/// Cancelled: the levels that are finished are returned, with complete = false; kCancelled where
///   that happens in the phase "prepare".
/// Cost: O(n log n) for bounded factor and degrees, fine to coarse; with the other schemes every
///   level costs about as much as the first.
/// Audit: every level by `audit`: embedding, conformity, constrained Delaunay, node-nestedness.
/// See: Figures 5.2, 5.6 to 5.9, 7.2, 7.3 and 7.10, chapters 6 and 8; CHOICES.md settles order,
/// ties and sums.
Result<Hierarchy> coarsen(TriangleMesh mesh, const CoarseningOptions& options);

}  // namespace wellspaced
