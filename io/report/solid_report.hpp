// The report of a tetrahedral mesh: one HTML file that opens from disk and loads nothing.
#pragma once

#include <cstddef>
#include <string>

#include "wellspaced/io/report/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// parameters: what the page lists beside the picture. A mesh of more than max_drawn_tets is not
/// drawn.
struct SolidReport {
  std::string title;
  ReportParameters parameters;
  const TetMesh* mesh = nullptr;
  std::size_t max_drawn_tets = 150'000;
};

/// The report as an HTML text: the mesh can be turned, and cut open across each axis. The same
/// report gives the same bytes. Coordinates are rounded to 2^-32 of the extent.
/// Requires: a mesh with indices in range and finite coordinates. Degenerate: flat tets are left
///   out.
/// Cost: linear; 22 bytes of text a tet.
[[gnu::cold]] std::string solid_report_html(const SolidReport& report);

}  // namespace wellspaced
