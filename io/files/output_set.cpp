#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/kernel/concat.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace wellspaced {

namespace fs = std::filesystem;

struct OutputSet::Output {
  std::string path;       // as the caller named it
  std::string target;     // where it goes, links followed
  std::string temporary;  // where it is written; empty: it waits in `text`
  std::string text;
};

// While one lives, abandon() finds the files and their names as they may be found together.
class OutputSet::Change {
 public:
  explicit Change(OutputSet& set) : set_(set) {
    while (set_.changing_.test_and_set()) {
    }
  }
  ~Change() { set_.changing_.clear(); }
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;

 private:
  OutputSet& set_;
};

namespace {

std::string describe(int error_number) { return std::generic_category().message(error_number); }

Error cannot_create(const std::string& path, const std::string& why) {
  return {ErrorCode::kUsage, {path, ": cannot create: ", why}};
}

Error cannot_write(const std::string& path, int error_number) {
  const std::string name = path == "-" ? "<stdout>" : path;
  if (error_number == ECANCELED) return {ErrorCode::kCancelled, {name, ": writing was cancelled"}};
  return {ErrorCode::kLimit, {name, ": cannot write: ", describe(error_number)}};
}

bool waits_in_memory(const std::string& path) {
  std::error_code error;
  return path == "-" || (fs::exists(path, error) && !fs::is_regular_file(path, error));
}

std::string follow_links(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

struct CloseStream {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, CloseStream>;

// Returns 0, or the errno of what failed last.
int close_stream(Stream stream) { return std::fclose(stream.release()) == 0 ? 0 : errno; }

// Opens a new file beside `target`, called `name`. Returns null, with errno, if none can be made.
Stream open_beside(const std::string& target, std::string& name) {
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries; ++i) {
    std::string candidate = concat({target, ".part", i});
    Stream file(std::fopen(candidate.c_str(), "wbx"));
    if (file) name = std::move(candidate);
    if (file || errno != EEXIST) return file;
  }
  return nullptr;
}

void keep_permissions(const std::string& from, const std::string& to) {
  std::error_code error;
  const fs::file_status status = fs::status(from, error);
  if (fs::exists(status)) fs::permissions(to, status.permissions(), error);
}

Status write_stream(const std::string& path, std::FILE* stream, std::string_view bytes) {
  TextWriter writer(stream);
  writer << bytes;
  if (writer.flush()) return Ok{};
  return cannot_write(path, writer.error());
}

Status write_in_place(const std::string& path, std::string_view bytes) {
  if (path == "-") return write_stream(path, stdout, bytes);
  Stream stream(std::fopen(path.c_str(), "wb"));
  if (!stream) return cannot_create(path, describe(errno));
  const Status status = write_stream(path, stream.get(), bytes);
  const int close_error = close_stream(std::move(stream));
  return close_error == 0 || !status.ok() ? status : cannot_write(path, close_error);
}

}  // namespace

OutputSet::OutputSet(Progress progress) : progress_(std::move(progress)) {}
OutputSet::~OutputSet() {
  const Change change(*this);
  remove_all();
}

bool OutputSet::abandon() {
  if (changing_.test_and_set()) return false;
  remove_all();
  return true;
}

Status OutputSet::add(const std::string& path, const std::function<void(TextWriter&)>& write) {
  std::error_code error;
  if (path.empty()) return cannot_create("''", "the name is empty");
  if (fs::is_directory(path, error)) return cannot_create(path, "it is a directory");
  auto output = std::make_unique<Output>();
  output->path = path;
  output->target = path == "-" ? path : follow_links(path);
  for (const auto& other : outputs_)
    if (other->target == output->target) return cannot_create(path, "it is written already");
  Output& staged = *output;
  {
    const Change change(*this);
    outputs_.push_back(std::move(output));
  }
  return stage(staged, write);
}

Status OutputSet::stage(Output& output, const std::function<void(TextWriter&)>& write) {
  if (waits_in_memory(output.path)) {
    TextWriter writer(nullptr, progress_);
    write(writer);
    if (writer.failed()) return cannot_write(output.path, writer.error());
    output.text = writer.text();
    return Ok{};
  }
  Stream stream = [&] {
    const Change change(*this);
    return open_beside(output.target, output.temporary);
  }();
  if (!stream) return cannot_create(output.path, describe(errno));
  TextWriter writer(stream.get(), progress_);
  write(writer);
  writer.flush();
  const int close_error = close_stream(std::move(stream));
  const int failure = writer.failed() ? writer.error() : close_error;
  if (failure != 0) return cannot_write(output.path, failure);
  keep_permissions(output.target, output.temporary);
  return Ok{};
}

Status OutputSet::make_directory(const std::string& path) {
  std::error_code error;
  std::vector<std::string> missing;
  for (fs::path p = path; !p.empty() && !fs::exists(p, error); p = p.parent_path())
    missing.push_back(p.string());
  std::reverse(missing.begin(), missing.end());
  const Change change(*this);
  for (const std::string& directory : missing) {
    new_directories_.push_back(directory);
    if (!fs::create_directory(directory, error)) new_directories_.pop_back();
  }
  if (fs::is_directory(path, error)) return Ok{};
  return cannot_create(path, error ? error.message() : "it is no directory");
}

bool OutputSet::uses_standard_output() const {
  return std::any_of(outputs_.begin(), outputs_.end(),
                     [](const auto& output) { return output->path == "-"; });
}

Status OutputSet::commit() {
  for (const auto& output : outputs_) {
    if (!output->temporary.empty()) continue;
    if (Status status = write_in_place(output->path, output->text); !status) return status;
  }
  const Change change(*this);
  for (const auto& output : outputs_) {
    if (output->temporary.empty()) continue;
    if (std::rename(output->temporary.c_str(), output->target.c_str()) != 0)
      return cannot_create(output->path, describe(errno));
    output->temporary.clear();
  }
  outputs_.clear();
  new_directories_.clear();
  return Ok{};
}

// std::remove() and std::rename() need no memory: this works when it has run out.
void OutputSet::remove_all() {
  for (const auto& output : outputs_)
    if (!output->temporary.empty()) std::remove(output->temporary.c_str());
  for (auto directory = new_directories_.rbegin(); directory != new_directories_.rend();
       ++directory)
    std::remove(directory->c_str());  // fails, as it should, where somebody else put a file
}

}  // namespace wellspaced
