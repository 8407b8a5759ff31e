// Files that appear together or not at all.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A set of outputs. add() writes each beside its place, under a name of its own; commit() moves
/// all of them into place. Without commit() nothing of them remains: no half-written file and no
/// new directory, whatever fails.
///
/// The standard output ("-") and what is no regular file (a device, a pipe) cannot be moved: their
/// bytes wait in memory for commit().
class OutputSet {
 public:
  /// progress: told by add(), which it may cancel; commit() takes its time.
  explicit OutputSet(Progress progress = {});
  ~OutputSet();
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  /// Lets `write` produce the file `path`. A file that is there is replaced at commit(), and keeps
  /// its permissions; a symbolic link is followed.
  /// Errors: kUsage if it cannot be created, or is in the set already; kLimit if the disk is full;
  /// kCancelled.
  [[gnu::cold]] Status add(const std::string& path, const std::function<void(TextWriter&)>& write);

  /// Makes the directory `path`, parents included, unless it is there.
  /// Errors: kUsage if that cannot be done.
  [[gnu::cold]] Status make_directory(const std::string& path);

  /// Whether the standard output is in the set.
  bool uses_standard_output() const;

  /// Publishes the set and empties it. The standard output and devices come first: if they fail,
  /// no file has changed.
  /// Errors: kLimit if a write fails; kUsage if a file cannot be moved into place.
  [[gnu::cold]] Status commit();

  /// For a signal handler that is about to end the process: removes what would remain of the set.
  /// Returns false, and does nothing, while files are being opened, moved or removed: ask again.
  /// After true the set is of no use any more: whoever touches it waits for ever.
  /// Allocates nothing.
  bool abandon();

 private:
  struct Output;
  class Change;
  Status stage(Output& output, const std::function<void(TextWriter&)>& write);
  void remove_all();

  Progress progress_;
  std::vector<std::unique_ptr<Output>> outputs_;
  std::vector<std::string> new_directories_;  // parents first
  std::atomic_flag changing_ = ATOMIC_FLAG_INIT;
};

}  // namespace wellspaced
