#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

bool crosses(Point2 a, Point2 b, Point2 c, Point2 d) {
  return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

// p between a and b, and neither of them.
bool on_open_segment(Point2 p, Point2 a, Point2 b) {
  return p != a && p != b && Box2::around(std::array{a, b}).meets({p, p}) && orient2d(a, b, p) == 0;
}

// How often the polygon winds around p, counter-clockwise. Requires: p is not on the polygon.
int winding_number(std::span<const Point2> polygon, Point2 p) {
  int winding = 0;
  Point2 a = polygon.back();
  for (const Point2 b : polygon) {
    const bool up = a.y <= p.y && p.y < b.y, down = b.y <= p.y && p.y < a.y;
    if (up && orient2d(a, b, p) > 0) ++winding;
    if (down && orient2d(a, b, p) < 0) --winding;
    a = b;
  }
  return winding;
}

double turn_area(Point2 origin, Point2 a, Point2 b) {
  return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

// The signed area of a polygon.
double polygon_area(std::span<const Point2> polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += turn_area(polygon[0], polygon[i], polygon[i + 1]);
  return twice / 2;
}

bool is_straight(std::span<const Point2> chain) {
  return all_of(chain, [&](Point2 p) { return orient2d(chain.front(), chain.back(), p) == 0; });
}

}  // namespace

ContractedBoundary::ContractedBoundary(const Boundary& boundary, std::span<const Point2> points,
                                       std::vector<ContractedEdge> edges)
    : points_(points), edges_(std::move(edges)) {
  std::vector<Box2> edge_boxes, region_boxes;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const ContractedEdge& edge = edges_[i];
    on_domain_curve_.push_back(boundary.curves[edge.curve].kind == BoundaryCurve::Kind::kDomain);
    edge_boxes.push_back(Box2::around(std::array{from(edge), to(edge)}));
    if (edge.steps == 1) continue;
    std::vector<Point2> chain = chain_points(boundary, points_, edge);
    if (is_straight(chain)) continue;
    region_boxes.push_back(Box2::around(chain));
    regions_.push_back({i, std::move(chain)});
  }
  edge_tree_ = BoxTree(std::move(edge_boxes));
  region_tree_ = BoxTree(std::move(region_boxes));
}

std::vector<std::size_t> ContractedBoundary::broken_edges(std::span<const Index> selected) const {
  std::vector<std::uint8_t> broken(edges_.size(), 0);
  mark_crossings(broken);
  mark_met_nodes(selected, broken);
  mark_doubles(broken);
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (broken[i]) list.push_back(i);
  return list;
}

// Only an edge that has moved can cross another.
void ContractedBoundary::mark_crossings(std::vector<std::uint8_t>& broken) const {
  for (const Region& region : regions_) {
    const Point2 a = region.chain.front(), b = region.chain.back();
    edge_tree_.for_each_meeting(Box2::around(std::array{a, b}), [&](std::size_t other) {
      if (!crosses(a, b, from(edges_[other]), to(edges_[other]))) return;
      broken[region.edge] = 1;
      if (edges_[other].steps > 1) broken[other] = 1;
    });
  }
}

void ContractedBoundary::mark_met_nodes(std::span<const Index> selected,
                                        std::vector<std::uint8_t>& broken) const {
  for (const Index v : selected) {
    const Point2 p = points_[v];
    region_tree_.for_each_meeting({p, p}, [&](std::size_t r) {
      const auto& [edge, chain] = regions_[r];
      if (p == chain.front() || p == chain.back()) return;
      if (on_open_segment(p, chain.front(), chain.back()) || winding_number(chain, p) != 0)
        broken[edge] = 1;
    });
  }
}

// Edges on the two lips of a slit join different nodes, though in the same places.
void ContractedBoundary::mark_doubles(std::vector<std::uint8_t>& broken) const {
  const auto ends = [&](std::size_t i) { return std::minmax(edges_[i].a, edges_[i].b); };
  std::vector<std::size_t> order(edges_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sort(order, [&](std::size_t i, std::size_t j) { return ends(i) < ends(j); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (ends(order[k - 1]) != ends(order[k])) continue;
    for (const std::size_t i : {order[k - 1], order[k]})
      if (edges_[i].steps > 1) broken[i] = 1;
  }
}

double ContractedBoundary::area() const {
  double twice = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (on_domain_curve_[i]) twice += turn_area(points_[0], from(edges_[i]), to(edges_[i]));
  return twice / 2;
}

std::vector<std::size_t> ContractedBoundary::edges_that_move_most() const {
  std::vector<double> areas(regions_.size(), 0);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    if (on_domain_curve_[regions_[r].edge]) areas[r] = std::fabs(polygon_area(regions_[r].chain));
  const double largest = areas.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
  std::vector<std::size_t> edges;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    if (areas[r] > 0 && areas[r] >= largest / 2) edges.push_back(regions_[r].edge);
  return edges;
}

bool ContractedBoundary::leaves_outside(Point2 p) const {
  int winding = 1;
  region_tree_.for_each_meeting({p, p}, [&](std::size_t r) {
    const auto& [edge, chain] = regions_[r];
    if (on_open_segment(p, chain.front(), chain.back())) winding = -1000000;
    if (on_domain_curve_[edge]) winding -= winding_number(chain, p);
  });
  return winding <= 0;
}

ContractedBoundary contract_and_repair(const Boundary& boundary, std::span<const Point2> points,
                                       NodeSelection& selection, AreaRange areas,
                                       const NodeSelection::KeepGoing& keep_going) {
  std::vector<std::uint8_t> survives(points.size(), 0);
  while (true) {
    const std::vector<Index> selected = selection.selected();
    for (const Index v : selected) survives[v] = 1;
    ContractedBoundary contracted(boundary, points, contract_boundary(boundary, points, survives));
    std::vector<std::size_t> broken = contracted.broken_edges(selected);
    const double area = contracted.area();
    if (broken.empty() && (area < areas.least || area > areas.most))
      broken = contracted.edges_that_move_most();
    if (broken.empty() || (keep_going && !keep_going())) return contracted;
    for (const std::size_t i : broken)
      selection.force(std::array{middle_node(boundary, contracted.edges()[i])});
  }
}

}  // namespace wellspaced
