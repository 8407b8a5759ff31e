// Keeps the ten worst items of many.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include "wellspaced/algorithms/audit/report.hpp"

namespace wellspaced::audit {

/// The items with the largest keys, the worst first; equal keys by lower item.
class WorstList {
 public:
  /// Items must be offered in ascending order. NaN counts as the worst of all.
  void offer(Index item, double key) {
    if (!(key <= threshold_)) insert(item, key);
  }

  /// -infinity if nothing was offered.
  double worst_key() const { return size_ > 0 ? entries_[0].first : kNothing; }

  /// The list under the name of its measure; value_of turns keys into values of the measure.
  template <class ValueOf>
  Worst list(std::string_view measure, ValueOf value_of, Item item = Item::kTriangle) const {
    Worst worst;
    worst.measure = measure;
    worst.item = item;
    for (std::size_t i = 0; i < size_; ++i) {
      worst.ids.push_back(entries_[i].second);
      worst.values.push_back(value_of(entries_[i].first));
    }
    return worst;
  }

 private:
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();

  void insert(Index item, double key);

  std::array<std::pair<double, Index>, 10> entries_;
  std::size_t size_ = 0;
  double threshold_ = kNothing;
};

}  // namespace wellspaced::audit
