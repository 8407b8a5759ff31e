// Progress and cancellation through long operations.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace wellspaced {

/// Called now and then with the name of the phase and how much of it is done; returns false to
/// cancel, upon which the operation returns ErrorCode::kCancelled and leaves its input as it was.
/// total: 0 where it is not known; otherwise at least `done`.
/// An empty function means: nobody listens.
using Progress =
    std::function<bool(std::string_view phase, std::uint64_t done, std::uint64_t total)>;

/// Tells `progress` if there is one. Returns false if the caller wants to stop.
inline bool report(const Progress& progress, std::string_view phase, std::uint64_t done,
                   std::uint64_t total) {
  return !progress || progress(phase, done, total);
}

}  // namespace wellspaced
