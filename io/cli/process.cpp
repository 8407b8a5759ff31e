#include "wellspaced/io/cli/process.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>

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

#if WELLSPACED_POSIX
timespec last_moment{};
LastWords last_words;
volatile std::sig_atomic_t ends_at_last_moment = 0;

bool has_passed(timespec time) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec > time.tv_sec || (now.tv_sec == time.tv_sec && now.tv_nsec >= time.tv_nsec);
}

// A read that begins after the signal would block all the same: the alarm breaks it off, if need
// be again and again.
extern "C" void break_off_reads(int) {
  if (interrupt_flag != 0) alarm(1);
  if (ends_at_last_moment == 0 || !has_passed(last_moment)) return;
  const auto ignored = write(STDERR_FILENO, last_words.text.data(), last_words.text.size());
  static_cast<void>(ignored);
  _exit(last_words.exit_code);
}
extern "C" void set_interrupt_flag(int) {
  interrupt_flag = 1;
  alarm(1);
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

bool interrupted() { return interrupt_flag != 0; }

#if WELLSPACED_POSIX

void catch_interrupts() {
  struct sigaction action {};  // without SA_RESTART: a blocked read returns
  action.sa_handler = break_off_reads;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = set_interrupt_flag;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void break_off_reads_after(double seconds) {
  const auto whole = static_cast<time_t>(std::min(seconds, 1e8));
  const auto micro = static_cast<suseconds_t>(1e6 * (std::min(seconds, 1e8) - double(whole))) + 1;
  const itimerval timer{{0, 20000}, {whole, std::min<suseconds_t>(micro, 999999)}};
  setitimer(ITIMER_REAL, &timer, nullptr);
}

void end_process_after(double seconds, LastWords words) {
  clock_gettime(CLOCK_MONOTONIC, &last_moment);
  const double since_second = 1e-9 * double(last_moment.tv_nsec) + std::min(seconds, 1e8);
  const auto whole = static_cast<time_t>(since_second);
  last_moment.tv_sec += whole;
  last_moment.tv_nsec = static_cast<long>(1e9 * (since_second - double(whole)));
  last_words = words;
  ends_at_last_moment = 1;
}

void protect_process() { ends_at_last_moment = 0; }

void let_reads_block() {
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
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
void break_off_reads_after(double) {}
void end_process_after(double, LastWords) {}
void protect_process() {}
void let_reads_block() {}
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

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  return result;
}

}  // namespace wellspaced::cli
