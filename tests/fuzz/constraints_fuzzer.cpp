// Any segments are split into a valid triangulation, or refused with ids; with every hole rule.
#include "tests/fuzz/bytes.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"

using namespace wellspaced;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  Pslg graph;
  TriangulateOptions options;
  options.holes = static_cast<HoleRule>(bytes.byte() % 4);
  options.crossings = static_cast<CrossingRule>(bytes.byte() % 2);
  graph.points = bytes.points(40);
  if (graph.points.empty()) return 0;
  const auto any = [&] { return static_cast<Index>(bytes.byte() % graph.points.size()); };
  for (int n = bytes.byte() % 40; n > 0; --n) {
    const Index a = any();
    graph.segments.push_back({a, any(), bytes.byte() % 3});
  }
  graph.holes = bytes.points(3);
  const Result<PlanarTriangulation> result = triangulate(graph, options);
  if (!result.ok()) {
    require(result.error().code == ErrorCode::kInvalidGeometry);
    require(!result.error().ids.empty());
    return 0;
  }
  const Delaunay2& dt = result->delaunay;
  require(dt.is_valid());
  require(dt.points().size() == graph.points.size() + result->added_points);
  if (dt.dimension() < 2) return 0;
  for (const Segment& s : result->segments) {
    const Delaunay2::Edge e = dt.find_edge(s.a, s.b);
    require(e.triangle != kNoIndex && dt.topology().is_constrained(e));
  }
  return 0;
}
