// Sparse matrices as files that solvers read.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "wellspaced/algorithms/transfer/sparse_matrix.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A file format for matrices. name: as on the command line. bytes: the file, for a matrix within
/// the limits of write_matrix.
struct MatrixFormat {
  std::string_view name, extension, about;
  std::string (*bytes)(const SparseMatrix& matrix);
};

/// mtx: MatrixMarket coordinate text, numbers exact and 1-based.
/// petsc: PETSc's binary file of an AIJ matrix, 32-bit indices, big-endian (MatLoad).
/// npz: SciPy's scipy.sparse.save_npz of a CSR matrix, 32-bit indices, not compressed.
std::span<const MatrixFormat> matrix_formats();

/// The format of that name, or null.
const MatrixFormat* find_matrix_format(std::string_view name);

/// Writes a matrix to `path`.
/// Errors: kLimit for 2^28 entries, or 2^31 rows or columns, and more; those of OutputSet::add().
Status write_matrix(OutputSet& outputs, const std::string& path, const MatrixFormat& format,
                    const SparseMatrix& matrix);

}  // namespace wellspaced
