// The report of coarsening sequences: one HTML file that opens from disk and loads nothing.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A level as the report shows it. origin: for each node its number in the input mesh; empty: the
/// nodes of the input mesh itself, in its order.
struct ReportLevel {
  const TriangleMesh* mesh = nullptr;
  std::span<const Index> origin;
  LevelStatistics statistics;
};

/// Names and values, as they are to be read.
using ReportParameters = std::vector<std::pair<std::string, std::string>>;

/// A coarsening sequence, the input mesh first. method: as on the command line, "function" or
/// "mis"; known methods are explained in the report's text.
struct ReportMethod {
  std::string method;
  ReportParameters parameters;
  std::vector<ReportLevel> levels;
};

/// One or several sequences of the same input mesh. Levels of more than max_drawn_nodes nodes are
/// counted and measured in the report, but not drawn.
struct HtmlReport {
  std::string title;
  ReportParameters parameters;
  std::vector<ReportMethod> methods;
  std::size_t max_drawn_nodes = 100'000;
};

/// The report as an HTML text: the levels drawn with a slider through them, charts, tables and
/// parameters. The same report gives the same bytes.
/// Requires: at least one method, each with at least one level; meshes and origins in range, and
///   every origin names the same input mesh.
/// Cost: O(n log n) time in the nodes drawn; about 35 bytes of text for each of them in a level.
[[gnu::cold]] std::string report_html(const HtmlReport& report);

}  // namespace wellspaced
