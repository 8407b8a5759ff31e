#include "wellspaced/io/reproduce/exhibit_files.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// ---- For the terminal

using TextRow = std::vector<std::string>;

// Characters, not bytes.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::string padded_left(std::string_view text, std::size_t width) {
  return concat({std::string(width - std::min(width, width_of(text)), ' '), text});
}

TextRow head_row(const ExhibitTable& table) {
  TextRow row = {table.row_heading, ""};
  for (const ExhibitColumn& column : table.columns) row.push_back(column.name);
  return row;
}

// A group's name stands over its first column; two columns come before those of the table.
std::string group_line(const ExhibitTable& table, std::span<const std::size_t> widths) {
  std::string line, last;
  std::size_t start = 4 + widths[0] + widths[1];
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& group = table.columns[i].group;
    if (std::exchange(last, group) != group)
      append(line, {std::string(start - std::min(start, width_of(line)), ' '), "  ", group});
    start += 2 + widths[i + 2];
  }
  return line;
}

template <class Text>
TextRow cells_row(const ExhibitTable& table, std::size_t row, const std::string& label,
                  const std::string& whose, Text text) {
  TextRow line = {label, whose};
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    line.push_back(text(table.columns[i], table.rows[row].cells[i], i));
  return line;
}

std::vector<TextRow> body_rows(const ExhibitTable& table) {
  std::vector<TextRow> lines;
  const bool compares = has_published(table);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto ours = [&](const ExhibitColumn& column, const ExhibitCell& cell, std::size_t i) {
      return concat({figure_text(cell.ours, column.digits), is_beyond(table, row, i) ? "*" : ""});
    };
    lines.push_back(cells_row(table, row, table.rows[row].label, compares ? "ours" : "", ours));
    if (!has_published(table.rows[row])) continue;
    lines.push_back(
        cells_row(table, row, "", "thesis",
                  [](const ExhibitColumn& column, const ExhibitCell& cell, std::size_t) {
                    return figure_text(cell.published, column.digits);
                  }));
    lines.push_back(cells_row(table, row, "", "difference",
                              [](const ExhibitColumn& column, const ExhibitCell& cell,
                                 std::size_t) { return difference_text(column, cell); }));
  }
  return lines;
}

std::string table_text(const ExhibitTable& table) {
  std::vector<TextRow> lines = body_rows(table);
  lines.insert(lines.begin(), head_row(table));
  std::vector<std::size_t> widths(lines[0].size());
  for (const TextRow& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], width_of(line[i]));
  const std::string groups = group_line(table, widths);
  std::string text =
      concat({table.title, table.note.empty() ? "" : concat({" (", table.note, ")"}), '\n'});
  if (!groups.empty()) append(text, {groups, '\n'});
  for (const TextRow& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      append(text, {"  ", padded_left(line[i], widths[i])});
    text += '\n';
  }
  return concat({text, '\n'});
}

std::string deviation_text(const Deviation& d) {
  return concat({"  ", d.table, ", ", d.row, ", ", d.column, ": ", figure_text(d.ours, d.digits),
                 ", in the thesis ", figure_text(d.published, d.digits), ": ", d.reason, '\n'});
}

// ---- Files

void append_figure(std::string& text, const std::optional<double>& value) {
  text += ',';
  if (value) text += shortest(*value);
}

void append_heading(std::string& text, const ExhibitColumn& column, std::string_view what) {
  std::string name = column.group.empty() ? column.name : concat({column.group, ' ', column.name});
  std::ranges::replace(name, ',', ';');
  text.append(",").append(name).append(" ").append(what);
}

void write_figure(JsonWriter& json, std::string_view name, const std::optional<double>& value) {
  if (value) json.field(name, *value);
}

void append_table_json(JsonWriter& json, const ExhibitTable& table) {
  json.begin_object().field("name", table.name).field("title", table.title);
  json.field("note", table.note).field("comparable", table.comparable);
  json.field("row_heading", table.row_heading).key("columns").begin_array();
  for (const ExhibitColumn& column : table.columns)
    json.begin_object().field("group", column.group).field("name", column.name).end_object();
  json.end_array().key("rows").begin_array();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    json.begin_object().field("label", table.rows[row].label).key("cells").begin_array();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const ExhibitCell& cell = table.rows[row].cells[i];
      json.begin_object();
      write_figure(json, "ours", cell.ours);
      write_figure(json, "low", cell.low);
      write_figure(json, "high", cell.high);
      write_figure(json, "published", cell.published);
      if (is_beyond(table, row, i)) json.field("beyond", true);
      json.end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().end_object();
}

void append_deviation_json(JsonWriter& json, const Deviation& deviation) {
  json.begin_object().field("table", deviation.table).field("row", deviation.row);
  json.field("column", deviation.column).field("ours", deviation.ours);
  json.field("published", deviation.published).field("reason", deviation.reason).end_object();
}

Status add_text(OutputSet& outputs, const std::string& path, const std::string& text) {
  return outputs.add(path, [&](TextWriter& out) { out << text; });
}

}  // namespace

bool has_published(const ExhibitRow& row) {
  return std::ranges::any_of(row.cells,
                             [](const ExhibitCell& cell) { return cell.published.has_value(); });
}

bool has_published(const ExhibitTable& table) {
  return std::ranges::any_of(table.rows, [](const ExhibitRow& row) { return has_published(row); });
}

std::string exhibit_text(const Exhibit& exhibit) {
  std::string text = concat({exhibit.title, "\n"});
  for (const std::string& note : exhibit.notes) append(text, {note, '\n'});
  text += '\n';
  for (const ExhibitTable& table : exhibit.tables) text += table_text(table);
  const std::vector<Deviation> found = deviations(exhibit);
  if (found.empty()) return text;
  text +=
      "* beyond the spread over the runs, or by more than 2 degrees; the reason as far as it "
      "is known:\n";
  for (const Deviation& deviation : found) text += deviation_text(deviation);
  return concat({text, '\n'});
}

std::string table_csv(const ExhibitTable& table) {
  const bool compares = has_published(table);
  std::string text = table.row_heading;
  for (const ExhibitColumn& column : table.columns) {
    for (const std::string_view what : {"ours", "low", "high"}) append_heading(text, column, what);
    if (!compares) continue;
    append_heading(text, column, "published");
    append_heading(text, column, column.relative ? "difference %" : "difference");
  }
  text += '\n';
  for (const ExhibitRow& row : table.rows) {
    text += row.label;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const ExhibitCell& cell = row.cells[i];
      for (const auto& figure : {cell.ours, cell.low, cell.high}) append_figure(text, figure);
      if (!compares) continue;
      append_figure(text, cell.published);
      append_figure(text, difference(table.columns[i], cell));
    }
    text += '\n';
  }
  return text;
}

void append_exhibit_json(JsonWriter& json, const Exhibit& exhibit) {
  json.begin_object().field("name", exhibit.name).field("title", exhibit.title);
  json.key("notes").begin_array();
  for (const std::string& note : exhibit.notes) json.value(note);
  json.end_array().key("tables").begin_array();
  for (const ExhibitTable& table : exhibit.tables) append_table_json(json, table);
  json.end_array().key("pictures").begin_array();
  for (const ExhibitPicture& picture : exhibit.pictures) json.value(concat({picture.name, ".svg"}));
  json.end_array().key("deviations").begin_array();
  for (const Deviation& deviation : deviations(exhibit)) append_deviation_json(json, deviation);
  json.end_array().end_object();
}

Status add_exhibit(OutputSet& outputs, const std::string& directory, const Exhibit& exhibit) {
  JsonWriter json;
  append_exhibit_json(json, exhibit);
  Status status = outputs.make_directory(directory);
  const auto add = [&](const std::string& name, const std::string& text) {
    if (status) status = add_text(outputs, concat({directory, "/", name}), text);
  };
  add(concat({exhibit.name, ".json"}), concat({json.text(), '\n'}));
  for (const ExhibitTable& table : exhibit.tables)
    add(concat({table.name, ".csv"}), table_csv(table));
  for (const ExhibitPicture& picture : exhibit.pictures)
    add(concat({picture.name, ".svg"}), picture.svg);
  return status;
}

}  // namespace wellspaced
