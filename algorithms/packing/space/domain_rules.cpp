#include "wellspaced/algorithms/packing/space/domain_rules.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

using Feature = FeatureSize3::Feature;

Point3 direction(Point3 from, Point3 to) {
  const Point3 way = to - from;
  return (1 / length(way)) * way;
}

// The part of a facet around one of its points: cones between two directions.
struct FacetCorner {
  Index facet = 0;
  std::vector<std::array<Point3, 2>> cones;
  Point3 normal;
};

// What meets in a vertex.
struct Meeting {
  std::vector<Index> segments;
  std::vector<FacetCorner> facets;
};

// A facet at a segment, and in what direction it leaves it.
struct Wing {
  Index facet = 0;
  Point3 away;
};

class RuleCheck {
 public:
  RuleCheck(const PolyhedralComplex& complex, double tolerance, std::size_t most)
      : complex_(complex),
        tolerance_(tolerance),
        most_(most),
        meetings_(complex.points.size()),
        wings_(complex.segments.size()) {}

  std::vector<RuleViolation> run() {
    collect();
    for (Index v = 0; v < meetings_.size(); ++v) {
      check_segments(v);
      check_segments_and_facets(v);
      check_facets(v);
    }
    for (Index s = 0; s < wings_.size(); ++s) check_wings(s);
    return std::move(found_);
  }

 private:
  void collect();
  void add_corner(Index v, Index facet, Point3 first, Point3 second);
  void check_segments(Index v);
  void check_segments_and_facets(Index v);
  void check_facets(Index v);
  void check_wings(Index s);
  double cosine_between(Point3 along, const FacetCorner& corner) const;
  bool share_segment_at(Index v, Index f, Index g) const;
  Point3 direction_from(Index v, Index s) const {
    const Segment& segment = complex_.segments[s];
    return direction(complex_.points[v], complex_.points[segment.a == v ? segment.b : segment.a]);
  }
  // Notes a fault if it is one. Returns false when there are enough.
  bool judge(const RuleViolation& violation) {
    if (violation.cosine > tolerance_ && found_.size() < most_) found_.push_back(violation);
    return found_.size() < most_;
  }

  const PolyhedralComplex& complex_;
  double tolerance_;
  std::size_t most_;
  std::vector<Meeting> meetings_;
  std::vector<std::vector<Wing>> wings_;
  std::vector<RuleViolation> found_;
};

void RuleCheck::add_corner(Index v, Index facet, Point3 first, Point3 second) {
  std::vector<FacetCorner>& corners = meetings_[v].facets;
  if (corners.empty() || corners.back().facet != facet) {
    const PlaneFrame& frame = complex_.facets[facet].frame;
    corners.push_back({facet, {}, cross(frame.u, frame.v)});
  }
  corners.back().cones.push_back({first, second});
}

void RuleCheck::collect() {
  for (Index s = 0; s < complex_.segments.size(); ++s)
    for (const Index v : {complex_.segments[s].a, complex_.segments[s].b})
      meetings_[v].segments.push_back(s);
  for (Index f = 0; f < complex_.facets.size(); ++f) {
    const PolyhedralComplex::Facet& facet = complex_.facets[f];
    for (const auto& triangle : facet.triangles) {
      for (unsigned i = 0; i < 3; ++i) {
        const Index v = triangle[i], next = triangle[(i + 1) % 3], last = triangle[(i + 2) % 3];
        const Point3 p = complex_.points[v];
        const Point3 to_next = direction(p, complex_.points[next]);
        const Point3 to_last = direction(p, complex_.points[last]);
        add_corner(v, f, to_next, to_last);
        const Segment edge{std::min(v, next), std::max(v, next)};
        const auto found =
            std::partition_point(facet.segments.begin(), facet.segments.end(), [&](Index s) {
              const Segment& other = complex_.segments[s];
              return std::pair(other.a, other.b) < std::pair(edge.a, edge.b);
            });
        if (found == facet.segments.end() || complex_.segments[*found].a != edge.a ||
            complex_.segments[*found].b != edge.b)
          continue;
        const Point3 away = to_last - dot(to_last, to_next) * to_next;
        wings_[*found].push_back({f, (1 / length(away)) * away});
      }
    }
  }
}

void RuleCheck::check_segments(Index v) {
  const std::vector<Index>& segments = meetings_[v].segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Point3 along = direction_from(v, segments[i]);
    for (std::size_t j = 0; j < i; ++j)
      if (!judge(
              {{1, segments[j]}, {1, segments[i]}, v, dot(along, direction_from(v, segments[j]))}))
        return;
  }
}

// The cosine of the smallest angle between a direction and a facet: where the direction appears
// within a cone, that to the plane; else that to the side of a cone.
double RuleCheck::cosine_between(Point3 along, const FacetCorner& corner) const {
  double largest = -1;
  const Point3 flat = along - dot(along, corner.normal) * corner.normal;
  for (const auto& [first, second] : corner.cones) {
    largest = std::max({largest, dot(along, first), dot(along, second)});
    const Point3 turn = cross(first, second);
    if (dot(cross(first, flat), turn) > 0 && dot(cross(flat, second), turn) > 0)
      largest = std::max(largest, length(flat));
  }
  return largest;
}

void RuleCheck::check_segments_and_facets(Index v) {
  for (const FacetCorner& corner : meetings_[v].facets) {
    const std::vector<Index>& own = complex_.facets[corner.facet].segments;
    for (const Index s : meetings_[v].segments) {
      if (std::binary_search(own.begin(), own.end(), s)) continue;
      if (!judge({{1, s}, {2, corner.facet}, v, cosine_between(direction_from(v, s), corner)}))
        return;
    }
  }
}

bool RuleCheck::share_segment_at(Index v, Index f, Index g) const {
  const std::vector<Index>&first = complex_.facets[f].segments,
        &second = complex_.facets[g].segments;
  return any_of(meetings_[v].segments, [&](Index s) {
    return std::binary_search(first.begin(), first.end(), s) &&
           std::binary_search(second.begin(), second.end(), s);
  });
}

// Facets that have only the vertex in common there: all directions of one against all of the other.
void RuleCheck::check_facets(Index v) {
  const std::vector<FacetCorner>& corners = meetings_[v].facets;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (share_segment_at(v, corners[i].facet, corners[j].facet)) continue;
      double largest = -1;
      for (const auto& cone : corners[i].cones)
        for (const Point3 along : cone)
          largest = std::max(largest, cosine_between(along, corners[j]));
      if (!judge({{2, corners[j].facet}, {2, corners[i].facet}, v, largest})) return;
    }
  }
}

void RuleCheck::check_wings(Index s) {
  const std::vector<Wing>& wings = wings_[s];
  for (std::size_t i = 0; i < wings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (wings[i].facet == wings[j].facet) continue;
      if (!judge({{2, wings[j].facet},
                  {2, wings[i].facet},
                  complex_.segments[s].a,
                  dot(wings[i].away, wings[j].away)}))
        return;
    }
  }
}

// The least cosine that counts as an angle of 0.
constexpr double kOverlapping = 1 - 1e-12;

double extent_of(const PolyhedralComplex& complex) {
  return complex.points.empty() ? 0 : length(Box3::around(complex.points).size());
}

std::string name_of(const Feature& feature, const PolyhedralComplex& complex) {
  if (feature.dimension == 0) return concat({"point ", feature.number});
  if (feature.dimension == 2) return concat({"facet ", complex.facets[feature.number].source});
  const Segment& s = complex.segments[feature.number];
  return concat({"segment ", s.a, "-", s.b});
}

Index point_of(const RuleViolation& violation, const PolyhedralComplex& complex) {
  if (violation.place != kNoIndex) return violation.place;
  const auto& [dimension, number] = violation.a;
  return dimension == 0 ? number : complex.segments[number].a;
}

// How two polytopes meet: "facet 2 and facet 5 meet at 45.00 degrees at point 7".
std::string description(const RuleViolation& violation, const PolyhedralComplex& complex) {
  const std::string both =
      concat({name_of(violation.a, complex), " and ", name_of(violation.b, complex)});
  if (violation.place == kNoIndex) return concat({both, " intersect"});
  const std::string at = concat({" at point ", violation.place});
  if (violation.cosine > kOverlapping) return concat({both, " overlap", at});
  const double c = std::clamp(violation.cosine, -1.0, 1.0);
  const double angle = arccotangent_deg(c / std::sqrt(1 - c * c));
  std::string digits = std::to_string(angle);
  digits.resize(digits.find('.') + 3);
  return concat({both, " meet at ", digits, " degrees", at});
}

// The worst violations, each pair of polytopes once.
std::string worst_of(const std::vector<RuleViolation>& sorted, const PolyhedralComplex& complex) {
  constexpr std::size_t kNamed = 3;
  std::vector<const RuleViolation*> named;
  std::string text;
  for (const RuleViolation& next : sorted) {
    if (any_of(named,
               [&](const RuleViolation* one) { return one->a == next.a && one->b == next.b; }))
      continue;
    if (named.size() == kNamed) return concat({text, "; and more"});
    text += (named.empty() ? "" : "; ") + description(next, complex);
    named.push_back(&next);
  }
  return text;
}

// The elements of a sorted list that are in it once.
std::vector<std::array<Index, 2>> lone_ones(std::vector<std::array<Index, 2>> edges) {
  sort(edges);
  std::vector<std::array<Index, 2>> lone;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_first = i == 0 || edges[i] != edges[i - 1];
    if (is_first && (i + 1 == edges.size() || edges[i] != edges[i + 1])) lone.push_back(edges[i]);
  }
  return lone;
}

// The number of edges that bound one facet only: none if the facets close up everywhere.
std::size_t count_free_edges(const PolyhedralComplex& complex) {
  std::vector<std::array<Index, 2>> bounds;
  for (const PolyhedralComplex::Facet& facet : complex.facets) {
    std::vector<std::array<Index, 2>> edges;
    for (const auto& triangle : facet.triangles)
      for (unsigned i = 0; i < 3; ++i) {
        const Index a = triangle[i], b = triangle[(i + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b)});
      }
    const auto own = lone_ones(std::move(edges));
    bounds.insert(bounds.end(), own.begin(), own.end());
  }
  return lone_ones(std::move(bounds)).size();
}

}  // namespace

std::vector<RuleViolation> find_rule_violations(const PolyhedralComplex& complex,
                                                const FeatureSize3& features, double tolerance,
                                                std::size_t most, const Progress& progress) {
  std::vector<RuleViolation> violations;
  for (const auto& [a, b] : features.contacts(tolerance * extent_of(complex), most, progress))
    violations.push_back({a, b, kNoIndex, 1});
  const auto angles = RuleCheck(complex, tolerance, most - violations.size()).run();
  violations.insert(violations.end(), angles.begin(), angles.end());
  return violations;
}

Error rule_error(const std::vector<RuleViolation>& violations, const PolyhedralComplex& complex) {
  std::vector<RuleViolation> worst = violations;
  sort(worst, [](const RuleViolation& a, const RuleViolation& b) { return a.cosine > b.cosine; });
  Error error{ErrorCode::kInvalidGeometry, "", {}};
  for (const RuleViolation& violation : worst) error.ids.push_back(point_of(violation, complex));
  const bool is_one = worst.size() == 1, intersects = worst[0].cosine > kOverlapping;
  error.message = concat({worst.size(), is_one ? " pair" : " pairs", " of polytopes ",
                          intersects ? "intersect or meet at"
                          : is_one   ? "meets at"
                                     : "meet at",
                          " less than 90 degrees: ", worst_of(worst, complex)});
  if (const std::size_t free = count_free_edges(complex); free > 0)
    append(error.message, {"; ", free, free == 1 ? " edge bounds" : " edges bound",
                           " one facet only: is a facet missing?"});
  return error;
}

}  // namespace wellspaced
