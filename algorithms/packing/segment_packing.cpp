#include "wellspaced/algorithms/packing/segment_packing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "wellspaced/algorithms/packing/point_on_segment.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

constexpr double kGap = 2.4;  // between neighbours, in radii; 2 is the least, below 4 nothing fits

// How many radii long the part is up to each of some fractions of the segment.
struct RadiusMeasure {
  std::vector<double> fraction, length;
};

Error bad_radius(Point2 p) {
  return {ErrorCode::kUsage,
          {"the spacing is not positive at (", std::to_string(p.x), ", ", std::to_string(p.y), ")"},
          {}};
}

Result<RadiusMeasure> measure_in_radii(const SegmentPart& part, const BallRadius& radius,
                                       std::size_t most_points) {
  constexpr double kStep = 0.5;  // in radii
  const double whole = distance(part.a, part.b);
  RadiusMeasure measure{{part.from}, {0}};
  for (double here = radius(part.at(part.from)); measure.fraction.back() < part.to;) {
    const double last = measure.fraction.back();
    const double t = std::min(part.to, last + kStep * here / whole);
    if (!(here > 0)) return bad_radius(part.at(last));
    if (measure.fraction.size() > 8 * most_points + 64 || !(t > last))
      return Error{ErrorCode::kLimit, "a segment needs more points than the limit", {}};
    const double there = radius(part.beside(t));
    const double step = (t - last) * whole;
    measure.length.push_back(measure.length.back() + step * (0.5 / here + 0.5 / there));
    measure.fraction.push_back(t);
    here = there;
  }
  return measure;
}

// The fractions that cut the part into `parts` of equal length in radii, its ends included.
std::vector<double> cut_evenly(const RadiusMeasure& measure, std::size_t parts) {
  std::vector<double> cuts{measure.fraction.front()};
  std::size_t k = 0;
  for (std::size_t i = 1; i < parts; ++i) {
    const double target =
        measure.length.back() * (static_cast<double>(i) / static_cast<double>(parts));
    while (k + 2 < measure.length.size() && measure.length[k + 1] < target) ++k;
    const double share = (target - measure.length[k]) / (measure.length[k + 1] - measure.length[k]);
    cuts.push_back(measure.fraction[k] + share * (measure.fraction[k + 1] - measure.fraction[k]));
  }
  cuts.push_back(measure.fraction.back());
  return cuts;
}

struct Ball {
  Point2 centre;
  double radius;
};

// With a little more between than the rounding of the centres takes away.
bool are_disjoint(const Ball& a, const Ball& b) {
  return (a.radius + b.radius) * (1 + 1e-12) <= distance(a.centre, b.centre);
}

class SegmentPacking {
 public:
  SegmentPacking(const SegmentPart& part, const BallRadius& radius)
      : part_(part), radius_(radius) {}

  bool balls_are_disjoint(const std::vector<double>& cuts) const {
    Ball before = ball(cuts[0]);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const Ball here = ball(cuts[i]);
      if (!are_disjoint(before, here)) return false;
      before = here;
    }
    return true;
  }

  // Puts a point in the middle of each gap where one fits, until none does; none where a radius
  // is not positive, which the measure may have stepped over.
  std::vector<double> with_gaps_filled(const std::vector<double>& cuts) const {
    std::vector<double> done{cuts[0]}, ahead(cuts.rbegin(), cuts.rend() - 1);
    while (!ahead.empty()) {
      const double middle = (done.back() + ahead.back()) / 2;
      const Ball fresh = ball(middle);
      if (fresh.radius > 0 && are_disjoint(ball(done.back()), fresh) &&
          are_disjoint(fresh, ball(ahead.back()))) {
        ahead.push_back(middle);
      } else {
        done.push_back(ahead.back());
        ahead.pop_back();
      }
    }
    return done;
  }

 private:
  Ball ball(double t) const {
    const Point2 p = part_.beside(t);
    return {p, radius_(p)};
  }

  const SegmentPart& part_;
  const BallRadius& radius_;
};

}  // namespace

double SegmentPart::length() const { return (to - from) * distance(a, b); }

Point2 SegmentPart::beside(double t) const {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

Point2 SegmentPart::at(double t) const {
  return t <= 0 ? a : t >= 1 ? b : point_on_segment(a, b, t);
}

Result<std::vector<Point2>> pack_segment(const SegmentPart& part, const BallRadius& radius,
                                         std::size_t most_points) {
  const Result<RadiusMeasure> measure = measure_in_radii(part, radius, most_points);
  if (!measure) return measure.error();
  const SegmentPacking packing(part, radius);
  const double wanted = std::floor(measure->length.back() / kGap + 0.5);
  std::size_t parts = wanted > 1 ? static_cast<std::size_t>(wanted) : 1;
  std::vector<double> cuts = cut_evenly(*measure, parts);
  while (parts > 1 && !packing.balls_are_disjoint(cuts)) {
    parts -= 1 + parts / 64;
    cuts = cut_evenly(*measure, parts);
  }
  cuts = packing.with_gaps_filled(cuts);
  std::vector<Point2> points;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i) points.push_back(part.at(cuts[i]));
  return points;
}

}  // namespace wellspaced
