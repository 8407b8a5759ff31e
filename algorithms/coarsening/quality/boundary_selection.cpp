#include "wellspaced/algorithms/coarsening/quality/boundary_selection.hpp"

namespace wellspaced {

BoundarySelection::BoundarySelection(const Boundary& boundary, std::size_t nodes)
    : boundary_(boundary), first_place_(nodes + 1, 0) {
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    first_of_curve_.push_back(node_.size());
    for (const Index v : boundary.curves[c].nodes) {
      node_.push_back(v);
      curve_of_.push_back(c);
      ++first_place_[v + 1];
    }
  }
  first_of_curve_.push_back(node_.size());
  for (std::size_t v = 0; v < nodes; ++v) first_place_[v + 1] += first_place_[v];
  place_.resize(node_.size());
  std::vector<std::size_t> free = first_place_;
  for (std::size_t p = 0; p < node_.size(); ++p) place_[free[node_[p]]++] = p;
  next_.assign(node_.size(), kNone);
  previous_ = next_;
  is_selected_.assign(node_.size(), 0);
}

// kNone at the ends of open curves.
std::size_t BoundarySelection::after(std::size_t place) const {
  const std::size_t c = curve_of_[place];
  if (place + 1 < first_of_curve_[c + 1]) return place + 1;
  return boundary_.curves[c].closed ? first_of_curve_[c] : kNone;
}

std::size_t BoundarySelection::before(std::size_t place) const {
  const std::size_t c = curve_of_[place];
  if (place > first_of_curve_[c]) return place - 1;
  return boundary_.curves[c].closed ? first_of_curve_[c + 1] - 1 : kNone;
}

std::optional<BoundarySelection::Link> BoundarySelection::link_over(std::size_t place) const {
  std::size_t from = before(place);
  while (from != kNone && from != place && !is_selected_[from]) from = before(from);
  if (from == kNone || from == place || next_[from] == kNone) return std::nullopt;
  return Link{from, next_[from]};
}

// Links a place that has just been selected. The only one of a closed curve gets no link.
void BoundarySelection::tie(std::size_t place) {
  std::size_t p = before(place), q = after(place);
  while (p != kNone && p != place && !is_selected_[p]) p = before(p);
  while (q != kNone && q != place && !is_selected_[q]) q = after(q);
  next_[place] = q == place ? kNone : q;
  previous_[place] = p == place ? kNone : p;
  if (next_[place] != kNone) previous_[q] = place;
  if (previous_[place] != kNone) next_[p] = place;
}

void BoundarySelection::select(Index node) {
  for (const std::size_t p : places_of(node)) is_selected_[p] = 1;
  for (const std::size_t p : places_of(node)) tie(p);
}

void BoundarySelection::unselect(Index node) {
  for (const std::size_t p : places_of(node)) {
    is_selected_[p] = 0;
    const std::size_t q = next_[p], r = previous_[p];
    if (r != kNone) next_[r] = q == r ? kNone : q;
    if (q != kNone) previous_[q] = q == r ? kNone : r;
    next_[p] = previous_[p] = kNone;
  }
}

}  // namespace wellspaced
