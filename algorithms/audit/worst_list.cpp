#include "wellspaced/algorithms/audit/worst_list.hpp"

namespace wellspaced::audit {

void WorstList::insert(Index item, double key) {
  if (key != key) key = std::numeric_limits<double>::infinity();
  if (size_ < entries_.size()) ++size_;
  std::size_t i = size_ - 1;
  for (; i > 0 && entries_[i - 1].first < key; --i) entries_[i] = entries_[i - 1];
  entries_[i] = {key, item};
  if (size_ == entries_.size()) threshold_ = entries_.back().first;
}

}  // namespace wellspaced::audit
