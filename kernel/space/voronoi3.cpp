#include "wellspaced/kernel/space/voronoi3.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

using Facet = Triangulation3::Facet;

Point3 along(Point3 a, Point3 b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

// ---- Which facets there are --------------------------------------------------------------------

// Whether the Voronoi vertices of the two tets at a facet are the same; those of ghosts lie at
// infinity, in the direction off their hull facets.
bool have_same_centre(const Delaunay3& delaunay, Facet f) {
  const Triangulation3& topology = delaunay.topology();
  const auto& p = delaunay.points();
  const Facet m = topology.mirror(f);
  if (topology.is_ghost(f.tet) != topology.is_ghost(m.tet)) return false;
  const auto& v = topology.vertices(f.tet);
  const Index w = topology.apex(m);
  if (topology.is_ghost(f.tet)) return orient3d(p[v[0]], p[v[1]], p[v[2]], p[w]) == 0;
  return insphere(p[v[0]], p[v[1]], p[v[2]], p[v[3]], p[w]) == 0;
}

// The tets around a vertex, and for each the number of its Voronoi vertex.
struct Corners {
  std::vector<std::pair<Index, Index>> centre_of_tet;  // ascending

  Index* find(Index t) {
    const auto at =
        std::lower_bound(centre_of_tet.begin(), centre_of_tet.end(), std::pair(t, Index{0}));
    return at != centre_of_tet.end() && at->first == t ? &at->second : nullptr;
  }
};

Corners corners_around(const Delaunay3& delaunay, const std::vector<Index>& tets) {
  Corners corners;
  for (const Index t : tets) corners.centre_of_tet.emplace_back(t, kNoIndex);
  sort(corners.centre_of_tet);
  Index count = 0;
  for (const Index first : tets) {
    if (*corners.find(first) != kNoIndex) continue;
    *corners.find(first) = count;
    std::vector<Index> same{first};
    for (std::size_t next = 0; next < same.size(); ++next) {
      for (unsigned i = 0; i < 4; ++i) {
        const Index t = delaunay.topology().neighbor(same[next], i);
        Index* const centre = corners.find(t);
        if (!centre || *centre != kNoIndex || !have_same_centre(delaunay, {same[next], i}))
          continue;
        *centre = count;
        same.push_back(t);
      }
    }
    ++count;
  }
  return corners;
}

// For each neighbour of v with which it has a facet in common, the corners of that facet.
std::map<Index, std::vector<Index>> facets_around(const Delaunay3& delaunay, Index v) {
  const std::vector<Index> tets = star(delaunay, v);
  Corners corners = corners_around(delaunay, tets);
  std::map<Index, std::vector<Index>> facets;
  for (const Index t : tets)
    for (const Index u : delaunay.topology().vertices(t))
      if (u != v && u != Triangulation3::kGhost) facets[u].push_back(*corners.find(t));
  for (auto it = facets.begin(); it != facets.end();) {
    auto& list = it->second;
    sort_unique(list);
    it = list.size() < 3 ? facets.erase(it) : std::next(it);
  }
  return facets;
}

// ---- Where they lie ----------------------------------------------------------------------------

// The half space of the x with dot(normal, x) <= offset.
struct HalfSpace {
  Point3 normal;
  double offset;
  double excess(Point3 x) const { return dot(normal, x) - offset; }
};

// A convex polygon; plane k bounds the edge from a corner to the next.
struct PolygonCorner {
  Point3 at;
  Index plane;
};
using CellPolygon = std::vector<PolygonCorner>;

CellPolygon clip(const CellPolygon& polygon, const HalfSpace& half_space, Index plane) {
  CellPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PolygonCorner& here = polygon[i];
    const PolygonCorner& next = polygon[(i + 1) % polygon.size()];
    const double a = half_space.excess(here.at), b = half_space.excess(next.at);
    if (a <= 0) kept.push_back({here.at, a == 0 && b > 0 ? plane : here.plane});
    if (a < 0 && b > 0) kept.push_back({along(here.at, next.at, a / (a - b)), plane});
    if (a > 0 && b < 0) kept.push_back({along(here.at, next.at, a / (a - b)), here.plane});
  }
  return kept.size() < 3 ? CellPolygon{} : kept;
}

// The cell as half spaces, relative to its vertex: first the six of the box, then the bisectors.
class CellBuilder {
 public:
  CellBuilder(const Delaunay3& delaunay, Index v, const Box3& box)
      : site_(delaunay.points()[v]), facets_(facets_around(delaunay, v)) {
    const Point3 low = box.low - site_, high = box.high - site_;
    half_spaces_ = {{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x},  {{0, -1, 0}, -low.y},
                    {{0, 1, 0}, high.y},  {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}};
    neighbors_.assign(kBoxPlanes, kNoIndex);
    for (const auto& [u, corners] : facets_) {
      const Point3 q = delaunay.points()[u] - site_;
      half_spaces_.push_back({q, dot(q, q) / 2});
      neighbors_.push_back(u);
    }
    centre_ = along(low, high, 0.5);
    reach_ = std::fabs(high.x - low.x) + std::fabs(high.y - low.y) + std::fabs(high.z - low.z);
  }

  VoronoiCell3 build() {
    for (Index k = 0; k < half_spaces_.size(); ++k) {
      CellPolygon polygon = square_on(half_spaces_[k]);
      for (Index m = 0; m < half_spaces_.size() && !polygon.empty(); ++m)
        if (m != k) polygon = clip(polygon, half_spaces_[m], m);
      add_facet(k, polygon);
    }
    return std::move(cell_);
  }

 private:
  static constexpr std::size_t kBoxPlanes = 6;

  // A square on the plane, counter-clockwise seen from outside, that holds all of it in the box.
  CellPolygon square_on(const HalfSpace& h) const {
    const double length = std::sqrt(dot(h.normal, h.normal));
    const Point3 n{h.normal.x / length, h.normal.y / length, h.normal.z / length};
    const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    const Point3 axis = x <= y && x <= z ? Point3{1, 0, 0}
                        : y <= z         ? Point3{0, 1, 0}
                                         : Point3{0, 0, 1};
    const Point3 u = cross(n, axis), v = cross(n, u);
    const double down = h.excess(centre_) / length, r = 4 * (reach_ + std::fabs(down));
    const auto at = [&](double s, double t) {
      return Point3{centre_.x - down * n.x + s * u.x + t * v.x,
                    centre_.y - down * n.y + s * u.y + t * v.y,
                    centre_.z - down * n.z + s * u.z + t * v.z};
    };
    return {
        {at(r, r), kNoIndex}, {at(-r, r), kNoIndex}, {at(-r, -r), kNoIndex}, {at(r, -r), kNoIndex}};
  }

  // The number of the corner where three planes meet: the same from all facets that meet there.
  Index vertex_number(std::array<Index, 3> planes, Point3 at) {
    sort(planes);
    const Index centre = common_centre(planes);
    if (centre != kNoIndex) planes = {centre, kNoIndex, kNoIndex};
    const auto [it, is_new] =
        numbers_.try_emplace(planes, static_cast<Index>(cell_.vertices.size()));
    if (is_new) cell_.vertices.push_back({site_.x + at.x, site_.y + at.y, site_.z + at.z});
    return it->second;
  }

  // The Voronoi vertex on three bisectors, if it is exactly one.
  Index common_centre(const std::array<Index, 3>& planes) const {
    if (planes[0] < kBoxPlanes || planes[2] == kNoIndex) return kNoIndex;
    std::vector<Index> common = facets_.at(neighbors_[planes[0]]);
    for (unsigned k = 1; k < 3; ++k) {
      const auto& other = facets_.at(neighbors_[planes[k]]);
      std::erase_if(common,
                    [&](Index c) { return !std::binary_search(other.begin(), other.end(), c); });
    }
    return common.empty() ? kNoIndex : common.front();
  }

  void add_facet(Index plane, const CellPolygon& polygon) {
    VoronoiCell3::Facet facet{neighbors_[plane], {}};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Index before = polygon[(i + polygon.size() - 1) % polygon.size()].plane;
      const Index number = vertex_number({plane, before, polygon[i].plane}, polygon[i].at);
      if (facet.corners.empty() || facet.corners.back() != number) facet.corners.push_back(number);
    }
    while (facet.corners.size() > 1 && facet.corners.front() == facet.corners.back())
      facet.corners.pop_back();
    if (facet.corners.size() < 3) return;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      cell_.volume += dot(polygon[0].at, cross(polygon[i - 1].at, polygon[i].at)) / 6;
    cell_.facets.push_back(std::move(facet));
  }

  Point3 site_;
  std::map<Index, std::vector<Index>> facets_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<Index> neighbors_;  // of each half space
  Point3 centre_;
  double reach_ = 0;
  std::map<std::array<Index, 3>, Index> numbers_;
  VoronoiCell3 cell_;
};

}  // namespace

VoronoiCell3 voronoi_cell(const Delaunay3& delaunay, Index v, const Box3& box) {
  assert(delaunay.dimension() == 3 && delaunay.representative(v) == v);
  return CellBuilder(delaunay, v, box).build();
}

}  // namespace wellspaced
