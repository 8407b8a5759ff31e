// Reads the real meshes of $WELLSPACED_DATA; tests skip where they are not there.
#pragma once

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

// The numbers of a Triangle file, comments left out.
inline std::vector<double> numbers_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<double> numbers;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) numbers.push_back(std::stod(word));
  }
  return numbers;
}

// A mesh of three files, 1-based, with one marker a node and a segment, as data/ has them.
inline std::optional<TriangleMesh> real_mesh(const std::string& name) {
  const std::string path = std::string(WELLSPACED_DATA_DIR) + "/" + name;
  const auto nodes = numbers_of(path + ".node"), triangles = numbers_of(path + ".ele");
  const auto segments = numbers_of(path + ".poly");
  if (nodes.empty() || triangles.empty() || segments.empty()) return std::nullopt;
  TriangleMesh mesh;
  for (std::size_t i = 4; i + 3 < nodes.size(); i += 4) {
    mesh.points.push_back({nodes[i + 1], nodes[i + 2]});
    mesh.point_markers.push_back(static_cast<int>(nodes[i + 3]));
  }
  const auto index = [](double number) { return static_cast<Index>(number) - 1; };
  for (std::size_t i = 3; i + 3 < triangles.size(); i += 4)
    mesh.triangles.push_back(
        {index(triangles[i + 1]), index(triangles[i + 2]), index(triangles[i + 3])});
  const std::size_t end = 6 + 4 * static_cast<std::size_t>(segments[4]);
  for (std::size_t i = 6; i + 3 < end; i += 4)
    mesh.segments.push_back(
        {index(segments[i + 1]), index(segments[i + 2]), static_cast<int>(segments[i + 3])});
  return mesh;
}

}  // namespace wellspaced::test
