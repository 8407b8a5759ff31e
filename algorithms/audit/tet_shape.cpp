#include "wellspaced/algorithms/audit/tet_shape.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "wellspaced/algorithms/audit/angle_intervals.hpp"
#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/worst_list.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced::audit {
namespace {

constexpr std::array<double, 11> kTetAspectBounds = {3,  3.5, 4,   5,    7,        10,
                                                     20, 50,  100, 1000, kInfinity};

TetCorners scaled(const TetCorners& tet, double scale) {
  return {scale * tet[0], scale * tet[1], scale * tet[2], scale * tet[3]};
}

struct TetEdge {
  int from, to, left, right;  // the corners at its ends, and the two others
};
constexpr std::array<TetEdge, 6> kTetEdges = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

// The cotangent of the dihedral angle at an edge: of the angle between the normals of its faces.
double dihedral_cotangent(const TetCorners& tet, const TetEdge& edge) {
  const Point3 along = tet[edge.to] - tet[edge.from];
  const Point3 n = cross(along, tet[edge.left] - tet[edge.from]);
  const Point3 m = cross(along, tet[edge.right] - tet[edge.from]);
  const double sine = length(cross(n, m)), cosine = dot(n, m);
  return sine > 0 ? cosine / sine : std::copysign(kInfinity, cosine);
}

struct Ball {
  Point3 centre;
  double radius = kInfinity;
};

bool contains(const Ball& ball, const TetCorners& tet) {
  return std::all_of(tet.begin(), tet.end(), [&](Point3 p) {
    return length(p - ball.centre) <= ball.radius * (1 + 1e-12);
  });
}

Ball ball_over_edge(Point3 a, Point3 b) { return {0.5 * (a + b), length(a - b) / 2}; }

Ball ball_over_face(Point3 a, Point3 b, Point3 c) {
  const Point3 p = b - a, q = c - a, n = cross(p, q);
  const double twice = 2 * dot(n, n);
  if (!(twice > 0)) return {};
  const Point3 offset = (1 / twice) * (dot(q, q) * cross(n, p) + dot(p, p) * cross(q, n));
  return {a + offset, length(offset)};
}

Ball circumscribed(const TetCorners& tet) {
  const Point3 b = tet[1] - tet[0], c = tet[2] - tet[0], d = tet[3] - tet[0];
  const double twice = 2 * dot(b, cross(c, d));
  if (twice == 0) return {};
  const Point3 offset =
      (1 / twice) * (dot(b, b) * cross(c, d) + dot(c, c) * cross(d, b) + dot(d, d) * cross(b, c));
  return {tet[0] + offset, length(offset)};
}

// Whether the circumcentre is on the inner side of every face.
bool contains_its_circumcentre(const TetCorners& tet) {
  const Point3 centre = circumscribed(tet).centre;
  for (int i = 0; i < 4; ++i) {
    const Point3 a = tet[(i + 1) % 4];
    const Point3 normal = cross(tet[(i + 2) % 4] - a, tet[(i + 3) % 4] - a);
    if (!(dot(normal, centre - a) * dot(normal, tet[i] - a) > 0)) return false;
  }
  return true;
}

// The smallest ball around a tet is that over an edge, a face or all of it.
double containing_radius(const TetCorners& tet, double circumradius) {
  if (contains_its_circumcentre(tet)) return circumradius;
  double least = circumradius;
  const auto try_ball = [&](const Ball& ball) {
    if (ball.radius < least && contains(ball, tet)) least = ball.radius;
  };
  for (const TetEdge& e : kTetEdges) try_ball(ball_over_edge(tet[e.from], tet[e.to]));
  for (int i = 0; i < 4; ++i)
    try_ball(ball_over_face(tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]));
  return least;
}

double volume_of(const TetCorners& tet) {
  return std::fabs(dot(tet[1] - tet[0], cross(tet[2] - tet[0], tet[3] - tet[0]))) / 6;
}

double surface_of(const TetCorners& tet) {
  double twice = 0;
  for (int i = 0; i < 4; ++i)
    twice +=
        length(cross(tet[(i + 2) % 4] - tet[(i + 1) % 4], tet[(i + 3) % 4] - tet[(i + 1) % 4]));
  return twice / 2;
}

// What the shape is made of; angles by their cotangents.
struct TetFigures {
  std::array<double, 6> cotangents, lengths;
  double volume, circumradius, containing, inverse_inradius;

  explicit TetFigures(const TetCorners& tet) {
    for (std::size_t i = 0; i < 6; ++i) {
      cotangents[i] = dihedral_cotangent(tet, kTetEdges[i]);
      lengths[i] = length(tet[kTetEdges[i].to] - tet[kTetEdges[i].from]);
    }
    volume = volume_of(tet);
    circumradius = circumscribed(tet).radius;
    containing = containing_radius(tet, circumradius);
    inverse_inradius = ratio(surface_of(tet), 3 * volume);
  }

  double shortest() const { return *std::min_element(lengths.begin(), lengths.end()); }
  double longest() const { return *std::max_element(lengths.begin(), lengths.end()); }
  double largest_cotangent() const {
    return *std::max_element(cotangents.begin(), cotangents.end());
  }
  double least_cotangent() const { return *std::min_element(cotangents.begin(), cotangents.end()); }
  double aspect_ratio() const { return containing * inverse_inradius; }
  double radius_edge() const { return ratio(circumradius, shortest()); }
};

TetClass class_of_stretched(const TetFigures& f) {
  const double mean = std::sqrt(f.shortest() * f.longest());
  std::array<int, 4> short_at{};  // short edges at each corner
  int short_edges = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    if (f.lengths[i] >= mean) continue;
    ++short_edges;
    ++short_at[kTetEdges[i].from];
    ++short_at[kTetEdges[i].to];
  }
  const bool one_corner_is_far = *std::min_element(short_at.begin(), short_at.end()) == 0;
  if (short_edges == 3 && one_corner_is_far) return TetClass::kNeedle;
  if (short_edges < 3 && one_corner_is_far) return TetClass::kWedge;
  return TetClass::kSpindle;
}

// Whether a corner's foot on the plane of the face opposite lies inside the face: then the dihedral
// angles at all three edges of that face are acute.
bool is_over_its_face(const TetFigures& f, int corner) {
  for (std::size_t i = 0; i < 6; ++i)
    if (kTetEdges[i].from != corner && kTetEdges[i].to != corner && f.cotangents[i] < 0)
      return false;
  return true;
}

TetClass class_of(const TetFigures& f) {
  if (f.aspect_ratio() <= kBadAspectRatio) return TetClass::kWellShaped;
  if (ratio(f.longest(), f.shortest()) > kLargeEdgeRatio) return class_of_stretched(f);
  if (f.radius_edge() <= kLargeRadiusEdge) return TetClass::kSliver;
  // Of a flat quadrilateral no corner stands over the face opposite, of a cap exactly one does.
  for (int corner = 0; corner < 4; ++corner)
    if (is_over_its_face(f, corner)) return TetClass::kCap;
  return TetClass::kFlat;
}

Histogram histogram(std::string_view name, std::vector<double> bounds) {
  Histogram result;
  result.name = name;
  result.counts.assign(bounds.size() - 1, 0);
  result.bounds = std::move(bounds);
  return result;
}

void count(Histogram& histogram, double value) {
  const auto last = histogram.bounds.end() - 1;
  const auto above = std::upper_bound(histogram.bounds.begin() + 1, last, value);
  ++histogram.counts[static_cast<std::size_t>(above - histogram.bounds.begin() - 1)];
}

class TetShapes {
 public:
  explicit TetShapes(const TetMesh& mesh) : mesh_(mesh), scale_(scale_of(mesh.points)) {
    std::vector<double> degrees;
    for (int i = 0; i <= 18; ++i) degrees.push_back(10 * i);
    dihedrals_ = histogram("dihedral", degrees);
    aspects_ = histogram("aspect_ratio", {kTetAspectBounds.begin(), kTetAspectBounds.end()});
    for (Index t = 0; t < mesh.tets.size(); ++t) add(t);
  }

  void report_to(Report& report) const {
    Check& check = report.add_check("no_sliver", Item::kTet, false);
    for (const Index t : slivers_) check.violate({t});
    if (mesh_.tets.empty()) return;
    report.add_measure("min_dihedral", arccotangent_deg(min_dihedral_.worst_key()));
    report.add_measure("max_dihedral", arccotangent_deg(-max_dihedral_.worst_key()));
    report.add_measure("aspect_ratio", aspect_.worst_key());
    report.add_measure("circumradius_to_inradius", circumradius_to_inradius_);
    report.add_measure("radius_edge", radius_edge_.worst_key());
    report.add_measure("edge_ratio", edge_ratio_);
    constexpr std::string_view kNames[] = {"well_shaped", "needles", "wedges", "spindles",
                                           "caps",        "flats",   "slivers"};
    for (std::size_t i = 1; i < classes_.size(); ++i)
      report.add_measure(kNames[i], static_cast<double>(classes_[i]));
    report.add_measure("shortest_edge", shortest_ / scale_);
    report.add_measure("longest_edge", longest_ / scale_);
    report.add_measure("gradation", binary_logarithm(ratio(longest_, shortest_)));
    report.add_measure("volume", volume_ / scale_ / scale_ / scale_);
    report.histograms.push_back(dihedrals_);
    report.histograms.push_back(aspects_);
    report_worst(report);
  }

 private:
  void add(Index t) {
    const auto& [a, b, c, d] = mesh_.tets[t];
    const auto& p = mesh_.points;
    const TetFigures f(scaled({p[a], p[b], p[c], p[d]}, scale_));
    min_dihedral_.offer(t, f.largest_cotangent());
    max_dihedral_.offer(t, -f.least_cotangent());
    aspect_.offer(t, f.aspect_ratio());
    radius_edge_.offer(t, f.radius_edge());
    edge_ratio_ = std::max(edge_ratio_, ratio(f.longest(), f.shortest()));
    circumradius_to_inradius_ =
        std::max(circumradius_to_inradius_, f.circumradius * f.inverse_inradius);
    shortest_ = std::min(shortest_, f.shortest());
    longest_ = std::max(longest_, f.longest());
    volume_ += f.volume;
    for (const double cotangent : f.cotangents) ++dihedrals_.counts[interval_of(cotangent)];
    count(aspects_, f.aspect_ratio());
    const TetClass type = class_of(f);
    ++classes_[static_cast<std::size_t>(type)];
    if (type == TetClass::kSliver) slivers_.push_back(t);
  }

  void report_worst(Report& report) const {
    const auto angle = [](double cotangent) { return arccotangent_deg(cotangent); };
    const auto itself = [](double key) { return key; };
    report.worst.push_back(min_dihedral_.list("min_dihedral", angle, Item::kTet));
    report.worst.push_back(max_dihedral_.list(
        "max_dihedral", [&](double key) { return angle(-key); }, Item::kTet));
    report.worst.push_back(aspect_.list("aspect_ratio", itself, Item::kTet));
    report.worst.push_back(radius_edge_.list("radius_edge", itself, Item::kTet));
  }

  const TetMesh& mesh_;
  double scale_;
  WorstList min_dihedral_, max_dihedral_, aspect_, radius_edge_;
  double circumradius_to_inradius_ = 0, edge_ratio_ = 0, volume_ = 0;
  double shortest_ = kInfinity, longest_ = 0;
  std::array<std::uint64_t, 7> classes_{};
  std::vector<Index> slivers_;
  Histogram dihedrals_, aspects_;
};

}  // namespace

TetShape tet_shape(const TetCorners& tet) {
  const double scale = scale_of(tet);
  const TetFigures f(scaled(tet, scale));
  TetShape shape;
  shape.min_dihedral = arccotangent_deg(f.largest_cotangent());
  shape.max_dihedral = arccotangent_deg(f.least_cotangent());
  shape.aspect_ratio = f.aspect_ratio();
  shape.circumradius_to_inradius = f.circumradius * f.inverse_inradius;
  shape.radius_edge = f.radius_edge();
  shape.edge_ratio = ratio(f.longest(), f.shortest());
  shape.volume = f.volume / scale / scale / scale;
  shape.shortest_edge = f.shortest() / scale;
  shape.longest_edge = f.longest() / scale;
  return shape;
}

std::optional<double> shape_value(const TetShape& shape, std::string_view name) {
  const std::pair<std::string_view, double> values[] = {
      {"min_dihedral", shape.min_dihedral},
      {"max_dihedral", shape.max_dihedral},
      {"aspect_ratio", shape.aspect_ratio},
      {"circumradius_to_inradius", shape.circumradius_to_inradius},
      {"radius_edge", shape.radius_edge},
      {"edge_ratio", shape.edge_ratio},
      {"shortest_edge", shape.shortest_edge},
      {"longest_edge", shape.longest_edge}};
  for (const auto& [key, value] : values)
    if (key == name) return value;
  return std::nullopt;
}

TetClass classify_tet(const TetCorners& tet) {
  return class_of(TetFigures(scaled(tet, scale_of(tet))));
}

void audit_tet_shape(const TetMesh& mesh, Report& report) { TetShapes(mesh).report_to(report); }

}  // namespace wellspaced::audit
