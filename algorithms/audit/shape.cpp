#include "wellspaced/algorithms/audit/shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/audit/interval_counts.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/worst_list.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced::audit {
namespace {

// What parts the intervals from 2 to infinity.
constexpr std::array<double, 9> kTriangleAspects = {2.5, 3, 4, 6, 10, 20, 50, 100, 1000};

// What all measures are made of: scalar products at the corners, edges and their squares in
// ascending order and twice the area.
struct TriangleFigures {
  double max_product, min_product, middle_product;
  double short_sq, middle_sq, long_sq;
  double short_edge, middle_edge, long_edge;
  double twice_area, inverse;  // infinite for a flat triangle

  TriangleFigures(Point2 a, Point2 b, Point2 c) {
    const double abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
    const double bcx = c.x - b.x, bcy = c.y - b.y;
    twice_area = std::fabs(abx * acy - aby * acx);
    inverse = 1 / twice_area;
    std::array<double, 3> products{abx * acx + aby * acy, -(abx * bcx + aby * bcy),
                                   acx * bcx + acy * bcy};
    std::array<double, 3> squares{abx * abx + aby * aby, acx * acx + acy * acy,
                                  bcx * bcx + bcy * bcy};
    sort3(products);
    sort3(squares);
    min_product = products[0], middle_product = products[1], max_product = products[2];
    short_sq = squares[0], middle_sq = squares[1], long_sq = squares[2];
    short_edge = std::sqrt(short_sq);
    middle_edge = std::sqrt(middle_sq);
    long_edge = std::sqrt(long_sq);
  }

  // Without branches, which would be mispredicted.
  static void sort3(std::array<double, 3>& v) {
    const double low = std::min(v[0], v[1]), high = std::max(v[0], v[1]);
    v = {std::min(low, v[2]), std::max(low, std::min(high, v[2])), std::max(high, v[2])};
  }

  double cotangent(double product) const { return product * inverse; }
  double circumradius() const { return short_edge * middle_edge * long_edge * (inverse / 2); }
  // The smallest disc around an obtuse triangle has the longest edge for a diameter.
  double containing_radius() const { return min_product <= 0 ? long_edge / 2 : circumradius(); }
  double inverse_inradius() const { return (short_edge + middle_edge + long_edge) * inverse; }
  double radius_edge_sq() const { return (middle_sq * inverse) * (long_sq * inverse) / 4; }
  double edge_to_height() const { return long_sq * inverse; }
};

Point2 scaled(Point2 p, double scale) { return {p.x * scale, p.y * scale}; }

class Shapes {
 public:
  explicit Shapes(const TriangleMesh& mesh) : mesh_(mesh), scale_(scale_of(mesh.points)) {
    for (Index t = 0; t < mesh.triangles.size(); ++t) add(t);
  }

  void report_to(Report& report) const {
    if (mesh_.triangles.empty()) return;
    report.add_measure("min_angle", arccotangent_deg(min_angle_.worst_key()));
    report.add_measure("max_angle", arccotangent_deg(-max_angle_.worst_key()));
    report.add_measure("triangles_le_10", static_cast<double>(triangles_le_10_));
    report.add_measure("triangles_le_20", static_cast<double>(triangles_le_20_));
    report.add_measure("aspect_ratio", aspect_.worst_key());
    report.add_measure("circumradius_to_inradius", circumradius_to_inradius_);
    report.add_measure("radius_edge", std::sqrt(radius_edge_.worst_key()));
    report.add_measure("edge_to_height", edge_to_height_);
    report_sizes(report);
    report.histograms.push_back(angles_.histogram("angle"));
    report.histograms.push_back(
        aspects_.histogram("aspect_ratio", bounds_between(2, kTriangleAspects)));
    report_worst(report);
  }

 private:
  void add(Index t) {
    const auto& [i, j, k] = mesh_.triangles[t];
    const TriangleFigures f(scaled(mesh_.points[i], scale_), scaled(mesh_.points[j], scale_),
                            scaled(mesh_.points[k], scale_));
    const double largest_cotangent = f.cotangent(f.max_product);
    min_angle_.offer(t, largest_cotangent);
    max_angle_.offer(t, -f.cotangent(f.min_product));
    radius_edge_.offer(t, f.radius_edge_sq());
    edge_to_height_ = std::max(edge_to_height_, f.edge_to_height());
    shortest_sq_ = std::min(shortest_sq_, f.short_sq);
    longest_sq_ = std::max(longest_sq_, f.long_sq);
    twice_area_ += f.twice_area;
    triangles_le_10_ += largest_cotangent >= kCotangents[0];
    triangles_le_20_ += largest_cotangent >= kCotangents[1];
    for (const double product : {f.min_product, f.middle_product, f.max_product})
      angles_.add_cotangent(f.cotangent(product));
    add_ratios(t, f);
  }

  void add_ratios(Index t, const TriangleFigures& f) {
    const double inverse_inradius = f.inverse_inradius();
    const double aspect = f.containing_radius() * inverse_inradius;
    aspect_.offer(t, aspect);
    circumradius_to_inradius_ =
        std::max(circumradius_to_inradius_, f.circumradius() * inverse_inradius);
    aspects_.add(aspect);
  }

  void report_sizes(Report& report) const {
    const double gradation =
        binary_logarithm(ratio(std::sqrt(longest_sq_), std::sqrt(shortest_sq_)));
    report.add_measure("shortest_edge", std::sqrt(shortest_sq_) / scale_);
    report.add_measure("longest_edge", std::sqrt(longest_sq_) / scale_);
    report.add_measure("gradation", gradation);
    report.add_measure("triangles_per_scale",
                       ratio(static_cast<double>(mesh_.triangles.size()), gradation));
    report.add_measure("area", twice_area_ / 2 / scale_ / scale_);
  }

  void report_worst(Report& report) const {
    const auto angle = [](double cotangent) { return arccotangent_deg(cotangent); };
    report.worst.push_back(min_angle_.list("min_angle", angle));
    report.worst.push_back(max_angle_.list("max_angle", [&](double key) { return angle(-key); }));
    report.worst.push_back(aspect_.list("aspect_ratio", [](double key) { return key; }));
    report.worst.push_back(
        radius_edge_.list("radius_edge", [](double key) { return std::sqrt(key); }));
  }

  const TriangleMesh& mesh_;
  double scale_;
  WorstList min_angle_, max_angle_, aspect_, radius_edge_;
  double circumradius_to_inradius_ = 0, edge_to_height_ = 0;
  double shortest_sq_ = kInfinity, longest_sq_ = 0, twice_area_ = 0;
  std::uint64_t triangles_le_10_ = 0, triangles_le_20_ = 0;
  AngleCounts angles_;
  IntervalCounts<kTriangleAspects.size()> aspects_{kTriangleAspects};
};

double boundary_length(const TriangleMesh& mesh, const HalfEdges& half_edges) {
  const double scale = scale_of(mesh.points);
  double length = 0;
  for (Index h = 0; h < half_edges.twin.size(); ++h) {
    if (half_edges.twin[h] != kNoIndex) continue;
    const Point2 p = scaled(mesh.points[origin(mesh.triangles, h)], scale);
    const Point2 q = scaled(mesh.points[target(mesh.triangles, h)], scale);
    length += std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
  }
  return length / scale;
}

}  // namespace

TriangleShape triangle_shape(Point2 a, Point2 b, Point2 c) {
  const std::array<Point2, 3> corners{a, b, c};
  const double scale = scale_of(corners);
  const TriangleFigures f(scaled(a, scale), scaled(b, scale), scaled(c, scale));
  TriangleShape shape;
  shape.min_angle = arccotangent_deg(f.cotangent(f.max_product));
  shape.max_angle = arccotangent_deg(f.cotangent(f.min_product));
  shape.aspect_ratio = f.containing_radius() * f.inverse_inradius();
  shape.circumradius_to_inradius = f.circumradius() * f.inverse_inradius();
  shape.radius_edge = std::sqrt(f.radius_edge_sq());
  shape.edge_to_height = f.edge_to_height();
  shape.area = f.twice_area / 2 / scale / scale;
  shape.shortest_edge = std::sqrt(f.short_sq) / scale;
  shape.longest_edge = std::sqrt(f.long_sq) / scale;
  return shape;
}

std::optional<double> shape_value(const TriangleShape& shape, std::string_view name) {
  const std::pair<std::string_view, double> values[] = {
      {"min_angle", shape.min_angle},
      {"max_angle", shape.max_angle},
      {"aspect_ratio", shape.aspect_ratio},
      {"circumradius_to_inradius", shape.circumradius_to_inradius},
      {"radius_edge", shape.radius_edge},
      {"edge_to_height", shape.edge_to_height},
      {"shortest_edge", shape.shortest_edge},
      {"longest_edge", shape.longest_edge}};
  for (const auto& [key, value] : values)
    if (key == name) return value;
  return std::nullopt;
}

void audit_shape(const TriangleMesh& mesh, const HalfEdges& half_edges, Report& report) {
  Shapes(mesh).report_to(report);
  report.add_measure("perimeter", boundary_length(mesh, half_edges));
}

}  // namespace wellspaced::audit
