// Triangulated and polygonal surfaces: OFF, OBJ and STL.
//
// A surface in space is read as facets (Geometry::solid.facets or polygons); one whose points all
// have z = 0 and whose faces are triangles is read as a mesh in the plane. Writers take facets, or
// the triangles of a mesh in the plane, and refuse tetrahedra, holes and facets of several
// polygons.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

// Errors of the readers: kUnreadable for malformed text; kInvalidGeometry for an index out of
// range, NaN and infinity; kLimit for more than 2^32 - 2 points. Each names file and line. Cost:
// linear in the text; STL O(n log n).

/// OFF, COFF, NOFF, STOFF or without a keyword; normals, colours and texture coordinates are passed
/// over. OFF BINARY and 4OFF are refused. Faces of one or two corners are points and segments.
Result<Geometry> parse_off(std::string_view text, const TextSource& source);
bool recognise_off(std::string_view text);
/// Segments and markers have no place in the format.
Status write_off(OutputSet& outputs, const std::string& path, const Geometry& geometry);

/// Vertices, faces, lines; groups ("g NAME") become markers, other statements are passed over.
Result<Geometry> parse_obj(std::string_view text, const TextSource& source);
bool recognise_obj(std::string_view text);
Status write_obj(OutputSet& outputs, const std::string& path, const Geometry& geometry);

/// ASCII or binary: binary if the size is what its count says. Corners with the same coordinates
/// (-0 = +0) become one point. Facets two of whose corners are one point are left out, and a note
/// tells how many. Where there are several solids, a facet's marker is the number of its own,
/// from 1.
Result<Geometry> parse_stl(std::string_view bytes, const TextSource& source);
bool recognise_stl(std::string_view bytes);
/// ASCII keeps the coordinates exactly. Markers and segments have no place in the format.
Status write_stl(OutputSet& outputs, const std::string& path, const Geometry& geometry);
/// Binary rounds the coordinates to 32 bits. Errors: also kUsage where one does not fit.
Status write_stl_binary(OutputSet& outputs, const std::string& path, const Geometry& geometry);

}  // namespace wellspaced
