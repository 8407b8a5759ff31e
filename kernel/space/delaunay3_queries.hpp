// What there is around the vertices and edges of a Delaunay triangulation of space.
#pragma once

#include <array>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced {

/// Whether the triangulation holds what Delaunay3 promises: its topology is valid, no tet is flat
/// or inverted, the hull is convex, and no vertex lies inside the circumsphere of the tet on the
/// other side of a facet; by Delaunay's lemma then none lies inside any. True below dimension 3.
/// Cost: linear, five exact signs a tet.
bool is_valid(const Delaunay3& delaunay);

/// The tets, ghosts left out, each positive. Empty below dimension 3.
std::vector<std::array<Index, 4>> real_tets(const Delaunay3& delaunay);

/// The facets of the convex hull, counter-clockwise seen from outside. Where more than three
/// vertices lie on one plane it is cut into triangles. Empty below dimension 3.
std::vector<std::array<Index, 3>> hull_facets(const Delaunay3& delaunay);

/// The vertices on the boundary of the convex hull, ascending; below dimension 3 the boundary
/// within what the points span: of a chain its two ends.
std::vector<Index> hull_vertices(const Delaunay3& delaunay);

/// The tets of vertex v, ghosts included; empty if v is a duplicate or below dimension 3.
/// Cost: linear in their number, as for the queries below.
std::vector<Index> star(const Delaunay3& delaunay, Index v);

/// The facets of the star of v opposite v, ghosts included: a sphere around v.
std::vector<Triangulation3::Facet> link(const Delaunay3& delaunay, Index v);

/// The vertices that v shares an edge with, ascending.
std::vector<Index> neighbors(const Delaunay3& delaunay, Index v);

/// The tets around the edge between corners i and j of tet t, ghosts included, in the order in
/// which they follow each other, t first. Requires: i != j.
std::vector<Index> tets_around_edge(const Triangulation3& topology, Index t, unsigned i,
                                    unsigned j);

/// The vertex nearest to p, the lowest number among several; kNoIndex if there is none. `hint` as
/// for Delaunay3::locate. Requires: p finite.
/// Cost: that of locate; below dimension 3 linear in the points.
Index nearest_vertex(const Delaunay3& delaunay, Point3 p, Index hint = 0);

/// The Delaunay polyhedra: tets whose circumspheres are exactly the same are one cell. Each is the
/// ascending list of its vertices. Empty below dimension 3.
/// The cells, as a set, do not depend on how ties are broken.
/// Cost: one exact test a facet.
std::vector<std::vector<Index>> delaunay_cells(const Delaunay3& delaunay);

}  // namespace wellspaced
