#include "wellspaced/algorithms/packing/coplanar_facets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

using Polygon = std::vector<Index>;

double extent_of(const Box3& box) { return length(box.size()); }

// What is known of one facet. The plane goes through `origin`.
struct FacetShape {
  Point3 origin, normal;  // the normal is twice the area long
  double normal_length = 0;

  double distance_to_plane(Point3 p) const {
    return std::fabs(dot(normal, p - origin)) / normal_length;
  }
};

// Facets that are one, the one in whose plane they lie first.
struct FacetGroup {
  std::vector<Index> facets;
  Box3 bounds;
  double off_plane = 0;  // the largest distance of a point
};

// One side of an edge: facet kNoIndex stands for a segment of the domain.
struct EdgeUse {
  Index a, b;  // a < b
  Index facet;
  bool forward;  // the polygon runs from a to b
  bool operator<(const EdgeUse& other) const {
    return std::pair(a, b) != std::pair(other.a, other.b)
               ? std::pair(a, b) < std::pair(other.a, other.b)
               : facet < other.facet;
  }
};

EdgeUse edge_use(Index from, Index to, Index facet) {
  return {std::min(from, to), std::max(from, to), facet, from < to};
}

// Twice the area of a polygon, along its normal (Newell's formula about its first corner).
Point3 area_vector(std::span<const Point3> points, const Polygon& polygon) {
  Point3 sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + cross(points[polygon[i - 1]] - points[polygon[0]],
                      points[polygon[i]] - points[polygon[0]]);
  return sum;
}

// The plane of the polygon with the largest area.
FacetShape shape_of(std::span<const Point3> points, const Pls::Facet& facet) {
  FacetShape shape;
  for (const Polygon& polygon : facet.polygons) {
    const Point3 normal = area_vector(points, polygon);
    const double normal_length = length(normal);
    if (normal_length <= shape.normal_length) continue;  // so NaN stays, and is found
    shape = {points[polygon[0]], normal, normal_length};
  }
  return shape;
}

// Merges facets along edges, then outlines what they became.
class FacetMerger {
 public:
  FacetMerger(const Pls& domain, double flatness) : domain_(domain), flatness_(flatness) {}

  std::vector<Index> find_bad_facets();
  void merge();
  MergedFacets result() const;

 private:
  void list_edges();
  bool may_join(std::span<const EdgeUse> uses) const;
  void list_neighbors();
  void grow(FacetGroup& group, std::vector<bool>& is_taken) const;
  bool take(FacetGroup& group, Index facet) const;
  Polygon oriented_polygon(Index facet, const FacetGroup& group) const;
  bool is_shared(const EdgeUse& use) const;
  Pls::Facet outline(const FacetGroup& group) const;
  void keep_inner_points(MergedFacets& result) const;

  const Pls& domain_;
  double flatness_;
  std::vector<FacetShape> shapes_;
  std::vector<EdgeUse> uses_;
  std::vector<std::vector<Index>> neighbors_;  // that a facet may be joined with
  std::vector<FacetGroup> groups_;
};

// Adds a facet to a group if its points lie near the plane of the first.
bool FacetMerger::take(FacetGroup& group, Index facet) const {
  const FacetShape& plane = shapes_[group.facets.empty() ? facet : group.facets[0]];
  Box3 bounds = group.facets.empty() ? Box3{plane.origin, plane.origin} : group.bounds;
  double off_plane = group.off_plane;
  for (const Polygon& polygon : domain_.facets[facet].polygons) {
    for (const Index v : polygon) {
      bounds.cover({domain_.points[v], domain_.points[v]});
      off_plane = std::max(off_plane, plane.distance_to_plane(domain_.points[v]));
    }
  }
  if (!(off_plane <= flatness_ * extent_of(bounds))) return false;
  group.facets.push_back(facet);
  group.bounds = bounds;
  group.off_plane = off_plane;
  return true;
}

// Returns the facets that are not flat or enclose no area.
std::vector<Index> FacetMerger::find_bad_facets() {
  std::vector<Index> bad;
  for (Index f = 0; f < domain_.facets.size(); ++f) {
    const FacetShape shape = shape_of(domain_.points, domain_.facets[f]);
    shapes_.push_back(shape);
    FacetGroup alone;
    const bool is_good =
        std::isfinite(shape.normal_length) && shape.normal_length > 0 && take(alone, f) &&
        shape.normal_length > flatness_ * extent_of(alone.bounds) * extent_of(alone.bounds);
    if (!is_good) bad.push_back(f);
  }
  return bad;
}

void FacetMerger::list_edges() {
  for (const Segment& s : domain_.segments) uses_.push_back(edge_use(s.a, s.b, kNoIndex));
  for (Index f = 0; f < domain_.facets.size(); ++f)
    for (const Polygon& polygon : domain_.facets[f].polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i)
        uses_.push_back(edge_use(polygon[i], polygon[(i + 1) % polygon.size()], f));
  sort(uses_);
}

// Whether the two facets of an edge could be one, but for the plane.
bool FacetMerger::may_join(std::span<const EdgeUse> uses) const {
  if (uses.size() != 2 || uses[1].facet == kNoIndex || uses[0].facet == uses[1].facet) return false;
  const Pls::Facet& f = domain_.facets[uses[0].facet];
  const Pls::Facet& g = domain_.facets[uses[1].facet];
  if (f.marker != g.marker || f.polygons.size() != 1 || g.polygons.size() != 1 ||
      !f.holes.empty() || !g.holes.empty())
    return false;
  // On different sides of the edge, facets that turn alike run along it in opposite directions.
  const bool turn_alike = dot(shapes_[uses[0].facet].normal, shapes_[uses[1].facet].normal) > 0;
  return turn_alike == (uses[0].forward != uses[1].forward);
}

void FacetMerger::list_neighbors() {
  neighbors_.resize(domain_.facets.size());
  for (std::size_t i = 0, j = 0; i < uses_.size(); i = j) {
    while (j < uses_.size() && uses_[j].a == uses_[i].a && uses_[j].b == uses_[i].b) ++j;
    if (!may_join(std::span(uses_).subspan(i, j - i))) continue;
    neighbors_[uses_[i].facet].push_back(uses_[i + 1].facet);
    neighbors_[uses_[i + 1].facet].push_back(uses_[i].facet);
  }
}

void FacetMerger::grow(FacetGroup& group, std::vector<bool>& is_taken) const {
  for (std::size_t i = 0; i < group.facets.size(); ++i) {
    for (const Index neighbor : neighbors_[group.facets[i]])
      if (!is_taken[neighbor] && take(group, neighbor)) is_taken[neighbor] = true;
  }
}

// From the largest facet down, so that planes are as certain as can be.
void FacetMerger::merge() {
  list_edges();
  list_neighbors();
  std::vector<Index> order(domain_.facets.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order,
       [&](Index f, Index g) { return shapes_[f].normal_length > shapes_[g].normal_length; });
  std::vector<bool> is_taken(order.size(), false);
  for (const Index seed : order) {
    if (is_taken[seed]) continue;
    FacetGroup& group = groups_.emplace_back();
    is_taken[seed] = take(group, seed);
    grow(group, is_taken);
  }
  const auto lowest = [](const FacetGroup& g) {
    return *std::min_element(g.facets.begin(), g.facets.end());
  };
  sort(groups_, [&](const FacetGroup& g, const FacetGroup& h) { return lowest(g) < lowest(h); });
}

// The polygon of a facet, turned as its group turns.
Polygon FacetMerger::oriented_polygon(Index facet, const FacetGroup& group) const {
  Polygon polygon = domain_.facets[facet].polygons[0];
  if (dot(shapes_[facet].normal, shapes_[group.facets[0]].normal) < 0)
    std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

// Whether more than two facets or segments have the edge.
bool FacetMerger::is_shared(const EdgeUse& use) const {
  const EdgeUse first{use.a, use.b, 0, true};
  const auto at = std::lower_bound(uses_.begin(), uses_.end(), first);
  return uses_.end() - at > 2 && at[2].a == use.a && at[2].b == use.b;
}

// Directed edges, joined to closed polygons where they can be, from the lowest corner on.
std::vector<Polygon> closed_polygons(std::vector<std::pair<Index, Index>> edges) {
  sort(edges);
  std::vector<bool> is_taken(edges.size(), false);
  const auto next_from = [&](Index v) {
    auto at = std::lower_bound(edges.begin(), edges.end(), std::pair(v, Index{0})) - edges.begin();
    const auto end = static_cast<std::ptrdiff_t>(edges.size());
    while (at < end && edges[at].first == v && is_taken[at]) ++at;
    return at < end && edges[at].first == v ? at : end;
  };
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_taken[i]) continue;
    Polygon polygon;
    auto at = static_cast<std::ptrdiff_t>(i);
    do {
      is_taken[at] = true;
      polygon.push_back(edges[at].first);
      const Index to = edges[at].second;
      at = next_from(to);
      if (to == polygon.front()) break;
    } while (at < static_cast<std::ptrdiff_t>(edges.size()));
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

// What bounds the facets of a group together, and the edges inside that others share.
Pls::Facet FacetMerger::outline(const FacetGroup& group) const {
  const Pls::Facet& first = domain_.facets[group.facets[0]];
  if (group.facets.size() == 1) return first;
  std::vector<EdgeUse> uses;
  for (const Index f : group.facets) {
    const Polygon polygon = oriented_polygon(f, group);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      uses.push_back(edge_use(polygon[i], polygon[(i + 1) % polygon.size()], f));
  }
  sort(uses);
  std::vector<std::pair<Index, Index>> boundary;
  std::vector<Polygon> inside;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const EdgeUse& use = uses[i];
    const bool is_twice = i + 1 < uses.size() && uses[i + 1].a == use.a && uses[i + 1].b == use.b;
    if (!is_twice) {
      boundary.push_back(use.forward ? std::pair(use.a, use.b) : std::pair(use.b, use.a));
    } else {
      if (is_shared(use)) inside.push_back({use.a, use.b});
      ++i;
    }
  }
  Pls::Facet facet{closed_polygons(std::move(boundary)), {}, first.marker};
  facet.polygons.insert(facet.polygons.end(), inside.begin(), inside.end());
  return facet;
}

// Points inside a joined facet that others use become polygons of one point.
void FacetMerger::keep_inner_points(MergedFacets& result) const {
  std::vector<bool> is_used(domain_.points.size(), false);
  const auto use = [&](const Polygon& polygon) {
    for (const Index v : polygon) is_used[v] = true;
  };
  for (const Segment& s : domain_.segments) is_used[s.a] = is_used[s.b] = true;
  for (const Pls::Facet& facet : result.domain.facets)
    std::for_each(facet.polygons.begin(), facet.polygons.end(), use);
  Index merged = 0;
  for (const FacetGroup& group : groups_) {
    Pls::Facet& facet = result.domain.facets[merged++];
    Polygon named;
    for (const Polygon& polygon : facet.polygons)
      named.insert(named.end(), polygon.begin(), polygon.end());
    sort_unique(named);
    Polygon points;
    for (const Index f : group.facets)
      for (const Polygon& polygon : domain_.facets[f].polygons)
        points.insert(points.end(), polygon.begin(), polygon.end());
    sort_unique(points);
    for (const Index v : points) {
      if (std::binary_search(named.begin(), named.end(), v)) continue;
      if (is_used[v])
        facet.polygons.push_back({v});
      else
        result.freed_points.push_back(v);
    }
  }
  sort_unique(result.freed_points);
}

MergedFacets FacetMerger::result() const {
  MergedFacets result{domain_, std::vector<Index>(domain_.facets.size()), {}, 0};
  result.domain.facets.clear();
  for (const FacetGroup& group : groups_) {
    for (const Index f : group.facets)
      result.merged_into[f] = static_cast<Index>(result.domain.facets.size());
    result.domain.facets.push_back(outline(group));
    result.flatness = std::max(result.flatness, group.off_plane / extent_of(group.bounds));
  }
  keep_inner_points(result);
  return result;
}

}  // namespace

Result<MergedFacets> merge_coplanar_facets(const Pls& domain, double flatness) {
  FacetMerger merger(domain, flatness);
  if (std::vector<Index> bad = merger.find_bad_facets(); !bad.empty())
    return Error{ErrorCode::kInvalidGeometry,
                 {"facet ", bad[0], " is not flat, or encloses no area"},
                 std::move(bad)};
  merger.merge();
  return merger.result();
}

}  // namespace wellspaced
