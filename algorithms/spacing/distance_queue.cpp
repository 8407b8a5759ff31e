#include "wellspaced/algorithms/spacing/distance_queue.hpp"

#include <algorithm>

namespace wellspaced {
namespace {

struct IsFarther {
  bool operator()(const Pending& a, const Pending& b) const {
    return a.distance_sq > b.distance_sq || (a.distance_sq == b.distance_sq && a.first > b.first);
  }
};

}  // namespace

DistanceQueue::DistanceQueue() : memory_(buffer_.data(), buffer_.size()), heap_(&memory_) {
  heap_.reserve(128);
}

void DistanceQueue::push(const Pending& pending) {
  heap_.push_back(pending);
  std::push_heap(heap_.begin(), heap_.end(), IsFarther());
}

Pending DistanceQueue::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), IsFarther());
  const Pending nearest = heap_.back();
  heap_.pop_back();
  return nearest;
}

}  // namespace wellspaced
