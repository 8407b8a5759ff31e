#include "wellspaced/io/reproduce/chapter.hpp"

#include <utility>

#include "wellspaced/io/reproduce/level_tables.hpp"
#include "wellspaced/io/reproduce/mesh_tables.hpp"
#include "wellspaced/io/reproduce/point_figures.hpp"
#include "wellspaced/io/reproduce/published.hpp"
#include "wellspaced/io/reproduce/sequence_figures.hpp"
#include "wellspaced/io/reproduce/work_tables.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

Result<Exhibit> sequence_exhibit(Laboratory& laboratory, Exhibit exhibit, const std::string& mesh) {
  for (const CoarseningMethod method : {CoarseningMethod::kFunction, CoarseningMethod::kMis}) {
    auto table = level_table(laboratory, exhibit.name, mesh, method);
    if (!table) return table.error();
    exhibit.tables.push_back(std::move(*table));
  }
  add_sequence_charts(exhibit);
  if (const PublishedSequence* printed = published_sequence(mesh, "mis");
      printed != nullptr && printed->small_angle_sums)
    exhibit.notes.push_back(
        concat({"Under \"≤ 10\" the thesis prints the sums of its ", printed->runs,
                " runs; here they are divided by ", printed->runs, ", as elsewhere."}));
  return exhibit;
}

constexpr ExhibitKind kExhibits[] = {
    {"figure-1.1", "Figure 1.1: well-spaced and uniformly distributed points", contrast_exhibit},
    {"figure-1.2", "Figure 1.2: two maximal point sets", maximal_exhibit},
    {"figure-1.3", "Figure 1.3: non-uniform well-spaced points", graded_exhibit},
    {"figure-1.4", "Figure 1.4: a Hammersley sequence", hammersley_exhibit},
    {"figure-1.5", "Figure 1.5: a Halton sequence", halton_exhibit},
    {"figure-5.4", "Figure 5.4: function-based coarsening", function_exhibit},
    {"section-6.1", "Section 6.1: repeated degradation by independent sets", degradation_exhibit},
    {"table-8.1", "Table 8.1: the test suite", suite_exhibit},
    {"figure-8.5", "Figure 8.5: the effect of the coarsening parameters", parameter_exhibit},
    {"section-8.4", "Section 8.4: measured depth and work constants", work_exhibit},
    {"table-8.3", "Table 8.3: coarsening GRID(1)",
     [](Laboratory& l, Exhibit e) { return sequence_exhibit(l, std::move(e), "grid1"); }},
    {"table-8.4", "Table 8.4: coarsening GRID(10)",
     [](Laboratory& l, Exhibit e) { return sequence_exhibit(l, std::move(e), "grid10"); }},
    {"table-8.5", "Table 8.5: coarsening CRACK",
     [](Laboratory& l, Exhibit e) { return sequence_exhibit(l, std::move(e), "crack"); }},
    {"table-8.6", "Table 8.6: coarsening AIRFOIL 1",
     [](Laboratory& l, Exhibit e) { return sequence_exhibit(l, std::move(e), "airfoil1"); }},
    {"table-8.7", "Table 8.7: coarsening AIRFOIL 2",
     [](Laboratory& l, Exhibit e) { return sequence_exhibit(l, std::move(e), "airfoil2"); }},
    {"table-8.8", "Table 8.8: coarsening AIRFOIL 3",
     [](Laboratory& l, Exhibit e) { return sequence_exhibit(l, std::move(e), "airfoil3"); }},
    {"figure-8.6", "Figure 8.6: sizes and angles on the grids", grid_figure_exhibit},
    {"figure-8.7", "Figure 8.7: sizes by level", size_figure_exhibit},
    {"figure-8.8", "Figure 8.8: sizes by level, logarithmic", log_size_figure_exhibit},
    {"figure-8.9", "Figure 8.9: smallest angles by size", angle_figure_exhibit},
    {"drawings", "Coarsening sequences, level by level", drawings_exhibit},
};

}  // namespace

std::span<const ExhibitKind> exhibit_kinds() { return kExhibits; }

Result<Exhibit> make_exhibit(const ExhibitKind& kind, Laboratory& laboratory) {
  Exhibit exhibit{.name = std::string(kind.name), .title = std::string(kind.title)};
  return kind.fill(laboratory, std::move(exhibit));
}

}  // namespace wellspaced
