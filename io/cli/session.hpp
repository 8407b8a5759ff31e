// One run of a command: its outputs, its notes to the user, its limits, and Ctrl-C.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "wellspaced/io/cli/arguments.hpp"
#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

/// What the common options ask for.
struct CommonOptions {
  std::string output;  ///< -o, empty: not given
  std::string format;
  std::string json;  ///< --json, empty: not given
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::optional<double> time_limit;         ///< seconds
  std::optional<std::uint64_t> max_memory;  ///< bytes
  bool quiet = false;
};

/// Reads the common options; complaints stay in `arguments`.
CommonOptions read_common_options(Arguments& arguments);

/// Why a session asks the library to stop.
enum class StopReason { kInterrupted, kTimeLimit, kMemoryLimit };

/// Everything that a command says goes through its session: files and JSON appear only when the
/// command has succeeded.
class Session {
 public:
  explicit Session(CommonOptions options);
  ~Session();

  Session(const Session&) = delete;  // callbacks refer to it
  Session& operator=(const Session&) = delete;

  const CommonOptions& options() const { return options_; }
  /// Whoever asks for it is about to write, and has the whole time limit for that.
  OutputSet& outputs();
  /// How many bytes of one file may be read.
  std::uint64_t largest_input() const { return options_.max_memory.value_or(kLargestInput); }
  /// How to read a file: within that limit, and with this session's progress.
  ReadOptions reading(Siblings siblings = Siblings::kRead);

  /// To pass to the library: draws the bar, and stops at Ctrl-C and at the limits.
  Progress progress();
  /// The same for what is made to be written: once a limit was hit, there is time for that.
  Progress writing();
  /// Why progress() last said stop, if it did.
  std::optional<StopReason> stopped() const { return stopped_; }

  bool wants_json() const { return !options_.json.empty(); }
  /// Puts the JSON text, and a newline, where --json says.
  Status write_json(const JsonWriter& json);
  /// Tells the user the result, on the standard output: unless --quiet, or data go there.
  void print(std::string_view text) { report_ += text; }
  /// Tells the user something in passing, on the standard error: unless --quiet.
  void note(std::string_view text);

  /// For commands that write what is finished at a limit: stops them `seconds` before the time
  /// limit.
  void leave_time_to_write(double seconds) { time_to_write_ = seconds; }
  /// The same for memory: stops them when only this part of the memory limit is left, 0 to 1.
  void leave_memory_to_write(double part) { memory_to_write_ = part; }
  /// From now on says this of a command that is cut off, in place of "nothing was written".
  void say_what_stays(std::string outcome);

  /// Publishes the outputs, then the report. Refuses after Ctrl-C.
  Status finish();
  /// `error` as the user should see it: a cancelled operation names the limit.
  Error explain(Error error) const;

 private:
  bool keep_going(std::string_view phase, std::uint64_t done, std::uint64_t total);
  bool keep_writing(std::uint64_t done);
  std::string sentence(StopReason reason, std::string_view in_phase) const;
  std::optional<StopReason> find_reason() const;
  bool is_short_of_memory();
  double elapsed() const;
  void draw_bar(std::string_view phase, std::uint64_t done, std::uint64_t total);
  void clear_bar();

  using Clock = std::chrono::steady_clock;
  CommonOptions options_;
  OutputSet outputs_;
  std::string report_;
  std::string outcome_ = "nothing was written";
  Clock::time_point start_;
  double time_to_write_ = 0;    // seconds
  double memory_to_write_ = 0;  // a part of the limit
  Clock::time_point last_drawn_, memory_read_;
  bool draws_ = false;
  bool bar_shows_ = false;
  std::string phase_;
  std::optional<StopReason> stopped_;
};

}  // namespace wellspaced::cli
