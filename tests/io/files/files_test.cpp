#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/temporary_directory.hpp"
#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/files/output_set.hpp"

namespace wellspaced {
namespace {

namespace fs = std::filesystem;
using test::read_bytes;
using test::TemporaryDirectory;

auto writes(std::string_view text) {
  return [text](TextWriter& out) { out << text; };
}

TEST(ReadInput, ReturnsTheBytesOfTheFile) {
  const TemporaryDirectory directory;
  const std::string bytes("a\0b\r\n\xff", 6);
  const auto text = read_input(directory.write("file", bytes));
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(*text, bytes);
  EXPECT_EQ(*read_input(directory.write("empty", "")), "");
}

TEST(ReadInput, NamesTheFileThatItCannotRead) {
  const TemporaryDirectory directory;
  const auto missing = read_input(directory / "missing");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::kUnreadable);
  EXPECT_EQ(missing.error().message,
            directory / "missing" + ": cannot read: No such file or directory");
  EXPECT_EQ(read_input(directory.path()).error().code, ErrorCode::kUnreadable);
  EXPECT_FALSE(read_input(std::string(10000, 'x')).ok()) << "a name that is too long";
  EXPECT_FALSE(read_input("").ok());
}

TEST(ReadInput, StopsAtTheSizeLimitEvenWhereTheSizeIsUnknown) {
  const TemporaryDirectory directory;
  const std::string path = directory.write("file", "12345");
  EXPECT_TRUE(read_input(path, 5).ok());
  EXPECT_EQ(read_input(path, 4).error().code, ErrorCode::kLimit);
  if (!fs::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero";
  EXPECT_EQ(read_input("/dev/zero", 1000).error().code, ErrorCode::kLimit);
}

TEST(OutputSet, PublishesAllFilesAtCommit) {
  const TemporaryDirectory directory;
  OutputSet outputs;
  ASSERT_TRUE(outputs.add(directory / "a", writes("one")).ok());
  ASSERT_TRUE(outputs.add(directory / "b", writes("two")).ok());
  EXPECT_FALSE(fs::exists(directory / "a"));
  ASSERT_TRUE(outputs.commit().ok());
  EXPECT_EQ(read_bytes(directory / "a"), "one");
  EXPECT_EQ(read_bytes(directory / "b"), "two");
  EXPECT_EQ(directory.count_files(), 2u);
}

TEST(OutputSet, LeavesNothingWithoutCommit) {
  const TemporaryDirectory directory;
  directory.write("kept", "old");
  {
    OutputSet outputs;
    ASSERT_TRUE(outputs.make_directory(directory / "new/deep").ok());
    ASSERT_TRUE(outputs.add(directory / "new/deep/a", writes("one")).ok());
    ASSERT_TRUE(outputs.add(directory / "kept", writes("new")).ok());
    EXPECT_TRUE(fs::exists(directory / "new/deep"));
  }
  EXPECT_EQ(directory.count_files(), 1u);
  EXPECT_EQ(read_bytes(directory / "kept"), "old");
}

TEST(OutputSet, ReplacesAFileThroughItsLinkAndKeepsItsPermissions) {
  const TemporaryDirectory directory;
  directory.write("file", "old");
  fs::permissions(directory / "file", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("file", directory / "link");
  OutputSet outputs;
  ASSERT_TRUE(outputs.add(directory / "link", writes("new")).ok());
  ASSERT_TRUE(outputs.commit().ok());
  EXPECT_TRUE(fs::is_symlink(directory / "link"));
  EXPECT_EQ(read_bytes(directory / "file"), "new");
  EXPECT_EQ(fs::status(directory / "file").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputSet, RefusesPathsThatCannotBeCreated) {
  const TemporaryDirectory directory;
  directory.write("file", "");
  OutputSet outputs;
  for (const std::string& path :
       {directory / "no/such/directory", directory.path(), directory / "file/below", std::string(),
        directory / std::string(300, 'x')}) {
    const Status status = outputs.add(path, writes("x"));
    ASSERT_FALSE(status.ok()) << path;
    EXPECT_EQ(status.error().code, ErrorCode::kUsage) << path;
  }
  EXPECT_FALSE(outputs.make_directory(directory / "file").ok());
  EXPECT_FALSE(outputs.make_directory(directory / "file/below").ok());
}

TEST(OutputSet, RefusesToWriteOneFileTwice) {
  const TemporaryDirectory directory;
  OutputSet outputs;
  ASSERT_TRUE(outputs.add(directory / "a", writes("1")).ok());
  EXPECT_FALSE(outputs.add(directory / "a", writes("2")).ok());
}

TEST(OutputSet, ReportsAFullDiskAndPublishesNothing) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const TemporaryDirectory directory;
  OutputSet outputs;
  ASSERT_TRUE(outputs.add(directory / "a", writes("1")).ok());
  ASSERT_TRUE(outputs.add("/dev/full", writes("2")).ok());
  const Status status = outputs.commit();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kLimit);
  EXPECT_EQ(status.error().message, "/dev/full: cannot write: No space left on device");
  EXPECT_FALSE(fs::exists(directory / "a"));
}

TEST(OutputSet, LeavesNothingWhenItIsAbandonedWhileItWrites) {
  const TemporaryDirectory directory;
  const std::string kept = directory.write("kept", "before");
  static OutputSet* const outputs = new OutputSet;  // never destroyed, as when the process ends
  ASSERT_TRUE(outputs->make_directory(directory / "new").ok());
  ASSERT_TRUE(outputs->add(directory / "new/a", [](TextWriter& out) { out << "a"; }).ok());
  bool abandoned = false;
  const Status status = outputs->add(kept, [&](TextWriter& out) {
    out << "after";
    abandoned = outputs->abandon();
  });
  EXPECT_TRUE(abandoned);
  EXPECT_FALSE(fs::exists(directory / "new"));
  EXPECT_EQ(directory.count_files(), 1u);
  EXPECT_EQ(test::read_bytes(kept), "before");
}

TEST(OutputSet, WritesDevicesInPlace) {
  if (!fs::exists("/dev/null")) GTEST_SKIP() << "no /dev/null";
  OutputSet outputs;
  ASSERT_TRUE(outputs.add("/dev/null", writes("gone")).ok());
  EXPECT_TRUE(outputs.commit().ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputSet, WritesFilesBeyondItsBuffer) {
  const TemporaryDirectory directory;
  OutputSet outputs;
  const std::string line(1000, 'x');
  ASSERT_TRUE(outputs
                  .add(directory / "a",
                       [&](TextWriter& out) {
                         for (int i = 0; i < 5000; ++i) out << line << i << '\n';
                       })
                  .ok());
  ASSERT_TRUE(outputs.commit().ok());
  EXPECT_EQ(read_bytes(directory / "a").size(), 5'000'000u + 5000 + 10 + 180 + 2700 + 16000);
}

}  // namespace
}  // namespace wellspaced
