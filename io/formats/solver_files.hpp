// Mesh files of solvers: SU2, MFEM v1.0, ADCIRC's fort.14.
//
// Errors of the readers: kUnreadable for malformed text and for elements other than triangles in
// the plane and tetrahedra; kInvalidGeometry for an index out of range, NaN and infinity; kLimit
// for more than 2^32 - 2 points. Each names file and line. Cost: linear in the text.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// SU2: sections in any order; the tags of boundaries become markers and marker names. Several
/// zones are refused; FFD boxes and periodic data are passed over.
Result<Geometry> parse_su2(std::string_view text, const TextSource& source);
bool recognise_su2(std::string_view text);
/// Markers of points and elements have no place in the format.
/// Errors: kUsage for facets that are no triangles.
Status write_su2(OutputSet& outputs, const std::string& path, const Geometry& geometry);

/// MFEM mesh v1.0 with straight edges: attributes are markers.
Result<Geometry> parse_mfem(std::string_view text, const TextSource& source);
bool recognise_mfem(std::string_view text);
/// Attributes must be positive: a marker that is not becomes one more than the largest of its
/// dimension. Markers of points have no place in the format.
/// Errors: kUsage for facets that are no triangles.
Status write_mfem(OutputSet& outputs, const std::string& path, const Geometry& geometry);

/// fort.14, read only. The depth is the points' attribute. Open boundaries have marker 1, those of
/// land their type (IBTYPE) + 2; marker names say so. Islands are closed; of a pair of nodes across
/// a barrier both chains are boundary. Coordinates that may be degrees are noted.
Result<Geometry> parse_fort14(std::string_view text, const TextSource& source);
bool recognise_fort14(std::string_view text);

}  // namespace wellspaced
