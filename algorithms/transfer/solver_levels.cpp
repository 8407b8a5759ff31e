#include "wellspaced/algorithms/transfer/solver_levels.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/algorithms/audit/intersection.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/kernel/corner_table.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

Point2 times(double scale, Point2 p) { return {scale * p.x, scale * p.y}; }

// Of a mesh, scaled, so that neither overflows nor vanishes.
double mesh_area(const TriangleMesh& mesh, double scale) {
  double twice = 0;
  for (const auto& t : mesh.triangles) {
    const Point2 p = times(scale, mesh.points[t[0]]), q = times(scale, mesh.points[t[1]]),
                 r = times(scale, mesh.points[t[2]]);
    twice += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return twice / 2;
}

double mesh_perimeter(const TriangleMesh& mesh, double scale) {
  double sum = 0;
  const auto nodes = static_cast<Index>(mesh.points.size());
  for (const auto& [a, b] : boundary_edges(corner_table(mesh.triangles, nodes)))
    sum += distance(times(scale, mesh.points[a]), times(scale, mesh.points[b]));
  return sum;
}

double part_of(double part, double whole) { return whole > 0 ? part / whole : 1; }

void describe_step(const Level& finer, const Level& coarser, const Transfer& transfer,
                   const Progress& progress, SolverLevel& level) {
  level.nodes_dropped = finer.mesh.points.size() - coarser.mesh.points.size();
  level.nodes_displaced = transfer.displaced.size();
  for (const DisplacedNode& node : transfer.displaced)
    level.displacement_max = std::max(level.displacement_max, node.distance);
  if (!finer.mesh.triangles.empty() && !coarser.mesh.triangles.empty())
    level.intersection_max =
        audit::count_intersections(finer.mesh, coarser.mesh, coarser.parent, progress)
            .max_per_coarse();
}

}  // namespace

Result<SolverHierarchy> prepare_for_solver(const Hierarchy& hierarchy, const Progress& progress) {
  auto transfers = transfers_of(hierarchy, progress);
  if (!transfers) return transfers.error();
  SolverHierarchy solver;
  solver.transfers = std::move(*transfers);
  const std::size_t levels = hierarchy.levels.size();
  ProgressParts parts(progress, "measure", levels);
  if (!parts.go_on(0)) return cancelled();
  const TriangleMesh& finest = hierarchy.levels[0].mesh;
  const std::vector<OperatorSize> sizes = operator_sizes(finest, solver.transfers, parts.part(0));
  if (parts.stopped()) return cancelled();
  const double scale = audit::scale_of(finest.points);
  const double area = mesh_area(finest, scale), perimeter = mesh_perimeter(finest, scale);
  double nodes = 0;
  for (std::size_t k = 0; k < levels; ++k) {
    const Level& level = hierarchy.levels[k];
    SolverLevel row;
    row.galerkin = sizes[k];
    row.area_kept = part_of(mesh_area(level.mesh, scale), area);
    row.perimeter_kept = part_of(mesh_perimeter(level.mesh, scale), perimeter);
    if (k > 0)
      describe_step(hierarchy.levels[k - 1], level, solver.transfers[k - 1], parts.part(k), row);
    if (!parts.go_on(k + 1)) return cancelled();
    solver.levels.push_back(row);
    nodes += static_cast<double>(level.mesh.points.size());
  }
  solver.grid_complexity = part_of(nodes, static_cast<double>(finest.points.size()));
  solver.operator_complexity = operator_complexity(sizes);
  return solver;
}

}  // namespace wellspaced
