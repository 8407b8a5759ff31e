// The one error vocabulary of the library: a value, or what was wrong with the data.
#pragma once

#include <cassert>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// What went wrong. The command line's exit codes follow from it.
enum class ErrorCode {
  kUsage,            ///< an option or argument is out of its documented range
  kUnreadable,       ///< a file is missing, truncated or malformed
  kInvalidGeometry,  ///< the data were read, but describe no valid mesh, domain or point set
  kLimit,            ///< a limit of time, memory, points or size was hit
  kCancelled,        ///< the caller's callback asked to stop
  kInternal          ///< a bug of ours: an invariant does not hold
};

/// Bad data, said once: a code, one line that names what to mend, and the offending items in the
/// caller's own numbering (0-based; what they number is said in the message).
struct Error {
  ErrorCode code = ErrorCode::kInternal;
  std::string message;
  std::vector<Index> ids;

  // Compiled once, not wherever a function may end with an error.
  Error();
  [[gnu::cold]] Error(ErrorCode c, TextPiece m);
  [[gnu::cold]] Error(ErrorCode c, TextPiece m, std::vector<Index> i);
  [[gnu::cold]] Error(ErrorCode c, std::initializer_list<TextPiece> m);
  [[gnu::cold]] Error(ErrorCode c, std::initializer_list<TextPiece> m, std::vector<Index> i);
  [[gnu::cold]] Error(const Error&);
  [[gnu::cold]] Error(Error&&) noexcept;
  Error& operator=(const Error&);
  Error& operator=(Error&&) noexcept;
  [[gnu::cold]] ~Error();
};

/// What an operation ends with when its caller said stop.
[[gnu::cold]] Error cancelled();

/// A T, or the Error that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Requires: ok().
  T& value() & { return assert(ok()), *std::get_if<0>(&state_); }
  const T& value() const& { return assert(ok()), *std::get_if<0>(&state_); }
  T&& value() && { return assert(ok()), std::move(*std::get_if<0>(&state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// Requires: !ok().
  const Error& error() const { return assert(!ok()), *std::get_if<1>(&state_); }

 private:
  std::variant<T, Error> state_;
};

/// The result of an operation that returns nothing but may fail.
struct Ok {};
using Status = Result<Ok>;

}  // namespace wellspaced
