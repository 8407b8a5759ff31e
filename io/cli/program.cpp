// Finds the command, parses its options, runs it, and turns errors into exit codes.
#include "wellspaced/io/cli/program.hpp"

#include <algorithm>
#include <cstdio>

#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/process.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/memory.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::size_t kHelpColumn = 28;
constexpr const char* kExitCodes =
    "Exit codes: 0 ok, 1 the audit found a violation, 2 usage, 3 unreadable input,\n"
    "4 invalid geometry, 5 a limit was hit, 6 internal error.\n";

std::string padded(std::string text) {
  if (text.size() < kHelpColumn) return concat({text, std::string(kHelpColumn - text.size(), ' ')});
  return concat({text, '\n', std::string(kHelpColumn, ' ')});
}

std::string help_of(std::span<const Option> options) {
  std::string text;
  for (const Option& option : options) {
    std::string head = concat({"  ", option.name});
    if (!option.value.empty()) append(head, {' ', option.value});
    append(text, {padded(head), option.help, '\n'});
  }
  return text;
}

std::string help_of(const Command& command) {
  std::string text = concat({"usage: wellspaced ", command.name, ' ', command.operands,
                             " [options]\n", command.summary, "\n"});
  if (!command.options.empty()) append(text, {"\noptions:\n", help_of(command.options)});
  return concat({text, "\ncommon options:\n", help_of(common_options()), '\n', kExitCodes});
}

std::string help_of_program() {
  std::string text =
      "usage: wellspaced COMMAND [INPUT] [options]\n"
      "Well-spaced points and well-shaped meshes.\n\ncommands:\n";
  for (const Command* command : commands())
    append(text,
           {padded(concat({"  ", command->name, ' ', command->operands})), command->summary, '\n'});
  return concat({text,
                 "\nwellspaced COMMAND --help lists the options of a command; --version prints the "
                 "version.\n",
                 kExitCodes});
}

const Command* find_command(std::string_view name) {
  const auto all = commands();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Command* command) { return command->name == name; });
  return found == all.end() ? nullptr : *found;
}

int print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return std::fflush(stdout) == 0 ? kExitOk : kExitLimit;
}

int complain(const Error& error) {
  std::fprintf(stderr, "wellspaced: %s\n", printable(error.message).c_str());
  return exit_code(error.code);
}

Error usage(const Command& command, const std::string& message) {
  return {ErrorCode::kUsage, {command.name, ": ", message}};
}

Status check_operands(const Command& command, const Arguments& arguments) {
  const std::size_t count = arguments.operands().size();
  if (count >= command.least_operands && count <= command.most_operands) return Ok{};
  return usage(command, concat({"takes ", command.operands, ", but ", count,
                                " operands are given; see --help"}));
}

int run(const Command& command, std::span<const std::string> words) {
  auto arguments = Arguments::parse(command.options, words);
  if (!arguments) return complain(usage(command, arguments.error().message));
  if (arguments->has("--help")) return print(help_of(command));
  CommonOptions options = read_common_options(*arguments);
  if (Status status = check_operands(command, *arguments); !status) return complain(status.error());
  if (Status status = arguments->status(); !status)
    return complain(usage(command, status.error().message));
  Session session(std::move(options));
  const Result<int> code = command.run(*arguments, session);
  if (!code) return complain(session.explain(code.error()));
  if (Status status = session.finish(); !status) return complain(session.explain(status.error()));
  return *code;
}

int run(std::span<const std::string> words) {
  if (words.empty()) {
    std::fputs(help_of_program().c_str(), stderr);
    return exit_code(ErrorCode::kUsage);
  }
  if (words[0] == "--help" || words[0] == "-h" || words[0] == "help")
    return print(help_of_program());
  if (words[0] == "--version") return print("wellspaced " WELLSPACED_VERSION "\n");
  if (const Command* command = find_command(words[0])) return run(*command, words.subspan(1));
  return complain(
      {ErrorCode::kUsage, {"unknown command ", in_quotes(words[0]), "; see wellspaced --help"}});
}

}  // namespace

int run_program(std::span<const std::string> words) {
  const Result<int> code = within_memory([&] { return Result<int>(run(words)); });
  if (code) return *code;
  std::fputs(
      "wellspaced: out of memory; nothing was written; raise --max-memory or use a smaller "
      "input\n",
      stderr);
  return exit_code(code.error().code);
}

}  // namespace wellspaced::cli
