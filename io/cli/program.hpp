// The program, but for the process around it.
#pragma once

#include <span>
#include <string>

namespace wellspaced::cli {

/// Runs the command that `words` name and returns the exit code. Errors, running out of memory
/// among them, are one line on the standard error.
int run_program(std::span<const std::string> words);

}  // namespace wellspaced::cli
