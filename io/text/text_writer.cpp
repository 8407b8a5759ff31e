#include "wellspaced/io/text/text_writer.hpp"

#include <array>
#include <cerrno>
#include <charconv>

namespace wellspaced {
namespace {

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
  if (failed()) return *this;
  buffer_ += text;
  if (buffer_.size() >= pass_on_at_) pass_on();
  return *this;
}

TextWriter& TextWriter::operator<<(char c) { return *this << std::string_view(&c, 1); }

void TextWriter::pass_on() {
  if (!report(progress_, "write", passed_ + buffer_.size(), 0)) error_ = ECANCELED;
  flush();
  pass_on_at_ = buffer_.size() + kPiece;
}

TextWriter& TextWriter::operator<<(double value) {
  if (failed()) return *this;
  std::array<char, 32> space{};
  return *this << to_text(value, space);
}

TextWriter& TextWriter::append_integer(std::int64_t value) {
  if (failed()) return *this;
  std::array<char, 32> space{};
  return *this << to_text(value, space);
}

void TextWriter::comment(std::string_view mark, std::string_view text) {
  if (!text.empty()) *this << mark << ' ' << text << '\n';
}

bool TextWriter::flush() {
  if (stream_ == nullptr || failed()) return !failed();
  errno = 0;
  const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), stream_) == buffer_.size() &&
                       std::fflush(stream_) == 0;
  if (!written) error_ = errno != 0 ? errno : EIO;
  passed_ += buffer_.size();
  buffer_.clear();
  return !failed();
}

}  // namespace wellspaced
