// Medit's .mesh, as mmg, FreeFEM and CGAL write it: plain text.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Reads versions 1 to 4: vertices, edges, triangles, quadrilaterals and tetrahedra with their
/// references, which become markers. Corners, ridges, required items, normals and tangents are
/// passed over; what is not known is, too, with a note. A file of dimension 3 without tetrahedra
/// and with z = 0 throughout is a mesh in the plane.
/// Errors: kUnreadable for malformed text and other elements; kInvalidGeometry for an index out of
/// range, NaN and infinity; kLimit for more than 2^32 - 2 points. Each names file and line.
Result<Geometry> parse_medit(std::string_view text, const TextSource& source);
bool recognise_medit(std::string_view text);

/// Writes version 2 with the core keywords, which every reader knows.
/// Errors: kUsage for facets of more than four corners, or with holes.
Status write_medit(OutputSet& outputs, const std::string& path, const Geometry& geometry);

}  // namespace wellspaced
