// Reading a whole file, or the standard input, into memory.
#pragma once

#include <cstdint>
#include <string>

#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The largest input that is read unless the caller says otherwise: 16 GiB.
inline constexpr std::uint64_t kLargestInput = std::uint64_t{1} << 34;

/// The bytes of the file `path`; "-" is the standard input.
/// Errors: kUnreadable if it is missing, a directory or cannot be read; kLimit if it holds more
/// than `largest` bytes; kCancelled if a signal breaks the reading off. Messages name the file.
/// Cost: the size of the file.
Result<std::string> read_input(const std::string& path, std::uint64_t largest = kLargestInput);

/// Whether `path` names something that can be opened as a file: it exists and is no directory.
bool file_exists(const std::string& path);

/// How messages call the input `path`: "<stdin>" for "-".
std::string display_name(const std::string& path);

}  // namespace wellspaced
