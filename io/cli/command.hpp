// What a sub-command is. Each lives in a file of its own and is listed once, in commands.cpp.
#pragma once

#include <span>
#include <string_view>

#include "wellspaced/io/cli/arguments.hpp"
#include "wellspaced/io/cli/session.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

/// The exit codes of the program. Other codes follow from errors: exit_code().
inline constexpr int kExitOk = 0;
inline constexpr int kExitViolation = 1;
inline constexpr int kExitLimit = 5;

int exit_code(ErrorCode code);

/// Says which file an error of the library is about.
Error in_file(const Error& error, const std::string& path);

struct Command {
  std::string_view name;
  std::string_view operands;  ///< as the help shows them: "IN OUT"
  std::string_view summary;   ///< one line
  std::size_t least_operands = 0;
  std::size_t most_operands = 0;
  std::span<const Option> options;  ///< beside the common ones
  /// Returns the exit code; what the session has collected is then published. On an error
  /// nothing is.
  Result<int> (*run)(Arguments& arguments, Session& session) = nullptr;
};

/// All commands, in the order in which the help lists them.
std::span<const Command* const> commands();

}  // namespace wellspaced::cli
