#include "wellspaced/algorithms/audit/polyhedral_domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// Looks at a plane along the axis that it faces most.
class FacetView {
 public:
  FacetView(const std::vector<Point3>& points, const std::vector<Index>& polygon)
      : points_(points) {
    Vec<3> normal{};  // Newell's
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec<3> p = coordinates_of(points[polygon[i]]);
      const Vec<3> q = coordinates_of(points[polygon[(i + 1) % polygon.size()]]);
      normal = step(normal, 1, cross_product(p, q));
    }
    for (std::size_t i = 1; i < 3; ++i)
      if (std::fabs(normal[i]) > std::fabs(normal[axis_])) axis_ = i;
  }

  Point2 seen(Point3 p) const {
    return axis_ == 0 ? Point2{p.y, p.z} : axis_ == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  }

  // Whether x appears strictly inside the polygon.
  bool is_inside(Point3 x, const std::vector<Index>& polygon) const {
    const Point2 p = seen(x);
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2 a = seen(points_[polygon[i]]);
      const Point2 b = seen(points_[polygon[(i + 1) % polygon.size()]]);
      const int side = orient2d(a, b, p);
      if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
          std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y))
        return false;
      if ((a.y > p.y) != (b.y > p.y) && (b.y > a.y) == (side > 0)) inside = !inside;
    }
    return inside;
  }

 private:
  const std::vector<Point3>& points_;
  std::size_t axis_ = 0;
};

bool is_nested(const Pls& system, const Pls::Facet& facet, const std::vector<Index>& polygon) {
  return any_of(facet.polygons, [&](const auto& outer) {
    if (&outer == &polygon || outer.size() < 3) return false;
    const FacetView view(system.points, outer);
    return any_of(polygon, [&](Index v) { return view.is_inside(system.points[v], outer); });
  });
}

bool holds_a_hole(const Pls& system, const Pls::Facet& facet, const std::vector<Index>& polygon) {
  const FacetView view(system.points, polygon);
  return any_of(facet.holes, [&](Point3 hole) { return view.is_inside(hole, polygon); });
}

// Sides that do not bound are polygons of two points; those come last.
FacetPolygons polygons_of(const Pls& system, const Pls::Facet& facet) {
  FacetPolygons polygons, sides;
  for (const auto& polygon : facet.polygons) {
    if (polygon.size() < 2) continue;
    const bool bounds = polygon.size() > 2 && (!is_nested(system, facet, polygon) ||
                                               holds_a_hole(system, facet, polygon));
    if (bounds) {
      polygons.push_back(polygon);
      continue;
    }
    for (std::size_t i = 0; i < polygon.size(); ++i)
      if (i + 1 < polygon.size() || i > 1)
        sides.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  polygons.insert(polygons.end(), sides.begin(), sides.end());
  return polygons;
}

// ---- Flat neighbours

using FacetSide = std::array<Index, 2>;

template <class Visit>
void for_each_side(const FacetPolygons& facet, Visit visit) {
  for (const auto& polygon : facet)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Index a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      visit(FacetSide{std::min(a, b), std::max(a, b)});
    }
}

// Whether points lie within flatness * extent of a plane of three of them, the first two far from
// each other and the third far from their line.
bool is_nearly_flat(std::vector<Point3> points, double flatness) {
  const double scale = scale_of(points);
  for (Point3& p : points) p = {scale * p.x, scale * p.y, scale * p.z};
  const Vec<3> a = coordinates_of(points[0]);
  Vec<3> along{}, normal{};
  for (const Point3 p : points)
    if (const Vec<3> way = difference(coordinates_of(p), a); norm(way) > norm(along)) along = way;
  for (const Point3 p : points) {
    const Vec<3> turn = cross_product(along, difference(coordinates_of(p), a));
    if (norm(turn) > norm(normal)) normal = turn;
  }
  const double reach = flatness * norm(along) * norm(normal);
  return all_of(points, [&](Point3 p) {
    return std::fabs(product(difference(coordinates_of(p), a), normal)) <= reach;
  });
}

// Whether all points of two facets lie in one plane: exactly, if the flatness is 0.
bool is_flat(const std::vector<Point3>& points, const FacetPolygons& f, const FacetPolygons& g,
             double flatness) {
  if (f.empty() || g.empty() || f[0].size() < 3 || g[0].size() < 3) return false;
  std::vector<Point3> all;
  for (const FacetPolygons* facet : {&f, &g})
    for (const auto& polygon : *facet)
      for (const Index v : polygon) all.push_back(points[v]);
  if (flatness > 0) return is_nearly_flat(std::move(all), flatness);
  const FacetView view(points, f.front());
  for (std::size_t i = 2; i < all.size(); ++i) {
    if (orient2d(view.seen(all[0]), view.seen(all[1]), view.seen(all[i])) == 0) continue;
    return all_of(all, [&](Point3 p) { return orient3d(all[0], all[1], all[i], p) == 0; });
  }
  return false;
}

// For each facet the lowest one that it is one with.
std::vector<Index> flat_parts(const Pls& system, const std::vector<FacetPolygons>& facets,
                              double flatness) {
  std::vector<std::pair<FacetSide, Index>> sides;
  for (Index f = 0; f < facets.size(); ++f)
    for_each_side(facets[f], [&](FacetSide side) { sides.push_back({side, f}); });
  sort(sides);
  std::vector<Index> part(facets.size());
  std::iota(part.begin(), part.end(), Index{0});
  const auto root = [&](Index f) {
    while (part[f] != f) f = part[f] = part[part[f]];
    return f;
  };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].first == sides[i].first) ++end;
    const Index f = sides[i].second, g = sides[end - 1].second;
    if (end - i != 2 || f == g || system.facets[f].marker != system.facets[g].marker) continue;
    if (!is_flat(system.points, facets[f], facets[g], flatness)) continue;
    const Index a = root(f), b = root(g);
    part[std::max(a, b)] = std::min(a, b);
  }
  for (Index f = 0; f < part.size(); ++f) part[f] = root(f);
  return part;
}

// Sides that an odd number of polygons has, as closed polygons: every node has an even number.
// Those of polygons of two points stay.
FacetPolygons outline(const FacetPolygons& facet) {
  FacetPolygons polygons;
  std::map<FacetSide, bool> odd;
  for (const auto& polygon : facet) {
    if (polygon.size() == 2)
      polygons.push_back(polygon);
    else
      for_each_side({polygon}, [&](FacetSide side) { odd[side] = !odd[side]; });
  }
  std::map<Index, std::vector<Index>> next;
  for (const auto& [side, is_odd] : odd)
    if (is_odd) next[side[0]].push_back(side[1]), next[side[1]].push_back(side[0]);
  for (auto& [start, unused] : next)
    while (!unused.empty()) {
      std::vector<Index> polygon;
      Index at = start;
      do {
        polygon.push_back(at);
        const Index to = next[at].back();
        next[at].pop_back();
        auto& back = next[to];
        back.erase(std::find(back.begin(), back.end(), at));
        at = to;
      } while (at != start);
      polygons.push_back(std::move(polygon));
    }
  return polygons;
}

std::vector<FacetPolygons> united_facets(const Pls& system, std::vector<FacetPolygons> facets,
                                         double flatness) {
  const std::vector<Index> part = flat_parts(system, facets, flatness);
  std::vector<Index> pieces(facets.size(), 0);
  for (const Index f : part) ++pieces[f];
  std::vector<FacetPolygons> united;
  for (Index f = 0; f < facets.size(); ++f)
    if (part[f] != f)
      facets[part[f]].insert(facets[part[f]].end(), facets[f].begin(), facets[f].end());
  for (Index f = 0; f < facets.size(); ++f)
    if (part[f] == f) united.push_back(pieces[f] > 1 ? outline(facets[f]) : facets[f]);
  return united;
}

std::vector<Index> points_named(const std::vector<FacetPolygons>& facets) {
  std::vector<Index> named;
  for (const FacetPolygons& facet : facets)
    for (const auto& polygon : facet) named.insert(named.end(), polygon.begin(), polygon.end());
  sort_unique(named);
  return named;
}

// The points that facets named before they were united, and nothing names since.
std::vector<Index> lost_points(const std::vector<Index>& before, const PolyhedralDomain& domain) {
  std::vector<Index> kept = points_named(domain.facets), lost;
  for (const Segment& s : domain.segments) kept.insert(kept.end(), {s.a, s.b});
  sort_unique(kept);
  std::set_difference(before.begin(), before.end(), kept.begin(), kept.end(),
                      std::back_inserter(lost));
  return lost;
}

}  // namespace

PolyhedralDomain domain_of(const Pls& system, double flatness) {
  PolyhedralDomain domain;
  domain.points = system.points;
  domain.segments = system.segments;
  domain.holes = system.holes;
  std::vector<FacetPolygons> facets;
  for (const Pls::Facet& facet : system.facets) facets.push_back(polygons_of(system, facet));
  const std::vector<Index> named = points_named(facets);
  domain.facets = united_facets(system, std::move(facets), flatness);
  domain.inner_points = lost_points(named, domain);
  domain.flatness = flatness;
  return domain;
}

}  // namespace wellspaced::audit
