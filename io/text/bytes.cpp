#include "wellspaced/io/text/bytes.hpp"

namespace wellspaced {

void append_in_order(std::string& bytes, const void* number, std::size_t size, std::endian order) {
  const std::size_t begin = bytes.size();
  bytes.append(static_cast<const char*>(number), size);
  if (order != std::endian::native)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
}

}  // namespace wellspaced
