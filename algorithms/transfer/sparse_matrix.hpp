// Sparse matrices in compressed rows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Where the entries of a sparse matrix are: those of row i lie in the columns
/// column[first[i]] .. column[first[i + 1] - 1], ascending and all different.
struct SparsityPattern {
  Index columns = 0;
  std::vector<std::size_t> first = {0};
  std::vector<Index> column;

  Index rows() const { return static_cast<Index>(first.size() - 1); }
  std::size_t entries() const { return column.size(); }
  std::span<const Index> row(Index i) const {
    return {column.data() + first[i], column.data() + first[i + 1]};
  }
  /// Ends the row to which columns were appended.
  void end_row() { first.push_back(column.size()); }
};

/// A sparse matrix: value[k] is the entry in column[k].
struct SparseMatrix : SparsityPattern {
  std::vector<double> value;

  std::span<const double> row_values(Index i) const {
    return {value.data() + first[i], value.data() + first[i + 1]};
  }
};

/// The pattern of the transpose. Cost: linear.
SparsityPattern transposed(const SparsityPattern& pattern);

}  // namespace wellspaced
