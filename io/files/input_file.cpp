#include "wellspaced/io/files/input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace wellspaced {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadPiece = std::size_t{1} << 20;

Error unreadable(const std::string& path, const std::string& why) {
  return {ErrorCode::kUnreadable, {display_name(path), ": cannot read: ", why}};
}

Error broken_off(const std::string& path, int error_number) {
  if (error_number == EINTR)
    return {ErrorCode::kCancelled, {display_name(path), ": reading was cancelled"}};
  return unreadable(path, std::generic_category().message(error_number));
}

Error too_large(const std::string& path, std::uint64_t largest) {
  return {ErrorCode::kLimit,
          {display_name(path), ": holds more than the ", largest,
           " bytes that may be read; raise --max-memory or split it"}};
}

// The size that the file system tells, 0 where it knows none (pipes, devices).
std::uint64_t known_size(const std::string& path) {
  std::error_code error;
  if (path == "-" || !fs::is_regular_file(path, error)) return 0;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

Result<std::string> read_stream(std::FILE* stream, const std::string& path, std::uint64_t largest) {
  const std::uint64_t size = known_size(path);
  if (size > largest) return too_large(path, largest);
  std::string bytes;
  std::size_t piece = static_cast<std::size_t>(size) + 1;  // one more, to see the end
  for (std::size_t used = 0;; piece = std::max(kReadPiece, used / 2)) {
    bytes.resize(used + piece);
    const std::size_t got = std::fread(bytes.data() + used, 1, piece, stream);
    used += got;
    if (used > largest) return too_large(path, largest);
    if (got == piece) continue;
    if (std::ferror(stream) != 0) return broken_off(path, errno);
    bytes.resize(used);
    return bytes;
  }
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

bool file_exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

Result<std::string> read_input(const std::string& path, std::uint64_t largest) {
  if (path == "-") return read_stream(stdin, path, largest);
  std::error_code error;
  if (fs::is_directory(path, error)) return unreadable(path, "it is a directory");
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) return unreadable(path, std::generic_category().message(errno));
  return read_stream(file.get(), path, largest);
}

}  // namespace wellspaced
