// What the comparison tables share: interleaved CPU times, medians, and peak memory of a child.
#pragma once

#include <malloc.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace wellspaced::bench {

inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double wall_seconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The CPU seconds of one call.
template <class Call>
double timed(Call&& call) {
  const double start = cpu_seconds();
  call();
  return cpu_seconds() - start;
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A figure in kB from /proc/self/status, in bytes; -1 where there is none.
inline double status_bytes(const char* key) {
  std::FILE* file = std::fopen("/proc/self/status", "r");
  double kilobytes = -1. / 1024;
  char line[256];
  while (file != nullptr && std::fgets(line, sizeof line, file) != nullptr)
    if (std::strncmp(line, key, std::strlen(key)) == 0)
      kilobytes = std::atof(line + std::strlen(key));
  if (file != nullptr) std::fclose(file);
  return 1024 * kilobytes;
}

/// Lets the peak of the resident set start again from its present size.
inline void reset_peak() {
  if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
    std::fputs("5", file);
    std::fclose(file);
  }
}

/// By how many bytes the peak resident set exceeds the present one during call(make()), in a child
/// process of its own that makes the input itself. To be asked before this process has freed much,
/// since freed memory may be used again without showing.
template <class Make, class Call>
double peak_growth(Make&& make, Call&& call) {
  int ends[2];
  if (pipe(ends) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    const auto input = make();
    reset_peak();
    const double before = status_bytes("VmRSS:");
    call(input);
    const double growth = status_bytes("VmHWM:") - before;
    const bool written = write(ends[1], &growth, sizeof growth) == sizeof growth;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  double growth = -1;
  if (read(ends[0], &growth, sizeof growth) != sizeof growth) growth = -1;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return growth;
}

/// From now on this process keeps the memory that it frees, large blocks too: what runs again finds
/// its pages there and does not pay the system for them.
inline void keep_freed_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

/// Prints the wall time of two threads as a ratio to that of one: medians of interleaved runs. It
/// says nothing while other programs use the cores.
/// build(threads): what so many threads make. are_same(a, b): whether two of these are. reach: what
/// is said of the ratio.
template <class Build, class AreSame>
void print_two_threads(int runs, const char* reach, Build&& build, AreSame&& are_same) {
  std::vector<double> seconds[2];
  decltype(build(1u)) made[2];
  for (int run = 0; run < runs; ++run) {
    for (const unsigned threads : {1u, 2u}) {
      made[threads - 1] = {};
      const double start = wall_seconds();
      made[threads - 1] = build(threads);
      seconds[threads - 1].push_back(wall_seconds() - start);
    }
  }
  const double one = median(seconds[0]), two = median(seconds[1]);
  std::printf("two threads: %.3f s of wall time to %.3f s of one: %.2f%s, bytes %s\n", two, one,
              two / one, reach, are_same(made[0], made[1]) ? "the same" : "DIFFERENT");
}

}  // namespace wellspaced::bench
