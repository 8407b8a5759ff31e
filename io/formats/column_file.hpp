// A column of numbers in a file: one value for each node of a mesh.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Reads one number a line, as many as `count`; # starts a comment.
/// Errors: kUnreadable where the file cannot be read, or holds more or fewer.
Result<std::vector<double>> read_column(const std::string& path, std::size_t count,
                                        const Progress& progress = {});

/// What the first line of a packing's spacing says, a comment: "# packing by lfs, beta 10", or "by
/// size" where something else than the local feature size lowered it.
struct PackingMark {
  bool is_by_lfs = false;
  double beta = 0;
};

/// Writes such a file: the mark, then one value a line. Errors: those of OutputSet::add().
Status write_spacing(OutputSet& outputs, const std::string& path, std::span<const double> values,
                     const PackingMark& mark);

/// The mark of the file, if there is such a file and it has one.
std::optional<PackingMark> read_packing_mark(const std::string& path);

/// The name of the file that holds the spacing of a set of Triangle's files: X.spacing.
std::string spacing_beside(const std::string& path);

}  // namespace wellspaced
