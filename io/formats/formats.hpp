// All file formats by name, extension and content: the one place that knows them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "wellspaced/algorithms/mesh/prepare_mesh.hpp"
#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// What a geometry may hold beside its points; sets of them are sums.
struct GeometryPart {
  enum : unsigned {
    kPointAttributes = 1,
    kPointMarkers = 2,
    kCells = 4,  ///< triangles in the plane, tetrahedra
    kCellAttributes = 8,
    kCellMarkers = 16,  ///< attributes that are one column of 32-bit integers
    kSegments = 32,
    kSegmentsInSpace = 64,
    kSegmentMarkers = 128,
    kFacets = 256,
    kFacetMarkers = 512,
    kMarkersBelowOne = 1024,  ///< of segments and facets, beside others
    kHolesAndRegions = 2048,
    kMarkerNames = 4096
  };
};

/// A file format. What it cannot do is null.
struct Format {
  std::string_view name;        ///< as in --format
  std::string_view extensions;  ///< ".node .ele": those that stand for it
  std::string_view about;       ///< one line for the help
  unsigned keeps;               ///< the parts of a geometry that it has a place for
  /// Reads one whole text.
  Result<Geometry> (*parse)(std::string_view text, const TextSource& source);
  /// Whether a text of unknown origin seems to be in this format.
  bool (*recognise)(std::string_view text);
  Status (*write)(OutputSet& outputs, const std::string& path, const Geometry& geometry);
  /// For a format of several files: reads those that `path` stands for.
  Result<Geometry> (*read_files)(const std::string& path, std::uint64_t largest,
                                 const Progress& progress) = nullptr;

  bool readable() const { return parse != nullptr || read_files != nullptr; }
};
std::span<const Format> formats();

/// What the name of a file of Triangle's stands for: the file alone, or all files of its set.
enum class Siblings { kIgnored, kRead };

struct ReadOptions {
  std::string format = {};                ///< empty: by extension and content
  Siblings siblings = Siblings::kRead;    ///< a .poly without points reads its .node in any case
  std::uint64_t largest = kLargestInput;  ///< of one file, in bytes
  Progress progress = {};                 ///< phase "read", for each file anew
};

/// Reads points, a domain or a mesh, in any format; "-" is the standard input. Where there is no
/// file "X", but X.node or X.poly, these are read.
/// Errors: kUnreadable, kInvalidGeometry and kLimit as the readers say; kUsage for a format that
/// does not exist or cannot be read.
[[gnu::cold]] Result<Geometry> read_geometry(const std::string& path,
                                             const ReadOptions& options = {});

/// Checks and completes the triangle mesh of `geometry`: see prepare_mesh(). What a user should
/// know (turned triangles, points in no triangle) joins its notes. `name` is for messages.
Status prepare_geometry(Geometry& geometry, const std::string& name, const Progress& progress = {});

/// Reads a triangle mesh in the plane and prepares it.
/// Errors: also kUnreadable where the file holds no triangles.
[[gnu::cold]] Result<Geometry> read_mesh(const std::string& path, const ReadOptions& options = {});

/// The domain that a geometry in the plane describes; its triangles are left out.
Pslg to_pslg(Geometry geometry);

/// The domain that a geometry in space describes; its tetrahedra are left out.
Pls to_pls(Geometry geometry);

/// Writes to `path` in the format of that name, or of its extension where `format` is empty, or as
/// Triangle's files where there is no extension.
/// Errors: kUsage for a format that does not exist, cannot be written or has no place for the
/// geometry; kUsage and kLimit as OutputSet::add().
[[gnu::cold]] Status write_geometry(OutputSet& outputs, const std::string& path,
                                    const std::string& format, const Geometry& geometry);

/// The parts that a geometry holds: a set of GeometryPart.
unsigned parts_of(const Geometry& geometry);

/// In words, those of the parts that write_geometry() leaves out, as the format has no place for
/// them: "point markers, holes and regions"; empty where there are none.
std::string parts_left_out(const std::string& path, const std::string& format, unsigned parts);

/// Whether an output of that name and format, as they are given on a command line, is a set of
/// Triangle's files: also where neither says anything.
bool writes_triangle_files(const std::string& path, const std::string& format);

/// A domain as a geometry, to be written with the given index base.
Geometry to_geometry(Pls domain, Index index_base = 0);
/// A mesh as a geometry, to be written with the given index base.
Geometry to_geometry(TriangleMesh mesh, Index index_base = 0);
Geometry to_geometry(TetMesh mesh, Index index_base = 0);

}  // namespace wellspaced
