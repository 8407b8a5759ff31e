// Graded test meshes: a cracked plate, a ring, the flow around a wing section.
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

enum class GradedDomain { kCrack, kAnnulus, kAirfoil };

/// nodes: how many there are to be, 300 to 2^26.
/// octaves: the spacing grows by the factor 2^octaves from its finest to its coarsest place; 0 to
///   16, or negative: as suits the domain and the number of nodes.
struct GradedMeshOptions {
  Index nodes = 20000;
  double octaves = -1;
};

/// A mesh of one of the domains of curved_domain.hpp by pack_domain, the size a multiple of the
/// domain's grading that gives the number of nodes.
/// Returns: within 2% of the nodes asked for (4% below 1000), smallest angle at least 25
///   degrees. The same bytes everywhere.
/// Errors: kUsage for an option out of its range, or if the number of nodes does not suit the
///   octaves: too few for such a grading, or for so little of it where the boundary is finely
///   shaped; kCancelled.
/// Cost: O(n log n) expected; the last of a few meshes of growing size is returned.
/// Audit: embedding, constrained Delaunay, smallest angle.
Result<TriangleMesh> generate_graded_mesh(GradedDomain domain, const GradedMeshOptions& options,
                                          const Progress& progress = {});

/// The boundary of that mesh as a domain: its segments with their points, and a point in each hole.
/// Errors and cost: those of generate_graded_mesh.
Result<Pslg> generate_graded_boundary(GradedDomain domain, const GradedMeshOptions& options,
                                      const Progress& progress = {});

}  // namespace wellspaced
