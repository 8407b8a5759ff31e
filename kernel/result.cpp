#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

Error::Error() = default;
Error::Error(ErrorCode c, TextPiece m) : Error(c, {m}) {}
Error::Error(ErrorCode c, TextPiece m, std::vector<Index> i) : Error(c, {m}, std::move(i)) {}
Error::Error(ErrorCode c, std::initializer_list<TextPiece> m) : code(c), message(concat(m)) {}
Error::Error(ErrorCode c, std::initializer_list<TextPiece> m, std::vector<Index> i)
    : code(c), message(concat(m)), ids(std::move(i)) {}

Error::Error(const Error&) = default;
Error::Error(Error&&) noexcept = default;
Error& Error::operator=(const Error&) = default;
Error& Error::operator=(Error&&) noexcept = default;
Error::~Error() = default;

Error cancelled() { return {ErrorCode::kCancelled, "cancelled"}; }

}  // namespace wellspaced
