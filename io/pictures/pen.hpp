// Line drawings on a grid of integers, as the data of SVG paths.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A place on the drawing grid.
struct GridPoint {
  int x = 0, y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// Maps a bounding box of points to a drawing of a given width: x to the right, y downwards.
class Canvas {
 public:
  /// Requires: finite points; width > 0. The height is at most `width` times 4 (a taller box is
  /// drawn smaller).
  Canvas(std::span<const Point2> points, int width);

  int width() const { return width_; }
  int height() const { return height_; }
  GridPoint place(Point2 p) const;

 private:
  Point2 low_{}, high_{};  // halved, so that their difference is finite
  double scale_ = 0;
  int width_ = 1, height_ = 1;
};

struct GridLine {
  GridPoint a, b;
  friend auto operator<=>(const GridLine&, const GridLine&) = default;
};

/// The data of one SVG path that draws each line once: strokes without lifting the pen wherever
/// lines continue each other, in relative coordinates. Lines of no length are left out.
/// Cost: O(n log n).
std::string path_data(std::vector<GridLine> lines);

}  // namespace wellspaced
