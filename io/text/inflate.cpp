#include "wellspaced/io/text/inflate.hpp"
#include "wellspaced/kernel/concat.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wellspaced {
namespace {

constexpr int kLongestCode = 15;

// A canonical Huffman code: how many codes there are of each length, and the symbols in order.
class HuffmanCode {
 public:
  /// False if the lengths claim more codes than there are.
  bool build(std::span<const std::uint8_t> lengths) {
    counts_ = {};
    for (const std::uint8_t length : lengths) ++counts_[length];
    counts_[0] = 0;
    int left = 1;
    for (int length = 1; length <= kLongestCode; ++length) {
      left = 2 * left - counts_[static_cast<std::size_t>(length)];
      if (left < 0) return false;
    }
    std::array<int, kLongestCode + 2> next{};
    for (std::size_t length = 1; length <= kLongestCode; ++length)
      next[length + 1] = next[length] + counts_[length];
    symbols_.assign(lengths.size(), 0);
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
      if (lengths[symbol] != 0)
        symbols_[static_cast<std::size_t>(next[lengths[symbol]]++)] = static_cast<int>(symbol);
    return true;
  }

  const std::array<int, kLongestCode + 1>& counts() const { return counts_; }
  int symbol(int i) const { return symbols_[static_cast<std::size_t>(i)]; }

 private:
  std::array<int, kLongestCode + 1> counts_{};
  std::vector<int> symbols_;
};

class Inflater {
 public:
  Inflater(std::string_view in, std::size_t size) : in_(in), size_(size) { out_.reserve(size); }

  std::optional<std::string> run();

 private:
  bool block();
  bool stored_block();
  bool dynamic_codes();
  void fixed_codes();
  bool compressed_block();
  bool copy(int symbol);
  int bits(int count);
  int decode(const HuffmanCode& code);

  std::string_view in_;
  std::size_t at_ = 0;
  std::uint32_t held_ = 0;  // bits that are read but not used, the next one lowest
  int held_count_ = 0;
  bool good_ = true;
  bool last_ = false;
  std::size_t size_;
  std::string out_;
  HuffmanCode literals_, distances_;
};

// 0 and a failure where the data end.
int Inflater::bits(int count) {
  while (held_count_ < count) {
    if (at_ == in_.size()) return good_ = false, 0;
    held_ |= std::uint32_t{static_cast<unsigned char>(in_[at_++])} << held_count_;
    held_count_ += 8;
  }
  const auto value = static_cast<int>(held_ & ((1u << count) - 1));
  held_ >>= count;
  held_count_ -= count;
  return value;
}

int Inflater::decode(const HuffmanCode& code) {
  int value = 0, first = 0, index = 0;
  for (std::size_t length = 1; length <= kLongestCode && good_; ++length) {
    value |= bits(1);
    const int count = code.counts()[length];
    if (value - count < first) return code.symbol(index + value - first);
    index += count;
    first = 2 * (first + count);
    value *= 2;
  }
  return good_ = false, 0;
}

bool Inflater::stored_block() {
  held_ = 0;
  held_count_ = 0;
  if (in_.size() - at_ < 4) return false;
  const auto byte = [&](std::size_t i) {
    return std::size_t{static_cast<unsigned char>(in_[at_ + i])};
  };
  const std::size_t length = byte(0) | byte(1) << 8, complement = byte(2) | byte(3) << 8;
  at_ += 4;
  if ((length ^ complement) != 0xFFFF || length > in_.size() - at_ || length > size_ - out_.size())
    return false;
  out_ += in_.substr(at_, length);
  at_ += length;
  return true;
}

void Inflater::fixed_codes() {
  std::array<std::uint8_t, 288> lengths;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
  literals_.build(lengths);
  std::array<std::uint8_t, 30> fives;
  fives.fill(5);
  distances_.build(fives);
}

bool Inflater::dynamic_codes() {
  constexpr std::array<std::size_t, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};
  const auto literals = static_cast<std::size_t>(bits(5)) + 257;
  const auto distances = static_cast<std::size_t>(bits(5)) + 1;
  const auto codes = static_cast<std::size_t>(bits(4)) + 4;
  if (!good_ || literals > 286 || distances > 30) return false;
  std::array<std::uint8_t, 19> code_lengths{};
  for (std::size_t i = 0; i < codes; ++i)
    code_lengths[kOrder[i]] = static_cast<std::uint8_t>(bits(3));
  HuffmanCode code;
  if (!good_ || !code.build(code_lengths)) return false;
  std::vector<std::uint8_t> lengths;
  while (good_ && lengths.size() < literals + distances) {
    const int symbol = decode(code);
    if (symbol < 16) {
      lengths.push_back(static_cast<std::uint8_t>(symbol));
      continue;
    }
    if (symbol == 16 && lengths.empty()) return false;
    const std::uint8_t repeated = symbol == 16 ? lengths.back() : std::uint8_t{0};
    const int times = symbol == 16 ? 3 + bits(2) : symbol == 17 ? 3 + bits(3) : 11 + bits(7);
    lengths.insert(lengths.end(), static_cast<std::size_t>(times), repeated);
  }
  if (!good_ || lengths.size() != literals + distances || lengths[256] == 0) return false;
  const std::span all(lengths);
  return literals_.build(all.first(literals)) && distances_.build(all.subspan(literals));
}

// A piece of what is there already, as long and as far back as the symbol says.
bool Inflater::copy(int symbol) {
  constexpr std::array<int, 29> kLengths = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                            15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                            67, 83, 99, 115, 131, 163, 195, 227, 258};
  constexpr std::array<int, 29> kLengthBits = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                               2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
  constexpr std::array<int, 30> kDistances = {
      1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
      193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
  const auto s = static_cast<std::size_t>(symbol - 257);
  if (s >= kLengths.size()) return false;
  const auto length = static_cast<std::size_t>(kLengths[s] + bits(kLengthBits[s]));
  const auto d = static_cast<std::size_t>(decode(distances_));
  if (!good_ || d >= kDistances.size()) return false;
  const int distance_bits = d < 2 ? 0 : static_cast<int>(d / 2) - 1;
  const auto distance = static_cast<std::size_t>(kDistances[d] + bits(distance_bits));
  if (!good_ || distance > out_.size() || length > size_ - out_.size()) return false;
  for (std::size_t i = 0; i < length; ++i) out_ += out_[out_.size() - distance];
  return true;
}

bool Inflater::compressed_block() {
  for (;;) {
    const int symbol = decode(literals_);
    if (!good_) return false;
    if (symbol == 256) return true;
    if (symbol < 256) {
      if (out_.size() == size_) return false;
      out_ += static_cast<char>(symbol);
    } else if (!copy(symbol)) {
      return false;
    }
  }
}

bool Inflater::block() {
  last_ = bits(1) == 1;
  switch (bits(2)) {
    case 0:
      return good_ && stored_block();
    case 1:
      fixed_codes();
      return compressed_block();
    case 2:
      return dynamic_codes() && compressed_block();
    default:
      return false;
  }
}

std::optional<std::string> Inflater::run() {
  while (!last_)
    if (!block() || !good_) return {};
  if (out_.size() != size_) return {};
  return std::move(out_);
}

std::uint32_t adler32(std::string_view bytes) {
  constexpr std::uint32_t kPrime = 65521;
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % kPrime;
    b = (b + a) % kPrime;
  }
  return b << 16 | a;
}

std::uint32_t big_endian_32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

std::optional<std::string> inflate(std::string_view zlib, std::size_t size) {
  constexpr std::size_t kHeader = 2, kChecksum = 4, kBestRatio = 1032;
  if (zlib.size() < kHeader + kChecksum || size / kBestRatio > zlib.size()) return {};
  const std::uint32_t head =
      big_endian_32(concat({std::string_view("\0\0", 2), zlib.substr(0, 2)}));
  const bool deflated = (head >> 8 & 15) == 8 && head % 31 == 0 && (head & 32) == 0;
  if (!deflated) return {};
  auto bytes = Inflater(zlib.substr(kHeader, zlib.size() - kHeader - kChecksum), size).run();
  if (!bytes || adler32(*bytes) != big_endian_32(zlib.substr(zlib.size() - kChecksum))) return {};
  return bytes;
}

}  // namespace wellspaced
