#include "wellspaced/kernel/concat.hpp"

#include <array>
#include <charconv>
#include <cstdio>

namespace wellspaced {
namespace {

template <class Number>
void append_digits(std::string& text, Number number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

void append_real(std::string& text, double real) {
#ifdef __cpp_lib_to_chars
  append_digits(text, real);
#else  // libc++ does not promise it: more digits than need be
  std::array<char, 32> digits;
  std::snprintf(digits.data(), digits.size(), "%.17g", real);
  text += digits.data();
#endif
}

}  // namespace

void TextPiece::append_to(std::string& text) const {
  switch (kind_) {
    case Kind::kWords:
      text += words_;
      return;
    case Kind::kString:
      text += *string_;
      return;
    case Kind::kLiteral:
      text += literal_;
      return;
    case Kind::kLetter:
      text += letter_;
      return;
    case Kind::kSigned:
      return append_digits(text, signed_);
    case Kind::kUnsigned:
      return append_digits(text, unsigned_);
    case Kind::kReal:
      return append_real(text, real_);
  }
}

void append(std::string& text, std::initializer_list<TextPiece> pieces) {
  for (const TextPiece& piece : pieces) piece.append_to(text);
}

std::string concat(std::initializer_list<TextPiece> pieces) {
  std::string text;
  append(text, pieces);
  return text;
}

}  // namespace wellspaced
