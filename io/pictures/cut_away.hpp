// Pictures of tetrahedral meshes: cut open by a plane, as SVG.
#pragma once

#include <array>
#include <vector>

#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// width, line_width: as in PictureOptions.
/// from: the direction to the viewer, who is far away; z is upwards in the picture unless that is
///   the direction.
/// cut_normal, cut: what lies furthest along cut_normal is taken away, this share of the extent: 0
///   leaves all, 1 nothing.
struct CutAwayOptions {
  double width = 800;
  double line_width = 0.4;
  Point3 from{1, -0.6, 0.5};
  Point3 cut_normal{1, 0, 0};
  double cut = 0.5;
};

/// A face that is seen: its corners, and whether it is one only because of the cut.
struct SeenFace {
  std::array<Index, 3> corners{};
  bool is_cut = false;
  Point3 outwards;  ///< of length 1
};

/// The faces of what is left that look to the viewer, from back to front: tets are left whole,
/// those whose middle is behind the plane. The order is that of the depths of circumcentres; in a
/// Delaunay mesh no face then hides one that comes later, in others it seldom does.
/// Requires: finite coordinates, indices in range. Degenerate: flat tets are not there.
/// Cost: O(n log n).
std::vector<SeenFace> seen_faces(const TetMesh& mesh, const CutAwayOptions& options);

/// Draws seen_faces() as shaded triangles with their edges, those of the cut in a warm colour.
/// Requires: as seen_faces(). Degenerate: an empty picture if nothing is left.
/// Cost: O(n log n); about 50 bytes a face.
void write_cut_away_svg(TextWriter& out, const TetMesh& mesh, const CutAwayOptions& options = {});

}  // namespace wellspaced
