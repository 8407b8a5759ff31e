// Triangle's and TetGen's text formats, one text at a time: .node, .ele, .poly, .smesh, .edge,
// .face.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

// Common to all readers. The number of the first point, 0 or 1, is the index base of its file and
// of all files that go with it; points are numbered upwards from there without a gap. Columns that
// the header does not announce are ignored, as Triangle does; lines that it does not announce are
// an error. Points that coincide, or that nothing refers to, are kept.
// `name` is the file's name for messages.
// Errors: kUnreadable for malformed, truncated or miscounted text; kInvalidGeometry for an index
// out of range, NaN and infinity; kLimit for more than 2^32 - 2 points. Nothing is allocated for a
// count that the text is too short to keep.
// Cost: linear in the text.

/// Reads points in the plane or in space, with attributes and markers.
Result<Geometry> parse_node(std::string_view text, const TextSource& source);

/// Reads a planar straight-line graph: points, segments, holes and regions; the hole and region
/// sections may be missing. Where the text holds no points, those of `points` are taken, which
/// come from its .node file. A region without a largest area takes its attribute for it, as in
/// Triangle. Over points in space it is TetGen's: facets with their polygons and holes, then holes
/// and regions of the volume.
Result<Geometry> parse_poly(std::string_view text, const TextSource& source,
                            const Geometry* points = nullptr);

/// Reads TetGen's simpler description of a domain in space: facets of one polygon each.
Result<Geometry> parse_smesh(std::string_view text, const TextSource& source,
                             const Geometry* points = nullptr);

/// Whether a .poly or .smesh text holds no points of its own, but refers to a .node file.
bool poly_refers_to_node(std::string_view text);

/// Adds to `geometry` its triangles (3 corners) or tetrahedra (4), with their attributes.
Status parse_ele(std::string_view text, const TextSource& source, Geometry& geometry);

/// Reads edges between the points of `geometry`, with their markers (0 where there is none).
Result<std::vector<Segment>> parse_edge(std::string_view text, const TextSource& source,
                                        const Geometry& geometry);

/// Reads triangles between the points of `geometry`, which lie in space, with their markers.
Result<std::vector<TetMesh::Facet>> parse_face(std::string_view text, const TextSource& source,
                                               const Geometry& geometry);

// The writers mirror the readers: numbers are shortest and read back bit for bit; everything is
// numbered from geometry.index_base; markers are written where there are any.

void write_node(TextWriter& out, const Geometry& geometry);
void write_ele(TextWriter& out, const Geometry& geometry);

enum class PolyPoints { kInside, kInNodeFile };
/// Writes the segments, holes and regions, with the points or with a reference to the .node file.
void write_poly(TextWriter& out, const Geometry& geometry, PolyPoints points);

/// Writes a domain in space whose facets all have one polygon and no holes. Requires: they do.
void write_smesh(TextWriter& out, const Geometry& geometry, PolyPoints points);
void write_face(TextWriter& out, const Geometry& geometry);

/// Writes all edges of the triangles and all segments, ascending, with the markers of the segments;
/// of a mesh in space the segments alone.
void write_edge(TextWriter& out, const Geometry& geometry);

}  // namespace wellspaced
