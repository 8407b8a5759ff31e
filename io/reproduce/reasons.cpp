#include "wellspaced/io/reproduce/reasons.hpp"
#include "wellspaced/kernel/concat.hpp"

#include <string_view>

namespace wellspaced {
namespace {

// 7.3 and 9.4: counted apart from this program, on a grid of 100 by 100 nodes.
constexpr std::string_view kLatticeCount =
    "How the thesis counts intersections is not told; ours share an area, by exact arithmetic. On "
    "lattices many triangles touch along edges alone: on level 1 of GRID(1) 7.3 share an area, 9.4 "
    "an area or a piece of an edge. The thesis prints 8.55: it seems to count some of them.";
constexpr std::string_view kGridCut =
    "How the thesis cut the cells of its grids is not told. All one way gives 2% fewer nodes on "
    "level 1; 13% cut the other way, by chance, fits best.";
constexpr std::string_view kHolePoints =
    "The thesis keeps 3 special points of each hole and does not say which. Towards the end they "
    "are the mesh.";
constexpr std::string_view kFewNodesLeft =
    "A few dozen nodes or less are left: what they look like depends on the run, and on a few "
    "nodes of the boundary.";
constexpr std::string_view kInspected =
    "The largest count of ten runs is an extreme; and which nodes count as inspected, the thesis "
    "tells in words alone.";
constexpr std::string_view kOneLevelMore = "A run of ours has one level more.";
constexpr std::string_view kFewEdges =
    "Among the last levels a dozen edges are left; the average over them follows a single one.";
constexpr std::string_view kMisprint843 =
    "Rows 1 and 2 of AIRFOIL 1 are printed alike in all four columns, though they come from "
    "different runs: one is a misprint, and by our figures it is row 1.";
constexpr std::string_view kDependsOnAspect = "Printed as \"depends on a\".";
constexpr std::string_view kDiagonal =
    "Printed as log a; but the longest edge of a grid is a diagonal, so it is log √(1 + a²).";

// Rows first to last (from 0) of the columns whose titles contain `column`; empty: all columns.
struct KnownReason {
  std::string_view table;
  std::size_t first, last;
  std::string_view column, text;
};

// The first that fits counts.
constexpr KnownReason kKnownReasons[] = {
    {"section-6.1", 4, 4, "6^k", "A misprint: 6^5 is 7776."},
    {"table-8.1", 3, 9, "gradation", kDiagonal},
    {"table-8.1", 3, 9, "number", kDependsOnAspect},
    {"section-8.4.1", 8, 9, "", kOneLevelMore},
    {"section-8.4.2", 8, 9, "", kOneLevelMore},
    {"section-8.4.2", 0, 9, "max", kInspected},
    {"section-8.4.3", 1, 1, "AIRFOIL 1", kMisprint843},
    {"section-8.4.3", 5, 9, "", kFewEdges},
    {"section-8.4.3", 0, 9, "max", kInspected},
    {"table-8.3-function", 7, 99, "", kFewNodesLeft},
    {"table-8.3-mis", 7, 99, "", kFewNodesLeft},
    {"table-8.4-function", 9, 99, "", kFewNodesLeft},
    {"table-8.4-mis", 7, 99, "", kFewNodesLeft},
    {"table-8.3", 0, 99, "intersection", kLatticeCount},
    {"table-8.4", 0, 99, "intersection", kLatticeCount},
    {"table-8.3", 0, 99, "nodes", kGridCut},
    {"table-8.4", 0, 99, "nodes", kGridCut},
    {"table-8.5-mis", 4, 99, "", kFewNodesLeft},
    {"table-8.5", 1, 2, "intersection", kLatticeCount},
    {"table-8.6-function", 2, 99, "boundary", kHolePoints},
    {"table-8.6-function", 4, 99, "", kHolePoints},
    {"table-8.6-mis", 3, 99, "", kHolePoints},
    {"table-8.8-function", 3, 99, "boundary", kHolePoints},
    {"table-8.8-function", 5, 99, "", kHolePoints},
    {"table-8.8-mis", 3, 99, "", kHolePoints},
};

// Of "table-8.3", both halves.
bool is_of(const ExhibitTable& table, std::string_view name) {
  return table.name == name || table.name.rfind(concat({name, '-'}), 0) == 0;
}

// Whether the next column holds the averages of what this one holds the least of, and they agree.
bool is_extreme(const ExhibitTable& table, std::size_t row, std::size_t column) {
  if (table.columns[column].name != "smallest" || column + 1 == table.columns.size()) return false;
  const ExhibitCell& average = table.rows[row].cells[column + 1];
  return table.columns[column + 1].name == "avg small." && average.ours && average.published &&
         !is_beyond(table, row, column + 1);
}

}  // namespace

std::string column_title(const ExhibitColumn& column) {
  return column.group.empty() ? column.name : concat({column.group, ", ", column.name});
}

std::string known_reason(const ExhibitTable& table, std::size_t row, std::size_t column) {
  if (is_extreme(table, row, column))
    return "The smallest of all runs is an extreme; the averages of the smallest angles agree.";
  const std::string title = column_title(table.columns[column]);
  for (const KnownReason& reason : kKnownReasons)
    if (is_of(table, reason.table) && reason.first <= row && row <= reason.last &&
        title.find(reason.column) != title.npos)
      return std::string(reason.text);
  return "not known";
}

}  // namespace wellspaced
