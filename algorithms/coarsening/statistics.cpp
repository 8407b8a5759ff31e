#include "wellspaced/algorithms/coarsening/statistics.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "wellspaced/algorithms/audit/intersection.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Angles by their cotangents. Comparisons with NaN are false, so corners without angle drop out.
struct AngleRange {
  double largest_cotangent = -kInfinity, smallest_cotangent = kInfinity;
  std::size_t le_10 = 0;
  bool empty = true;

  void add(double cotangent) {
    largest_cotangent = std::max(largest_cotangent, cotangent);
    smallest_cotangent = std::min(smallest_cotangent, cotangent);
    le_10 += cotangent >= kCotangentOf10Degrees;
    empty = false;
  }
  std::optional<double> smallest_deg() const {
    if (empty) return std::nullopt;
    return arccotangent_deg(largest_cotangent);
  }
};

std::vector<bool> boundary_nodes(const TriangleMesh& mesh) {
  std::vector<bool> on_boundary(mesh.points.size());
  for (const Segment& s : mesh.segments) on_boundary[s.a] = on_boundary[s.b] = true;
  return on_boundary;
}

std::optional<double> largest_deg(const AngleRange& one, const AngleRange& other) {
  if (one.empty && other.empty) return std::nullopt;
  return arccotangent_deg(std::min(one.smallest_cotangent, other.smallest_cotangent));
}

std::optional<MeanAndMax> intersection_of(const Level& level, const Level& finer,
                                          ProgressParts& progress, std::size_t number) {
  if (level.mesh.triangles.empty() || finer.mesh.triangles.empty()) return std::nullopt;
  const auto counts =
      audit::count_intersections(finer.mesh, level.mesh, level.parent, progress.part(number));
  if (progress.stopped()) return std::nullopt;
  return MeanAndMax{counts.mean_per_coarse(), counts.max_per_coarse()};
}

std::optional<MeanAndMax> mean_over(std::size_t divisor, const SearchCount& count) {
  if (count.searches == 0) return std::nullopt;
  return MeanAndMax{static_cast<double>(count.total) / static_cast<double>(divisor), count.max};
}

void add_work(const CoarseningWork& work, LevelStatistics& statistics) {
  statistics.search = mean_over(statistics.nodes, work.selection);
  statistics.edge_search = mean_over(work.edge_protection.searches, work.edge_protection);
  if (statistics.search)  // only the function-based method has paths
    statistics.path_depth = MeanAndMax{work.path_depth_mean, work.path_depth_max};
}

}  // namespace

AngleStatistics angle_statistics(const TriangleMesh& mesh) {
  const std::vector<bool> on_boundary = boundary_nodes(mesh);
  AngleRange interior, boundary;
  for (const auto& [a, b, c] : mesh.triangles) {
    AngleRange& range = on_boundary[a] || on_boundary[b] || on_boundary[c] ? boundary : interior;
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    range.add(corner_cotangent(p, q, r));
    range.add(corner_cotangent(q, r, p));
    range.add(corner_cotangent(r, p, q));
  }
  return {interior.smallest_deg(), boundary.smallest_deg(), largest_deg(interior, boundary),
          interior.le_10, boundary.le_10};
}

std::optional<double> gradation(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return std::nullopt;
  double shortest_sq = kInfinity, longest_sq = 0;
  for (const auto& triangle : mesh.triangles)
    for (unsigned i = 0; i < 3; ++i) {
      const Point2 p = mesh.points[triangle[i]], q = mesh.points[triangle[(i + 1) % 3]];
      const double length_sq = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
      shortest_sq = std::min(shortest_sq, length_sq);
      longest_sq = std::max(longest_sq, length_sq);
    }
  return 0.5 * binary_logarithm(longest_sq / shortest_sq);
}

LevelStatistics mesh_statistics(const TriangleMesh& mesh) {
  LevelStatistics result;
  result.nodes = mesh.points.size();
  result.triangles = mesh.triangles.size();
  result.boundary_edges = mesh.segments.size();
  result.angles = angle_statistics(mesh);
  result.gradation = gradation(mesh);
  return result;
}

std::vector<LevelStatistics> hierarchy_statistics(const Hierarchy& hierarchy,
                                                  const Progress& progress) {
  std::vector<LevelStatistics> rows;
  ProgressParts parts(progress, "measure", hierarchy.levels.size());
  for (const Level& level : hierarchy.levels) {
    LevelStatistics row = mesh_statistics(level.mesh);
    const std::size_t k = rows.size();
    if (parts.go_on(k) && k > 0)
      row.intersection = intersection_of(level, hierarchy.levels[k - 1], parts, k);
    if (level.work) add_work(*level.work, row);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace wellspaced
