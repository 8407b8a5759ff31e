#include "wellspaced/algorithms/packing/space/background_size3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/shortest_paths.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

using Edge3 = std::array<Index, 2>;

std::vector<Edge3> tet_edges(const Triangulation3& topology) {
  std::vector<Edge3> edges;
  for (Index t = 0; t < topology.size(); ++t) {
    if (topology.is_ghost(t)) continue;
    const auto& v = topology.vertices(t);
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = 0; j < i; ++j)
        edges.push_back({std::min(v[i], v[j]), std::max(v[i], v[j])});
  }
  sort_unique(edges);
  return edges;
}

// The Delaunay edges with lengths times the slope.
Graph slope_graph(const Delaunay3& delaunay, double slope) {
  const std::vector<Edge3> edges = tet_edges(delaunay.topology());
  Graph graph;
  graph.first.assign(delaunay.points().size() + 1, 0);
  for (const auto& [a, b] : edges) ++graph.first[a], ++graph.first[b];
  Index sum = 0;
  for (Index& first : graph.first) first = sum += first;
  graph.arcs.resize(2 * edges.size());
  for (std::size_t k = edges.size(); k-- > 0;) {
    const auto& [a, b] = edges[k];
    const double rise = slope * length(delaunay.points()[b] - delaunay.points()[a]);
    graph.arcs[--graph.first[a]] = {b, rise};
    graph.arcs[--graph.first[b]] = {a, rise};
  }
  return graph;
}

Status check_sizes(std::span<const Point3> points, std::span<const double> values) {
  if (points.empty() || values.size() != points.size())
    return Error{ErrorCode::kUsage, "a background needs one size at each of its points", {}};
  Error error{ErrorCode::kUsage, "", {}};
  for (Index v = 0; v < values.size(); ++v)
    if (!(values[v] > 0) || !std::isfinite(values[v])) error.ids.push_back(v);
  if (error.ids.empty()) return Ok{};
  error.message = concat({"the size at point ", error.ids[0], " is not positive and finite"});
  return error;
}

// The volume of a tet, six times.
double volume6(Point3 a, Point3 b, Point3 c, Point3 d) { return dot(b - a, cross(c - a, d - a)); }

}  // namespace

Result<BackgroundSize3> BackgroundSize3::build(std::span<const Point3> points,
                                               std::span<const double> values, double slope) {
  if (Status status = check_sizes(points, values); !status) return status.error();
  std::vector<Point3> all(points.begin(), points.end());
  add_far_points(all);
  auto delaunay = Delaunay3::build(all);
  if (!delaunay) return delaunay.error();
  std::vector<double> start(all.size(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < values.size(); ++v) {
    double& least = start[delaunay->representative(v)];
    least = std::min(least, values[v]);
  }
  auto sizes = shortest_distances(slope_graph(*delaunay, slope), start);
  return BackgroundSize3(std::move(*delaunay), std::move(sizes));
}

double BackgroundSize3::operator()(Point3 x) {
  const Delaunay3::Location place = delaunay_.locate(x, last_);
  last_ = place.tet;
  const auto& corners = delaunay_.topology().vertices(last_);
  const std::size_t count = place.place == Delaunay3::Place::kOutside ? 3 : 4;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    least = std::min(least, sizes_[corners[i]]);
    most = std::max(most, sizes_[corners[i]]);
  }
  if (count < 4) return least;
  std::array<Point3, 4> p;
  for (unsigned i = 0; i < 4; ++i) p[i] = delaunay_.points()[corners[i]];
  const double whole = volume6(p[0], p[1], p[2], p[3]);
  const double u = volume6(x, p[1], p[2], p[3]), v = volume6(p[0], x, p[2], p[3]),
               w = volume6(p[0], p[1], x, p[3]);
  const double size = sizes_[corners[3]] + (u * (sizes_[corners[0]] - sizes_[corners[3]]) +
                                            v * (sizes_[corners[1]] - sizes_[corners[3]]) +
                                            w * (sizes_[corners[2]] - sizes_[corners[3]])) /
                                               whole;
  return whole > 0 ? std::clamp(size, least, most) : least;
}

double BackgroundSize3::steepest() const {
  double steepest = 0;
  const Triangulation3& topology = delaunay_.topology();
  for (Index t = 0; t < topology.size(); ++t) {
    const auto& v = topology.vertices(t);
    if (any_of(v, [this](Index w) { return is_far(w); })) continue;
    const Point3 a = delaunay_.points()[v[0]], ab = delaunay_.points()[v[1]] - a,
                 ac = delaunay_.points()[v[2]] - a, ad = delaunay_.points()[v[3]] - a;
    const double rise_b = sizes_[v[1]] - sizes_[v[0]], rise_c = sizes_[v[2]] - sizes_[v[0]],
                 rise_d = sizes_[v[3]] - sizes_[v[0]];
    const Point3 rise = rise_b * cross(ac, ad) + rise_c * cross(ad, ab) + rise_d * cross(ab, ac);
    const double height = length(rise);
    if (height > 0) steepest = std::max(steepest, height / dot(ab, cross(ac, ad)));
  }
  return steepest;
}

bool BackgroundSize3::covers(Point3 x) const {
  const Delaunay3::Location place = delaunay_.locate(x);
  if (place.place == Delaunay3::Place::kOutside) return false;
  const auto& corners = delaunay_.topology().vertices(place.tet);
  for (unsigned i = 0; i < 4; ++i)
    if (place.corners >> i & 1 && is_far(corners[i])) return false;
  return true;
}

}  // namespace wellspaced
