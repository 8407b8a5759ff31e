#include "wellspaced/io/reproduce/chapter_page.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "wellspaced/io/report/report_templates.hpp"
#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/io/reproduce/exhibit_files.hpp"
#include "wellspaced/io/text/markup.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr double kFewNodes = 50;
constexpr std::size_t kLongTable = 12;  // rows; longer ones may break over pages

std::string tagged(std::string_view tag, std::string_view text, std::string_view more = "") {
  return concat({'<', tag, more, '>', text, "</", tag, '>'});
}

std::string paragraph(std::string_view text, std::string_view kind) {
  return text.empty()
             ? ""
             : concat({tagged("p", escape_markup(text), concat({" class=\"", kind, "\""})), '\n'});
}

// Adds what a table compares.
void add_agreement(const ExhibitTable& table, Agreement& agreement) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (is_beyond(table, row, i)) ++agreement.differing;
      agreement.compared += table.rows[row].cells[i].published.has_value() &&
                            table.columns[i].rule != CellRule::kNever;
    }
}

// Adds the sizes of a function-based half.
void add_sizes(const ExhibitTable& half, Agreement& agreement) {
  for (const ExhibitRow& row : half.rows) {
    const auto percent = difference(half.columns[0], row.cells[0]);
    if (!percent || *row.cells[0].published < kFewNodes) continue;
    agreement.largest_size_percent = std::fmax(agreement.largest_size_percent, std::fabs(*percent));
    ++agreement.size_rows;
  }
}

// ---- Tables

// Where a group begins, a rule stands left of it.
std::string column_class(const ExhibitTable& table, std::size_t i, std::string_view more = "") {
  const bool first = i > 0 && !table.columns[i].group.empty() &&
                     table.columns[i].group != table.columns[i - 1].group;
  const std::string names = concat({first ? "first" : "", more.empty() ? "" : concat({' ', more})});
  return names.empty() ? "" : concat({" class=\"", names, '"'});
}

std::string group_heads(const ExhibitTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size();) {
    std::size_t end = i + 1;
    while (end < table.columns.size() && table.columns[end].group == table.columns[i].group) ++end;
    text +=
        tagged("th", escape_markup(table.columns[i].group),
               concat({" scope=\"colgroup\" colspan=\"", end - i, '"', column_class(table, i)}));
    i = end;
  }
  return text;
}

std::string table_head(const ExhibitTable& table) {
  std::string names = concat({tagged("th", table.row_heading, " scope=\"col\""), "<td></td>"});
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    names += tagged("th", escape_markup(table.columns[i].name),
                    concat({" scope=\"col\"", column_class(table, i)}));
  return concat({"<thead>\n", tagged("tr", concat({"<td></td><td></td>", group_heads(table)})),
                 '\n', tagged("tr", names), "\n</thead>\n"});
}

std::string our_line(const ExhibitTable& table, std::size_t row, std::string_view whose) {
  std::string line = concat({tagged("th", escape_markup(table.rows[row].label), " scope=\"row\""),
                             tagged("td", whose, " class=\"whose\"")});
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    line += tagged("td", figure_text(table.rows[row].cells[i].ours, table.columns[i].digits),
                   column_class(table, i, is_beyond(table, row, i) ? "beyond" : ""));
  return concat({tagged("tr", line), '\n'});
}

template <class Text>
std::string other_line(const ExhibitTable& table, const ExhibitRow& row, std::string_view whose,
                       Text text) {
  std::string line = concat({"<td></td>", tagged("td", whose, " class=\"whose\"")});
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    line += tagged("td", text(table.columns[i], row.cells[i]), column_class(table, i));
  return concat({tagged("tr", line, concat({" class=\"", whose, '"'})), '\n'});
}

std::string row_lines(const ExhibitTable& table, std::size_t row, std::string_view whose) {
  const ExhibitRow& cells = table.rows[row];
  std::string lines = our_line(table, row, whose);
  if (!has_published(cells)) return lines;
  lines +=
      other_line(table, cells, "thesis", [](const ExhibitColumn& column, const ExhibitCell& cell) {
        return figure_text(cell.published, column.digits);
      });
  return concat({lines, other_line(table, cells, "difference", difference_text)});
}

std::string table_html(const ExhibitTable& table) {
  const bool compares = has_published(table);
  std::string body;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    append(body, {tagged("tbody", concat({'\n', row_lines(table, row, compares ? "ours" : "")}),
                         compares ? " class=\"level\"" : ""),
                  '\n'});
  const std::string note = table.note.empty() ? "" : concat({". ", table.note});
  const std::string caption =
      concat({tagged("caption", concat({escape_markup(table.title),
                                        tagged("span", escape_markup(note), " class=\"note\"")})),
              '\n'});
  const std::string kind = table.rows.size() > kLongTable ? "table long" : "table";
  return concat({tagged("div", tagged("table", concat({'\n', caption, table_head(table), body})),
                        concat({" class=\"", kind, '"'})),
                 '\n'});
}

// ---- Pictures and exhibits

std::string pictures_html(const Exhibit& exhibit) {
  std::string plates;
  for (const ExhibitPicture& picture : exhibit.pictures)
    if (!picture.repeats)
      append(plates,
             {tagged("figure",
                     concat({picture.svg, tagged("figcaption", escape_markup(picture.caption))}),
                     concat({" id=\"picture-", escape_markup(picture.name), '"'})),
              '\n'});
  if (plates.empty()) return "";
  const bool wide = exhibit.name == "drawings";
  return concat(
      {tagged("div", concat({'\n', plates}), wide ? " class=\"plates wide\"" : " class=\"plates\""),
       '\n'});
}

std::string exhibit_html(const Exhibit& exhibit) {
  std::string text = concat({tagged("h2", escape_markup(exhibit.title)), '\n'});
  for (const std::string& note : exhibit.notes) text += paragraph(note, "note");
  for (const ExhibitTable& table : exhibit.tables)
    if (!table.repeats) text += table_html(table);
  text += pictures_html(exhibit);
  return concat({tagged("section", concat({'\n', text}),
                        concat({" id=\"", escape_markup(exhibit.name), '"'})),
                 '\n'});
}

std::string contents_html(std::span<const Exhibit> exhibits) {
  std::string items = tagged("li", "<a href=\"#differences\">What differs, and why</a>");
  for (const Exhibit& exhibit : exhibits)
    append(items, {tagged("li", tagged("a", escape_markup(exhibit.title),
                                       concat({" href=\"#", escape_markup(exhibit.name), '"'}))),
                   '\n'});
  return concat(
      {tagged("nav", tagged("ol", concat({'\n', items})), " aria-label=\"Contents\""), '\n'});
}

// ---- What differs

std::string place_text(const Deviation& d) {
  return concat({d.row, ", ", d.column, ": ", figure_text(d.ours, d.digits), " (",
                 figure_text(d.published, d.digits), ")"});
}

// One row for all figures of a table that differ for the same reason, in the order of the first.
std::string reasons_table(std::span<const Deviation> found) {
  std::vector<const Deviation*> firsts;
  std::map<std::pair<std::string, std::string>, std::string> places;
  for (const Deviation& deviation : found) {
    std::string& list = places[{deviation.table, deviation.reason}];
    if (list.empty()) firsts.push_back(&deviation);
    append(list, {list.empty() ? "" : "; ", place_text(deviation)});
  }
  std::string rows = "<tr><th>table</th><th>ours (thesis)</th><th>why</th></tr>\n";
  for (const Deviation* first : firsts)
    append(rows,
           {tagged("tr", concat({tagged("td", escape_markup(first->table)),
                                 tagged("td", escape_markup(places[{first->table, first->reason}])),
                                 tagged("td", escape_markup(first->reason))})),
            '\n'});
  return tagged("div", tagged("table", concat({'\n', rows}), " class=\"reasons\""),
                " class=\"table long\"");
}

std::vector<Deviation> all_deviations(std::span<const Exhibit> exhibits) {
  std::vector<Deviation> found;
  for (const Exhibit& exhibit : exhibits)
    for (Deviation& deviation : deviations(exhibit)) found.push_back(std::move(deviation));
  return found;
}

std::string differences_html(std::span<const Deviation> found) {
  std::string text = "<h2>What differs, and why</h2>\n";
  text += paragraph(
      "A count differs where the published figure lies outside all of our runs, by more than a "
      "unit of its last digit; an angle, where it is more than 2 degrees off. In the tables these "
      "figures have a star.",
      "note");
  if (!found.empty()) text += reasons_table(found);
  return concat({tagged("section", concat({'\n', text}), " id=\"differences\""), '\n'});
}

// ---- The head

std::string lead_html(const ChapterPage& page) {
  return concat(
      {paragraph(
           "Tables and figures of Dafna Talmor's thesis, made again by wellspaced, beside the "
           "published ones.",
           "lead headline"),
       paragraph(agreement_text(agreement_of(page.exhibits)), "lead")});
}

std::string parameters_html(const ChapterPage& page) {
  std::string items;
  for (const auto& [name, value] : page.parameters)
    append(items, {tagged("dt", escape_markup(name)), tagged("dd", escape_markup(value)), '\n'});
  return tagged("dl", concat({'\n', items}));
}

}  // namespace

Agreement agreement_of(std::span<const Exhibit> exhibits) {
  Agreement agreement;
  for (const Exhibit& exhibit : exhibits)
    for (const ExhibitTable& table : exhibit.tables) {
      if (table.repeats || !table.comparable) continue;
      add_agreement(table, agreement);
      if (table.name == concat({exhibit.name, "-function"})) add_sizes(table, agreement);
    }
  return agreement;
}

std::string agreement_text(const Agreement& agreement) {
  if (agreement.compared == 0)
    return "No figure is compared: nothing here was measured on the thesis' own meshes, or too "
           "few runs were made.";
  std::string text = concat({agreement.compared, " figures are compared; ", agreement.differing,
                             " differ, and are listed with the reasons as far as they are known."});
  if (agreement.size_rows > 0)
    append(text, {" In the ", agreement.size_rows,
                  " function-based rows down to 50 nodes, sizes differ by at most ",
                  decimal(agreement.largest_size_percent, 1), "%."});
  return text;
}

std::string chapter_html(const ChapterPage& page) {
  const std::vector<Deviation> found = all_deviations(page.exhibits);
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\" data-theme=\"paper\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Well-Spaced Points for Numerical Methods, reproduced</title>\n<style>\n";
  text.append(kReportCss).append(kChapterCss);
  text +=
      "</style>\n</head>\n<body>\n<header>\n<p class=\"kicker\">wellspaced reproduce</p>\n"
      "<h1>Well-Spaced Points for Numerical Methods, reproduced</h1>\n</header>\n<main>\n";
  append(text, {lead_html(page), parameters_html(page), contents_html(page.exhibits)});
  text += differences_html(found);
  for (const Exhibit& exhibit : page.exhibits) text += exhibit_html(exhibit);
  return concat({text, "</main>\n</body>\n</html>\n"});
}

}  // namespace wellspaced
