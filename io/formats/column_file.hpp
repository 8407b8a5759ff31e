// A column of numbers in a file: one value for each node of a mesh.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Reads one number a line, as many as `count`; # starts a comment.
/// Errors: kUnreadable where the file cannot be read, or holds more or fewer.
Result<std::vector<double>> read_column(const std::string& path, std::size_t count);

}  // namespace wellspaced
