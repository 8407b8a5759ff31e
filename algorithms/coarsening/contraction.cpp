#include "wellspaced/algorithms/coarsening/contraction.hpp"

namespace wellspaced {
namespace {

std::vector<std::size_t> surviving_positions(const BoundaryCurve& curve,
                                             std::span<const std::uint8_t> survives) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < curve.nodes.size(); ++i)
    if (survives[curve.nodes[i]]) positions.push_back(i);
  if (curve.closed && !positions.empty())
    positions.push_back(positions.front() + curve.nodes.size());
  return positions;
}

}  // namespace

std::vector<ContractedEdge> contract_boundary(const Boundary& boundary,
                                              std::span<const Point2> points,
                                              std::span<const std::uint8_t> survives) {
  std::vector<ContractedEdge> edges;
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const BoundaryCurve& curve = boundary.curves[c];
    const std::vector<std::size_t> positions = surviving_positions(curve, survives);
    for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
      const std::size_t begin = positions[i], end = positions[i + 1];
      const Index a = curve.node(begin), b = curve.node(end);
      if (points[a] == points[b]) continue;
      edges.push_back({a, b, curve.markers[begin], c, begin, end - begin});
    }
  }
  return edges;
}

std::vector<ConstrainedEdge> constrained_edges(const Boundary& boundary,
                                               std::span<const ContractedEdge> edges,
                                               std::span<const Index> number) {
  std::vector<ConstrainedEdge> result;
  for (const ContractedEdge& edge : edges) {
    const bool is_domain = boundary.curves[edge.curve].kind == BoundaryCurve::Kind::kDomain;
    result.push_back({number[edge.a], number[edge.b], edge.marker,
                      is_domain ? ConstrainedEdge::Kind::kDomain : ConstrainedEdge::Kind::kInner});
  }
  return result;
}

std::vector<Point2> chain_points(const Boundary& boundary, std::span<const Point2> points,
                                 const ContractedEdge& edge) {
  std::vector<Point2> chain;
  for (std::size_t i = 0; i <= edge.steps; ++i)
    chain.push_back(points[boundary.curves[edge.curve].node(edge.begin + i)]);
  return chain;
}

Index middle_node(const Boundary& boundary, const ContractedEdge& edge) {
  return boundary.curves[edge.curve].node(edge.begin + edge.steps / 2);
}

}  // namespace wellspaced
