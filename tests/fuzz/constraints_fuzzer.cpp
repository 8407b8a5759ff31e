// Any segments are split into a valid triangulation that connects their ends, or refused with ids;
// with every hole rule, also for points hardly off a line.
#include "tests/fuzz/bytes.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"

using namespace wellspaced;
using fuzz::require;

namespace {

// Whether constrained edges lead from a to b.
bool are_connected(const PlanarTriangulation& result, Index a, Index b) {
  std::vector<std::uint8_t> reached(result.delaunay.points().size());
  reached[a] = 1;
  for (bool grows = true; grows && !reached[b];) {
    grows = false;
    for (const Segment& s : result.segments) {
      grows |= reached[s.a] != reached[s.b];
      reached[s.a] = reached[s.b] = reached[s.a] | reached[s.b];
    }
  }
  return reached[b] != 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  Pslg graph;
  TriangulateOptions options;
  options.holes = static_cast<HoleRule>(bytes.byte() % 4);
  const std::uint8_t kind = bytes.byte();
  options.crossings = static_cast<CrossingRule>(kind % 2);
  graph.points = bytes.points(40);
  if (kind % 4 == 2)
    for (Point2& p : graph.points) p.y = p.x / 3 + (p.y == 0 ? 0 : 1);
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
  for (const Segment& s : graph.segments)
    require(are_connected(*result, dt.representative(s.a), dt.representative(s.b)));
  return 0;
}
