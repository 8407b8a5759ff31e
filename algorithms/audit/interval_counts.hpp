// Sorts values into intervals; angles into those of 10 degrees by their cotangents, without
// computing them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/bit_cast.hpp"

namespace wellspaced::audit {

/// The cotangents of 10, 20, ..., 170 degrees.
inline constexpr std::array<double, 17> kCotangents = {5.671281819617709530994418439864,
                                                       2.747477419454622278761640264977,
                                                       1.732050807568877293527446341506,
                                                       1.191753592594209958705308071747,
                                                       0.8390996311772800117631272981231,
                                                       0.5773502691896257645091487805020,
                                                       0.3639702342662023613510478827768,
                                                       0.1763269807084649734710903868687,
                                                       0,
                                                       -0.1763269807084649734710903868687,
                                                       -0.3639702342662023613510478827768,
                                                       -0.5773502691896257645091487805020,
                                                       -0.8390996311772800117631272981231,
                                                       -1.191753592594209958705308071747,
                                                       -1.732050807568877293527446341506,
                                                       -2.747477419454622278761640264977,
                                                       -5.671281819617709530994418439864};

/// Counts values by the intervals between N ascending thresholds, without a search or a branch,
/// which would be mispredicted.
/// Requires: no two thresholds agree in sign, exponent and the first two bits after the point.
template <std::size_t N>
class IntervalCounts {
 public:
  explicit IntervalCounts(const std::array<double, N>& thresholds) : reached_(kCells, N) {
    thresholds_.back() = std::numeric_limits<double>::quiet_NaN();
    std::copy(thresholds.begin(), thresholds.end(), thresholds_.begin());
    std::size_t cell = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (; cell <= cell_of(thresholds[i]); ++cell) reached_[cell] = static_cast<std::uint8_t>(i);
  }

  /// A value lies in the interval above each threshold that it reaches; NaN reaches none.
  void add(double value) {
    const std::size_t i = reached_[cell_of(value)];
    ++counts_[i + (value >= thresholds_[i])];
  }

  Histogram histogram(std::string_view name, std::vector<double> bounds) const {
    return {std::string(name), std::move(bounds), {counts_.begin(), counts_.end()}};
  }

 private:
  // Numbers with the same sign, exponent and first two bits after the point share a cell; the cells
  // ascend with them. NaN is in the first.
  static constexpr std::size_t kCells = std::size_t{1} << 14;
  static std::size_t cell_of(double value) {
    const auto bits = bit_cast<std::int64_t>(value == value ? value + 0.0 : kLowest);
    const std::int64_t other_bits_if_negative =
        (bits >> 63) & std::numeric_limits<std::int64_t>::max();
    return static_cast<std::size_t>(((bits ^ other_bits_if_negative) >> 50) +
                                    static_cast<std::int64_t>(kCells / 2));
  }
  static constexpr double kLowest = -std::numeric_limits<double>::infinity();

  // The thresholds that end with one that is never reached; those below each cell.
  std::array<double, N + 1> thresholds_;
  std::vector<std::uint8_t> reached_;
  std::array<std::uint64_t, N + 1> counts_{};
};

/// The bounds of a histogram: from `low` by the thresholds to infinity.
template <std::size_t N>
std::vector<double> bounds_between(double low, const std::array<double, N>& thresholds) {
  std::vector<double> bounds{low};
  bounds.insert(bounds.end(), thresholds.begin(), thresholds.end());
  bounds.push_back(std::numeric_limits<double>::infinity());
  return bounds;
}

/// Counts angles by intervals of 10 degrees.
class AngleCounts {
 public:
  /// 180 degrees, with the cotangent -infinity, are in the last interval, NaN in the first.
  void add_cotangent(double cotangent) { counts_.add(-cotangent); }

  Histogram histogram(std::string_view name) const {
    std::vector<double> degrees;
    for (int i = 0; i <= 18; ++i) degrees.push_back(10 * i);
    return counts_.histogram(name, degrees);
  }

 private:
  static constexpr std::array<double, 17> negative(std::array<double, 17> values) {
    for (double& v : values) v = -v;
    return values;
  }

  IntervalCounts<17> counts_{negative(kCotangents)};
};

}  // namespace wellspaced::audit
