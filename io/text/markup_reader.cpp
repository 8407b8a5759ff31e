#include "wellspaced/io/text/markup_reader.hpp"

#include <algorithm>

namespace wellspaced {
namespace {

constexpr std::string_view kMarkupBlanks = " \t\r\n";

// The length of the tag at the beginning of `text`, up to and with its '>'; 0 if there is none.
std::size_t tag_length(std::string_view text) {
  if (text.substr(0, 4) == "<!--") {
    const std::size_t end = text.find("-->", 4);
    return end == std::string_view::npos ? 0 : end + 3;
  }
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote == 0 && text[i] == '>') return i + 1;
    if (quote != 0 && text[i] == quote) {
      quote = 0;
    } else if (quote == 0 && (text[i] == '"' || text[i] == '\'')) {
      quote = text[i];
    }
  }
  return 0;
}

}  // namespace

std::optional<std::string_view> MarkupTag::attribute(std::string_view key) const {
  std::string_view rest = attributes;
  for (;;) {
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(kMarkupBlanks)));
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos) return {};
    std::string_view found = rest.substr(0, equals);
    found = found.substr(0, found.find_last_not_of(kMarkupBlanks) + 1);
    rest.remove_prefix(equals + 1);
    const std::size_t open = rest.find_first_of("\"'");
    if (open == std::string_view::npos) return {};
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == std::string_view::npos) return {};
    if (found == key) return rest.substr(open + 1, close - open - 1);
    rest.remove_prefix(close + 1);
  }
}

void MarkupReader::pass(std::size_t count) {
  const std::string_view passed = rest_.substr(0, count);
  line_ += static_cast<std::uint64_t>(std::count(passed.begin(), passed.end(), '\n'));
  rest_.remove_prefix(passed.size());
}

std::optional<MarkupTag> MarkupReader::next_tag() {
  for (;;) {
    pass(std::min(rest_.size(), rest_.find('<')));
    const std::size_t length = tag_length(rest_);
    if (length == 0) return {};
    std::string_view inside = rest_.substr(1, length - 2);
    MarkupTag tag;
    tag.line = line_;
    pass(length);
    if (inside.empty() || inside[0] == '/' || inside[0] == '?' || inside[0] == '!') continue;
    tag.empty = inside.back() == '/';
    if (tag.empty) inside.remove_suffix(1);
    tag.name = inside.substr(0, inside.find_first_of(kMarkupBlanks));
    tag.attributes = inside.substr(tag.name.size());
    return tag;
  }
}

}  // namespace wellspaced
