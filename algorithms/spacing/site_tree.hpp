// Weighted sites in the plane, ready for the question which of them is nearest to a point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/weighted_distance.hpp"

namespace wellspaced {

/// Sites in blocks along a Hilbert curve, under a complete binary tree whose nodes keep the box
/// around the sites below them and their least weight. Distances are weight + |site - x|.
///
/// Decisions are exact: of several sites at equal distance the lowest in number is nearest.
/// Cost: O(n log n) to build. A query looks at the sites that are nearly as near as the nearest:
/// O(log n) where these are few, as for the sites of a mesh; all n at worst, as from the centre of
/// a circle of sites.
class SiteTree {
 public:
  /// weights: one a site, >= 0, infinite for a site that is never nearest; empty: all 0.
  /// Requires: finite places, at most kMaxOrderedPoints.
  explicit SiteTree(std::span<const Point2> places, std::span<const double> weights = {});

  std::size_t size() const { return sites_.size(); }
  const WeightedSite& site(Index i) const { return sites_[position_[i]]; }

  /// The nearest site to x among those at a distance of at most `bound` that `accept` takes;
  /// kNoIndex if there is none. accept(i): asked of few sites, those nearer than all taken before.
  /// Requires: accept answers the same whenever asked.
  template <class Accept>
  Index nearest(Point2 x, double bound, Accept accept) const {
    Best best{bound, kNoIndex};
    if (!sites_.empty()) descend(x, {1, 0, leaves_}, best, accept);
    return best.site;
  }

  /// The nearest site of all; kNoIndex if no weight is finite.
  Index nearest(Point2 x) const {
    return nearest(x, std::numeric_limits<double>::max(), [](Index) { return true; });
  }

  /// Calls visit with every site, near ones in succession: queries at them share their paths.
  template <class Visit>
  void for_each_along_curve(Visit visit) const {
    for (const Index i : number_) visit(i);
  }

  /// Lowers the weight of a site. Requires: 0 <= weight <= its weight. Cost: O(log n).
  void lower_weight(Index i, double weight);

 private:
  static constexpr std::size_t kBlock = 8;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  struct Node {
    Box2 box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    double least_weight = kInfinity;

    void cover(const Node& other) {
      box.cover(other.box);
      least_weight = std::min(least_weight, other.least_weight);
    }
  };
  struct Range {
    std::size_t node, first, last;  // blocks first .. last-1; node k has children 2k and 2k + 1
    std::size_t middle() const { return first + (last - first) / 2; }
    Range lower() const { return {2 * node, first, middle()}; }
    Range upper() const { return {2 * node + 1, middle(), last}; }
  };
  struct Best {
    double distance;
    Index site;
  };

  double lower_bound(std::size_t node, Point2 x) const;
  bool improves(std::size_t position, Point2 x, const Best& best) const;

  // Recursion is as deep as the tree, log2 n.
  template <class Accept>
  void descend(Point2 x, Range range, Best& best, Accept& accept) const {
    if (range.last - range.first == 1) return visit_block(x, range.first, best, accept);
    Range near = range.lower(), far = range.upper();
    double to_near = lower_bound(near.node, x), to_far = lower_bound(far.node, x);
    if (to_far < to_near) std::swap(near, far), std::swap(to_near, to_far);
    if (to_near <= best.distance) descend(x, near, best, accept);
    if (to_far <= best.distance) descend(x, far, best, accept);
  }

  template <class Accept>
  void visit_block(Point2 x, std::size_t block, Best& best, Accept& accept) const {
    const std::size_t end = std::min((block + 1) * kBlock, sites_.size());
    for (std::size_t k = block * kBlock; k < end; ++k)
      if (improves(k, x, best) && accept(number_[k]))
        best.distance = weighted_distance(sites_[k], x), best.site = number_[k];
  }

  std::vector<WeightedSite> sites_;  // along the curve
  std::vector<Index> number_;        // for each its number
  std::vector<Index> position_;      // and the inverse
  std::vector<Node> nodes_;
  std::size_t leaves_ = 1;  // blocks, a power of 2
};

}  // namespace wellspaced
