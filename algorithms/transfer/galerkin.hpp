// The cost of the Galerkin coarse operators P^T A P, foretold from the patterns.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/transfer/sparse_matrix.hpp"
#include "wellspaced/algorithms/transfer/transfer.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The pattern of a linear finite element operator on a mesh: the diagonal and the edges.
SparsityPattern operator_pattern(const TriangleMesh& mesh);

/// The pattern of P^T A P. Requires: a is square, with as many rows as p.
/// progress: phase "measure", in columns of p.
/// Cost: the sum, over the entries of P^T, A and P that meet, in time.
SparsityPattern galerkin_pattern(const SparsityPattern& a, const SparsityPattern& p,
                                 const Progress& progress = {});

/// A level's operator: its entries, the mean and the largest number of them in a row.
struct OperatorSize {
  std::size_t entries = 0;
  double row_mean = 0;
  std::size_t row_max = 0;
};

/// The sizes of the operators of all levels: that of the finest mesh, then of the coarse ones.
/// transfers: as transfers_of() makes them. progress: phase "measure".
/// Cost: that of the products.
std::vector<OperatorSize> operator_sizes(const TriangleMesh& finest,
                                         std::span<const Transfer> transfers,
                                         const Progress& progress = {});

/// The entries of the operators of all levels by those of the finest: what a cycle costs by what a
/// smoothing step on the finest level costs. Requires: at least one level.
double operator_complexity(std::span<const OperatorSize> sizes);

}  // namespace wellspaced
