// The audit of an interpolation matrix between two levels of a hierarchy, whoever made it.
#pragma once

#include <span>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/algorithms/transfer/sparse_matrix.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Judges a prolongation: rows are the nodes of the finer level, columns those of the coarser.
/// parent: for each node of the coarser level its number in the finer one.
///   transfer_shape     (required) a column for each coarse node, their parents are rows, and the
///                      rows' ends ascend to the number of entries (violations: 1); if it is
///                      broken, the rest is not judged
///   transfer_columns   (required) the columns of a row are in range, ascending and different
///                      (node)
///   transfer_weights   (required) no entry is negative or no number (node)
///   transfer_row_sums  (required) the entries of a row add up to 1 within 2^-52 (node)
///   transfer_rank      (required) the row of a kept node is that of the identity, so the matrix
///                      has full column rank (node)
/// Measures: transfer_entries, transfer_row_max.
/// Cost: linear.
Report audit_transfer(const SparseMatrix& prolongation, std::span<const Index> parent);

}  // namespace wellspaced::audit
