// The help of each command and its options tell the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace wellspaced {
namespace {

using test::run_program;

struct HelpLine {
  std::string option;
  bool takes_value = false;
};

bool is_in_option(char c) { return c == '-' || (c >= 'a' && c <= 'z'); }

// The options that the help of a command lists: "  --name VALUE   text".
std::vector<HelpLine> options_in(const std::string& help) {
  std::vector<HelpLine> options;
  for (std::size_t at = help.find("\n  -"); at != std::string::npos;
       at = help.find("\n  -", at + 1)) {
    std::size_t end = at + 3;
    while (is_in_option(help[end])) ++end;
    const bool takes_value = help[end] == ' ' && help[end + 1] != ' ';
    options.push_back({help.substr(at + 3, end - at - 3), takes_value});
  }
  return options;
}

std::set<std::string> names_of(const std::vector<HelpLine>& options) {
  std::set<std::string> names;
  for (const HelpLine& line : options) names.insert(line.option);
  return names;
}

// The options that a source file names: its string literals "--name".
std::set<std::string> options_named_in(const std::string& source) {
  std::set<std::string> names;
  for (std::size_t at = source.find("\"--"); at != std::string::npos;
       at = source.find("\"--", at + 1)) {
    std::size_t end = at + 1;
    while (is_in_option(source[end])) ++end;
    if (source[end] == '"' && end > at + 3) names.insert(source.substr(at + 1, end - at - 1));
  }
  return names;
}

std::string source_of(const std::string& name) {
  return test::read_bytes(std::string(test::kSourceDir) + "/io/cli/" + name);
}

// The commands and the files that read their options.
struct CommandSources {
  std::string command;
  std::vector<std::string> files;
};
const std::vector<CommandSources> kCommandSources = {
    {"generate", {"generate.cpp"}},
    {"triangulate", {"triangulate.cpp"}},
    {"predicate", {"predicate.cpp"}},
    {"mesh", {"mesh.cpp", "mesh_size.cpp", "mesh_space.cpp"}},
    {"coarsen", {"coarsen.cpp", "coarsen_request.cpp"}},
    {"audit", {"audit.cpp"}},
    {"reproduce", {"reproduce.cpp"}},
    {"convert", {"convert.cpp"}},
};

TEST(Help, KnowsEveryCommand) {
  const std::string help = run_program({"--help"}).out;
  for (const CommandSources& command : kCommandSources)
    EXPECT_NE(help.find("\n  " + command.command + " "), help.npos) << command.command;
  const std::size_t begin = help.find("commands:\n"), end = help.find("\n\n", begin);
  ASSERT_NE(end, help.npos);
  std::size_t commands = 0;
  for (std::size_t at = begin; at < end; at = help.find('\n', at + 1))
    commands += help.compare(at, 3, "\n  ") == 0 && help[at + 3] != ' ';
  EXPECT_EQ(commands, kCommandSources.size());
}

TEST(Help, ListsEveryOptionThatACommandReads) {
  for (const CommandSources& command : kCommandSources) {
    const std::set<std::string> listed =
        names_of(options_in(run_program({command.command, "--help"}).out));
    for (const std::string& file : command.files)
      for (const std::string& option : options_named_in(source_of(file)))
        EXPECT_TRUE(listed.contains(option)) << command.command << " " << option;
  }
}

TEST(Help, ListsNoOptionThatNobodyReads) {
  std::set<std::string> common = options_named_in(source_of("session.cpp"));
  common.merge(std::set<std::string>{"-o", "--help"});
  for (const CommandSources& command : kCommandSources) {
    std::string sources;
    for (const std::string& file : command.files) sources += source_of(file);
    for (const auto& [option, takes_value] :
         options_in(run_program({command.command, "--help"}).out)) {
      const std::string literal = '"' + option + '"';
      const std::size_t declared = sources.find(literal);
      const bool is_read =
          declared != sources.npos && sources.find(literal, declared + 1) != sources.npos;
      EXPECT_TRUE(is_read || common.contains(option)) << command.command << " " << option;
    }
  }
}

// Without its operands a command complains of them, but not of the options.
TEST(Help, SaysOfEveryOptionWhetherItTakesAValue) {
  for (const CommandSources& command : kCommandSources)
    for (const auto& [option, takes_value] :
         options_in(run_program({command.command, "--help"}).out)) {
      if (option == "--help") continue;
      std::vector<std::string> words = {command.command, option};
      if (takes_value) words.push_back("1");
      const auto run = run_program(words);
      EXPECT_EQ(run.exit_code, 2);
      EXPECT_NE(run.err.find("operands"), run.err.npos) << option << ": " << run.err;
      const auto with_equals = run_program({command.command, option + "=1"});
      EXPECT_EQ(with_equals.err.find("takes no value") == run.err.npos, takes_value) << option;
    }
}

TEST(Help, TellsTheExitCodesOfEachCommand) {
  for (const CommandSources& command : kCommandSources) {
    const std::string help = run_program({command.command, "--help"}).out;
    for (const char* code :
         {"0 ok", "2 usage", "3 unreadable", "4 invalid", "5 a limit", "6 intern"})
      EXPECT_NE(help.find(code), help.npos) << command.command;
  }
}

}  // namespace
}  // namespace wellspaced
