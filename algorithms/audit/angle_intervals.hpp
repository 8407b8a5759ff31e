// Sorts angles into intervals of 10 degrees by their cotangents, without computing them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

/// The number of the interval [10 i, 10 i + 10) degrees that the angle lies in; 180 is in the last.
/// NaN is in the first.
inline std::size_t interval_of(double cotangent) {
  // A guess within half a degree: arctan x is about x (pi/4 + 0.273 (1 - x)) up to x = 1.
  const double size = std::fabs(cotangent), x = std::min(size, 1 / size);
  const double tens = x * (6.064 - 1.564 * x);
  const double acute = size > 1 ? tens : 9 - tens;
  const double angle = cotangent > 0 ? acute : 18 - acute;
  std::size_t i = angle > 0 ? static_cast<std::size_t>(std::min(angle, 17.0)) : 0;
  while (i < kCotangents.size() && cotangent <= kCotangents[i]) ++i;
  while (i > 0 && cotangent > kCotangents[i - 1]) --i;
  return i;
}

}  // namespace wellspaced::audit
