// Reads the meshes of $WELLSPACED_DATA for tests, with a reader of its own.
#pragma once

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/data.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

/// The numbers of a text file, line by line, without comments and empty lines; none if the file is
/// not there.
inline std::vector<std::vector<double>> number_lines(const std::string& path) {
  std::vector<std::vector<double>> lines;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    std::istringstream stream(text.substr(0, text.find('#')));
    std::vector<double> numbers;
    // Through text, for operator>> into a double stops at what it cannot represent.
    for (std::string word; stream >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    if (!numbers.empty()) lines.push_back(std::move(numbers));
  }
  return lines;
}

inline Index zero_based(double one_based) { return static_cast<Index>(one_based) - 1; }

/// The mesh of NAME.node, NAME.ele and NAME.poly, whose numbers start at 1, in the data directory;
/// nothing if it is not there.
inline std::optional<TriangleMesh> data_mesh(const std::string& name) {
  const std::string path = data_path(name);
  const auto nodes = number_lines(path + ".node"), triangles = number_lines(path + ".ele"),
             poly = number_lines(path + ".poly");
  if (nodes.empty() || triangles.empty() || poly.empty()) return std::nullopt;
  TriangleMesh mesh;
  for (std::size_t i = 1; i < nodes.size(); ++i) mesh.points.push_back({nodes[i][1], nodes[i][2]});
  for (std::size_t i = 1; i < triangles.size(); ++i)
    mesh.triangles.push_back(
        {zero_based(triangles[i][1]), zero_based(triangles[i][2]), zero_based(triangles[i][3])});
  const auto segments = static_cast<std::size_t>(poly[1][0]);  // poly[0]: the nodes are elsewhere
  for (std::size_t i = 2; i < 2 + segments; ++i)
    mesh.segments.push_back(
        {zero_based(poly[i][1]), zero_based(poly[i][2]), static_cast<int>(poly[i][3])});
  return mesh;
}

/// The domain of NAME.poly, whose numbers start at 1, in the data directory: points, segments and
/// holes; nothing if it is not there.
inline std::optional<Pslg> data_domain(const std::string& name) {
  const auto lines = number_lines(data_path(name + ".poly"));
  if (lines.empty()) return std::nullopt;
  Pslg domain;
  auto line = lines.begin();
  for (auto left = static_cast<std::size_t>((*line++)[0]); left > 0; --left, ++line)
    domain.points.push_back({(*line)[1], (*line)[2]});
  for (auto left = static_cast<std::size_t>((*line++)[0]); left > 0; --left, ++line)
    domain.segments.push_back({zero_based((*line)[1]), zero_based((*line)[2]), 0});
  for (auto left = static_cast<std::size_t>((*line++)[0]); left > 0; --left, ++line)
    domain.holes.push_back({(*line)[1], (*line)[2]});
  return domain;
}

/// A file with one number a line; empty if it is not there.
inline std::vector<Index> index_file(const std::string& path) {
  std::vector<Index> numbers;
  for (const auto& line : number_lines(path)) numbers.push_back(static_cast<Index>(line[0]));
  return numbers;
}

}  // namespace wellspaced::test
