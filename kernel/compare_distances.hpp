// Which of two points is nearer to a third, exactly.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The sign of |a - p| - |b - p|: negative when a is nearer to p than b, 0 when they are equally
/// far. Exact for every finite double.
int compare_distances(Point3 p, Point3 a, Point3 b);

}  // namespace wellspaced
