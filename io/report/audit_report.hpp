// The report of an audit as JSON, as a table and as a picture.
#pragma once

#include <string>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/json/json_writer.hpp"

namespace wellspaced {

/// Appends the members of the JSON object of `audit --json`: "verdict", "checks", "measures",
/// "histograms", "worst", and "witnesses" and "theorems" where there are any. "first" holds the ids
/// of the first ten violations, as many ids for each as its item takes. Measures and witnesses of
/// the levels of a hierarchy stand in "levels", level by level.
[[gnu::cold]] void append_audit_json(JsonWriter& json, const audit::Report& report);

/// A table for people: the verdict, the checks, the measures. Of the levels of a hierarchy it shows
/// the checks that fail, the theorems that apply, and a line of measures each.
[[gnu::cold]] std::string audit_table(const audit::Report& report);

/// Adds to a grid, for each check that fails, a field named as the check, 1 at the offenders:
/// a cell field for triangles and tetrahedra, a point field for nodes and the nodes of edges and
/// faces. Requires: the cells of the grid begin with the triangles or tetrahedra, in their order.
void mark_offenders(const audit::Report& report, VtkGrid& grid);

}  // namespace wellspaced
