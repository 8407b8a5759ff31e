#include "wellspaced/algorithms/packing/space/solid_packing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/packing/space/far_points.hpp"
#include "wellspaced/algorithms/packing/space/room_search3.hpp"
#include "wellspaced/algorithms/packing/space/surface_index.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/circumsphere.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

using Facet3 = Triangulation3::Facet;
using Tet = std::array<Index, 4>;

Error no_radius() {
  return {ErrorCode::kUsage, "the spacing is not positive inside the domain", {}};
}

template <class Test>
bool any_rim_vertex(const Triangulation3::Cavity& cavity, Test test) {
  return any_of(cavity.rim, [&](const auto& rim) {
    for (unsigned i = 0; i < 4; ++i)
      if (i != rim.corner && test(rim.vertex[i])) return true;
    return false;
  });
}

// The Delaunay triangulation while it is packed.
//
// Vertices: the surface's points, the far ones, then new ones. What is kept for each tet, its
// region and whether it awaits its turn, follows the tets as they get other numbers.
class SolidPacking {
 public:
  static Result<SolidPacking> start(const PolyhedralComplex& complex, const PackedSurface& surface,
                                    const SolidOptions& options);

  Status check_surface() const;
  Status find_regions();
  Status run();
  PackedSolids result();

 private:
  SolidPacking(Delaunay3 delaunay, const PolyhedralComplex& complex, const PackedSurface& surface,
               const SolidOptions& options, std::vector<Index> number)
      : delaunay_(std::move(delaunay)),
        complex_(complex),
        surface_(surface),
        options_(options),
        number_(std::move(number)),
        index_(surface, number_, delaunay_.points()) {}

  const Point3& point(Index v) const { return delaunay_.points()[v]; }
  const Triangulation3& topology() const { return delaunay_.topology(); }
  Index facet_of(Index triangle) const;
  Index triangle_at(Facet3 f) const;
  bool is_on_facet(Index v, Index facet) const;
  void flood(Index first, Index region);
  void open_holes();
  void number_solids();
  Status check_sides() const;
  bool is_solid(Index t) const { return solids_[region_of_[t]].is_inside; }

  bool keep_going();
  void push_all();
  Status drain();
  Result<bool> try_circumcentre(Index t);
  Result<bool> try_everywhere(Index t, RoomSearch3& search);
  Result<bool> try_ball(Index t, const Sphere& ball, bool is_certain);
  bool is_protected(const Tet& corners, Point3 p) const;
  void push(Index t) {
    if (waits_[t]) return;
    waits_[t] = 1;
    waiting_.push_back(t);
  }
  void follow_change(Index v, Index region);

  Delaunay3 delaunay_;
  const PolyhedralComplex& complex_;
  const PackedSurface& surface_;
  const SolidOptions& options_;
  std::vector<Index> number_;         // of the surface's points; kNoIndex: no vertex
  std::vector<Index> surface_point_;  // the other way
  SurfaceIndex index_;
  Index first_far_ = 0;
  std::vector<double> radius_;  // for each vertex

  struct Solid {
    bool is_inside = true;
    Index seed = kNoIndex;
  };
  std::vector<Solid> solids_;     // for each region; the first is all around
  std::vector<Index> region_of_;  // for each tet
  std::vector<std::uint8_t> waits_;
  std::vector<Index> waiting_;
  std::size_t balls_packed_ = 0, steps_ = 0;
  bool fills_ = false, is_complete_ = true, was_cancelled_ = false;
};

// ---- The start -----------------------------------------------------------------------------

Result<SolidPacking> SolidPacking::start(const PolyhedralComplex& complex,
                                         const PackedSurface& surface,
                                         const SolidOptions& options) {
  std::vector<Index> number(surface.points.size(), kNoIndex), surface_point;
  std::vector<Point3> points;
  std::vector<double> radius;
  for (Index v = 0; v < surface.points.size(); ++v) {
    if (!(surface.radius[v] > 0)) continue;
    number[v] = static_cast<Index>(points.size());
    surface_point.push_back(v);
    points.push_back(surface.points[v]);
    radius.push_back(surface.radius[v]);
  }
  const auto first_far = static_cast<Index>(points.size());
  add_far_points(points);
  Delaunay3::Options building;
  building.progress = options.progress;
  auto delaunay = Delaunay3::build(points, building);
  if (!delaunay) return delaunay.error();
  if (delaunay->duplicate_count() > 0)
    return Error{ErrorCode::kInvalidGeometry, "points of the packed surface coincide", {}};
  SolidPacking packing(std::move(*delaunay), complex, surface, options, std::move(number));
  packing.surface_point_ = std::move(surface_point);
  packing.first_far_ = first_far;
  packing.radius_ = std::move(radius);
  packing.radius_.resize(points.size(), 0);
  return packing;
}

Index SolidPacking::facet_of(Index triangle) const {
  const auto& first = surface_.first_triangle;
  return static_cast<Index>(std::upper_bound(first.begin(), first.end(), triangle) - first.begin() -
                            1);
}

// The triangle of the surface that a facet of the triangulation is, or kNoIndex.
Index SolidPacking::triangle_at(Facet3 f) const {
  const auto [a, b, c] = topology().vertices(f);
  return index_.triangle(a, b, c);
}

bool SolidPacking::is_on_facet(Index v, Index facet) const {
  if (v >= first_far_) return false;
  const std::vector<Index>& on = surface_.on_facet[facet];
  return std::binary_search(on.begin(), on.end(), surface_point_[v]);
}

// Whether all triangles of the surface are faces, with tets on both sides that are not flat on
// their facet, and all pieces edges.
Status SolidPacking::check_surface() const {
  std::vector<std::uint8_t> sides(surface_.triangles.size()), is_edge(surface_.pieces.size());
  for (Index t = 0; t < topology().size(); ++t) {
    const Tet& corners = topology().vertices(t);
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = 0; j < i; ++j)
        if (const Index piece = index_.piece(corners[i], corners[j]); piece != kNoIndex)
          is_edge[piece] = 1;
      const Index triangle = triangle_at({t, i});
      if (triangle != kNoIndex && !is_on_facet(corners[i], facet_of(triangle))) ++sides[triangle];
    }
  }
  Error error{ErrorCode::kInvalidGeometry, "", {}};
  for (Index k = 0; k < sides.size(); ++k)
    if (sides[k] != 2) error.ids.push_back(complex_.facets[facet_of(k)].source);
  sort_unique(error.ids);
  if (!error.ids.empty()) {
    error.message = concat(
        {"facet ", error.ids[0], " does not appear in the triangulation: a larger beta is needed"});
    return error;
  }
  for (Index k = 0; k < is_edge.size(); ++k)
    if (!is_edge[k]) error.ids.insert(error.ids.end(), {surface_.pieces[k][0]});
  if (error.ids.empty()) return Ok{};
  error.message = concat({"a segment does not appear in the triangulation near point ",
                          error.ids[0], ": a larger beta is needed"});
  return error;
}

// ---- Regions -------------------------------------------------------------------------------

// Gives a number to what can be reached from a tet without crossing the surface.
void SolidPacking::flood(Index first, Index region) {
  std::vector<Index> front{first};
  region_of_[first] = region;
  while (!front.empty()) {
    const Index t = front.back();
    front.pop_back();
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = topology().neighbor(t, i);
      if (region_of_[u] != kNoIndex || triangle_at({t, i}) != kNoIndex) continue;
      region_of_[u] = region;
      front.push_back(u);
    }
  }
}

Status SolidPacking::find_regions() {
  region_of_.assign(topology().size(), kNoIndex);
  waits_.assign(topology().size(), 0);
  flood(delaunay_.tet_of(first_far_), 0);
  solids_.push_back({.is_inside = false});
  for (Index t = 0; t < topology().size(); ++t) {
    if (region_of_[t] != kNoIndex) continue;
    flood(t, static_cast<Index>(solids_.size()));
    solids_.emplace_back();
  }
  open_holes();
  number_solids();
  return check_sides();
}

void SolidPacking::open_holes() {
  for (const Point3 hole : options_.holes) {
    const auto location = delaunay_.locate(hole);
    if (location.place != Delaunay3::Place::kOutside)
      solids_[region_of_[location.tet]].is_inside = false;
  }
}

void SolidPacking::number_solids() {
  for (Index k = 0; k < options_.seeds.size(); ++k) {
    const auto location = delaunay_.locate(options_.seeds[k]);
    Index& seed = solids_[region_of_[location.tet]].seed;
    if (seed == kNoIndex) seed = k;
  }
}

// Every facet must have a solid on one side, or else the surface is open.
Status SolidPacking::check_sides() const {
  std::vector<std::uint8_t> has_solid(surface_.triangles.size());
  for (Index t = 0; t < topology().size(); ++t)
    for (unsigned i = 0; i < 4; ++i)
      if (const Index triangle = triangle_at({t, i}); triangle != kNoIndex)
        has_solid[triangle] |= is_solid(t);
  Error error{ErrorCode::kInvalidGeometry, "", {}};
  for (Index k = 0; k < has_solid.size(); ++k)
    if (!has_solid[k]) error.ids.push_back(complex_.facets[facet_of(k)].source);
  sort_unique(error.ids);
  if (error.ids.empty()) return Ok{};
  const bool is_all = error.ids.size() == complex_.facets.size();
  error.message = is_all ? "the facets enclose no solid: the surface is open"
                         : concat({"facet ", error.ids[0],
                                   " bounds no solid on either side: the surface is open"});
  return error;
}

// ---- Balls ---------------------------------------------------------------------------------

bool SolidPacking::keep_going() {
  constexpr std::size_t kReportEvery = 256;
  const std::size_t points = delaunay_.points().size() - kFarPoints;
  if (points >= options_.max_points) is_complete_ = false;
  if (steps_++ % kReportEvery == 0 &&
      !report(options_.progress, "pack", points, options_.max_points))
    was_cancelled_ = true, is_complete_ = false;
  return is_complete_;
}

Status SolidPacking::run() {
  push_all();
  if (Status status = drain(); !status) return status;
  if (options_.maximality == Maximality::kDelaunay) return Ok{};
  fills_ = true;
  push_all();
  return drain();
}

void SolidPacking::push_all() {
  for (Index t = topology().size(); t-- > 0;)
    if (is_solid(t)) push(t);
}

Status SolidPacking::drain() {
  RoomSearch3 search({delaunay_, radius_, index_, options_.radius, options_.slope});
  while (!waiting_.empty() && keep_going()) {
    const Index t = waiting_.back();
    waiting_.pop_back();
    if (t >= topology().size() || !waits_[t]) continue;
    waits_[t] = 0;
    Result<bool> is_done = try_circumcentre(t);
    if (is_done && !*is_done && fills_) is_done = try_everywhere(t, search);
    if (!is_done) return is_done.error();
  }
  return Ok{};
}

// Adds the circumcentre of a tet if there is room for its ball. No vertex is nearer to it than the
// corners, R away, and where the radius grows by at most `slope`, one at the distance L has a ball
// of at most r + slope L. So the radius r need not be asked for where even the least that it can be
// is too much; and no other vertex need be looked at where 2 r <= (1 - slope) R.
Result<bool> SolidPacking::try_circumcentre(Index t) {
  const Tet& corners = topology().vertices(t);
  const Sphere sphere = unchecked_circumsphere(point(corners[0]), point(corners[1]),
                                               point(corners[2]), point(corners[3]));
  double largest = 0;
  for (const Index v : corners) largest = std::max(largest, radius_[v]);
  if (!(largest < sphere.radius) || !std::isfinite(sphere.radius)) return false;
  if (2 * largest - options_.slope * sphere.radius > sphere.radius) return false;
  const double radius = options_.radius(sphere.centre);
  if (!(radius > 0)) return no_radius();
  if (radius + largest > sphere.radius) return false;
  const bool is_certain = 2 * radius <= sphere.radius * (1 - options_.slope);
  return try_ball(t, {sphere.centre, radius}, is_certain);
}

Result<bool> SolidPacking::try_everywhere(Index t, RoomSearch3& search) {
  Result<bool> is_taken = false;
  search.run(t, [&](Point3 place, double radius) {
    is_taken = radius > 0 ? try_ball(t, {place, radius}, false) : no_radius();
    return !is_taken || *is_taken;
  });
  return is_taken;
}

// Adds the centre of a ball, which lies in the circumsphere of tet t, unless the ball meets others.
Result<bool> SolidPacking::try_ball(Index t, const Sphere& ball, bool is_certain) {
  const Index region = region_of_[t];
  const Point3 p = ball.centre;
  const auto meets_ball = [&](Index w) {
    const Point3 way = p - point(w);
    const double reach = ball.radius + radius_[w];
    return dot(way, way) < reach * reach;
  };
  const auto accepts = [&](const Triangulation3::Cavity& cavity) {
    if (!is_certain && any_rim_vertex(cavity, meets_ball)) return false;
    return all_of(cavity.tets, [&](Index u) {
      return region_of_[u] == region && !is_protected(topology().vertices(u), p);
    });
  };
  const auto v = delaunay_.insert_if(p, t, accepts);
  if (!v) return v.error();
  if (*v == kNoIndex) return false;
  radius_.push_back(ball.radius);
  ++balls_packed_;
  follow_change(*v, region);
  return true;
}

// Whether p is in the protective sphere of a face or edge of a tet that it would remove. There are
// no others: such a sphere lies within those of the tets around the face or edge together.
bool SolidPacking::is_protected(const Tet& corners, Point3 p) const {
  return index_.any_sphere(corners,
                           [&](const ProtectiveSphere& sphere) { return sphere.holds(p); });
}

void SolidPacking::follow_change(Index v, Index region) {
  const auto [changed, moves] = delaunay_.last_change();
  const std::size_t size = topology().size();
  region_of_.resize(std::max(region_of_.size(), size));
  waits_.resize(std::max(waits_.size(), size));
  for (const auto& [from, to] : moves) {
    region_of_[to] = region_of_[from];
    waits_[to] = waits_[from];
    if (waits_[to]) waiting_.push_back(to);
  }
  region_of_.resize(size);
  waits_.resize(size);
  for (const Index t : changed) {
    const Tet& corners = topology().vertices(t);
    if (!is_among(v, corners)) continue;
    region_of_[t] = region;
    waits_[t] = 0;
    push(t);
  }
}

// ---- The result ----------------------------------------------------------------------------

PackedSolids SolidPacking::result() {
  PackedSolids result;
  std::vector<Index> number(delaunay_.points().size(), kNoIndex);
  std::vector<std::uint8_t> has_triangle(surface_.triangles.size()),
      has_piece(surface_.pieces.size());
  for (Index t = 0; t < topology().size(); ++t) {
    if (!is_solid(t)) continue;
    const Tet& corners = topology().vertices(t);
    result.tets.push_back(corners);
    result.seed_of.push_back(solids_[region_of_[t]].seed);
    for (unsigned i = 0; i < 4; ++i) {
      number[corners[i]] = 0;
      if (const Index k = triangle_at({t, i}); k != kNoIndex) has_triangle[k] = 1;
      for (unsigned j = 0; j < i; ++j)
        if (const Index k = index_.piece(corners[i], corners[j]); k != kNoIndex) has_piece[k] = 1;
    }
  }
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    number[v] = static_cast<Index>(result.points.size());
    result.points.push_back(point(v));
    result.radius.push_back(radius_[v]);
    result.surface_point.push_back(v < first_far_ ? surface_point_[v] : kNoIndex);
  }
  for (Tet& corners : result.tets)
    for (Index& v : corners) v = number[v];
  result.number_of.assign(surface_.points.size(), kNoIndex);
  for (Index v = 0; v < surface_.points.size(); ++v)
    if (number_[v] != kNoIndex) result.number_of[v] = number[number_[v]];
  for (Index k = 0; k < has_triangle.size(); ++k)
    if (has_triangle[k]) result.triangles.push_back(k);
  for (Index k = 0; k < has_piece.size(); ++k)
    if (has_piece[k]) result.pieces.push_back(k);
  result.balls_packed = balls_packed_;
  result.is_complete = is_complete_;
  result.was_cancelled = was_cancelled_;
  return result;
}

}  // namespace

Result<PackedSolids> pack_solids(const PolyhedralComplex& complex, const PackedSurface& surface,
                                 const SolidOptions& options) {
  if (complex.facets.empty())
    return Error{
        ErrorCode::kInvalidGeometry, "the domain has no facets, so it encloses nothing", {}};
  auto packing = SolidPacking::start(complex, surface, options);
  if (!packing) return packing.error();
  if (Status status = packing->check_surface(); !status) return status.error();
  if (Status status = packing->find_regions(); !status) return status.error();
  if (Status status = packing->run(); !status) return status.error();
  if (Status status = packing->check_surface(); !status) return status.error();
  return packing->result();
}

}  // namespace wellspaced
