// Runs the built program and keeps what it says.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_directory.hpp"

namespace wellspaced::test {

struct ProgramRun {
  int exit_code = -1;  // -1: ended by a signal
  std::string out, err;
};

/// Starts the program with `words`, its standard streams in files of `directory`, and
/// returns the number of the process.
inline pid_t start_program(const TemporaryDirectory& directory,
                           const std::vector<std::string>& words, const std::string& input) {
  std::vector<const char*> arguments = {kProgram};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  arguments.push_back(nullptr);
  const std::string out = directory / "out", err = directory / "err";
  const pid_t child = fork();
  if (child != 0) return child;
  dup2(open(input.c_str(), O_RDONLY), STDIN_FILENO);
  dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  execv(kProgram, const_cast<char* const*>(arguments.data()));
  _exit(127);
}

inline ProgramRun wait_for_program(const TemporaryDirectory& directory, pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(directory / "out"),
          read_bytes(directory / "err")};
}

/// Runs the program where no file may grow beyond `bytes`, as on a disk that fills up.
inline ProgramRun run_program_on_full_disk(const std::vector<std::string>& words,
                                           std::uint64_t bytes) {
  const TemporaryDirectory directory;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{bytes, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  const pid_t child = start_program(directory, words, "/dev/null");  // inherits the limit
  setrlimit(RLIMIT_FSIZE, &before);
  return wait_for_program(directory, child);
}

/// Runs the program to its end, with `input` on its standard input.
inline ProgramRun run_program(const std::vector<std::string>& words, std::string_view input = "") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("in", input);
  return wait_for_program(directory, start_program(directory, words, file));
}

}  // namespace wellspaced::test
