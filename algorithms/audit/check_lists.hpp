// Checks that go through items one by one, or list those found elsewhere.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced::audit {

/// Adds a required check on the items 0 .. count - 1; returns whether all are good.
template <class Good>
bool check_each(Report& report, std::string_view name, Item item, std::size_t count, Good good) {
  Check& check = report.add_required_check(name, item);
  for (Index i = 0; i < count; ++i)
    if (!good(i)) check.violate({i});
  return check.pass();
}

/// Adds a check that the listed items violate; ids_per(item) ids for each.
inline Check& list_violations(Report& report, std::string_view name, Item item,
                              const std::vector<Index>& ids) {
  Check& check = report.add_check(name, item);
  check.violations = ids.size() / ids_per(item);
  check.ids = ids;
  return check;
}

/// Whether an element names nodes that exist, and no node twice.
template <std::size_t N>
bool in_range(const std::array<Index, N>& nodes, std::size_t count) {
  return all_of(nodes, [&](Index v) { return v < count; });
}
template <std::size_t N>
bool distinct(const std::array<Index, N>& nodes) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (nodes[i] == nodes[j]) return false;
  return true;
}

/// The required checks no_inverted and no_flat, from the orientations of all elements.
template <class Signs>
void check_orientations(Report& report, Item item, const Signs& orientation) {
  check_each(report, "no_inverted", item, orientation.size(),
             [&](Index i) { return orientation[i] >= 0; });
  check_each(report, "no_flat", item, orientation.size(),
             [&](Index i) { return orientation[i] != 0; });
}

}  // namespace wellspaced::audit
