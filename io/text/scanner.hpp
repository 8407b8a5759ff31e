// A reader of line-oriented text in memory: fields between blanks, comments, exact positions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// How the lines of a format are to be understood.
struct ScanRules {
  char comment = '#';         ///< begins one; 0: there are none
  char blank = ' ';           ///< separates fields, beside white space
  bool across_lines = false;  ///< a field that the present line lacks is looked for in the next
};

/// Walks through the lines of a text. A comment runs from # to the end of its line; empty lines
/// are skipped; fields are separated by blanks (space, tab, CR, form feed). A byte order mark and
/// a missing last newline are legal. ScanRules change the first two of these.
///
/// The first failure sticks: from then on next_line() is false and every field reads as 0, so a
/// parser may read a whole line before it asks ok(). The error names file and line.
class Scanner {
 public:
  /// Requires: `text` outlives the scanner. kCancelled sticks where the source says stop.
  Scanner(std::string_view text, const TextSource& source, ScanRules rules = {});

  /// Moves to the next line that holds a field. False at the end and after a failure.
  bool next_line();
  /// The same, but the end of the text is a failure: `what` was expected.
  bool require_line(std::string_view what);
  /// The same for one of `count` lines with a record each, which `what` names in the plural.
  bool next_record(Index count, std::string_view what);
  /// Moves to the next line, whatever it holds: for formats where an empty line means something.
  bool next_line_or_empty();
  /// Whether another field follows: on the line, or in the text if fields go across lines.
  bool more();
  /// Whether another field follows on the line.
  bool more_on_line();
  /// Whether a comment ends the present line.
  bool has_comment() const { return has_comment_; }
  /// How many fields the rest of the line holds.
  std::size_t count_fields() const;

  /// The next field as a finite number. Fails if there is none; kInvalidGeometry for NaN and
  /// infinities. `what` names the field in the message.
  double number(std::string_view what);
  /// The next field as a number, be it infinite or none (NaN).
  double any_number(std::string_view what);
  /// The next field as an integer.
  std::int64_t integer(std::string_view what);
  /// The next field as an integer, or `otherwise` if the line ends here.
  std::int64_t integer_or(std::int64_t otherwise, std::string_view what);
  /// The next field as a marker: an int.
  int marker();
  /// The next field as it stands. "0" if there is none, which is a failure.
  std::string_view word(std::string_view what);
  void skip_fields(std::size_t count);
  /// What is left of the present line, without blanks at its ends; the fields there are passed.
  std::string_view rest_of_line();
  /// The bytes that follow the present line. Fails, and is empty, where fewer than `count` do.
  std::string_view bytes_after_line(std::uint64_t count, std::string_view what);

  /// The next field as the number of records that follow, each with at least `fields` fields.
  Index count(std::string_view what, std::uint64_t fields);
  /// The next field as the number of one of `points` points, the first of which has number `base`:
  /// counted from 0. kInvalidGeometry if there is no such point.
  Index point(std::size_t points, Index base);

  /// Fails unless `records` records of at least `fields` fields each can follow in what is left of
  /// the text: so nobody allocates for a count that the file cannot keep.
  bool has_room_for(std::uint64_t records, std::uint64_t fields, std::string_view what);

  bool ok() const { return !error_.has_value(); }
  /// Requires: !ok().
  const Error& error() const { return *error_; }
  /// Records a failure at the present line, unless there is one already.
  [[gnu::cold]] void fail(ErrorCode code, std::initializer_list<TextPiece> message);
  void fail(ErrorCode code, TextPiece message) { fail(code, {message}); }

  const std::string& file() const { return source_.name; }
  std::uint64_t line_number() const { return line_number_; }

 private:
  std::string_view field();
  std::string_view required_field(std::string_view what);
  double to_number(std::string_view token, std::string_view what);
  void fail_field(ErrorCode code, std::string_view what, std::string_view token,
                  std::string_view complaint);

  void report_place();

  TextSource source_;
  ScanRules rules_;
  std::size_t size_;
  std::string_view rest_;  // what follows the present line
  std::string_view line_;  // what is left of the present line
  std::uint64_t line_number_ = 0;
  bool has_comment_ = false;
  std::optional<Error> error_;
};

/// `token` for a message: quoted, cut after 24 bytes, unprintable bytes in hexadecimal.
std::string in_quotes(std::string_view token);

/// `text` with control characters replaced by '?': one line, whatever a file name holds.
std::string printable(std::string_view text);

}  // namespace wellspaced
