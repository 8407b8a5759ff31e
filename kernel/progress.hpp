// Progress and cancellation through long operations.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace wellspaced {

/// Called now and then with the name of the phase and how much of it is done; returns false to
/// cancel, upon which the operation returns ErrorCode::kCancelled and leaves its input as it was.
/// total: 0 where it is not known; otherwise at least `done`.
/// An empty function means: nobody listens.
///
/// Some functions that return plain values take one as well. Once it has said stop, what they
/// return is unfinished, and of no use: the caller, who knows, drops it.
using Progress =
    std::function<bool(std::string_view phase, std::uint64_t done, std::uint64_t total)>;

/// Tells `progress` if there is one. Returns false if the caller wants to stop.
inline bool report(const Progress& progress, std::string_view phase, std::uint64_t done,
                   std::uint64_t total) {
  return !progress || progress(phase, done, total);
}

/// An operation in equal parts, told in one phase; the parts may tell how far they are. Once the
/// answer was to stop, nobody is asked again.
class ProgressParts {
 public:
  /// Requires: progress outlives the object, and that what part() returns.
  ProgressParts(const Progress& progress, std::string_view phase, std::uint64_t parts)
      : progress_(progress), phase_(phase), parts_(parts) {}

  /// Tells that so many parts are done. Returns false if the caller wants to stop.
  bool go_on(std::uint64_t parts) { return tell(parts, 0, 1); }
  bool stopped() const { return stopped_; }

  /// For the part of that number, from 0, and for one at a time.
  Progress part(std::uint64_t number) {
    if (!progress_) return {};
    return [this, number](std::string_view, std::uint64_t done, std::uint64_t total) {
      return tell(number, done, total);
    };
  }

 private:
  bool tell(std::uint64_t number, std::uint64_t done, std::uint64_t total) {
    constexpr double kUnits = 1024;  // of a part
    const double within = total == 0 ? 0 : static_cast<double>(done) / static_cast<double>(total);
    const auto units = [](double parts) { return static_cast<std::uint64_t>(kUnits * parts); };
    stopped_ = stopped_ || !report(progress_, phase_, units(static_cast<double>(number) + within),
                                   units(static_cast<double>(parts_)));
    return !stopped_;
  }

  const Progress& progress_;
  std::string_view phase_;
  std::uint64_t parts_;
  bool stopped_ = false;
};

/// Asks in the course of a loop: at every so many steps, and not again once the answer was to stop.
/// Steps that need no answer cost an addition and a comparison.
class ProgressMeter {
 public:
  /// total: steps to come; 0 where that is not known. interval: steps between two questions, best
  /// some milliseconds of work.
  /// Requires: progress outlives the meter.
  ProgressMeter(const Progress& progress, std::string_view phase, std::uint64_t total,
                std::uint64_t interval = 1 << 14)
      : progress_(progress),
        phase_(phase),
        total_(total),
        interval_(interval),
        next_(progress ? interval : UINT64_MAX) {}

  /// To be called for every step, or for several at once. Returns false if the caller wants to
  /// stop: then the loop ends at once.
  bool step(std::uint64_t steps = 1) {
    done_ += steps;
    if (done_ >= next_) ask();
    return !stopped_;
  }
  bool stopped() const { return stopped_; }

 private:
  void ask() {
    if (stopped_) return;
    next_ = done_ + interval_;
    const bool within = total_ == 0 || done_ <= total_;
    stopped_ = !progress_(phase_, within ? done_ : total_, total_);
  }

  const Progress& progress_;
  std::string_view phase_;
  std::uint64_t total_, interval_, next_, done_ = 0;
  bool stopped_ = false;
};

}  // namespace wellspaced
