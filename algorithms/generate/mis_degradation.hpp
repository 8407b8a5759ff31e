// The pattern by which independent sets degrade a mesh again and again (Figure 6.1).
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A grid of 2^levels x 3^levels square cells, cut along one diagonal, whose nodes are numbered by
/// the levels that they outlive: so the independent set that is chosen greedily by number takes
/// every second node of a row and every third of a column, level by level, and the smallest angle
/// falls to atan((2/3)^k). It is sheared by 2^-20 so that each level has one Delaunay
/// triangulation, which cuts its cells the same way.
///
/// Table 6.1 counts 6^k nodes for level k; a cell really takes (2^k + 1)(3^k + 1).
/// levels: 1 to 8 (1.7 million nodes).
/// Errors: kUsage for another number of levels.
/// Use: coarsen with kMis, kPriority and no protection. See: section 6.1, erratum to Table 6.1.
Result<TriangleMesh> generate_mis_degradation(unsigned levels);

}  // namespace wellspaced
