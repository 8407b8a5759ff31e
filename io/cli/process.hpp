// The few things that the program asks of its operating system. The library never does.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace wellspaced::cli {

/// From now on the first Ctrl-C (SIGINT) or SIGTERM only sets the flag of interrupted(); a second
/// one kills as usual. A write to a closed pipe, or beyond the largest size of a file, becomes an
/// error.
void catch_interrupts();
bool interrupted();

/// Reads that block are broken off in `seconds`, and again and again after that: they return
/// errors.
void break_off_reads_after(double seconds);
/// No longer.
void let_reads_block();

/// How a process ends that is out of time.
struct LastWords {
  std::string_view text;  ///< for the standard error; lives as long as the process
  int exit_code = 0;
};

/// Ends the process in `seconds`, whatever it does then, unless it is protected: so that a limit is
/// kept even where it is not asked for in time.
/// Requires: break_off_reads_after() fewer seconds than these; let_reads_block() calls it off.
void end_process_after(double seconds, LastWords words);
/// From now on it must not be cut off: files that are half written would stay.
void protect_process();

/// Lets allocations fail beyond `bytes`, where the system can.
void limit_memory(std::uint64_t bytes);

bool standard_error_is_terminal();

/// Resident memory now; 0 where the system does not tell.
std::uint64_t resident_bytes();
/// The most resident memory since reset_peak_resident(), or since the start where the system
/// cannot reset it.
std::uint64_t peak_resident_bytes();
void reset_peak_resident();

/// Processor time that the process has used, in seconds.
double cpu_seconds();
/// Time on a steady clock, in seconds.
double wall_seconds();

/// Gives memory that the process has freed back to the system, where it can: so that what is
/// resident is in use.
void release_free_memory();

/// `text` with control characters replaced by '?': one line, whatever a file name holds.
std::string printable(std::string_view text);

}  // namespace wellspaced::cli
