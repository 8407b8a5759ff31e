// Reading and writing large files can be watched and cancelled, in every format.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/temporary_directory.hpp"
#include "wellspaced/io/formats/formats.hpp"

namespace wellspaced {
namespace {

using test::TemporaryDirectory;

const Geometry& large_mesh() {
  static const Geometry geometry = to_geometry(test::grid_mesh({.nx = 150, .ny = 150}));
  return geometry;
}

std::string path_in(const TemporaryDirectory& directory, const Format& format) {
  return directory / "x" + std::string(format.extensions.substr(0, format.extensions.find(' ')));
}

Status write_to(const std::string& path, const Format& format, OutputSet& outputs) {
  return write_geometry(outputs, path, std::string(format.name), large_mesh());
}

// Formats of domains alone have nothing to say of a mesh.
bool holds_meshes(const Format& format) {
  return format.write != nullptr && format.readable() && format.name != "smesh" &&
         format.name != "poly";
}

TEST(ReadProgress, EveryFormatTellsHowFarItIs) {
  for (const Format& format : formats()) {
    if (!holds_meshes(format)) continue;
    SCOPED_TRACE(format.name);
    const TemporaryDirectory directory;
    const std::string path = path_in(directory, format);
    OutputSet outputs;
    ASSERT_TRUE(write_to(path, format, outputs).ok());
    ASSERT_TRUE(outputs.commit().ok());
    int calls = 0;
    const Progress watch = [&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
      EXPECT_EQ(phase, "read");
      EXPECT_LE(done, total);
      ++calls;
      return true;
    };
    const std::string name(format.name);
    EXPECT_TRUE(read_geometry(path, {.format = name, .progress = watch}).ok());
    EXPECT_GE(calls, 1);
    const Progress refuse = [](auto, auto, auto) { return false; };
    const auto cancelled = read_geometry(path, {.format = name, .progress = refuse});
    ASSERT_FALSE(cancelled.ok());
    EXPECT_EQ(cancelled.error().code, ErrorCode::kCancelled) << cancelled.error().message;
  }
}

TEST(WriteProgress, ACancelledFileLeavesNothing) {
  const TemporaryDirectory directory;
  OutputSet outputs([](auto, auto, auto) { return false; });
  for (const Format& format : formats()) {
    if (format.name != "gmsh" && format.name != "vtu-ascii" && format.name != "obj") continue;
    const Status status = write_to(directory / std::string(format.name), format, outputs);
    ASSERT_FALSE(status.ok()) << format.name;
    EXPECT_EQ(status.error().code, ErrorCode::kCancelled) << status.error().message;
  }
  const Status status = outputs.add("/dev/null", [](TextWriter& out) {
    for (int i = 0; i < 1000000; ++i) out << i << '\n';
  });
  EXPECT_FALSE(status.ok());
}

TEST(WriteProgress, CountsTheBytes) {
  const TemporaryDirectory directory;
  std::uint64_t last = 0;
  OutputSet outputs([&](std::string_view phase, std::uint64_t done, std::uint64_t) {
    EXPECT_EQ(phase, "write");
    EXPECT_GT(done, last);
    last = done;
    return true;
  });
  ASSERT_TRUE(outputs
                  .add(directory / "a",
                       [](TextWriter& out) {
                         for (int i = 0; i < 1000000; ++i) out << "1234567\n";
                       })
                  .ok());
  EXPECT_GT(last, 7'000'000u);
  EXPECT_LE(last, 8'000'000u);
}

}  // namespace
}  // namespace wellspaced
