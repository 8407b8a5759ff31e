// No include runs up a layer: kernel <- algorithms <- io.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/support/paths.hpp"

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
    const fs::path folder = fs::path(wellspaced::test::kSourceDir) / kLayers[layer];
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

// The project's files that each file of the layers includes, by the name in its include line.
std::map<std::string, std::vector<std::string>> include_graph() {
  std::map<std::string, std::vector<std::string>> graph;
  for (const std::string& layer : kLayers) {
    const fs::path root(wellspaced::test::kSourceDir);
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      if (!is_source(entry.path())) continue;
      auto& included = graph[fs::relative(entry.path(), root).generic_string()];
      std::ifstream file(entry.path());
      const std::string start = "#include \"wellspaced/";
      for (std::string line; std::getline(file, line);)
        if (line.rfind(start, 0) == 0)
          included.push_back(line.substr(start.size(), line.rfind('"') - start.size()));
    }
  }
  return graph;
}

TEST(Layering, NoFileIncludesItselfByAnyWay) {
  auto graph = include_graph();
  EXPECT_GT(graph.size(), 5u);
  // Files that include nothing that is left are taken away until none is left, or a circle.
  for (bool taken = true; taken && !graph.empty();) {
    taken = false;
    for (auto file = graph.begin(); file != graph.end();) {
      const auto& included = file->second;
      const bool is_leaf = std::none_of(included.begin(), included.end(),
                                        [&](const auto& name) { return graph.count(name) != 0; });
      taken |= is_leaf;
      file = is_leaf ? graph.erase(file) : std::next(file);
    }
  }
  for (const auto& [file, included] : graph)
    ADD_FAILURE() << file << " is on a circle or above one";
}

}  // namespace
