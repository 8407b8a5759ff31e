#include "wellspaced/io/reproduce/chapter.hpp"

#include <utility>

#include "wellspaced/io/reproduce/level_tables.hpp"

namespace wellspaced {
namespace {

Exhibit exhibit_of(const ExhibitKind& kind) {
  return {.name = std::string(kind.name), .title = std::string(kind.title)};
}

Result<Exhibit> sequence_exhibit(const ExhibitKind& kind, Laboratory& laboratory,
                                 const std::string& mesh) {
  Exhibit exhibit = exhibit_of(kind);
  for (const CoarseningMethod method : {CoarseningMethod::kFunction, CoarseningMethod::kMis}) {
    auto table = level_table(laboratory, exhibit.name, mesh, method);
    if (!table) return table.error();
    exhibit.tables.push_back(std::move(*table));
  }
  return exhibit;
}

constexpr ExhibitKind kExhibits[] = {
    {"table-8.3", "Table 8.3: GRID(1)",
     [](const ExhibitKind& kind, Laboratory& l) { return sequence_exhibit(kind, l, "grid1"); }},
    {"table-8.4", "Table 8.4: GRID(10)",
     [](const ExhibitKind& kind, Laboratory& l) { return sequence_exhibit(kind, l, "grid10"); }},
    {"table-8.5", "Table 8.5: CRACK",
     [](const ExhibitKind& kind, Laboratory& l) { return sequence_exhibit(kind, l, "crack"); }},
    {"table-8.6", "Table 8.6: AIRFOIL 1",
     [](const ExhibitKind& kind, Laboratory& l) { return sequence_exhibit(kind, l, "airfoil1"); }},
    {"table-8.7", "Table 8.7: AIRFOIL 2",
     [](const ExhibitKind& kind, Laboratory& l) { return sequence_exhibit(kind, l, "airfoil2"); }},
    {"table-8.8", "Table 8.8: AIRFOIL 3",
     [](const ExhibitKind& kind, Laboratory& l) { return sequence_exhibit(kind, l, "airfoil3"); }},
};

}  // namespace

std::span<const ExhibitKind> exhibit_kinds() { return kExhibits; }

}  // namespace wellspaced
