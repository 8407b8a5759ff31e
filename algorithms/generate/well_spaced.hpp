// Well-spaced point sets of the unit square: those of Figures 1.1 to 1.3.
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Two ways to fill the square until no ball can be added (Figure 1.2): with gaps left that are
/// just too small, or with balls that touch, which leaves larger angles.
enum class WellSpacedStyle { kLoose, kTight };

/// nodes: how many there are to be, 20 to 2^26.
/// octaves: the spacing grows by the factor 2^octaves from the centre to the corners, 0 to 16; 0:
///   a uniform set.
struct WellSpacedOptions {
  Index nodes = 2000;
  double octaves = 0;
  WellSpacedStyle style = WellSpacedStyle::kLoose;
};

/// A well-spaced set of points in the unit square with its triangulation, by pack_domain.
/// Returns: within 5% of the nodes asked for (10% below 200); smallest angle 25 degrees, in uniform
///   sets 30 away from the boundary. The same bytes everywhere.
/// Errors: kUsage for an option out of its range, or too few nodes for so many octaves; kCancelled.
/// Cost: O(n log n) expected; the last of a few sets of growing size is returned.
/// See: section 1.1.
Result<TriangleMesh> generate_well_spaced(const WellSpacedOptions& options,
                                          const Progress& progress = {});

}  // namespace wellspaced
