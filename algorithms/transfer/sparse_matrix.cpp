#include "wellspaced/algorithms/transfer/sparse_matrix.hpp"

namespace wellspaced {

SparsityPattern transposed(const SparsityPattern& pattern) {
  SparsityPattern result;
  result.columns = pattern.rows();
  result.first.assign(std::size_t{pattern.columns} + 2, 0);
  for (const Index j : pattern.column) ++result.first[j + 2];
  for (std::size_t j = 2; j < result.first.size(); ++j) result.first[j] += result.first[j - 1];
  result.column.resize(pattern.entries());
  for (Index i = 0; i < pattern.rows(); ++i)
    for (const Index j : pattern.row(i)) result.column[result.first[j + 1]++] = i;
  result.first.pop_back();
  return result;
}

}  // namespace wellspaced
