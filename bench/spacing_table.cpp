// The coarsening function in the graph metric beside a Dijkstra with a lazy std::priority_queue on
// the same graph, numbered along a Hilbert curve, all nodes seeded: CPU time as a ratio, from
// interleaved runs in one process. Both give the same bits, which is checked outside the clock.
//
//   spacing_table [NODES] [RUNS]      default 1000000 3
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/point_order.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::bench {
namespace {

// grading: the exponent that pulls uniform points into a corner.
std::vector<Point2> points_along_curve(std::size_t n, int grading) {
  Random random(1);
  const auto coordinate = [&] {
    const double u = random.uniform();
    double x = u;
    for (int i = 1; i < grading; ++i) x *= u;
    return x;
  };
  std::vector<Point2> points(n), ordered;
  for (Point2& p : points) p = {coordinate(), coordinate()};
  for (const Index i : hilbert_order(points)) ordered.push_back(points[i]);
  return ordered;
}

Graph delaunay_graph(const std::vector<Point2>& points) {
  const auto delaunay = Delaunay2::build(points);
  const Triangulation2& topology = delaunay->topology();
  TriangleMesh mesh{points, {}, {}, {}, {}};
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) mesh.triangles.push_back(topology.vertices(t));
  return mesh_graph(mesh);
}

// As a textbook has it: entries that a shorter path outdates stay in the queue and are skipped.
std::vector<double> lazy_dijkstra(const Graph& graph, std::vector<double> distance) {
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index v = 0; v < graph.nodes(); ++v) queue.push({distance[v], v});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d != distance[v]) continue;
    for (const auto& [w, length] : graph.arcs_of(v)) {
      if (!(d + length < distance[w])) continue;
      distance[w] = d + length;
      queue.push({distance[w], w});
    }
  }
  return distance;
}

void print_row(const char* name, const std::vector<Point2>& points, const Graph& graph,
               double factor, int runs) {
  const std::vector<double> g = mesh_spacing(graph);
  std::vector<double> ours, peer, euclidean, f, expected;
  for (int run = 0; run < runs; ++run) {
    ours.push_back(timed([&] { f = coarsened_spacing(graph, g, factor); }));
    peer.push_back(timed([&] { expected = lazy_dijkstra(graph, scaled(g, factor)); }));
    if (f != expected) std::exit(1);
    euclidean.push_back(timed([&] { euclidean_coarsened_spacing(points, g, factor); }));
  }
  std::printf("%-10s %9zu %10zu %7g %11.3f %11.3f\n", name, points.size(), graph.arcs.size() / 2,
              factor, median(ours) / median(peer), median(euclidean) / median(peer));
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced::bench;
  const std::size_t nodes = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 3;
  std::printf("%-10s %9s %10s %7s %11s %11s\n", "spacing", "nodes", "edges", "factor", "graph/lazy",
              "cones/lazy");
  for (const auto& [name, grading] : {std::pair{"uniform", 1}, std::pair{"graded", 6}}) {
    const std::vector<wellspaced::Point2> points = points_along_curve(nodes, grading);
    const wellspaced::Graph graph = delaunay_graph(points);
    for (const double factor : {2., 50.}) print_row(name, points, graph, factor, runs);
  }
}
