#include "wellspaced/io/cli/session.hpp"

#include <algorithm>
#include <cstdio>

#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/process.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

constexpr auto kDrawInterval = std::chrono::milliseconds(100);
constexpr auto kMemoryInterval = std::chrono::milliseconds(5);  // to read it takes a hundredth
constexpr double kMegabyte = 1e6;

// What does not stop in time is ended by force, to be gone after this part of its time limit.
constexpr double kForce = 1.04;

// What is asked to stop does so a little below the limit; what allocates beyond it, before it is
// asked again, fails a little above: there is room in between to end in good order. Both lie within
// a tenth of the limit.
constexpr std::uint64_t soft_limit(std::uint64_t bytes) { return bytes - bytes / 16; }
constexpr std::uint64_t hard_limit(std::uint64_t bytes) { return bytes + bytes / 24; }

std::string bar_text(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  constexpr std::uint64_t kWidth = 30;
  const double part =
      total == 0 ? 0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  const auto filled = static_cast<std::size_t>(part * kWidth);
  std::string text = "[";
  text.append(filled, '#').append(kWidth - filled, ' ').append("] ");
  return concat({text, static_cast<int>(part * 100), "% ", phase});
}

}  // namespace

CommonOptions read_common_options(Arguments& arguments) {
  CommonOptions options;
  options.output = arguments.text("-o", "");
  options.format = arguments.text("--format", "");
  options.json = arguments.text("--json", "");
  options.seed = static_cast<std::uint64_t>(arguments.integer("--seed", 1, at_least(0)));
  options.threads = static_cast<unsigned>(arguments.integer("--threads", 1, between(1, 1024)));
  if (arguments.has("--time-limit"))
    options.time_limit = arguments.number("--time-limit", 0, more_than(0));
  if (arguments.has("--max-memory"))
    options.max_memory = static_cast<std::uint64_t>(
        kMegabyte * arguments.number("--max-memory", 0, between(1, 1e9)));
  options.quiet = arguments.has("--quiet");
  for (const std::string_view name : {"-o", "--json"})
    if (arguments.has(name) && arguments.text(name, "").empty()) arguments.refuse(name, "is empty");
  if (options.output == "-" && options.json == "-")
    arguments.refuse("--json", "the standard output takes one of -o and --json");
  return options;
}

Session::Session(CommonOptions options)
    : options_(std::move(options)), outputs_(writing()), start_(Clock::now()) {
  draws_ = !options_.quiet && standard_error_is_terminal();
  if (options_.max_memory) limit_memory(hard_limit(*options_.max_memory));
  say_what_stays("nothing was written");
  if (options_.time_limit) set_deadline(*options_.time_limit, kForce * *options_.time_limit);
}

Session::~Session() {
  call_off_deadline();
  clear_bar();
}

OutputSet& Session::outputs() {
  time_to_write_ = memory_to_write_ = 0;
  return outputs_;
}

void Session::say_what_stays(std::string outcome) {
  outcome_ = std::move(outcome);
  set_last_words({concat({"wellspaced: ", sentence(StopReason::kTimeLimit, ""), '\n'}),
                  concat({"wellspaced: ", sentence(StopReason::kInterrupted, ""), '\n'}),
                  kExitLimit, &outputs_});
}

ReadOptions Session::reading(Siblings siblings) {
  return {.siblings = siblings, .largest = largest_input(), .progress = progress()};
}

Progress Session::progress() {
  return [this](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    return keep_going(phase, done, total);
  };
}

Progress Session::writing() {
  time_to_write_ = memory_to_write_ = 0;
  return [this](auto, std::uint64_t done, auto) { return keep_writing(done); };
}

bool Session::keep_going(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  stopped_ = find_reason();
  if (!stopped_ && is_short_of_memory()) stopped_ = StopReason::kMemoryLimit;
  phase_ = phase;
  if (stopped_) return false;
  if (draws_ && Clock::now() - last_drawn_ >= kDrawInterval) draw_bar(phase, done, total);
  return true;
}

// Once a limit was hit, there is time to write what was finished by then.
bool Session::keep_writing(std::uint64_t done) {
  if (!stopped_ || stopped_ == StopReason::kInterrupted) return keep_going("write", done, 0);
  return !interrupted();
}

std::optional<StopReason> Session::find_reason() const {
  if (interrupted()) return StopReason::kInterrupted;
  if (options_.time_limit && elapsed() > *options_.time_limit - time_to_write_)
    return StopReason::kTimeLimit;
  return {};
}

bool Session::is_short_of_memory() {
  const Clock::time_point now = Clock::now();
  if (!options_.max_memory || now - memory_read_ < kMemoryInterval) return false;
  memory_read_ = now;
  const auto limit = static_cast<double>(soft_limit(*options_.max_memory));
  return static_cast<double>(resident_bytes()) > (1 - memory_to_write_) * limit;
}

double Session::elapsed() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Session::draw_bar(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  last_drawn_ = Clock::now();
  bar_shows_ = true;
  std::fprintf(stderr, "\r\033[K%s", bar_text(phase, done, total).c_str());
  std::fflush(stderr);
}

void Session::clear_bar() {
  if (bar_shows_) std::fputs("\r\033[K", stderr);
  bar_shows_ = false;
}

Status Session::write_json(const JsonWriter& json) {
  if (!wants_json()) return Ok{};
  return outputs().add(options_.json, [&](TextWriter& out) { out << json.text() << '\n'; });
}

void Session::note(std::string_view text) {
  if (options_.quiet) return;
  clear_bar();
  std::fprintf(stderr, "wellspaced: note: %s\n", printable(text).c_str());
}

Status Session::finish() {
  clear_bar();
  if (interrupted()) return explain({ErrorCode::kCancelled, ""});
  call_off_deadline();  // all is there: it may appear
  if (!options_.quiet && !report_.empty() && !outputs_.uses_standard_output())
    if (Status status = outputs().add("-", [&](TextWriter& out) { out << report_; }); !status)
      return status;
  return outputs_.commit();
}

std::string Session::sentence(StopReason reason, std::string_view in_phase) const {
  const std::string outcome = concat({in_phase, "; ", outcome_});
  switch (reason) {
    case StopReason::kInterrupted:
      return concat({"interrupted", outcome});
    case StopReason::kTimeLimit:
      return concat({"the time limit was reached", outcome, "; raise --time-limit"});
    case StopReason::kMemoryLimit:
      return concat({"the memory limit was reached", outcome, "; raise --max-memory"});
  }
  return {};
}

Error Session::explain(Error error) const {
  const std::string in_phase = phase_.empty() ? "" : concat({" while it did: ", phase_});
  if (interrupted()) return {ErrorCode::kCancelled, sentence(StopReason::kInterrupted, in_phase)};
  const auto reason = stopped_ ? stopped_ : find_reason();
  if (error.code != ErrorCode::kCancelled || !reason) return error;
  return {ErrorCode::kLimit, sentence(*reason, in_phase)};
}

}  // namespace wellspaced::cli
