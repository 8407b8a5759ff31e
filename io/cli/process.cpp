#include "wellspaced/io/cli/process.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <utility>

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#define WELLSPACED_POSIX 1
#else
#define WELLSPACED_POSIX 0
#endif

namespace wellspaced::cli {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

}  // namespace

bool interrupted() { return interrupt_flag != 0; }

namespace {

#if WELLSPACED_POSIX
constexpr double kReaction = 0.25;  // seconds that an interrupted process has to stop by itself
constexpr suseconds_t kAskAgain = 10'000;  // microseconds

timespec last_moment{};
LastWords last_words;
volatile std::sig_atomic_t has_last_moment = 0, has_last_words = 0;

timespec moment_in(double seconds) {
  timespec moment{};
  clock_gettime(CLOCK_MONOTONIC, &moment);
  const double since_second = 1e-9 * double(moment.tv_nsec) + std::min(seconds, 1e8);
  const auto whole = static_cast<time_t>(since_second);
  return {moment.tv_sec + whole, static_cast<long>(1e9 * (since_second - double(whole)))};
}

bool is_before(timespec a, timespec b) {
  return a.tv_sec < b.tv_sec || (a.tv_sec == b.tv_sec && a.tv_nsec < b.tv_nsec);
}

// A read that begins after a signal would block all the same: so it comes again and again.
void send_alarms_after(double seconds) {
  const double latest = std::min(seconds, 1e8);
  const auto whole = static_cast<time_t>(latest);
  const auto micro = static_cast<suseconds_t>(1e6 * (latest - double(whole))) + 1;
  const itimerval timer{{0, kAskAgain}, {whole, std::min<suseconds_t>(micro, 999'999)}};
  setitimer(ITIMER_REAL, &timer, nullptr);
}

// How long the system takes to take a process's memory back, about.
double seconds_to_free() {
#if defined(__APPLE__)
  constexpr double kUnit = 1;
#else
  constexpr double kUnit = 1024;
#endif
  constexpr double kSecondsPerByte = 1.2e-10;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return kSecondsPerByte * kUnit * static_cast<double>(usage.ru_maxrss);
}

// The handlers call what signal handlers may: system calls, and no memory is allocated.
extern "C" void end_at_last_moment(int) {
  if (has_last_moment == 0 || has_last_words == 0) return;
  if (is_before(moment_in(seconds_to_free()), last_moment)) return;
  if (!last_words.outputs->abandon()) return;  // the next alarm comes soon
  const std::string& text = interrupted() ? last_words.interrupted : last_words.out_of_time;
  const auto ignored = write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(ignored);
  _exit(last_words.exit_code);
}
extern "C" void set_interrupt_flag(int) {
  interrupt_flag = 1;
  const timespec moment = moment_in(kReaction);
  if (has_last_moment == 0 || is_before(moment, last_moment)) last_moment = moment;
  has_last_moment = 1;
  send_alarms_after(0);
}
#else
extern "C" void set_interrupt_flag(int) { interrupt_flag = 1; }
#endif

// A line "NAME:  123 kB" of /proc/self/status, in bytes.
std::uint64_t status_bytes(const char* format) {
  std::FILE* const file = std::fopen("/proc/self/status", "r");
  if (file == nullptr) return 0;
  char line[256];
  unsigned long long kilobytes = 0;
  while (std::fgets(line, sizeof line, file) != nullptr)
    if (std::sscanf(line, format, &kilobytes) == 1) break;
  std::fclose(file);
  return kilobytes * 1024;
}

}  // namespace

#if WELLSPACED_POSIX

void catch_interrupts() {
  struct sigaction action {};  // without SA_RESTART: a blocked read returns
  sigaddset(&action.sa_mask, SIGALRM);
  action.sa_handler = end_at_last_moment;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = set_interrupt_flag;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void set_last_words(LastWords words) {
  has_last_words = 0;
  last_words = std::move(words);
  has_last_words = 1;
}

void set_deadline(double ask, double force) {
  if (interrupted()) return;  // what comes then is sooner
  has_last_moment = 0;
  last_moment = moment_in(force);
  has_last_moment = 1;
  send_alarms_after(ask);
}

void call_off_deadline() {
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
  has_last_words = 0;
}

void limit_memory(std::uint64_t bytes) {
  const rlimit limit{static_cast<rlim_t>(bytes), static_cast<rlim_t>(bytes)};
  setrlimit(RLIMIT_DATA, &limit);
}

bool standard_error_is_terminal() { return isatty(STDERR_FILENO) == 1; }

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

#else

void catch_interrupts() {
  std::signal(SIGINT, set_interrupt_flag);
  std::signal(SIGTERM, set_interrupt_flag);
}
void set_last_words(LastWords) {}
void set_deadline(double, double) {}
void call_off_deadline() {}
void limit_memory(std::uint64_t) {}
bool standard_error_is_terminal() { return false; }
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

#endif

std::uint64_t resident_bytes() { return status_bytes("VmRSS: %llu"); }

std::uint64_t peak_resident_bytes() { return status_bytes("VmHWM: %llu"); }

void reset_peak_resident() {
  std::FILE* const file = std::fopen("/proc/self/clear_refs", "w");
  if (file == nullptr) return;
  std::fputs("5", file);
  std::fclose(file);
}

void release_free_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

double wall_seconds() {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  return now.count();
}

}  // namespace wellspaced::cli
