#include "wellspaced/io/text/text_writer.hpp"

#include <array>
#include <cerrno>
#include <charconv>

namespace wellspaced {
namespace {

constexpr std::size_t kFlushAt = std::size_t{1} << 20;

template <class T>
std::string_view to_text(T value, std::array<char, 32>& space) {
  const auto [end, code] = std::to_chars(space.data(), space.data() + space.size(), value);
  return {space.data(), static_cast<std::size_t>(end - space.data())};
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 32> space{};
  return std::string(to_text(value, space));
}

TextWriter& TextWriter::operator<<(std::string_view text) {
  buffer_ += text;
  if (stream_ != nullptr && buffer_.size() >= kFlushAt) flush();
  return *this;
}

TextWriter& TextWriter::operator<<(double value) {
  std::array<char, 32> space{};
  return *this << to_text(value, space);
}

TextWriter& TextWriter::append_integer(std::int64_t value) {
  std::array<char, 32> space{};
  return *this << to_text(value, space);
}

void TextWriter::comment(std::string_view mark, std::string_view text) {
  if (!text.empty()) *this << mark << ' ' << text << '\n';
}

bool TextWriter::flush() {
  if (stream_ == nullptr) return true;
  errno = 0;
  const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), stream_) == buffer_.size() &&
                       std::fflush(stream_) == 0;
  if (!written && error_ == 0) error_ = errno != 0 ? errno : EIO;
  buffer_.clear();
  return !failed();
}

}  // namespace wellspaced
