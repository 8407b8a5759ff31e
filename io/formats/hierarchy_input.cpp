#include "wellspaced/io/formats/hierarchy_input.hpp"

#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/column_file.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/json/json_reader.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// The first file `stem`.extension that exists; empty if there is none.
std::string find_file(const std::string& stem) {
  for (const Format& format : formats()) {
    if (format.parse == nullptr) continue;
    std::istringstream extensions{std::string(format.extensions)};
    for (std::string extension; extensions >> extension;)
      if (file_exists(concat({stem, extension}))) return concat({stem, extension});
  }
  return {};
}

// A column beside a level; empty if there is no such file.
Result<std::vector<double>> read_column_if_there(const std::string& path, std::size_t count,
                                                 const Progress& progress) {
  if (!file_exists(path)) return std::vector<double>{};
  return read_column(path, count, progress);
}

Index to_index(double value) {
  return value >= 0 && value < kNoIndex && value == std::floor(value) ? static_cast<Index>(value)
                                                                      : kNoIndex;
}

Result<audit::HierarchyLevel> read_level(const std::string& stem, const std::string& file,
                                         std::vector<std::string>& notes,
                                         const Progress& progress) {
  auto geometry = read_geometry(file, {.progress = progress});
  if (!geometry) return geometry.error();
  std::move(geometry->notes.begin(), geometry->notes.end(), std::back_inserter(notes));
  if (geometry->dimension != 2 || !geometry->has_cells())
    return Error{ErrorCode::kUnreadable, {file, ": holds no triangles"}};
  audit::HierarchyLevel level;
  level.mesh = std::move(geometry->mesh);
  const auto origin =
      read_column_if_there(concat({stem, ".origin"}), level.mesh.points.size(), progress);
  if (!origin) return origin.error();
  for (const double value : *origin) level.origin.push_back(to_index(value));
  auto spacing =
      read_column_if_there(concat({stem, ".spacing"}), level.mesh.points.size(), progress);
  if (!spacing) return spacing.error();
  level.spacing = std::move(*spacing);
  return level;
}

// listed: how many levels hierarchy.json tells of, where it does.
Status read_manifest(const std::string& path, HierarchyInput& input,
                     std::optional<std::size_t>& listed) {
  if (!file_exists(path)) return Ok{};
  const auto text = read_input(path);
  if (!text) return text.error();
  const auto json = parse_json(*text, path);
  if (!json) return json.error();
  if (const JsonValue* beta = json->find("beta")) input.beta = beta->number;
  if (const JsonValue* factor = json->find("factor")) input.factor = factor->number;
  if (const JsonValue* metric = json->find("metric")) input.metric = metric->text;
  if (const JsonValue* method = json->find("method")) input.method = method->text;
  if (const JsonValue* scheme = json->find("scheme")) input.scheme = scheme->text;
  if (const JsonValue* nested = json->find("node_nested"))
    input.node_nested = nested->kind != JsonValue::Kind::kFalse;
  if (const JsonValue* levels = json->find("levels");
      levels != nullptr && levels->kind == JsonValue::Kind::kArray)
    listed = levels->items.size();
  if (const JsonValue* fixed = json->find("fixed"))
    for (const JsonValue& node : fixed->items) input.fixed.push_back(to_index(node.number));
  return Ok{};
}

}  // namespace

Result<HierarchyInput> read_hierarchy(const std::string& directory, const Progress& progress) {
  HierarchyInput input;
  std::optional<std::size_t> listed;
  if (Status status = read_manifest(concat({directory, "/hierarchy.json"}), input, listed); !status)
    return status.error();
  for (std::size_t k = 0; !listed || k < *listed; ++k) {
    const std::string stem = concat({directory, "/level_", k});
    const std::string file = find_file(stem);
    if (file.empty() && listed && k > 0)
      return Error{ErrorCode::kUnreadable, {stem, ": hierarchy.json lists it, but it is missing"}};
    if (file.empty()) break;
    auto level = read_level(stem, file, input.notes, progress);
    if (!level) return level.error();
    input.levels.push_back(std::move(*level));
  }
  if (input.levels.empty())
    return Error{ErrorCode::kUnreadable, {directory, ": there is no mesh level_0 in it"}};
  return input;
}

}  // namespace wellspaced
