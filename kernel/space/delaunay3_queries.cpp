#include "wellspaced/kernel/space/delaunay3_queries.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/kernel/index_set.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using Facet = Triangulation3::Facet;

}  // namespace

// ---- Validity ----------------------------------------------------------------------------------

// The vertex beyond the facet lies neither inside the sphere of a real tet nor beyond the plane of
// a ghost's hull facet.
static bool is_locally_delaunay(const Delaunay3& delaunay, Facet f) {
  const Triangulation3& topology = delaunay.topology();
  const auto& p = delaunay.points();
  const Index beyond = topology.apex(topology.mirror(f));
  if (beyond == Triangulation3::kGhost) return true;
  const auto& v = topology.vertices(f.tet);
  if (topology.is_ghost(f.tet)) return orient3d(p[v[0]], p[v[1]], p[v[2]], p[beyond]) >= 0;
  return insphere(p[v[1]], p[v[0]], p[v[2]], p[v[3]], p[beyond]) <= 0;
}

bool is_valid(const Delaunay3& delaunay) {
  const Triangulation3& topology = delaunay.topology();
  const auto& p = delaunay.points();
  if (!topology.is_valid()) return false;
  for (Index t = 0; t < topology.size(); ++t) {
    const auto& v = topology.vertices(t);
    if (!topology.is_ghost(t) && orient3d(p[v[1]], p[v[0]], p[v[2]], p[v[3]]) <= 0) return false;
    for (unsigned i = 0; i < 4; ++i)
      if (!is_locally_delaunay(delaunay, {t, i})) return false;
  }
  return true;
}

std::vector<std::array<Index, 4>> real_tets(const Delaunay3& delaunay) {
  const Triangulation3& topology = delaunay.topology();
  std::vector<std::array<Index, 4>> tets;
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) tets.push_back(topology.vertices(t));
  return tets;
}

// ---- The hull ----------------------------------------------------------------------------------

std::vector<std::array<Index, 3>> hull_facets(const Delaunay3& delaunay) {
  const Triangulation3& topology = delaunay.topology();
  std::vector<std::array<Index, 3>> facets;
  for (Index t = 0; t < topology.size(); ++t)
    if (topology.is_ghost(t)) facets.push_back(topology.vertices(topology.mirror({t, 3})));
  return facets;
}

// The ends of the edges that only one triangle has.
static std::vector<Index> boundary_vertices(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& v : triangles)
    for (unsigned i = 0; i < 3; ++i) edges.push_back(std::minmax({v[i], v[(i + 1) % 3]}));
  sort(edges);
  std::vector<Index> ends;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool twice =
        (i > 0 && edges[i - 1] == edges[i]) || (i + 1 < edges.size() && edges[i + 1] == edges[i]);
    if (!twice) ends.insert(ends.end(), {edges[i].first, edges[i].second});
  }
  return ends;
}

std::vector<Index> hull_vertices(const Delaunay3& delaunay) {
  std::vector<Index> vertices;
  if (delaunay.dimension() == 3) {
    for (const auto& facet : hull_facets(delaunay))
      vertices.insert(vertices.end(), facet.begin(), facet.end());
  } else if (delaunay.dimension() == 2) {
    vertices = boundary_vertices(delaunay.triangles());
  } else if (!delaunay.chain().empty()) {
    vertices = {delaunay.chain().front(), delaunay.chain().back()};
  }
  sort_unique(vertices);
  return vertices;
}

// ---- Around vertices and edges -----------------------------------------------------------------

std::vector<Index> star(const Delaunay3& delaunay, Index v) {
  const Triangulation3& topology = delaunay.topology();
  const Index first = delaunay.tet_of(v);
  if (first == kNoIndex) return {};
  std::vector<Index> tets{first};
  IndexSet met;
  met.insert(first);
  for (std::size_t next = 0; next < tets.size(); ++next) {
    const unsigned corner = topology.corner_of(tets[next], v);
    for (unsigned i = 0; i < 4; ++i) {
      const Index t = topology.neighbor(tets[next], i);
      if (i != corner && met.insert(t)) tets.push_back(t);
    }
  }
  return tets;
}

std::vector<Facet> link(const Delaunay3& delaunay, Index v) {
  std::vector<Facet> facets;
  for (const Index t : star(delaunay, v))
    facets.push_back({t, delaunay.topology().corner_of(t, v)});
  return facets;
}

std::vector<Index> neighbors(const Delaunay3& delaunay, Index v) {
  std::vector<Index> vertices;
  for (const Index t : star(delaunay, v))
    for (const Index u : delaunay.topology().vertices(t))
      if (u != v && u != Triangulation3::kGhost) vertices.push_back(u);
  sort_unique(vertices);
  return vertices;
}

std::vector<Index> tets_around_edge(const Triangulation3& topology, Index t, unsigned i,
                                    unsigned j) {
  const Index a = topology.vertex(t, i), b = topology.vertex(t, j);
  std::vector<Index> tets;
  unsigned exit = 0;  // a corner off the edge: the facet opposite holds the edge
  while (exit == i || exit == j) ++exit;
  for (Index here = t; tets.empty() || here != t;) {
    tets.push_back(here);
    const Facet entered = topology.mirror({here, exit});
    here = entered.tet;
    exit = 6 - entered.i - topology.corner_of(here, a) - topology.corner_of(here, b);
  }
  return tets;
}

// ---- Nearest vertex ----------------------------------------------------------------------------

static Index nearest_by_search(const Delaunay3& delaunay, Point3 p) {
  const auto& points = delaunay.points();
  Index best = points.empty() ? kNoIndex : 0;
  for (Index v = 1; v < points.size(); ++v)
    if (compare_distances(p, points[v], points[best]) < 0) best = v;
  return best;
}

// The lowest vertex as far from p as v: they are all connected by edges among them.
static Index lowest_equally_far(const Delaunay3& delaunay, Point3 p, Index v) {
  const auto& points = delaunay.points();
  std::vector<Index> equals{v};
  IndexSet met;
  met.insert(v);
  for (std::size_t next = 0; next < equals.size(); ++next)
    for (const Index u : neighbors(delaunay, equals[next]))
      if (compare_distances(p, points[u], points[v]) == 0 && met.insert(u)) equals.push_back(u);
  return *std::min_element(equals.begin(), equals.end());
}

Index nearest_vertex(const Delaunay3& delaunay, Point3 p, Index hint) {
  if (delaunay.dimension() < 3) return nearest_by_search(delaunay, p);
  const auto& points = delaunay.points();
  // A vertex that is not nearest has a neighbour that is nearer, so going there ends at the goal.
  Index best = delaunay.topology().vertex(delaunay.locate(p, hint).tet, 0), from = kNoIndex;
  while (best != from) {
    from = best;
    for (const Index u : neighbors(delaunay, from))
      if (compare_distances(p, points[u], points[best]) < 0) best = u;
  }
  return lowest_equally_far(delaunay, p, best);
}

// ---- Cells -------------------------------------------------------------------------------------

namespace {

// Whether the two tets at a facet, both real, have the same circumsphere.
bool share_sphere(const Delaunay3& delaunay, Facet f) {
  const auto& p = delaunay.points();
  const auto& v = delaunay.topology().vertices(f.tet);
  const Index opposite = delaunay.topology().apex(delaunay.topology().mirror(f));
  return insphere(p[v[0]], p[v[1]], p[v[2]], p[v[3]], p[opposite]) == 0;
}

// The vertices of the tets reached from `first` over facets that bound no cell.
std::vector<Index> cell_from(const Delaunay3& delaunay, Index first, std::vector<bool>& done) {
  const Triangulation3& topology = delaunay.topology();
  std::vector<Index> tets{first}, vertices;
  done[first] = true;
  for (std::size_t next = 0; next < tets.size(); ++next) {
    const Index t = tets[next];
    vertices.insert(vertices.end(), topology.vertices(t).begin(), topology.vertices(t).end());
    for (unsigned i = 0; i < 4; ++i) {
      const Index beyond = topology.neighbor(t, i);
      if (done[beyond] || topology.is_ghost(beyond) || !share_sphere(delaunay, {t, i})) continue;
      done[beyond] = true;
      tets.push_back(beyond);
    }
  }
  sort_unique(vertices);
  return vertices;
}

}  // namespace

std::vector<std::vector<Index>> delaunay_cells(const Delaunay3& delaunay) {
  const Triangulation3& topology = delaunay.topology();
  std::vector<bool> done(topology.size());
  std::vector<std::vector<Index>> cells;
  for (Index t = 0; t < topology.size(); ++t)
    if (!done[t] && !topology.is_ghost(t)) cells.push_back(cell_from(delaunay, t, done));
  return cells;
}

}  // namespace wellspaced
