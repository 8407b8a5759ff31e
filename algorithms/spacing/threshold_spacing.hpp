// The threshold coarsening function (Definition 5.3.3).
#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace wellspaced {

/// t_{g,C,P} = max(g, C min g) on the points: features smaller than C min g are coarsened, larger
/// ones left alone. Lipschitz as g is; at most f_{g,C,P} for C >= 1 and a 1-Lipschitz g (Lemma
/// 5.4.5).
/// spacing: g, one value >= 0 a point. factor: C > 0.
/// Cost: linear. See: Definition 5.3.3, section 6.3.
inline std::vector<double> threshold_spacing(std::span<const double> spacing, double factor) {
  std::vector<double> values(spacing.begin(), spacing.end());
  if (values.empty()) return values;
  const double threshold = factor * *std::min_element(values.begin(), values.end());
  for (double& value : values) value = std::max(value, threshold);
  return values;
}

}  // namespace wellspaced
