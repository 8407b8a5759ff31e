// Gmsh's .msh: versions 2 (2.0 to 2.2) and 4.1, as text and binary.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Reads nodes, points, lines, triangles and tetrahedra. An element's marker is its physical group:
/// the first of them where its entity has several. Elementary tags are no markers. Physical names
/// become marker names; an element that is listed once for each of its groups is read once, with a
/// note. Nodes may have any numbers. Sections that are not known are passed over, as are parameters
/// of nodes. Without tetrahedra and with z = 0 throughout it is a mesh in the plane.
/// Errors: kUnreadable for malformed text, other elements (quadrilaterals, curved ones) and other
/// versions; kInvalidGeometry for a node that does not exist, NaN and infinity; kLimit for more
/// than 2^32 - 2 nodes. Each names file and line; within binary data the line is where they begin.
/// Cost: O(n log n).
Result<Geometry> parse_gmsh(std::string_view bytes, const TextSource& source);
bool recognise_gmsh(std::string_view bytes);

/// The name of the physical group of elements without a marker; it is read as marker 0.
inline constexpr std::string_view kGmshUnmarked = "unmarked";

enum class GmshVersion { k22, k41 };
enum class GmshEncoding { kAscii, kBinary };
struct GmshStyle {
  GmshVersion version = GmshVersion::k41;
  GmshEncoding encoding = GmshEncoding::kAscii;
};

/// Writes the elements in their order; points with a marker become point elements. Where only some
/// elements have a marker, the others are put into a physical group kGmshUnmarked, since Gmsh drops
/// elements that are in none.
/// Errors: kUsage for facets that are no triangles.
Status write_gmsh(OutputSet& outputs, const std::string& path, const Geometry& geometry,
                  GmshStyle style = {});

}  // namespace wellspaced
