// What happens when memory runs out.
#pragma once

#include <new>
#include <stdexcept>
#include <type_traits>

#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Calls `operation`, which returns a Result, and returns its result, or kLimit if memory ran out
/// in it.
///
/// The library throws nothing itself, but the standard containers in it do when memory runs out:
/// std::bad_alloc then leaves any function that allocates. All is unwound on its way: no memory or
/// file is lost, and arguments passed by reference to const are as they were. Who wants a value in
/// place of the exception calls through here; the C interface and the program always do.
///
/// Where the library is compiled without exceptions (-fno-exceptions) running out of memory ends
/// the program, by std::terminate() or as the std::new_handler of the program says.
template <class Operation>
auto within_memory(const Operation& operation) -> std::invoke_result_t<Operation> {
#if defined(__cpp_exceptions)
  try {
    return operation();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {  // more elements than a container can ever hold
  }
  return Error{ErrorCode::kLimit, "out of memory", {}};  // short enough to need none
#else
  return operation();
#endif
}

}  // namespace wellspaced
