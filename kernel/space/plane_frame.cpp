#include "wellspaced/kernel/space/plane_frame.hpp"

#include <vector>

namespace wellspaced {

Point2 PlaneFrame::coordinates(Point3 p) const {
  const double x = p.x - origin.x, y = p.y - origin.y, z = p.z - origin.z;
  return {x * u.x + y * u.y + z * u.z, x * v.x + y * v.y + z * v.z};
}

Point3 PlaneFrame::point(Point2 at) const {
  return {origin.x + at.x * u.x + at.y * v.x, origin.y + at.x * u.y + at.y * v.y,
          origin.z + at.x * u.z + at.y * v.z};
}

Result<Delaunay2> build_in_frame(std::span<const Point3> points, const PlaneFrame& frame) {
  std::vector<Point2> coordinates;
  coordinates.reserve(points.size());
  for (const Point3 p : points) coordinates.push_back(frame.coordinates(p));
  return Delaunay2::build(coordinates);
}

}  // namespace wellspaced
