#include "wellspaced/io/report/audit_report.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

using audit::Check;
using audit::Item;

constexpr std::size_t kListed = 10;

std::size_t listed_ids(const Check& check) {
  return std::min(check.ids.size(), kListed * audit::ids_per(check.item));
}

template <class Values>
void append_list(JsonWriter& json, const Values& values, std::size_t count) {
  json.begin_array();
  for (std::size_t i = 0; i < count; ++i) json.value(values[i]);
  json.end_array();
}

void append_check(JsonWriter& json, const Check& check) {
  json.begin_object().field("name", check.name);
  if (check.level) json.field("level", *check.level);
  json.field("required", check.required).field("pass", check.pass());
  if (!check.promised) json.field("promised", false);
  json.field("violations", check.violations).field("item", audit::name_of(check.item));
  append_list(json.key("first"), check.ids, listed_ids(check));
  json.key("value");
  check.value ? json.value(*check.value) : json.null();
  json.end_object();
}

void append_measures(JsonWriter& json, const audit::Report& report, std::optional<Index> level) {
  for (const audit::Measure& measure : report.measures)
    if (measure.level == level) json.field(measure.name, measure.value);
}

Index level_count(const audit::Report& report) {
  Index count = 0;
  for (const audit::Measure& measure : report.measures)
    if (measure.level) count = std::max(count, *measure.level + 1);
  return count;
}

void append_histograms(JsonWriter& json, const audit::Report& report) {
  json.key("histograms").begin_object();
  for (const audit::Histogram& histogram : report.histograms) {
    json.key(histogram.name).begin_object();
    append_list(json.key("bounds"), histogram.bounds, histogram.bounds.size());
    append_list(json.key("counts"), histogram.counts, histogram.counts.size());
    json.end_object();
  }
  json.end_object();
}

void append_worst(JsonWriter& json, const audit::Report& report) {
  json.key("worst").begin_object();
  for (const audit::Worst& worst : report.worst) {
    json.key(worst.measure).begin_object().field("item", audit::name_of(worst.item));
    append_list(json.key("ids"), worst.ids, worst.ids.size());
    append_list(json.key("values"), worst.values, worst.values.size());
    json.end_object();
  }
  json.end_object();
}

void append_witnesses(JsonWriter& json, const audit::Report& report, std::optional<Index> level) {
  for (const audit::Witness& witness : report.witnesses) {
    if (witness.level != level) continue;
    json.key(witness.name).begin_object();
    append_list(json.key("centre"), witness.centre, witness.centre.size());
    append_list(json.key("at"), witness.at, witness.at.size());
    json.end_object();
  }
}

// What there is of the whole, then a list of the levels with what there is of each.
template <class Append>
void append_by_level(JsonWriter& json, const audit::Report& report, Append append) {
  json.begin_object();
  append(json, report, std::nullopt);
  const Index count = level_count(report);
  if (count > 0) json.key("levels").begin_array();
  for (Index level = 0; level < count; ++level) {
    json.begin_object().field("level", level);
    append(json, report, level);
    json.end_object();
  }
  if (count > 0) json.end_array();
  json.end_object();
}

void append_theorems(JsonWriter& json, const audit::Report& report) {
  if (report.theorems.empty()) return;
  json.key("theorems").begin_array();
  for (const audit::Theorem& theorem : report.theorems) {
    json.begin_object().field("name", theorem.name);
    if (theorem.level) json.field("level", *theorem.level);
    json.field("statement", theorem.statement);
    json.field("applies", theorem.applies()).field("missing", theorem.missing_hypothesis);
    json.field("left", theorem.left).field("right", theorem.right);
    json.field("holds", theorem.holds).end_object();
  }
  json.end_array();
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string six_digits(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
  return {text, end.ptr};
}

std::string level_prefix(std::optional<Index> level) {
  if (!level) return "";
  std::string text = "level ";
  return text.append(std::to_string(*level)).append(1, ' ');
}

// "FAIL: 8, edges 3-17 5-2 7-9 ..."
std::string failure(const Check& check) {
  TextWriter text;
  text << (check.required   ? "FAIL: "
           : check.promised ? "fails: "
                            : "not promised: ")
       << check.violations;
  const unsigned width = audit::ids_per(check.item);
  const std::size_t count = std::min<std::size_t>(check.ids.size(), 3 * width);
  if (count > 0) text << ", " << audit::name_of(check.item) << "s";
  for (std::size_t i = 0; i < count; ++i) text << (i % width == 0 ? " " : "-") << check.ids[i];
  if (count < check.ids.size()) text << " ...";
  return text.text();
}

std::string check_line(const Check& check) {
  std::string line = concat({"  ", padded(concat({level_prefix(check.level), check.name}), 34)});
  line += check.required ? "required  " : "          ";
  return concat({line, check.pass() ? "pass" : failure(check), "\n"});
}

std::string theorem_line(const audit::Theorem& theorem) {
  TextWriter text;
  text << "  theorem " << padded(concat({level_prefix(theorem.level), theorem.name}), 12) << ' '
       << padded(theorem.statement, 42) << ' ';
  if (!theorem.applies()) {
    text << "does not apply: not that " << theorem.missing_hypothesis << '\n';
    return text.text();
  }
  text << six_digits(theorem.left) << " <= " << six_digits(theorem.right)
       << (theorem.holds ? "\n" : "  FAILS\n");
  return text.text();
}

// The columns of the table of levels: titles and measures.
constexpr std::pair<std::string_view, std::string_view> kColumns[] = {
    {"nodes", "nodes"},
    {"triangles", "triangles"},
    {"min angle", "min_angle"},
    {"area kept", "area_kept"},
    {"hausdorff", "hausdorff"},
    {"meets", "intersection_mean"},
    {"at most", "intersection_max"},
    {"similar", "similarity"}};

std::string level_cell(const audit::Report& report, Index level, std::string_view name) {
  for (const audit::Measure& measure : report.measures)
    if (measure.level == level && measure.name == name) return six_digits(measure.value);
  return "-";
}

std::string aligned(std::string text) {
  return text.size() < 12 ? concat({std::string(12 - text.size(), ' '), text})
                          : concat({' ', text});
}

std::string level_table(const audit::Report& report) {
  const Index count = level_count(report);
  if (count == 0) return "";
  std::string text = "  level";
  for (const auto& [title, name] : kColumns) text += aligned(std::string(title));
  for (Index level = 0; level < count; ++level) {
    std::string number = std::to_string(level);
    append(text, {"\n  ", std::string(5 - std::min<std::size_t>(5, number.size()), ' '), number});
    for (const auto& [title, name] : kColumns) text += aligned(level_cell(report, level, name));
  }
  return concat({text, "\n"});
}

void mark(std::vector<std::int32_t>& field, const std::vector<Index>& ids) {
  for (const Index id : ids)
    if (id < field.size()) field[id] = 1;
}

bool is_of_cells(Item item) {
  return item == Item::kTriangle || item == Item::kTrianglePair || item == Item::kTet ||
         item == Item::kTetPair;
}

bool is_of_nodes(Item item) {
  return item == Item::kNode || item == Item::kEdge || item == Item::kFace;
}

}  // namespace

void append_audit_json(JsonWriter& json, const audit::Report& report) {
  json.field("verdict", report.pass() ? "pass" : "fail").key("checks").begin_array();
  for (const Check& check : report.checks) append_check(json, check);
  append_by_level(json.end_array().key("measures"), report, append_measures);
  append_histograms(json, report);
  append_worst(json, report);
  if (!report.witnesses.empty()) append_by_level(json.key("witnesses"), report, append_witnesses);
  append_theorems(json, report);
}

std::string audit_table(const audit::Report& report) {
  std::string text = concat({"verdict: ", report.pass() ? "pass" : "FAIL", "\n"});
  for (const Check& check : report.checks)
    if (!check.level || !check.pass()) text += check_line(check);
  for (const audit::Measure& measure : report.measures)
    if (!measure.level)
      append(text, {"  ", padded(measure.name, 34), six_digits(measure.value), "\n"});
  for (const audit::Theorem& theorem : report.theorems)
    if (!theorem.level || theorem.applies()) text += theorem_line(theorem);
  return concat({text, level_table(report)});
}

void mark_offenders(const audit::Report& report, VtkGrid& grid) {
  for (const Check& check : report.checks) {
    if (check.pass() || check.level || check.ids.empty()) continue;
    const bool of_cells = is_of_cells(check.item);
    if (!of_cells && !is_of_nodes(check.item)) continue;
    std::vector<std::int32_t> field(of_cells ? grid.types.size() : grid.points.size(), 0);
    mark(field, check.ids);
    auto& fields = of_cells ? grid.cell_fields : grid.point_fields;
    fields.push_back({check.name, std::move(field)});
  }
}

}  // namespace wellspaced
