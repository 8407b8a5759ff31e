// SHA-256 (FIPS 180-4): to compare large results by one line.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace wellspaced {

/// Hashes bytes as they come.
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// The hash of all bytes added, as 64 lower-case hexadecimal digits. Ends the object's use.
  std::string finish();

 private:
  void take(std::uint8_t byte);
  void mix_block();

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::uint64_t length_ = 0;  // in bytes
};

/// The hash of `bytes`.
inline std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.finish();
}

}  // namespace wellspaced
