// Walking through a tetrahedralization to a point. Used by Delaunay3.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <span>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/space/triangulation3.hpp"

namespace wellspaced {

/// On which side of facet f point p lies: positive on the side of the facet's tet, 0 on its plane.
/// Requires: no ghost vertex on the facet.
inline int side_of_facet(const Triangulation3& topology, std::span<const Point3> points,
                         Triangulation3::Facet f, Point3 p) {
  const auto [a, b, c] = topology.vertices(f);
  return orient3d(points[a], points[b], points[c], p);
}

/// The lowest facet of tet t but `entry` that has p strictly on its far side, or 4. Facets whose
/// side the filter cannot tell are asked only where none is certain.
/// Requires: t is no ghost.
inline unsigned exit_facet(const Triangulation3& topology, std::span<const Point3> points, Index t,
                           unsigned entry, Point3 p) {
  const auto& v = topology.vertices(t);
  const auto signs =
      predicate_filter::sides(points[v[0]], points[v[1]], points[v[2]], points[v[3]], p).signs();
  const unsigned candidates = 0b1111u & ~(1u << entry);
  if (signs.negative & candidates)
    return static_cast<unsigned>(std::countr_zero(signs.negative & candidates));
  for (unsigned i = 0; i < 4; ++i)
    if ((candidates & ~signs.certain) >> i & 1 && side_of_facet(topology, points, {t, i}, p) < 0)
      return i;
  return 4;
}

/// A tet that p lies in or on, or a ghost that p lies strictly beyond: from tet to tet, starting at
/// `hint`, over a facet that has p strictly on its far side. In a Delaunay triangulation that
/// cannot run in circles. Returns kNoIndex if may_enter(t) is false for a tet t on the way.
/// Requires: the triangulation is Delaunay, p finite; hint is a tet that may be entered.
template <class MayEnter>
Index walk(const Triangulation3& topology, std::span<const Point3> points, Point3 p, Index hint,
           MayEnter may_enter) {
  Index t = topology.is_ghost(hint) ? topology.neighbor(hint, 3) : hint;
  unsigned entry = 4;  // the facet over which t was entered; none yet
  for (Index steps = 0; steps <= topology.size(); ++steps) {
    if (!may_enter(t)) return kNoIndex;
    if (topology.is_ghost(t)) return t;
    const unsigned exit = exit_facet(topology, points, t, entry, p);
    if (exit == 4) return t;
    const auto entered = topology.mirror({t, exit});
    t = entered.tet;
    entry = entered.i;
  }
  assert(false && "the walk ran in circles");
  return kNoIndex;
}

/// The vertex of tet t that has the coordinates of p, or kNoIndex.
inline Index vertex_at(const Triangulation3& topology, std::span<const Point3> points, Index t,
                       Point3 p) {
  for (const Index v : topology.vertices(t))
    if (v != Triangulation3::kGhost && points[v] == p) return v;
  return kNoIndex;
}

}  // namespace wellspaced
