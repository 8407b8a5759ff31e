// Sets of files in Triangle's and TetGen's formats: X.node, X.ele, X.poly, ... together.
#pragma once

#include <cstdint>
#include <string>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Reads the set that `path`, one of its files, stands for: those of X.node, X.poly, X.smesh,
/// X.ele, X.face and X.edge that exist. Points come from X.node, or from X.poly where there is no
/// X.node; if both hold points, those of X.poly must be the first ones of X.node. Segments come
/// from X.poly, or else are the edges of X.edge with a marker other than 0. In space X.smesh may
/// stand for X.poly; but where there is an X.ele, the facets are those of X.face if that exists,
/// and the segments those of X.edge.
/// Errors: as the readers of triangle_text.hpp; kUnreadable if `path` is missing or nothing holds
/// points.
[[gnu::cold]] Result<Geometry> read_triangle_set(const std::string& path,
                                                 std::uint64_t largest = kLargestInput,
                                                 const Progress& progress = {});

/// Reads the one file `path`: a .node, or a .poly or .smesh (which may refer to its .node).
[[gnu::cold]] Result<Geometry> read_triangle_file(const std::string& path,
                                                  std::uint64_t largest = kLargestInput,
                                                  const Progress& progress = {});

/// Whether a set has an .ele without elements and a .poly without segments, holes and regions.
enum class EmptyFiles { kLeaveOut, kWrite };

/// Writes the set that `path`, with or without the extension of a file of it, stands for: .node,
/// .ele, .poly and, if that is the extension, .edge. A mesh in space has .face and .edge for the
/// .poly, unless it comes with polygons, holes or regions. An .ele or .poly that `path` names is
/// written in any case: what is read by that name must be there.
/// Errors: kUsage where `path` names a folder: "dir/", "..".
[[gnu::cold]] Status write_triangle_set(OutputSet& outputs, const std::string& path,
                                        const Geometry& geometry,
                                        EmptyFiles empty = EmptyFiles::kLeaveOut);

/// Writes a domain as one .poly file with its points.
[[gnu::cold]] Status write_poly_file(OutputSet& outputs, const std::string& path,
                                     const Geometry& geometry);

/// Writes a domain in space as one .smesh file with its points.
/// Errors: kUsage where a facet has holes or several polygons, or the domain lies in the plane.
[[gnu::cold]] Status write_smesh_file(OutputSet& outputs, const std::string& path,
                                      const Geometry& geometry);

/// "dir/X" for "dir/X.node", "dir/X.ele" and the other extensions of the set; else `path` itself.
std::string triangle_set_name(const std::string& path);

}  // namespace wellspaced
