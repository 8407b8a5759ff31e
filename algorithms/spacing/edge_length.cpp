#include "wellspaced/algorithms/spacing/edge_length.hpp"

#include <algorithm>

#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

double longest_edge(const TriangleMesh& mesh, Index triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
  return std::max({distance(p, q), distance(q, r), distance(r, p)});
}

}  // namespace

std::vector<double> edge_length_spacing(const TriangleMesh& mesh) {
  std::vector<double> values(mesh.points.size(), 0);
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (const Index v : mesh.triangles[t]) values[v] = std::max(values[v], longest_edge(mesh, t));
  return values;
}

EdgeLengthFunction::EdgeLengthFunction(const TriangleMesh& mesh)
    : mesh_(mesh), locator_(mesh.points, mesh.triangles) {}

double EdgeLengthFunction::operator()(Point2 x) const {
  double longest = 0;
  for (const Index t : locator_.triangles_at(x))
    longest = std::max(longest, longest_edge(mesh_, t));
  return longest;
}

}  // namespace wellspaced
