// Where the real meshes are.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/paths.hpp"

namespace wellspaced::test {

/// The path of a file of $WELLSPACED_DATA (default: beside the checkout), whether or not it is
/// there.
inline std::string data_path(const std::string& name) {
  const char* const folder = std::getenv("WELLSPACED_DATA");
  return std::string(folder != nullptr ? folder : kDataDir) + "/" + name;
}

inline bool has_data(const std::string& name) { return std::filesystem::exists(data_path(name)); }

}  // namespace wellspaced::test

/// Ends the test as skipped where the real data are absent.
#define WELLSPACED_REQUIRE_DATA(name) \
  if (!wellspaced::test::has_data(name)) GTEST_SKIP() << "no " << wellspaced::test::data_path(name)
