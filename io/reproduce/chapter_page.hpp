// All exhibits as one web page that loads nothing: the living chapter 8.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/io/reproduce/exhibit.hpp"

namespace wellspaced {

/// parameters: names and values, as they are to be read.
struct ChapterPage {
  std::vector<std::pair<std::string, std::string>> parameters;
  std::span<const Exhibit> exhibits;
};

/// The page as an HTML text without scripts: what was made and how near it is, the figures that
/// differ with their reasons, then every exhibit with its tables and pictures.
/// The same exhibits give the same bytes. Requires: pictures are SVG texts. Cost: linear.
[[gnu::cold]] std::string chapter_html(const ChapterPage& page);

/// How near the exhibits are to the thesis: figures compared, and how many of them differ; over the
/// function-based rows with at least 50 published nodes of the comparable tables, how many there
/// are, and the largest difference in nodes, in percent.
struct Agreement {
  std::size_t compared = 0, differing = 0, size_rows = 0;
  double largest_size_percent = 0;
};
[[gnu::cold]] Agreement agreement_of(std::span<const Exhibit> exhibits);

/// The agreement in a sentence or two.
[[gnu::cold]] std::string agreement_text(const Agreement& agreement);

}  // namespace wellspaced
