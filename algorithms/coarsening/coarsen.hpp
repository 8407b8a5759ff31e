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

/// How the nodes of a level are chosen: spaced by a coarsening function (chapter 7), or as a
/// maximal independent set of the mesh's edges (section 5.2.1).
enum class CoarseningMethod { kFunction, kMis };

struct CoarseningOptions {
  CoarseningMethod method = CoarseningMethod::kFunction;
  double beta = 25;   ///< spacing constant, > 1: angles get better as it grows, levels more
  double factor = 8;  ///< C, > 1: how much the spacing grows from level to level; the first level's
                      ///< factor is C beta (section 8.3, CHOICES 3)
  /// R, >= 0: interior nodes keep a distance of R |e| from boundary edges e. Default: 0.2 for
  /// kFunction, 0.15 for kMis.
  std::optional<double> protect = std::nullopt;
  std::uint64_t seed = 1;  ///< of the random order of nodes (CHOICES 13)
  /// The special points F; default: automatic_special_points. Ends of inner curves, tips of slits
  /// and nodes in no edge are added, for the boundary hangs on them.
  std::optional<std::vector<Index>> fixed = std::nullopt;
  std::size_t max_levels = SIZE_MAX;  ///< levels after the input
  std::size_t until_nodes = 0;        ///< no further level once one has at most so many nodes
  bool count_work = false;            ///< fill Level::work
  /// Phases "spacing", "boundary", "select", "triangulate" of each level, in order, each at its
  /// start and some more often; done: nodes of the input that are coarsened away, total: all.
  Progress progress = {};
};

/// R: the one that options give, or else the method's default.
double protection_ratio(const CoarseningOptions& options);

/// The coarsening sequence of a mesh, fine to coarse. Each level is a node-nested constrained
/// Delaunay triangulation of nodes of the level before: special points, then boundary nodes, then
/// interior nodes, each a maximal set without conflicts in random order. The sequence ends before
/// the first level that would drop no node.
/// mesh: see TriangleMesh; boundary edges that are missing from its segments are added with marker
///   1. Holes, several components, inner segments, slits, dangling segments and isolated points
///   are all kept.
/// Requires: counter-clockwise triangles that do not overlap; coincident nodes only across slits.
/// Errors: kUsage for an option or special point out of range (ids: the points);
///   kInvalidGeometry for an index out of range, a coordinate that is not finite, or a boundary
///   that crosses itself; kLimit for meshes beyond 2^28 nodes.
/// Cancelled: the levels that are finished are returned, with complete = false.
/// Cost: O(n log n) for bounded factor and degrees.
/// Audit: every level by `audit`: embedding, conformity, constrained Delaunay, node-nestedness.
/// See: Figures 5.2, 7.2, 7.3 and 7.10, chapter 8; CHOICES.md settles order, ties and sums.
Result<Hierarchy> coarsen(TriangleMesh mesh, const CoarseningOptions& options);

}  // namespace wellspaced
