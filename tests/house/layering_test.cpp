// No include runs up a layer: kernel <- algorithms <- io.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kLayers = {"kernel", "algorithms", "io"};

bool is_source(const fs::path& path) {
  return path.extension() == ".hpp" || path.extension() == ".cpp";
}

// The layer that an include line names, or -1 for a system header.
int included_layer(const std::string& line) {
  for (std::size_t layer = 0; layer < kLayers.size(); ++layer)
    if (line.find("\"wellspaced/" + kLayers[layer] + "/") != std::string::npos)
      return static_cast<int>(layer);
  return -1;
}

TEST(Layering, NoIncludeRunsUpALayer) {
  int files = 0;
  for (int layer = 0; layer < static_cast<int>(kLayers.size()); ++layer) {
    const fs::path folder = fs::path(WELLSPACED_SOURCE_DIR) / kLayers[layer];
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!is_source(entry.path())) continue;
      ++files;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        if (line.rfind("#include", 0) != 0) continue;
        EXPECT_LE(included_layer(line), layer) << entry.path() << ": " << line;
        if (line.find('"') != std::string::npos)
          EXPECT_NE(included_layer(line), -1) << entry.path() << ": " << line;
      }
    }
  }
  EXPECT_GT(files, 5);
}

}  // namespace
