#include "wellspaced/io/cli/arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wellspaced/io/text/numbers.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::array kCommonOptions = {
    Option{"-o", "FILE|DIR", "where the result goes; - is the standard output"},
    Option{"--format", "NAME", "format of the result, where its name does not tell"},
    Option{"--json", "FILE|-", "write what was done and measured as JSON"},
    Option{"--seed", "N", "seed of everything random (default 1)"},
    Option{"--threads", "N", "threads to use at most; results never depend on it (default 1)"},
    Option{"--time-limit", "S", "stop after S seconds (exit code 5)"},
    Option{"--max-memory", "MB", "use no more than MB megabytes (exit code 5)"},
    Option{"--quiet", "", "no table, no notes, no progress bar"},
    Option{"--help", "", "print this help"},
};

Error usage(std::string message) { return {ErrorCode::kUsage, std::move(message)}; }

const Option* find(std::span<const Option> options, std::string_view name) {
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const Option& option) { return option.name == name; });
  return found == options.end() ? nullptr : &*found;
}

std::string_view long_name(std::string_view name) {
  if (name == "--output") return "-o";
  if (name == "-h") return "--help";
  return name;
}

bool is_option(std::string_view word) { return word.size() > 1 && word[0] == '-'; }

std::string describe(Range range) {
  const std::string low = shortest(range.low), high = shortest(range.high);
  if (std::isinf(range.high)) return concat({range.low_is_legal ? "at least " : "more than ", low});
  return concat({"between ", low, " and ", high});
}

bool contains(Range range, double value) {
  return std::isfinite(value) && value <= range.high &&
         (range.low_is_legal ? value >= range.low : value > range.low);
}

}  // namespace

std::span<const Option> common_options() { return kCommonOptions; }

Result<Arguments> Arguments::parse(std::span<const Option> options,
                                   std::span<const std::string> words) {
  Arguments result;
  bool options_end = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (options_end || !is_option(word)) {
      result.operands_.push_back(word);
      continue;
    }
    if (word == "--") {
      options_end = true;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name(long_name(std::string_view(word).substr(0, equals)));
    const Option* option = find(options, name);
    if (option == nullptr) option = find(kCommonOptions, name);
    if (option == nullptr)
      return usage(concat({"unknown option ", in_quotes(name), "; see --help"}));
    if (option->times == Option::Times::kOnce && result.has(name))
      return usage(concat({name, " is given twice"}));
    std::string value;
    if (option->value.empty()) {
      if (equals != std::string::npos) return usage(concat({name, " takes no value"}));
    } else if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else {
      if (++i == words.size()) return usage(concat({name, " needs a value: ", option->value}));
      value = words[i];
    }
    result.given_.emplace_back(name, std::move(value));
  }
  return result;
}

bool Arguments::has(std::string_view name) const { return value(name).has_value(); }

std::optional<std::string> Arguments::value(std::string_view name) const {
  for (const auto& [given, value] : given_)
    if (given == name) return value;
  return {};
}

std::vector<std::string> Arguments::values(std::string_view name) const {
  std::vector<std::string> result;
  for (const auto& [given, value] : given_)
    if (given == name) result.push_back(value);
  return result;
}

std::string Arguments::text(std::string_view name, std::string_view otherwise) const {
  return value(name).value_or(std::string(otherwise));
}

double Arguments::checked_number(std::string_view name, std::string_view text, Range range) {
  const auto [value, status] = parse_number(text);
  if (status != NumberStatus::kOk) {
    refuse(name, concat({in_quotes(text), " is not a number"}));
  } else if (!contains(range, value)) {
    refuse(name, concat({in_quotes(text), " should be ", describe(range)}));
  }
  return value;
}

double Arguments::number(std::string_view name, double otherwise, Range range) {
  const auto given = value(name);
  return given ? checked_number(name, *given, range) : otherwise;
}

std::int64_t Arguments::integer(std::string_view name, std::int64_t otherwise, Range range) {
  const auto given = value(name);
  if (!given) return otherwise;
  const auto integer = parse_integer(*given);
  if (!integer) {
    refuse(name, concat({in_quotes(*given), " is not an integer"}));
  } else if (!contains(range, static_cast<double>(*integer))) {
    refuse(name, concat({in_quotes(*given), " should be ", describe(range)}));
  }
  return integer.value_or(otherwise);
}

std::size_t Arguments::choice(std::string_view name, std::size_t otherwise,
                              std::initializer_list<std::string_view> names) {
  const auto given = value(name);
  if (!given) return otherwise;
  const auto found = std::find(names.begin(), names.end(), *given);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string list;
  for (const std::string_view legal : names) append(list, {list.empty() ? "" : ", ", legal});
  refuse(name, concat({in_quotes(*given), " is none of ", list}));
  return otherwise;
}

std::vector<double> Arguments::numbers(std::string_view name, Range range) {
  std::vector<double> result;
  const auto given = value(name);
  if (!given) return result;
  std::string_view rest = *given;
  for (;;) {
    const std::size_t comma = rest.find(',');
    result.push_back(checked_number(name, rest.substr(0, comma), range));
    if (comma == std::string_view::npos) return result;
    rest.remove_prefix(comma + 1);
  }
}

void Arguments::refuse(std::string_view name, std::string_view complaint) {
  if (!complaint_) complaint_ = usage(concat({name, ": ", complaint}));
}

Status Arguments::status() const {
  if (complaint_) return *complaint_;
  return Ok{};
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    words.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

}  // namespace wellspaced::cli
