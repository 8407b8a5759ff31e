// A reader of the tags of an XML text, as far as VTU files need it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace wellspaced {

/// An opening tag: <name key="value" ...> or, empty, <name ... />.
struct MarkupTag {
  std::string_view name;
  std::string_view attributes;
  bool empty = false;
  std::uint64_t line = 0;

  /// The value of the attribute `key`, as it stands.
  std::optional<std::string_view> attribute(std::string_view key) const;
};

/// Walks through the opening tags. Comments, declarations and closing tags are passed over; nothing
/// is checked beyond that. Cost: linear in the text, for all calls together.
class MarkupReader {
 public:
  /// Requires: `text` outlives the reader.
  explicit MarkupReader(std::string_view text) : rest_(text) {}

  /// The next opening tag; nothing at the end, and where a tag does not end.
  std::optional<MarkupTag> next_tag();
  /// What stands between here and the next tag.
  std::string_view text() const { return rest_.substr(0, rest_.find('<')); }
  /// All that follows the last tag.
  std::string_view rest() const { return rest_; }
  bool at_end() const { return rest_.empty(); }
  std::uint64_t line() const { return line_; }

 private:
  void pass(std::size_t count);

  std::string_view rest_;
  std::uint64_t line_ = 1;
};

}  // namespace wellspaced
