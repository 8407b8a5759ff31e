// Texts from pieces: words and numbers.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace wellspaced {

/// A piece of a text: words, or a number as a decimal that reads back the same: the shortest, but
/// for doubles with libc++. Requires: the words outlive the piece.
class TextPiece {
 public:
  TextPiece(std::string_view words) : kind_(Kind::kWords), words_(words) {}
  TextPiece(const std::string& words) : kind_(Kind::kString), string_(&words) {}
  TextPiece(const char* words) : kind_(Kind::kLiteral), literal_(words) {}
  TextPiece(char letter) : kind_(Kind::kLetter), letter_(letter) {}
  TextPiece(double real) : kind_(Kind::kReal), real_(real) {}
  TextPiece(std::signed_integral auto integer) : kind_(Kind::kSigned), signed_(integer) {}
  TextPiece(std::unsigned_integral auto integer) : kind_(Kind::kUnsigned), unsigned_(integer) {}
  TextPiece(bool) = delete;

  void append_to(std::string& text) const;

 private:
  enum class Kind { kWords, kString, kLiteral, kLetter, kSigned, kUnsigned, kReal };

  Kind kind_;
  union {
    std::string_view words_;
    const std::string* string_;
    const char* literal_;
    char letter_;
    std::int64_t signed_;
    std::uint64_t unsigned_;
    double real_;
  };
};

/// The pieces, one after the other: concat({"point ", 3, " of ", name}). Compiled once, where a
/// chain of + is compiled anew in every place.
std::string concat(std::initializer_list<TextPiece> pieces);

/// Adds the pieces to `text`, of which none may be a part.
void append(std::string& text, std::initializer_list<TextPiece> pieces);

}  // namespace wellspaced
