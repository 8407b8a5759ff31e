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
std::string chapter_html(const ChapterPage& page);

/// Over the function-based rows with at least 50 published nodes of the comparable tables: the
/// largest difference in nodes, in percent, and how many rows there are.
struct SizeAgreement {
  double largest_percent = 0;
  std::size_t rows = 0;
};
SizeAgreement size_agreement(std::span<const Exhibit> exhibits);

}  // namespace wellspaced
