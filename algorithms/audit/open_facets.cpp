#include "wellspaced/algorithms/audit/open_facets.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "wellspaced/algorithms/audit/vectors.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

constexpr std::size_t kPlacesTried = 8;  // on a facet
constexpr std::size_t kHolesTried = 8;   // from each place

enum class Meeting { kMiss, kPass, kTouch };

using FanTriangle = std::array<Point3, 3>;

bool is_on_one_line(const FanTriangle& t) {
  const auto flat = [&](auto view) { return orient2d(view(t[0]), view(t[1]), view(t[2])) == 0; };
  return flat([](Point3 p) {
           return Point2{p.x, p.y};
         }) &&
         flat([](Point3 p) {
           return Point2{p.y, p.z};
         }) &&
         flat([](Point3 p) {
           return Point2{p.z, p.x};
         });
}

// kTouch where the line meets the triangle's rim or lies in its plane.
Meeting meeting(Point3 from, Point3 to, const FanTriangle& t) {
  const int before = orient3d(t[0], t[1], t[2], from), behind = orient3d(t[0], t[1], t[2], to);
  if (before == 0 && behind == 0) return is_on_one_line(t) ? Meeting::kMiss : Meeting::kTouch;
  if (before == behind) return Meeting::kMiss;
  int least = 1, most = -1;
  for (int i = 0; i < 3; ++i) {
    const int side = orient3d(from, to, t[i], t[(i + 1) % 3]);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least < 0 && most > 0) return Meeting::kMiss;
  const bool clear = least == most && before != 0 && behind != 0;
  return clear ? Meeting::kPass : Meeting::kTouch;
}

// Calls visit for the triangles that join each polygon's first corner to its edges. Where they
// overlap an even number of times, the facet is not.
template <class Visit>
void for_each_fan_triangle(const PolyhedralDomain& domain, Index facet, Visit visit) {
  for (const auto& polygon : domain.facets[facet])
    for (std::size_t i = 2; i < polygon.size(); ++i)
      visit(FanTriangle{domain.points[polygon[0]], domain.points[polygon[i - 1]],
                        domain.points[polygon[i]]});
}

Meeting meeting(Point3 from, Point3 to, const PolyhedralDomain& domain, Index facet) {
  bool odd = false, touches = false;
  for_each_fan_triangle(domain, facet, [&](const FanTriangle& t) {
    const Meeting with = meeting(from, to, t);
    odd ^= with == Meeting::kPass;
    touches |= with == Meeting::kTouch;
  });
  return touches ? Meeting::kTouch : odd ? Meeting::kPass : Meeting::kMiss;
}

// The centres of the largest fan triangles: of these at least one is likely to be on the facet.
// Off the fans' common edges, so that no line passes through one of those.
std::vector<Point3> places_on(const PolyhedralDomain& domain, Index facet) {
  std::vector<std::pair<double, Point3>> places;
  for_each_fan_triangle(domain, facet, [&](const FanTriangle& t) {
    const Vec<3> a = coordinates_of(t[0]), b = coordinates_of(t[1]), c = coordinates_of(t[2]);
    const double area = norm(cross_product(difference(b, a), difference(c, a)));
    const Vec<3> centre = step(step(a, 0.3125, difference(b, a)), 0.375, difference(c, a));
    places.emplace_back(-area, point_at(centre));
  });
  const std::size_t tried = std::min(places.size(), kPlacesTried);
  sort(places);
  std::vector<Point3> result;
  for (std::size_t i = 0; i < tried; ++i) result.push_back(places[i].second);
  return result;
}

std::vector<Box<3>> boxes_of_facets(const PolyhedralDomain& domain) {
  std::vector<Box<3>> boxes;
  for (const FacetPolygons& facet : domain.facets) {
    constexpr double kFar = std::numeric_limits<double>::max();
    Box<3> box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (const auto& polygon : facet)
      for (const Index v : polygon) box.grow(box_of(domain.points[v]));
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

OpenFacets::OpenFacets(const PolyhedralDomain& domain)
    : domain_(domain), boxes_(boxes_of_facets(domain)), tree_(boxes_) {
  if (domain.points.empty()) return;
  Box<3> around = box_of(domain.points[0]);
  for (const Point3& p : domain.points) around.grow(box_of(p));
  reach_ = 2 * distance_of(around.low, around.high);
}

// From the nearest hole points and along the axes, each to beyond the domain; and between holes.
std::vector<OpenFacets::Line> OpenFacets::lines_through(Point3 p) const {
  const Vec<3> at = coordinates_of(p);
  std::vector<std::pair<double, Point3>> holes;
  for (const Point3& hole : domain_.holes)
    holes.emplace_back(distance_of(at, coordinates_of(hole)), hole);
  const std::size_t tried = std::min(holes.size(), kHolesTried);
  sort(holes);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < tried; ++i) {
    const auto& [distance, hole] = holes[i];
    if (!(distance > 0)) continue;
    const Vec<3> away = difference(at, coordinates_of(hole));
    lines.push_back({hole, point_at(step(at, reach_ / distance, away))});
    for (std::size_t j = 0; j < i; ++j) lines.push_back({hole, holes[j].second});
  }
  for (const Vec<3>& axis : {Vec<3>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
    lines.push_back({point_at(step(at, -reach_, axis)), point_at(step(at, reach_, axis))});
  return lines;
}

bool OpenFacets::passes_only(const Line& line, Index facet) const {
  if (meeting(line.from, line.to, domain_, facet) != Meeting::kPass) return false;
  const Box<3> box = box_of(line.from, line.to);
  bool alone = true;
  tree_.search([&](const Box<3>& other) { return touch(box, other); },
               [&](Index other) {
                 alone = other == facet || !touch(box, boxes_[other]) ||
                         meeting(line.from, line.to, domain_, other) == Meeting::kMiss;
                 return alone;
               });
  return alone;
}

bool OpenFacets::is_open(Index facet) const {
  for (const Point3& place : places_on(domain_, facet))
    for (const Line& line : lines_through(place))
      if (passes_only(line, facet)) return true;
  return false;
}

}  // namespace wellspaced::audit
