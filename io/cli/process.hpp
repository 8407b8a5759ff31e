// The few things that the program asks of its operating system. The library never does.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "wellspaced/io/files/output_set.hpp"

namespace wellspaced::cli {

/// From now on the first Ctrl-C (SIGINT) or SIGTERM only sets the flag of interrupted(), and breaks
/// off reads that block: they return errors; a second one kills as usual. A write to a closed pipe,
/// or beyond the largest size of a file, becomes an error.
void catch_interrupts();
bool interrupted();

/// How a process ends that does not stop in time when it is asked to: by force, whatever it does.
/// out_of_time, interrupted: lines for the standard error, at the time limit and after Ctrl-C.
/// outputs: abandoned first, so that nothing half-written stays; live until call_off_deadline().
struct LastWords {
  std::string out_of_time, interrupted;
  int exit_code = 0;
  OutputSet* outputs = nullptr;
};

/// From now on the process ends by force some tenths of a second after Ctrl-C.
/// Requires: no other thread sets or calls off at the same time; so for the next two.
void set_last_words(LastWords words);
/// In `ask` seconds, and again and again after that, reads that block are broken off; after that,
/// in time to be gone in `force` seconds, the process ends by force. Requires: ask <= force.
void set_deadline(double ask, double force);
/// No longer: what the process does now, it may finish.
void call_off_deadline();

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

}  // namespace wellspaced::cli
