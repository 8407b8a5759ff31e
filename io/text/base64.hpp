// Base64 (RFC 4648), as VTU files carry their arrays.
#pragma once

#include <string>
#include <string_view>

namespace wellspaced {

/// The bytes in base64, padded with '='.
std::string base64(std::string_view bytes);

}  // namespace wellspaced
