#include <array>

#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/files/input_file.hpp"

namespace wellspaced::cli {

// To add a command: declare it here, list it below, define it in a file of its own.
extern const Command kAudit;
extern const Command kCoarsen;
extern const Command kConvert;
extern const Command kGenerate;
extern const Command kMesh;
extern const Command kPredicate;
extern const Command kReproduce;
extern const Command kTriangulate;

namespace {

constexpr std::array kCommands = {&kGenerate, &kTriangulate, &kMesh,      &kCoarsen,
                                  &kAudit,    &kReproduce,   &kPredicate, &kConvert};

}  // namespace

std::span<const Command* const> commands() { return kCommands; }

Error in_file(const Error& error, const std::string& path) {
  if (error.code == ErrorCode::kCancelled || error.code == ErrorCode::kUsage) return error;
  const std::string counted = error.ids.empty() ? "" : " (counted from 0)";
  return {error.code, {display_name(path), ": ", error.message, counted}, error.ids};
}

int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return 2;
    case ErrorCode::kUnreadable:
      return 3;
    case ErrorCode::kInvalidGeometry:
      return 4;
    case ErrorCode::kLimit:
    case ErrorCode::kCancelled:
      return kExitLimit;
    case ErrorCode::kInternal:
      return 6;
  }
  return 6;
}

}  // namespace wellspaced::cli
