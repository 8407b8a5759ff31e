// Exact geometric predicates: orient2d, incircle, orient3d, insphere, compare_distances.
//
// Each returns the sign of a determinant of its points' coordinates, exact for every finite double,
// subnormals included. Three rungs, each asked only if the one before cannot tell: a floating-point
// filter inlined here (predicate_filter.hpp), integers of fixed width, integers of any width (both
// in exact_predicates.hpp, compiled once in predicates.cpp).
//
// Laws: exchanging two points reverses the sign (for incircle and insphere any two as well); so a
// sign never depends on the order in which points are given, beyond the parity. Scaling all
// coordinates by a power of two and exact translation change nothing.
//
// Requires: finite coordinates, and IEEE double arithmetic that rounds to nearest and keeps
// subnormals while a predicate runs: not another rounding mode, and no flushing to zero, which some
// compilers switch on at the start of a program that is linked with -ffast-math, -Ofast or
// -funsafe-math-optimizations. Compiling with -ffast-math, or a part of it that lets a sum be
// rearranged, is an error (gcc) or has no effect in here (clang). Cost: a few ns where the filter
// decides, tens of ns on grids and cocircular points, microseconds where the coordinates' exponents
// lie more than 72 apart.
//
// Header-only use: define WELLSPACED_HEADER_ONLY in every source file, and link nothing.
#pragma once

#include <array>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

#ifdef WELLSPACED_HEADER_ONLY
#include "wellspaced/kernel/exact_predicates.hpp"
#endif

namespace wellspaced {

/// Rungs 2 and 3, out of line: the exact sign without the filter, for the points' coordinates one
/// after the other.
namespace predicate_exact {
#ifdef WELLSPACED_HEADER_ONLY
using exact::compare_distances, exact::incircle, exact::insphere, exact::orient2d, exact::orient3d;
#else
int compare_distances(const std::array<double, 6>& x);
int compare_distances(const std::array<double, 9>& x);
int orient2d(const std::array<double, 6>& x);
int incircle(const std::array<double, 8>& x);
int orient3d(const std::array<double, 12>& x);
int insphere(const std::array<double, 15>& x);
#endif
}  // namespace predicate_exact

/// The sign (-1, 0, 1) of det[a-c; b-c]: positive when a, b, c make a left turn, 0 when they lie
/// on one line.
inline int orient2d(Point2 a, Point2 b, Point2 c) {
  const int sign = predicate_filter::orient2d(a, b, c);
  return sign != 0 ? sign : predicate_exact::orient2d({a.x, a.y, b.x, b.y, c.x, c.y});
}

/// Positive when d lies inside the circle through a, b, c, negative outside, 0 on it.
/// Requires: orient2d(a, b, c) > 0; with a, b, c clockwise the sign is reversed.
/// Degenerate: for a, b, c on one line it is the sign of the determinant with rows (p-d, |p-d|^2),
/// p = a, b, c: positive when d lies to the left of the circle of infinite radius.
inline int incircle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const int sign = predicate_filter::incircle(a, b, c, d);
  return sign != 0 ? sign : predicate_exact::incircle({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
}

/// The sign of det[a-d; b-d; c-d] (Shewchuk's convention: positive when d lies below the plane
/// in which a, b, c appear counter-clockwise seen from above), 0 when they lie on one plane.
inline int orient3d(Point3 a, Point3 b, Point3 c, Point3 d) {
  const int sign = predicate_filter::orient3d(a, b, c, d);
  return sign != 0 ? sign
                   : predicate_exact::orient3d(
                         {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
}

/// The sign of the determinant with rows (p-e, |p-e|^2), p = a, b, c, d: positive when e lies
/// inside the sphere through a, b, c, d, 0 on it. Requires: orient3d(a, b, c, d) > 0; where it is
/// negative the sign is reversed.
inline int insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) {
  const int sign = predicate_filter::insphere(a, b, c, d, e);
  return sign != 0 ? sign
                   : predicate_exact::insphere({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x,
                                                d.y, d.z, e.x, e.y, e.z});
}

/// Whether p, which is collinear with a and b, lies strictly between them.
inline bool strictly_between(Point2 a, Point2 p, Point2 b) {
  return b < a ? b < p && p < a : a < p && p < b;
}

/// The sign of |a-p| - |b-p|: negative when a is nearer to p than b, 0 when they are equally far.
inline int compare_distances(Point2 p, Point2 a, Point2 b) {
  const int sign = predicate_filter::compare_distances(p, a, b);
  return sign != 0 ? sign
                   : predicate_exact::compare_distances(std::array{a.x, a.y, b.x, b.y, p.x, p.y});
}
inline int compare_distances(Point3 p, Point3 a, Point3 b) {
  const int sign = predicate_filter::compare_distances(p, a, b);
  return sign != 0 ? sign
                   : predicate_exact::compare_distances(
                         std::array{a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z});
}

}  // namespace wellspaced
