// TetGen's descriptions of domains in space: what follows the points in .poly and .smesh files.
#pragma once

#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/io/text/text_writer.hpp"

namespace wellspaced {

/// How facets are listed: kPoly with their polygons and holes, kSmesh as one polygon a line.
enum class FacetSyntax { kPoly, kSmesh };

/// Reads facets, holes and regions; the last two sections may be missing. The corners of a polygon
/// may go on in the next line. Failures stick in the scanner.
void read_space_domain(Scanner& scanner, FacetSyntax syntax, Geometry& geometry);

/// Writes what read_space_domain() reads. Segments become facets of two points, as TetGen has it.
/// Requires for kSmesh: no facet has holes or more than one polygon.
void write_space_domain(TextWriter& out, FacetSyntax syntax, const Geometry& geometry);

}  // namespace wellspaced
