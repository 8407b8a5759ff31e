// Work shared among threads.
#pragma once

#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace wellspaced {

/// What different threads write should lie this far apart: processors fetch memory in lines.
inline constexpr std::size_t kCacheLine = 64;

/// Calls task(worker, i) once for every i below `count` and returns when all is done. Worker w does
/// i = w, w + workers, ... one after the other; worker 0 is the caller's thread, the others have
/// threads of their own, or the caller's where the system grants none.
/// Requires: workers > 0. Calls with different i do not write to the same memory.
/// Errors: an exception that a task throws (memory is exhausted) leaves from here.
template <class Task>
void run_parallel(unsigned workers, std::size_t count, const Task& task) {
  std::vector<std::exception_ptr> thrown(workers);
  const auto work = [&](unsigned worker) {
    for (std::size_t i = worker; i < count; i += workers) task(worker, i);
  };
#if defined(__cpp_exceptions)
  const auto work_safely = [&](unsigned worker) {
    try {
      work(worker);
    } catch (...) {
      thrown[worker] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  unsigned started = 1;
  try {
    threads.reserve(workers);
    for (; started < workers && started < count; ++started)
      threads.emplace_back(work_safely, started);
  } catch (const std::exception&) {
  }
  work_safely(0);
  for (; started < workers; ++started) work_safely(started);
#else
  std::vector<std::thread> threads;
  for (unsigned worker = 1; worker < workers && worker < count; ++worker)
    threads.emplace_back(work, worker);
  work(0);
#endif
  for (std::thread& thread : threads) thread.join();
#if defined(__cpp_exceptions)
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
#endif
}

}  // namespace wellspaced
