#include "wellspaced/algorithms/generate/curved_domain.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

constexpr int kOuterMarker = 1;
constexpr double kOuterRadius = 8;

Point2 between(Point2 a, Point2 b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// What must be added to the distance from a feature so that it grows by 2^octaves up to `reach`.
double offset_for(double octaves, double reach) {
  return octaves > 0 ? reach / (power_of_two(octaves) - 1) : 1e3 * reach;
}

void add_line(CurvedDomain& domain, Index from, Index to, int marker) {
  const Point2 a = domain.corners[from], b = domain.corners[to];
  domain.curves.push_back({from, to, marker, [=](double t) { return between(a, b, t); }});
}

void add_circle(CurvedDomain& domain, double radius, int marker) {
  const Index corner = static_cast<Index>(domain.corners.size());
  domain.corners.push_back({radius, 0});
  domain.curves.push_back({corner, corner, marker, [=](double t) {
                             const Point2 unit = circle_point(t);
                             return Point2{radius * unit.x, radius * unit.y};
                           }});
}

// A wing section of the NACA four-digit family and where it lies: the leading edge, and the vector
// from there to the trailing edge.
struct Section {
  double camber, camber_position, thickness;
  Point2 leading, chord;
  Point2 trailing() const { return {leading.x + chord.x, leading.y + chord.y}; }
};

struct CamberLine {
  double height, slope;
};

CamberLine camber_line(const Section& section, double x) {
  if (section.camber == 0) return {0, 0};
  const double m = section.camber, p = section.camber_position;
  const double q = x < p ? p : 1 - p;
  return {m / (q * q) * (x < p ? x * (2 * p - x) : 1 - 2 * p + x * (2 * p - x)),
          2 * m / (q * q) * (p - x)};
}

// The point of the upper (side 1) or lower (side -1) surface at the fraction root^2 of the chord.
// The last coefficient is the one that closes the trailing edge.
Point2 surface_point(const Section& section, double root, int side) {
  const double x = root * root;
  const double polynomial = x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1036 * x)));
  const double half = side * 5 * section.thickness * (0.2969 * root + polynomial);
  const CamberLine line = camber_line(section, x);
  const double cosine = 1 / std::sqrt(1 + line.slope * line.slope);
  const double along = x - half * line.slope * cosine, above = line.height + half * cosine;
  const Point2 c = section.chord;
  return {section.leading.x + along * c.x - above * c.y,
          section.leading.y + along * c.y + above * c.x};
}

void add_section(CurvedDomain& domain, const Section& section, int marker) {
  const Index leading = static_cast<Index>(domain.corners.size()), trailing = leading + 1;
  domain.corners.push_back(section.leading);
  domain.corners.push_back(section.trailing());
  for (const int side : {-1, 1})
    domain.curves.push_back(
        {leading, trailing, marker, [=](double t) { return surface_point(section, t, side); }});
  const Point2 up = surface_point(section, 0.5, 1), down = surface_point(section, 0.5, -1);
  domain.holes.push_back(between(up, down, 0.5));
}

// A curve cut into short steps, with the length up to each measured in spacings.
struct MeasuredCurve {
  std::vector<double> parameter, length;
};

MeasuredCurve measure(const CurvedDomain::Curve& curve, const CurvedDomain& domain, double scale) {
  constexpr double kLongestStep = 0.125;              // in spacings
  constexpr double kShortestParameterStep = 0x1p-45;  // bounds the number of steps
  MeasuredCurve result{{0}, {0}};
  double t = 0, step = 0x1p-8;
  for (Point2 here = curve.point(0); t < 1;) {
    step = std::min(step, 1 - t);
    const Point2 there = curve.point(t + step);
    const double in_spacings =
        distance(here, there) / (scale * std::min(domain.grading(here), domain.grading(there)));
    if (in_spacings > kLongestStep && step > kShortestParameterStep) {
      step /= 2;
      continue;
    }
    t += step;
    here = there;
    result.parameter.push_back(t);
    result.length.push_back(result.length.back() + in_spacings);
    step = std::min(2 * step, 0x1p-8);
  }
  return result;
}

// The parameters that cut the curve into equal parts of about `part` spacings, ends excluded.
std::vector<double> equal_parts(const MeasuredCurve& curve, double part, int least_parts) {
  const double total = curve.length.back();
  const double parts = std::max<double>(least_parts, std::floor(total / part + 0.5));
  std::vector<double> cuts;
  std::size_t k = 0;
  for (double i = 1; i < parts; ++i) {
    const double target = total * (i / parts);
    while (curve.length[k + 1] < target) ++k;
    const double fraction = (target - curve.length[k]) / (curve.length[k + 1] - curve.length[k]);
    cuts.push_back(curve.parameter[k] + fraction * (curve.parameter[k + 1] - curve.parameter[k]));
  }
  return cuts;
}

void append_chain(const CurvedDomain::Curve& curve, const std::vector<double>& cuts, Pslg& pslg) {
  Index last = curve.from;
  for (const double t : cuts) {
    const Index next = static_cast<Index>(pslg.points.size());
    pslg.points.push_back(curve.point(t));
    pslg.segments.push_back({last, next, curve.marker});
    last = next;
  }
  pslg.segments.push_back({last, curve.to, curve.marker});
}

}  // namespace

CurvedDomain crack_domain(double octaves) {
  CurvedDomain domain;
  const Point2 tip{0.5, 0.5};
  domain.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.5}, tip};
  for (Index k = 0; k < 5; ++k) add_line(domain, k, (k + 1) % 5, kOuterMarker);
  add_line(domain, 4, 5, 2);
  const double offset = offset_for(octaves, std::sqrt(0.5));
  domain.grading = [=](Point2 p) { return offset + distance(p, tip); };
  return domain;
}

CurvedDomain annulus_domain(double octaves) {
  CurvedDomain domain;
  add_circle(domain, kOuterRadius, kOuterMarker);
  add_circle(domain, 1, 2);
  domain.holes = {{0, 0}};
  const double offset = offset_for(octaves, kOuterRadius - 1);
  domain.grading = [=](Point2 p) { return offset + std::max(0.0, distance(p, {0, 0}) - 1); };
  return domain;
}

CurvedDomain airfoil_domain(double octaves) {
  constexpr double kSurfaceOffset = 6;  // spacing on the chords, in spacings at the edges
  const Section main{0.02, 0.4, 0.12, {-0.6, 0}, {1, 0}};
  const Point2 flap_direction = circle_point(-0.075);
  const Section flap{
      0, 0, 0.12, {0.39, -0.035}, {0.32 * flap_direction.x, 0.32 * flap_direction.y}};
  CurvedDomain domain;
  add_circle(domain, kOuterRadius, kOuterMarker);
  add_section(domain, main, 2);
  add_section(domain, flap, 3);
  const double offset = offset_for(octaves, kOuterRadius);
  domain.grading = [=](Point2 p) {
    double result = kOuterRadius + offset;
    for (const Section& section : {main, flap}) {
      const Point2 a = section.leading, b = section.trailing();
      result = std::min({result, offset + distance(p, a), offset + distance(p, b),
                         kSurfaceOffset * offset + distance_to_segment(p, a, b)});
    }
    return result;
  };
  return domain;
}

Pslg discretize(const CurvedDomain& domain, double scale) {
  constexpr double kPart = 1.2;
  Pslg pslg;
  pslg.points = domain.corners;
  pslg.holes = domain.holes;
  for (const auto& curve : domain.curves) {
    const int least_parts = curve.from == curve.to ? 6 : 1;
    append_chain(curve, equal_parts(measure(curve, domain, scale), kPart, least_parts), pslg);
  }
  return pslg;
}

}  // namespace wellspaced
