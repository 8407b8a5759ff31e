// Decompression of zlib data (RFC 1950, 1951), as VTU files hold their arrays.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace wellspaced {

/// The `size` bytes that a zlib stream holds.
/// Returns: nothing if it is malformed, holds another number of bytes or fails its checksum.
/// Nothing is allocated for a size that deflate cannot reach from so few bytes (1032 to 1).
std::optional<std::string> inflate(std::string_view zlib, std::size_t size);

}  // namespace wellspaced
