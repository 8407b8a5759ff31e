// Who shares an edge with whom, with everything that is wrong about the edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The half-edges of a triangle mesh. Half-edge 3t + i runs from corner i of triangle t to its
/// corner i + 1, with the triangle on its left if that is counter-clockwise.
///
/// twin: the half-edge in the opposite direction, where exactly these two lie on the edge; else
///   kNoIndex: a boundary edge, or one that is crowded or disagreeing.
/// constrained: 1 where a segment lies on the edge.
/// segment_edge: for each segment a half-edge that it lies on, kNoIndex if it is no mesh edge.
/// edges: the number of edges.
struct HalfEdges {
  std::vector<Index> twin;
  std::vector<std::uint8_t> constrained;
  std::vector<Index> segment_edge;
  std::uint64_t edges = 0;

  std::vector<Index> crowded_edges;         ///< pairs of nodes: more than two triangles
  std::vector<Index> disagreeing_edges;     ///< pairs of nodes: two triangles, same direction
  std::vector<Index> duplicate_triangles;   ///< triangles with the nodes of an earlier one
  std::vector<Index> duplicate_segments;    ///< segments with the nodes of an earlier one
  std::vector<Index> conflicting_segments;  ///< those of them that have another marker

  // i + 1 and i - 1 modulo 3 looked up two bits a value: a branch would be mispredicted.
  static constexpr Index next(Index h) { return h - h % 3 + (0b00'10'01u >> 2 * (h % 3) & 3); }
  static constexpr Index previous(Index h) { return h - h % 3 + (0b01'00'10u >> 2 * (h % 3) & 3); }

  /// The next half-edge counter-clockwise that leaves the same node, or kNoIndex.
  Index turn_left(Index h) const { return twin[previous(h)]; }
  /// The next one clockwise, or kNoIndex.
  Index turn_right(Index h) const { return twin[h] == kNoIndex ? kNoIndex : next(twin[h]); }

  /// The boundary half-edge that follows boundary half-edge h along the rim of the same fan.
  Index next_on_boundary(Index h) const {
    Index g = next(h);
    while (twin[g] != kNoIndex) g = next(twin[g]);
    return g;
  }
};

/// The nodes that a half-edge leaves and reaches.
inline Index origin(std::span<const std::array<Index, 3>> triangles, Index h) {
  return triangles[h / 3][h % 3];
}
inline Index target(std::span<const std::array<Index, 3>> triangles, Index h) {
  return triangles[h / 3][HalfEdges::next(h % 3)];
}
/// The corner that is not on the half-edge.
inline Index apex(std::span<const std::array<Index, 3>> triangles, Index h) {
  return triangles[h / 3][HalfEdges::previous(h % 3)];
}

/// Pairs up the half-edges of a mesh.
/// Requires: indices in range, three distinct corners in every triangle, two distinct ends in every
/// segment, 3 * triangles + segments < 2^32.
/// Cost: linear for bounded degrees, O(n log n) always; 60 bytes a triangle.
HalfEdges pair_half_edges(std::span<const std::array<Index, 3>> triangles,
                          std::span<const Segment> segments, Index nodes);

/// For each node the number of fans that its triangles form, at most 255; total: over all nodes.
/// Cost: linear.
std::vector<std::uint8_t> count_fans(std::span<const std::array<Index, 3>> triangles,
                                     const HalfEdges& half_edges, std::size_t nodes,
                                     std::uint64_t& total);

/// The number of sets of triangles that hang together by edges. Cost: linear.
std::uint64_t count_components(const HalfEdges& half_edges);

}  // namespace wellspaced::audit
