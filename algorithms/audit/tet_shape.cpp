#include "wellspaced/algorithms/audit/tet_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/audit/interval_counts.hpp"
#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/algorithms/audit/worst_list.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced::audit {
namespace {

// What parts the intervals from 3 to infinity.
constexpr std::array<double, 9> kTetAspects = {3.5, 4, 5, 7, 10, 20, 50, 100, 1000};

TetCorners scaled(const TetCorners& tet, double scale) {
  return {scale * tet[0], scale * tet[1], scale * tet[2], scale * tet[3]};
}

struct TetEdge {
  int from, to, left, right;  // the corners at its ends, and the two others
};
constexpr std::array<TetEdge, 6> kTetEdges = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

// The faces of a tet as vectors: outward normals as long as twice the areas, if the tet is
// positive. volume: six times that of the tet, with its sign.
struct FaceVectors {
  std::array<Point3, 4> normal;
  double volume;

  explicit FaceVectors(const TetCorners& tet) {
    const Point3 b = tet[1] - tet[0], c = tet[2] - tet[0], d = tet[3] - tet[0];
    normal = {cross(tet[2] - tet[1], tet[3] - tet[1]), cross(d, c), cross(b, d), cross(c, b)};
    volume = -dot(b, normal[1]);
  }

  // The cross product of two normals is the edge between them, times the volume.
  double dihedral_cotangent(const TetEdge& edge, double edge_length) const {
    const double sine = std::fabs(volume) * edge_length;
    const double cosine = -dot(normal[edge.left], normal[edge.right]);
    return sine > 0 ? cosine / sine : std::copysign(kInfinity, cosine);
  }

  // Relative to corner 0. Requires: volume != 0.
  Point3 circumcentre(const TetCorners& tet) const {
    const Point3 b = tet[1] - tet[0], c = tet[2] - tet[0], d = tet[3] - tet[0];
    return (-1 / (2 * volume)) *
           (dot(b, b) * normal[1] + dot(c, c) * normal[2] + dot(d, d) * normal[3]);
  }

  // Whether a place, relative to corner 0, is on the inner side of every face.
  bool contain(Point3 place, const TetCorners& tet) const {
    const Point3 from_b = place - (tet[1] - tet[0]);
    const int inner = (dot(normal[0], from_b) * volume < 0) + (dot(normal[1], place) * volume < 0) +
                      (dot(normal[2], place) * volume < 0) + (dot(normal[3], place) * volume < 0);
    return inner == 4;
  }

  double surface() const {
    return (length(normal[0]) + length(normal[1]) + length(normal[2]) + length(normal[3])) / 2;
  }
};

double square(Point3 v) { return dot(v, v); }

bool is_in_ball(Point3 p, Point3 centre, double radius_sq) {
  return square(p - centre) <= radius_sq * (1 + 2e-12);
}

// The squared radius of the circle through a, b, c with this normal, if its ball contains d; else
// infinity.
double face_ball_sq(Point3 a, Point3 b, Point3 c, Point3 d, Point3 normal) {
  const double twice = 2 * square(normal);
  if (!(twice > 0)) return kInfinity;
  const Point3 p = b - a, q = c - a;
  const Point3 offset = (1 / twice) * (square(q) * cross(normal, p) + square(p) * cross(q, normal));
  return is_in_ball(d, a + offset, square(offset)) ? square(offset) : kInfinity;
}

// The smallest ball around a tet that does not contain its circumcentre is that over the longest
// edge or over a face.
double containing_radius(const TetCorners& tet, const FaceVectors& faces, const TetEdge& longest,
                         double circumradius) {
  const Point3 half = 0.5 * (tet[longest.to] - tet[longest.from]);
  const Point3 middle = tet[longest.from] + half;
  if (is_in_ball(tet[longest.left], middle, square(half)) &&
      is_in_ball(tet[longest.right], middle, square(half)))
    return length(half);
  double least_sq = circumradius * circumradius;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [p, q, r] = kFaceCorners[i];
    least_sq = std::min(least_sq, face_ball_sq(tet[p], tet[q], tet[r], tet[i], faces.normal[i]));
  }
  return std::sqrt(least_sq);
}

// What the shape is made of; angles by their cotangents.
struct TetFigures {
  std::array<double, 6> cotangents, lengths;
  double volume, circumradius, containing, inverse_inradius;

  explicit TetFigures(const TetCorners& tet) {
    const FaceVectors faces(tet);
    for (std::size_t i = 0; i < 6; ++i) {
      lengths[i] = length(tet[kTetEdges[i].to] - tet[kTetEdges[i].from]);
      cotangents[i] = faces.dihedral_cotangent(kTetEdges[i], lengths[i]);
    }
    volume = std::fabs(faces.volume) / 6;
    inverse_inradius = ratio(faces.surface(), 3 * volume);
    const Point3 centre = volume > 0 ? faces.circumcentre(tet) : Point3{};
    circumradius = volume > 0 ? length(centre) : kInfinity;
    const auto longest_at = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
    containing = volume > 0 && faces.contain(centre, tet)
                     ? circumradius
                     : containing_radius(tet, faces, kTetEdges[longest_at], circumradius);
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

class TetShapes {
 public:
  TetShapes(const TetMesh& mesh, const Progress& progress)
      : mesh_(mesh), scale_(scale_of(mesh.points)) {
    ProgressMeter meter(progress, "audit", mesh.tets.size());
    for (Index t = 0; t < mesh.tets.size() && meter.step(); ++t) add(t);
  }

  void report_to(Report& report) const {
    Check& check = report.add_check("no_sliver", Item::kTet);
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
    report.histograms.push_back(dihedrals_.histogram("dihedral"));
    report.histograms.push_back(aspects_.histogram("aspect_ratio", bounds_between(3, kTetAspects)));
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
    for (const double cotangent : f.cotangents) dihedrals_.add_cotangent(cotangent);
    aspects_.add(f.aspect_ratio());
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
  AngleCounts dihedrals_;
  IntervalCounts<kTetAspects.size()> aspects_{kTetAspects};
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

void audit_tet_shape(const TetMesh& mesh, const Progress& progress, Report& report) {
  TetShapes(mesh, progress).report_to(report);
}

}  // namespace wellspaced::audit
