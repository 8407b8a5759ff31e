// Facets of a domain in space that no mesh of it has faces on.
#pragma once

#include <vector>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/polyhedral_domain.hpp"

namespace wellspaced::audit {

/// Finds facets with nothing to be meshed on either side: the mouth of a hole that is open to the
/// outside, or a wall between two holes.
///
/// The proof on the instance is a straight line from a hole point, or from beyond the domain, to
/// another such place that passes through the facet and meets no other one. Only a few lines are
/// tried: a facet that is not found open may be so all the same, hidden behind others.
class OpenFacets {
 public:
  /// Requires: indices of the domain in range; the domain outlives this.
  /// Cost: O(n log n) for n corners of polygons.
  explicit OpenFacets(const PolyhedralDomain& domain);

  /// Whether such a line was found; that it is one is decided exactly.
  /// Cost: O(hole points + corners of the facet), and the facets that a few dozen lines come near.
  bool is_open(Index facet) const;

 private:
  struct Line {
    Point3 from, to;
  };

  std::vector<Line> lines_through(Point3 p) const;
  bool passes_only(const Line& line, Index facet) const;

  const PolyhedralDomain& domain_;
  std::vector<Box<3>> boxes_;  // of the facets
  BoxTree<3> tree_;
  double reach_ = 0;  // more than the distance from any point of the domain to what is beyond it
};

}  // namespace wellspaced::audit
