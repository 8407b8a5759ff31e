#include "wellspaced/kernel/space/delaunay3.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <utility>

#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/point_order.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/walk3.hpp"

namespace wellspaced {
namespace {

// The point without its coordinate `axis`.
Point2 projection(Point3 p, unsigned axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

bool project_to_line(Point3 a, Point3 b, Point3 c, unsigned axis) {
  return orient2d(projection(a, axis), projection(b, axis), projection(c, axis)) == 0;
}

bool are_collinear(Point3 a, Point3 b, Point3 c) {
  return project_to_line(a, b, c, 0) && project_to_line(a, b, c, 1) && project_to_line(a, b, c, 2);
}

}  // namespace

// ---- Location ----------------------------------------------------------------------------------

// Where a walk to p ends, started at tet `hint` if there is one.
Index Delaunay3::find(Point3 p, Index hint) const {
  return walk(topology_, points_, p, hint < topology_.size() ? hint : 0,
              [](Index) { return true; });
}

Delaunay3::Location Delaunay3::locate(Point3 p, Index hint) const {
  assert(dimension_ == 3);
  const Index t = find(p, hint);
  if (topology_.is_ghost(t)) return {Place::kOutside, t, 0b0111};
  unsigned corners = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (side_of_facet(topology_, points_, {t, i}, p) != 0) corners |= 1u << i;
  constexpr Place kPlaces[] = {Place::kVertex, Place::kEdge, Place::kFacet, Place::kTet};
  return {kPlaces[std::popcount(corners) - 1], t, corners};
}

// ---- Building ----------------------------------------------------------------------------------

Result<Delaunay3> Delaunay3::build(std::span<const Point3> points, const Options& options) {
  if (Status status = check_points(points); !status) return status.error();
  Delaunay3 result;
  const unsigned regions = BulkInsertion3::region_count(points.size());
  InsertionRuns runs = insertion_runs(points, regions);
  result.points_.reserve(points.size() + 1);  // one more for add_apex
  for (const Index i : runs.order) result.points_.push_back(points[i]);
  std::vector<Duplicate> duplicates;
  if (result.start()) {
    BulkInsertion3 insertion(result.topology_, result.points_,
                             {options.progress, options.max_tets, options.threads});
    if (Status s = insertion.run(runs.ends, regions); !s) return s.error();
    duplicates = insertion.duplicates();
    if (result.dimension_ == 2) result.take_triangles();
  } else {
    result.take_chain(duplicates);
  }
  result.number_as_input(points, runs.order, duplicates, std::clamp(options.threads, 1u, regions));
  return result;
}

// Makes the first tet of the first points in general position; coplanar points get an apex for
// that. Returns false if all are collinear; dimension_ is set either way.
bool Delaunay3::start() {
  const Index n = static_cast<Index>(points_.size());
  Index b = 1;
  while (b < n && points_[b] == points_[0]) ++b;
  Index c = b + 1;
  while (c < n && are_collinear(points_[0], points_[b], points_[c])) ++c;
  if (c >= n) {
    dimension_ = n == 0 ? -1 : b >= n ? 0 : 1;
    return false;
  }
  Index d = c + 1;
  while (d < n && orient3d(points_[0], points_[b], points_[c], points_[d]) == 0) ++d;
  dimension_ = d < n ? 3 : 2;
  if (dimension_ == 2) add_apex(b, c);
  topology_.reserve(7 * static_cast<std::size_t>(n));
  // Tets are positive, for which orient3d is negative.
  if (orient3d(points_[0], points_[b], points_[c], points_[d]) > 0) std::swap(b, c);
  topology_.reset(0, b, c, d);
  return true;
}

// Coplanar points and one apex off their plane: spheres through the apex meet the plane in the
// circumcircles, so the tets are the Delaunay triangles of the plane joined to the apex.
void Delaunay3::add_apex(Index b, Index c) {
  unsigned axis = 2;  // the plane meets every line along the axis once
  while (project_to_line(points_[0], points_[b], points_[c], axis)) --axis;
  Point3 apex = points_[0];
  double& height = axis == 0 ? apex.x : axis == 1 ? apex.y : apex.z;
  const Point3 p = points_[0], q = points_[b];
  const double size = std::fabs(p.x - q.x) + std::fabs(p.y - q.y) + std::fabs(p.z - q.z);
  const double wanted = height > 0 ? height - size : height + size;
  if (std::isfinite(wanted) && wanted != height)
    height = wanted;
  else
    height = height != 0 ? height / 2 : 1;
  points_.push_back(apex);
}

// Undoes add_apex.
void Delaunay3::take_triangles() {
  const Index apex = static_cast<Index>(points_.size() - 1);
  for (Index t = 0; t < topology_.size(); ++t)
    if (!topology_.is_ghost(t))
      triangles_.push_back(topology_.vertices(Facet{t, topology_.corner_of(t, apex)}));
  topology_ = {};
  points_.pop_back();
}

void Delaunay3::take_chain(std::vector<Duplicate>& duplicates) {
  std::vector<Index> sorted(points_.size());
  std::iota(sorted.begin(), sorted.end(), Index{0});
  sort(sorted, [&](Index a, Index b) {
    return points_[a] == points_[b] ? a < b : points_[a] < points_[b];
  });
  for (const Index v : sorted) {
    if (!chain_.empty() && points_[v] == points_[chain_.back()])
      duplicates.push_back({v, chain_.back()});
    else
      chain_.push_back(v);
  }
}

// From numbers in insertion order to the caller's: vertex v becomes order[v], or the lowest number
// among its duplicates.
void Delaunay3::number_as_input(std::span<const Point3> points, std::vector<Index>& order,
                                const std::vector<Duplicate>& duplicates, unsigned threads) {
  points_ = {};  // before the copy below, so that the two are never in memory together
  duplicate_count_ = duplicates.size();
  if (!duplicates.empty()) {
    const std::vector<Index> input_number = order;
    for (const auto& [point, vertex] : duplicates)
      order[vertex] = std::min(order[vertex], input_number[point]);
    for (const auto& [point, vertex] : duplicates) order[point] = order[vertex];
    representative_.resize(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) representative_[input_number[i]] = order[i];
  }
  if (dimension_ == 3) index_tets(order);
  topology_.renumber_vertices(order, threads);
  for (auto& triangle : triangles_)
    for (Index& v : triangle) v = order[v];
  for (Index& v : chain_) v = order[v];
  points_.assign(points.begin(), points.end());
}

// Notes a tet of each vertex, numbered as `order` will have it: the scattered writes are left to
// the vertices, of which there are fewer than corners.
void Delaunay3::index_tets(const std::vector<Index>& order) {
  std::vector<Index> tet_of(order.size(), kNoIndex);
  for (Index t = 0; t < topology_.size(); ++t)
    for (const Index v : topology_.vertices(t))
      if (v != kGhost) tet_of[v] = t;
  tet_of_.assign(order.size(), kNoIndex);
  for (Index v = 0; v < order.size(); ++v)
    if (tet_of[v] != kNoIndex) tet_of_[order[v]] = tet_of[v];
}

// ---- Insertion ---------------------------------------------------------------------------------

Result<Index> Delaunay3::insert(Point3 p, Index hint) {
  const Index v = static_cast<Index>(points_.size());
  if (!is_finite(p)) return Error{ErrorCode::kInvalidGeometry, "the new point is not finite", {v}};
  if (v >= kMaxOrderedPoints) return Error{ErrorCode::kLimit, "more than 2^28 points", {}};
  if (dimension_ < 3) return insert_anew(p);
  const Index t = find(p, hint), twin = vertex_at(topology_, points_, t, p);
  points_.push_back(p);
  if (twin == kNoIndex) {
    inserter_.filler.reserve_vertices(points_.size());
    if (Status s = inserter_.insert(topology_, points_, v, t, Triangulation3::kMaxTets); !s) {
      points_.pop_back();
      return s.error();
    }
  } else if (representative_.empty()) {
    representative_.resize(v);
    std::iota(representative_.begin(), representative_.end(), Index{0});
  }
  const Index vertex = twin == kNoIndex ? v : twin;
  if (!representative_.empty()) representative_.push_back(vertex);
  duplicate_count_ += vertex != v;
  tet_of_.push_back(kNoIndex);
  if (vertex == v) index_changed_tets();
  return vertex;
}

void Delaunay3::index_changed_tets() {
  for (const Index changed : inserter_.cavity.tets)
    for (const Index u : topology_.vertices(changed))
      if (u != kGhost) tet_of_[u] = changed;
}

Result<Index> Delaunay3::insert_if(Point3 p, Index t, const CavityTest& accepts) {
  assert(dimension_ == 3 && is_finite(p) && points_.size() < kMaxOrderedPoints);
  if (!in_conflict(topology_, points_, t, p)) return kNoIndex;
  inserter_.search.run(topology_, points_, t, p, inserter_.cavity);
  if (!accepts(inserter_.cavity)) return kNoIndex;
  const Index v = static_cast<Index>(points_.size());
  inserter_.filler.reserve_vertices(points_.size() + 1);
  if (Status s = inserter_.fill(topology_, v, Triangulation3::kMaxTets); !s) return s.error();
  points_.push_back(p);
  if (!representative_.empty()) representative_.push_back(v);
  tet_of_.push_back(kNoIndex);
  index_changed_tets();
  return v;
}

Result<Index> Delaunay3::insert_anew(Point3 p) {
  std::vector<Point3> points = std::move(points_);
  points.push_back(p);
  Result<Delaunay3> built = build(points);
  if (!built) {
    points.pop_back();
    points_ = std::move(points);
    return built.error();
  }
  *this = std::move(built).value();
  return representative(static_cast<Index>(points_.size() - 1));
}

}  // namespace wellspaced
