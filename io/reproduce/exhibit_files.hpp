// Exhibits as text for the terminal and as files: CSV, JSON and SVG.
#pragma once

#include <string>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/io/reproduce/exhibit.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The tables as text: three lines a row (ours, the thesis', the difference), one where nothing is
/// published; "*" marks what is_beyond. Then each deviation with its reason.
[[gnu::cold]] std::string exhibit_text(const Exhibit& exhibit);

/// A table as CSV: one line a row; for each column ours, the least and greatest of our runs and, in
/// tables where something is published, the published figure and the difference.
[[gnu::cold]] std::string table_csv(const ExhibitTable& table);

/// Appends one JSON object: names, notes, tables with their cells, deviations.
[[gnu::cold]] void append_exhibit_json(JsonWriter& json, const Exhibit& exhibit);

/// Adds NAME.json, a CSV for each table and an SVG for each picture to `outputs`, in `directory`.
[[gnu::cold]] Status add_exhibit(OutputSet& outputs, const std::string& directory,
                                 const Exhibit& exhibit);

/// Whether anything of the table, or of the row, is published.
bool has_published(const ExhibitTable& table);
bool has_published(const ExhibitRow& row);

}  // namespace wellspaced
