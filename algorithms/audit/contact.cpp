#include "wellspaced/algorithms/audit/contact.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced::audit {
namespace {

// The projections along the three axes.
Point2 projected(Point3 p, int axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

int orientation_along(int axis, Point3 a, Point3 b, Point3 c) {
  return orient2d(projected(a, axis), projected(b, axis), projected(c, axis));
}

// An axis along which the triangle does not look flat.
int viewing_axis(const Corners3& t) {
  for (int axis = 0; axis < 2; ++axis)
    if (orientation_along(axis, t[0], t[1], t[2]) != 0) return axis;
  return 2;
}

bool all_on_one_side(int a, int b, int c) {
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

// For points of one plane: whether the closed segments p q and a b meet.
bool segments_meet_in_plane(int axis, Point3 p, Point3 q, Point3 a, Point3 b) {
  const auto side = [&](Point3 u, Point3 v, Point3 w) { return orientation_along(axis, u, v, w); };
  const int at_a = side(p, q, a), at_b = side(p, q, b);
  const int at_p = side(a, b, p), at_q = side(a, b, q);
  if (at_a * at_b > 0 || at_p * at_q > 0) return false;
  if (at_a != 0 || at_b != 0) return true;
  // All on one line: compare along it.
  const auto key = [](Point3 x) { return std::array{x.x, x.y, x.z}; };
  const auto [p_low, p_high] = std::minmax({key(p), key(q)});
  const auto [a_low, a_high] = std::minmax({key(a), key(b)});
  return p_low <= a_high && a_low <= p_high;
}

bool contains_in_plane(int axis, const Corners3& t, Point3 p) {
  return all_on_one_side(orientation_along(axis, t[0], t[1], p),
                         orientation_along(axis, t[1], t[2], p),
                         orientation_along(axis, t[2], t[0], p));
}

bool segment_meets_in_plane(Point3 p, Point3 q, const Corners3& t) {
  const int axis = viewing_axis(t);
  if (contains_in_plane(axis, t, p)) return true;
  for (int i = 0; i < 3; ++i)
    if (segments_meet_in_plane(axis, p, q, t[i], t[(i + 1) % 3])) return true;
  return false;
}

// Rotates the triangles so that their shared corners come first, in the same order for both;
// returns how many there are.
int align(std::array<Point3, 3>& a, std::array<Index, 3>& a_nodes, std::array<Point3, 3>& b,
          std::array<Index, 3>& b_nodes) {
  int shared = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = shared; j < 3; ++j) {
      if (a_nodes[i] != b_nodes[j]) continue;
      std::swap(a[i], a[shared]), std::swap(a_nodes[i], a_nodes[shared]);
      std::swap(b[j], b[shared]), std::swap(b_nodes[j], b_nodes[shared]);
      ++shared;
      break;
    }
  return shared;
}

// Triangles u v p and u v q: on the same side of u v in one plane.
bool folded_together(Point3 u, Point3 v, Point3 p, Point3 q) {
  if (orient3d(u, v, p, q) != 0) return false;
  const int axis = viewing_axis({u, v, p});
  return orientation_along(axis, u, v, p) == orientation_along(axis, u, v, q);
}

bool any_edge_meets(const Corners3& a, const Corners3& b) {
  for (int i = 0; i < 3; ++i)
    if (segment_meets_triangle(a[i], a[(i + 1) % 3], b)) return true;
  return false;
}

// Whether the plane through p, q, r, which has three corners of a or of b on it, separates a and b.
bool separates(Point3 p, Point3 q, Point3 r, const TetCorners& a, const TetCorners& b) {
  int side_of_a = 0;
  for (const Point3& corner : a) {
    const int sign = orient3d(p, q, r, corner);
    if (sign * side_of_a < 0) return false;
    if (sign != 0) side_of_a = sign;
  }
  if (side_of_a == 0) return false;  // p, q and r are on one line
  return all_of(b,
                [&](const Point3& corner) { return orient3d(p, q, r, corner) * side_of_a <= 0; });
}

bool a_face_separates(const TetCorners& a, const TetCorners& b) {
  return separates(a[1], a[2], a[3], a, b) || separates(a[0], a[2], a[3], a, b) ||
         separates(a[0], a[1], a[3], a, b) || separates(a[0], a[1], a[2], a, b);
}

bool an_edge_separates(const TetCorners& a, const TetCorners& b) {
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 4; ++j)
      for (const Point3& corner : b)
        if (separates(a[i], a[j], corner, a, b)) return true;
  return false;
}

}  // namespace

bool segment_meets_triangle(Point3 p, Point3 q, const Corners3& t) {
  const int at_p = orient3d(t[0], t[1], t[2], p), at_q = orient3d(t[0], t[1], t[2], q);
  if (at_p * at_q > 0) return false;
  if (at_p == 0 && at_q == 0) return segment_meets_in_plane(p, q, t);
  return all_on_one_side(orient3d(p, q, t[0], t[1]), orient3d(p, q, t[1], t[2]),
                         orient3d(p, q, t[2], t[0]));
}

bool meet_improperly(const std::array<Point3, 3>& a, const std::array<Index, 3>& a_nodes,
                     const std::array<Point3, 3>& b, const std::array<Index, 3>& b_nodes) {
  auto c = a, d = b;
  auto c_nodes = a_nodes, d_nodes = b_nodes;
  switch (align(c, c_nodes, d, d_nodes)) {
    case 0:
      return any_edge_meets(c, d) || any_edge_meets(d, c);
    case 1:  // what they have in common beside the corner reaches an edge opposite it
      return segment_meets_triangle(c[1], c[2], d) || segment_meets_triangle(d[1], d[2], c);
    default:
      return folded_together(c[0], c[1], c[2], d[2]);
  }
}

bool interiors_overlap(const TetCorners& a, const TetCorners& b) {
  return !a_face_separates(a, b) && !a_face_separates(b, a) && !an_edge_separates(a, b) &&
         !an_edge_separates(b, a);
}

}  // namespace wellspaced::audit
