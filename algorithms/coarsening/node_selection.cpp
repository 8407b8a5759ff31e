#include "wellspaced/algorithms/coarsening/node_selection.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {
namespace {

// Two ways along one path differ by rounding errors, some 2^-52 an edge. What is in conflict up to
// this much more, on a path of any length that can occur, is near.
constexpr double kNearly = 1 - 0x1p-20;

constexpr std::size_t kWorkBetweenQuestions = 1 << 16;

}  // namespace

ConflictRule function_conflicts(LocalSearch& search, std::span<const double> f, double beta) {
  return [&search, f, beta](Index node, std::vector<Conflict>& conflicts) {
    const double radius = 3 * f[node] / beta;
    const auto reached = search.run(
        std::array{node}, [&](Index v, double d) { return f[node] + f[v] > kNearly * (beta * d); });
    for (const Index v : reached) {
      const double d = search.distance(v);
      conflicts.push_back({v, f[node] + f[v] > beta * d && d <= radius});
    }
  };
}

ConflictRule neighbor_conflicts(const Graph& graph) {
  return [&graph](Index node, std::vector<Conflict>& conflicts) {
    for (const Graph::Arc& arc : graph.arcs_of(node)) conflicts.push_back({arc.target});
  };
}

NodeSelection::NodeSelection(Index nodes, const TwinNodes& twins, ConflictRule rule,
                             Considered considered)
    : twins_(twins),
      rule_(std::move(rule)),
      considered_(std::move(considered)),
      states_(nodes, State::kFree) {}

bool NodeSelection::force(std::span<const Index> nodes, const KeepGoing& keep_going) {
  for (const Index v : nodes) mark_selected(v);
  for (const Index v : nodes) {
    if (!goes_on(keep_going)) return false;
    pool_.clear();
    find_conflicts(v);
    if (considered_) considered_(v);
    invalidate_conflicts(0);
  }
  return true;
}

bool NodeSelection::select(std::span<const Index> nodes, std::span<const std::uint64_t> keys,
                           const KeepGoing& keep_going) {
  for (const Index v : nodes)
    if (states_[v] == State::kFree) states_[v] = State::kCandidate;
  work_ = kWorkBetweenQuestions;
  for (const Index v : nodes) {
    if (!goes_on(keep_going)) return false;
    if (states_[v] == State::kCandidate) decide(v, keys);
  }
  return true;
}

bool NodeSelection::goes_on(const KeepGoing& keep_going) {
  if (++work_ <= kWorkBetweenQuestions) return true;
  work_ = 0;
  return !keep_going || keep_going();
}

// An explicit stack in place of recursion: the top waits for nobody, or for the one that comes on
// top of it next.
void NodeSelection::decide(Index v, std::span<const std::uint64_t> keys) {
  pool_.clear();
  wait_for(v, keys);
  while (!waiting_.empty()) {
    Waiting& top = waiting_.back();
    if (states_[top.node] == State::kCandidate) {
      const Index before = conflict_before(top, keys);
      if (before != kNoIndex) {
        wait_for(before, keys);
        continue;
      }
      consider(top.node, top.conflicts);
    }
    pool_.resize(top.conflicts);
    waiting_.pop_back();
  }
}

void NodeSelection::wait_for(Index v, std::span<const std::uint64_t> keys) {
  waiting_.push_back({v, key_of(v, keys), pool_.size(), pool_.size()});
  find_conflicts(v);
}

// A conflict that is undecided and comes before the waiting node; kNoIndex if none is left. Of few
// conflicts the next one, of many the first in order: it is the likeliest to be selected, and then
// no other has to be looked at, which costs a large search.
Index NodeSelection::conflict_before(Waiting& waiting, std::span<const std::uint64_t> keys) const {
  constexpr std::size_t kMany = 256;
  const bool many = pool_.size() - waiting.conflicts > kMany;
  std::uint64_t least = waiting.key;
  Index first = kNoIndex;
  for (std::size_t i = many ? waiting.conflicts : waiting.next; i < pool_.size(); ++i) {
    const Index w = pool_[i].node;
    if (states_[w] != State::kCandidate || key_of(w, keys) >= least) continue;
    first = w;
    least = key_of(w, keys);
    waiting.next = i;
    if (!many) break;
  }
  return first;
}

// The turn of v has come: all before it are decided.
void NodeSelection::consider(Index v, std::size_t conflicts) {
  if (considered_) considered_(v);
  const bool meets_selected = any_of(std::span(pool_).subspan(conflicts), [&](const Conflict& c) {
    return c.holds && is_selected(c.node);
  });
  if (meets_selected) return invalidate(v);
  mark_selected(v);
  invalidate_conflicts(conflicts);
}

void NodeSelection::invalidate(Index v) {
  twins_.for_each(v, [&](Index w) {
    if (is_free(w)) states_[w] = State::kInvalid;
  });
}

std::vector<Index> NodeSelection::selected() const {
  std::vector<Index> nodes;
  for (Index v = 0; v < states_.size(); ++v)
    if (is_selected(v)) nodes.push_back(v);
  return nodes;
}

std::uint64_t NodeSelection::key_of(Index v, std::span<const std::uint64_t> keys) const {
  const auto own_key = [&](Index w) { return keys.empty() ? w : keys[w]; };
  std::uint64_t key = own_key(v);
  twins_.for_each(v, [&](Index w) { key = std::min(key, own_key(w)); });
  return key;
}

void NodeSelection::find_conflicts(Index v) {
  const std::size_t before = pool_.size();
  twins_.for_each(v, [&](Index w) { rule_(w, pool_); });
  work_ += pool_.size() - before;
}

void NodeSelection::mark_selected(Index v) {
  twins_.for_each(v, [&](Index w) { states_[w] = State::kSelected; });
}

void NodeSelection::invalidate_conflicts(std::size_t conflicts) {
  for (std::size_t i = conflicts; i < pool_.size(); ++i)
    if (pool_[i].holds) invalidate(pool_[i].node);
}

}  // namespace wellspaced
