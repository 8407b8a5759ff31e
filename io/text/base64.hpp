// Base64 (RFC 4648), as VTU files carry their arrays.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wellspaced {

/// The bytes in base64, padded with '='.
std::string base64(std::string_view bytes);

/// The bytes that base64 text stands for; several padded texts may follow each other.
/// Returns: nothing if a character is none of base64's or a group of four is incomplete.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace wellspaced
