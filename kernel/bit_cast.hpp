// The bits of a value as another type, also where the standard library is too old to say so.
#pragma once

#include <bit>

namespace wellspaced {

#if defined(__cpp_lib_bit_cast)
using std::bit_cast;
#else
// Emscripten 3.1's library; its compiler has what it takes.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}
#endif

}  // namespace wellspaced
