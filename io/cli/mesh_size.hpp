// The option --size of the command mesh.
#pragma once

#include <vector>

#include "wellspaced/io/cli/arguments.hpp"
#include "wellspaced/io/cli/session.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

/// One size everywhere, or sizes at the points of a background.
/// constant: 0 if there is none. sizes: one a point of the background; empty if there is none.
struct WantedSize {
  double constant = 0;
  Geometry background;
  std::vector<double> sizes;
};

/// What --size says: a number, or a file of points of that dimension whose first attribute is the
/// size. Neither if the option is not given.
/// Errors: kUsage for a number that is not positive, points without attributes or of another
/// dimension; those of reading the file.
Result<WantedSize> read_size(int dimension, const Arguments& arguments, Session& session);

}  // namespace wellspaced::cli
