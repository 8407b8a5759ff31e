// METIS and Chaco: X.graph with the coordinates of its vertices in X.xyz or X.coords.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A graph without coordinates: each edge once, from its lower vertex, ascending.
struct MetisGraph {
  Index vertices = 0;
  std::vector<Segment> edges;
};

/// Reads a .graph text; weights are passed over. An empty line is a vertex without edges.
/// Errors: kUnreadable for malformed text, loops, repeated edges, edges that only one end lists and
/// a wrong count of edges; kInvalidGeometry for a vertex out of range.
/// Cost: O(n log n).
Result<MetisGraph> parse_metis_graph(std::string_view text, const TextSource& source);

/// Reads X.graph and the coordinates beside it: the edges become segments.
/// Errors: also kUnreadable where the coordinates are missing or are not as many as the vertices.
Result<Geometry> read_metis(const std::string& path, std::uint64_t largest = kLargestInput,
                            const Progress& progress = {});

/// Writes X.graph, the graph of nodes and edges of the mesh or domain, and X.xyz.
/// Errors: kUsage for the standard output, which takes one file.
Status write_metis(OutputSet& outputs, const std::string& path, const Geometry& geometry);

}  // namespace wellspaced
