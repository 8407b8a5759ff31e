// What holds for all, some or none of a list: plain loops, for the standard ones hold the predicate
// four times over.
#pragma once

namespace wellspaced {

/// Whether holds(x) for at least one x in `list`; the others are not asked after it.
template <class List, class Holds>
constexpr bool any_of(const List& list, Holds holds) {
  for (const auto& x : list)
    if (holds(x)) return true;
  return false;
}

/// Whether holds(x) for no x in `list`.
template <class List, class Holds>
constexpr bool none_of(const List& list, Holds holds) {
  return !any_of(list, holds);
}

/// Whether holds(x) for every x in `list`; none is asked after the first for which it does not.
template <class List, class Holds>
constexpr bool all_of(const List& list, Holds holds) {
  return !any_of(list, [&](const auto& x) { return !holds(x); });
}

/// Whether `x` stands in `list`. Cost: O(n).
template <class T, class List>
constexpr bool is_among(const T& x, const List& list) {
  return any_of(list, [&](const auto& y) { return y == x; });
}

}  // namespace wellspaced
