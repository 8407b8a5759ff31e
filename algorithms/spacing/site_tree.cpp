#include "wellspaced/algorithms/spacing/site_tree.hpp"

#include <bit>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/point_order.hpp"

namespace wellspaced {
namespace {

// Distances that are larger by rounding alone are not larger.
constexpr double kRoundingMargin = 1 - 0x1p-48;

double outside_interval(double x, double low, double high) {
  return x < low ? low - x : x > high ? x - high : 0;
}

}  // namespace

SiteTree::SiteTree(std::span<const Point2> places, std::span<const double> weights)
    : number_(hilbert_order(places)), position_(places.size()) {
  sites_.reserve(places.size());
  for (const Index i : number_) {
    position_[i] = static_cast<Index>(sites_.size());
    sites_.push_back({places[i], weights.empty() ? 0 : weights[i]});
  }
  leaves_ = std::bit_ceil((sites_.size() + kBlock - 1) / kBlock);
  nodes_.resize(2 * leaves_);
  for (std::size_t k = 0; k < sites_.size(); ++k) {
    const Point2 p = sites_[k].place;
    nodes_[leaves_ + k / kBlock].cover({{p, p}, sites_[k].weight});
  }
  for (std::size_t k = nodes_.size(); k-- > 2;) nodes_[k / 2].cover(nodes_[k]);
}

void SiteTree::lower_weight(Index i, double weight) {
  const std::size_t k = position_[i];
  sites_[k].weight = weight;
  for (std::size_t node = leaves_ + k / kBlock; node > 0; node /= 2)
    nodes_[node].least_weight = std::min(nodes_[node].least_weight, weight);
}

double SiteTree::lower_bound(std::size_t node, Point2 x) const {
  const auto& [box, least_weight] = nodes_[node];
  if (least_weight == kInfinity) return kInfinity;
  const Point2 gap{outside_interval(x.x, box.low.x, box.high.x),
                   outside_interval(x.y, box.low.y, box.high.y)};
  return kRoundingMargin * (least_weight + distance({0, 0}, gap));
}

// Whether the site is nearer than the best so far, or at the bound where there is none yet.
bool SiteTree::improves(std::size_t k, Point2 x, const Best& best) const {
  const double to_site = weighted_distance(sites_[k], x);
  if (best.site == kNoIndex) return to_site <= best.distance;
  if (kRoundingMargin * to_site > best.distance) return false;
  const int order = weighted_distance_order(sites_[k], site(best.site), x);
  return order < 0 || (order == 0 && number_[k] < best.site);
}

}  // namespace wellspaced
