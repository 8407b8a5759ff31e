// The words of a command line, parsed against the options that a command declares.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

/// An option of a command. `value` names what follows it in the help; empty: nothing does.
struct Option {
  enum class Times { kOnce, kAnyNumber };
  std::string_view name;  ///< "--beta"
  std::string_view value;
  std::string_view help;  ///< one line
  Times times = Times::kOnce;
};

/// The values that a number may have.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_is_legal = true;
};
constexpr Range at_least(double low) { return {low, Range{}.high, true}; }
constexpr Range more_than(double low) { return {low, Range{}.high, false}; }
constexpr Range between(double low, double high) { return {low, high, true}; }

/// The options that every command has.
std::span<const Option> common_options();

/// The options and operands given. The typed getters check what they read; the first complaint
/// sticks in status(), so that a command reads all its options and asks once. They are cold: who
/// calls them is compiled for size.
class Arguments {
 public:
  /// Understands "--name value" and "--name=value"; "--" ends the options; "-" is an operand.
  /// Errors: kUsage for an option that is in neither list, that lacks its value or that is given
  /// twice and may not be.
  static Result<Arguments> parse(std::span<const Option> options,
                                 std::span<const std::string> words);

  const std::vector<std::string>& operands() const { return operands_; }
  [[gnu::cold]] bool has(std::string_view name) const;
  /// The value of the option, if it is given.
  [[gnu::cold]] std::optional<std::string> value(std::string_view name) const;
  /// All values of a repeatable option, in order.
  [[gnu::cold]] std::vector<std::string> values(std::string_view name) const;
  [[gnu::cold]] std::string text(std::string_view name, std::string_view otherwise) const;

  [[gnu::cold]] double number(std::string_view name, double otherwise, Range range = {});
  [[gnu::cold]] std::int64_t integer(std::string_view name, std::int64_t otherwise, Range range);
  /// Which of `names` is given.
  [[gnu::cold]] std::size_t choice(std::string_view name, std::size_t otherwise,
                                   std::initializer_list<std::string_view> names);
  /// A comma-separated list of numbers; empty if the option is not given.
  [[gnu::cold]] std::vector<double> numbers(std::string_view name, Range range = {});
  /// Lets a command complain about a value itself.
  [[gnu::cold]] void refuse(std::string_view name, std::string_view complaint);

  /// kUsage with the first complaint, if there was one.
  [[gnu::cold]] Status status() const;

 private:
  double checked_number(std::string_view name, std::string_view text, Range range);

  std::vector<std::string> operands_;
  std::vector<std::pair<std::string, std::string>> given_;
  std::optional<Error> complaint_;
};

/// The words of a list separated by commas; a word may be empty.
std::vector<std::string> words_of(const std::string& list);

}  // namespace wellspaced::cli
