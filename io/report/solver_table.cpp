#include "wellspaced/io/report/solver_table.hpp"

#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

std::string percent(double ratio) { return concat({decimal(100 * ratio, 1), "%"}); }

std::string row_of(const SolverLevel& level, std::size_t number) {
  const auto count = [](std::size_t value) { return std::to_string(value); };
  return concat({right_aligned(count(number), 5),
                 right_aligned(level.intersection_max ? count(*level.intersection_max) : "-", 14),
                 right_aligned(percent(level.area_kept), 8),
                 right_aligned(percent(level.perimeter_kept), 11),
                 right_aligned(count(level.nodes_dropped), 9),
                 right_aligned(count(level.nodes_displaced), 11),
                 right_aligned(decimal(level.galerkin.row_mean, 1), 9),
                 right_aligned(count(level.galerkin.row_max), 5), '\n'});
}

}  // namespace

std::string solver_table(const SolverHierarchy& solver) {
  std::string text =
      "\nfor a solver: most triangles of the level before that one meets, what is kept of the\n"
      "domain, nodes gone, those of them interpolated beside their place, Galerkin entries a row\n"
      "level  intersection    area  perimeter  dropped  displaced     mean  max\n";
  for (std::size_t k = 0; k < solver.levels.size(); ++k) text += row_of(solver.levels[k], k);
  return concat({text, "grid complexity ", decimal(solver.grid_complexity),
                 ", operator complexity ", decimal(solver.operator_complexity), "\n"});
}

}  // namespace wellspaced
