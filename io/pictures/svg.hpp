// SVG pictures of meshes: small files, crisp lines.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

struct PictureOptions {
  double width = 800;         ///< of a mesh, in pixels; its height follows from the mesh
  double line_width = 0.6;    ///< of mesh edges, in pixels, however far one zooms in
  double border_width = 1.6;  ///< of segments
  double zoom = 1;            ///< more than 1: a part only, so many times larger; not for panels
  std::optional<Point2> centre = {};  ///< of that part; default: the densest place, the median
};

/// Draws the edges of `mesh`, its segments on top and, without either, its points.
/// Coordinates are rounded to a tenth of a pixel, edges that become equal are drawn once, and all
/// edges make one path of long pen strokes: about 5 bytes an edge.
/// Requires: finite coordinates. Cost: O(n log n).
void write_mesh_svg(TextWriter& out, const TriangleMesh& mesh, const PictureOptions& options = {});

/// Draws a disk of its radius around each point, over the edges and segments of `mesh`.
/// radii: one a point, >= 0; those of radius 0 are dots.
/// Requires: finite coordinates. Cost: O(n log n).
void write_disks_svg(TextWriter& out, const TriangleMesh& mesh, std::span<const double> radii,
                     const PictureOptions& options = {});

/// One mesh of a sequence, and what is written under its picture.
struct Panel {
  const TriangleMesh* mesh = nullptr;
  std::string caption;
};

/// Draws the meshes side by side, `columns` in a row, all to the scale of the first.
/// Requires: columns > 0.
void write_panels_svg(TextWriter& out, std::span<const Panel> panels, std::size_t columns,
                      const PictureOptions& options = {});

}  // namespace wellspaced
