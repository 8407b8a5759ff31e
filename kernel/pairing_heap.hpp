// A pairing heap over the nodes of a graph: intrusive, pooled, with decrease-key.
#pragma once

#include <cassert>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A priority queue of items 0 .. capacity - 1, each at most once, smallest key first; equal keys
/// by lower item. The links live in one record an item, so that nothing is allocated after the
/// constructor.
///
/// A heap-ordered tree: no child comes before its parent. Children of a node form a list through
/// `next`; `previous` is the sibling before, or the parent for the first child.
/// Cost: push, decrease and top constant (decrease: o(log n) amortised), pop O(log n) amortised
/// (Fredman, Sedgewick, Sleator and Tarjan 1986).
class PairingHeap {
 public:
  explicit PairingHeap(Index capacity) : records_(capacity) {}

  bool empty() const { return root_ == kNoIndex; }
  bool contains(Index item) const { return records_[item].previous != kNoIndex; }
  double key(Index item) const { return records_[item].key; }

  /// The item that comes first. Requires: not empty.
  Index top() const { return root_; }

  /// Requires: item < capacity, not in the heap; key is no NaN.
  void push(Index item, double key);

  /// Lowers the key of an item. Requires: contains(item), key <= key(item).
  void decrease(Index item, double key);

  /// Removes and returns the item that comes first. Requires: not empty.
  Index pop();

 private:
  struct Record {
    double key = 0;
    Index child = kNoIndex, next = kNoIndex;
    Index previous = kNoIndex;  // kNoIndex: not in the heap; the root points to itself
  };

  bool before(Index a, Index b) const {
    const double ka = records_[a].key, kb = records_[b].key;
    return ka < kb || (ka == kb && a < b);
  }
  Index meld(Index a, Index b);
  void cut(Index item);
  Index meld_siblings(Index first);

  std::vector<Record> records_;
  Index root_ = kNoIndex;
};

inline void PairingHeap::push(Index item, double key) {
  assert(!contains(item));
  records_[item] = {key, kNoIndex, kNoIndex, item};
  root_ = empty() ? item : meld(root_, item);
  records_[root_].previous = root_;
}

inline void PairingHeap::decrease(Index item, double key) {
  assert(contains(item) && key <= records_[item].key);
  records_[item].key = key;
  if (item == root_) return;
  cut(item);
  root_ = meld(root_, item);
  records_[root_].previous = root_;
}

inline Index PairingHeap::pop() {
  assert(!empty());
  const Index item = root_;
  root_ = meld_siblings(records_[item].child);
  if (root_ != kNoIndex) records_[root_].previous = root_;
  records_[item].previous = kNoIndex;
  return item;
}

// Makes the later of two roots the first child of the other, which it returns.
inline Index PairingHeap::meld(Index a, Index b) {
  if (before(b, a)) std::swap(a, b);
  Record &parent = records_[a], &child = records_[b];
  child.next = parent.child;
  child.previous = a;
  if (parent.child != kNoIndex) records_[parent.child].previous = b;
  parent.child = b;
  return a;
}

// Takes an item that is not the root, with its subtree, out of the list of its siblings.
inline void PairingHeap::cut(Index item) {
  Record& record = records_[item];
  Record& before_it = records_[record.previous];
  if (before_it.child == item) {
    before_it.child = record.next;
  } else {
    before_it.next = record.next;
  }
  if (record.next != kNoIndex) records_[record.next].previous = record.previous;
  record.next = kNoIndex;
}

// Melds a list of siblings into one tree: in pairs from the front, then the pairs from the back.
inline Index PairingHeap::meld_siblings(Index first) {
  Index pairs = kNoIndex;  // a stack through `next`
  while (first != kNoIndex) {
    const Index a = first, b = records_[a].next;
    first = b == kNoIndex ? kNoIndex : records_[b].next;
    records_[a].next = kNoIndex;
    if (b != kNoIndex) records_[b].next = kNoIndex;
    const Index pair = b == kNoIndex ? a : meld(a, b);
    records_[pair].next = pairs;
    pairs = pair;
  }
  if (pairs == kNoIndex) return kNoIndex;
  Index root = pairs;
  pairs = records_[root].next;
  records_[root].next = kNoIndex;
  while (pairs != kNoIndex) {
    const Index pair = pairs;
    pairs = records_[pair].next;
    records_[pair].next = kNoIndex;
    root = meld(root, pair);
  }
  return root;
}

}  // namespace wellspaced
