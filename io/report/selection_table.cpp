#include "wellspaced/io/report/selection_table.hpp"

#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {

std::string selection_table(std::span<const SelectionCheck> levels) {
  std::string text =
      "\nagainst a maximal set without conflicts f + f > beta d: pairs in conflict and the "
      "largest\n"
      "(f + f) / (beta d); nodes of the input with room for one more, and by how much f is short\n"
      "level  conflicts  largest  uncovered  largest\n";
  for (std::size_t k = 0; k < levels.size(); ++k)
    append(text, {right_aligned(std::to_string(k + 1), 5),
                  right_aligned(std::to_string(levels[k].conflicts), 11),
                  right_aligned(decimal(levels[k].conflict_max), 9),
                  right_aligned(std::to_string(levels[k].uncovered), 11),
                  right_aligned(decimal(levels[k].uncovered_max), 9), '\n'});
  return text;
}

}  // namespace wellspaced
