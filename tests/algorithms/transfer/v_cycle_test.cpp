// A plain multigrid cycle on the hierarchies: what people with a solver make of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "tests/support/data_files.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/algorithms/transfer/galerkin.hpp"
#include "wellspaced/algorithms/transfer/transfer.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using Vector = std::vector<double>;
using Row = std::map<Index, double>;
using Matrix = std::vector<Row>;

// The stiffness matrix of the Laplacian with linear elements; the rows and columns of boundary
// nodes are those of the identity.
Matrix laplacian(const TriangleMesh& mesh) {
  Matrix a(mesh.points.size());
  for (const auto& triangle : mesh.triangles) {
    Point2 side[3];  // side[i]: the one opposite corner i
    for (unsigned i = 0; i < 3; ++i) {
      const Point2 p = mesh.points[triangle[(i + 1) % 3]], q = mesh.points[triangle[(i + 2) % 3]];
      side[i] = {q.x - p.x, q.y - p.y};
    }
    const double twice_area = side[0].x * side[1].y - side[0].y * side[1].x;
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        a[triangle[i]][triangle[j]] +=
            (side[i].x * side[j].x + side[i].y * side[j].y) / (2 * twice_area);
  }
  std::vector<bool> fixed(a.size());
  for (const Segment& s : mesh.segments) fixed[s.a] = fixed[s.b] = true;
  for (Index i = 0; i < a.size(); ++i) {
    if (fixed[i]) a[i] = {{i, 1.0}};
    std::erase_if(a[i], [&](const auto& entry) { return entry.first != i && fixed[entry.first]; });
  }
  return a;
}

// P with the rows of Dirichlet nodes empty, and no column for coarse ones: their error is 0.
Matrix interpolation(const Transfer& transfer, const Level& finer, const Level& coarser) {
  std::vector<bool> fine_fixed(finer.mesh.points.size()), coarse_fixed(coarser.mesh.points.size());
  for (const Segment& s : finer.mesh.segments) fine_fixed[s.a] = fine_fixed[s.b] = true;
  for (Index v = 0; v < coarse_fixed.size(); ++v) coarse_fixed[v] = fine_fixed[coarser.parent[v]];
  Matrix p(fine_fixed.size());
  const SparseMatrix& matrix = transfer.prolongation;
  for (Index i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; !fine_fixed[i] && k < matrix.row(i).size(); ++k)
      if (!coarse_fixed[matrix.row(i)[k]]) p[i][matrix.row(i)[k]] = matrix.row_values(i)[k];
  return p;
}

// P^T A P; 1 on the diagonal of what it does not reach.
Matrix galerkin(const Matrix& a, const Matrix& p, std::size_t columns) {
  Matrix result(columns);
  for (Index i = 0; i < a.size(); ++i) {
    Row ap;
    for (const auto& [k, value] : a[i])
      for (const auto& [j, weight] : p[k]) ap[j] += value * weight;
    for (const auto& [j, weight] : p[i])
      for (const auto& [k, value] : ap) result[j][k] += weight * value;
  }
  for (Index j = 0; j < columns; ++j)
    if (result[j].empty()) result[j][j] = 1;
  return result;
}

void smooth(const Matrix& a, const Vector& b, Vector& x, bool backwards) {
  const auto relax = [&](Index i) {
    double sum = b[i], diagonal = 1;
    for (const auto& [j, value] : a[i]) j == i ? void(diagonal = value) : void(sum -= value * x[j]);
    x[i] = sum / diagonal;
  };
  for (Index i = 0; i < a.size(); ++i) relax(backwards ? static_cast<Index>(a.size()) - 1 - i : i);
}

struct Multigrid {
  std::vector<Matrix> operators, interpolations;

  explicit Multigrid(const Hierarchy& hierarchy) {
    operators.push_back(laplacian(hierarchy.levels[0].mesh));
    const auto transfers = transfers_of(hierarchy).value();
    for (std::size_t k = 0; k < transfers.size(); ++k) {
      const Level &finer = hierarchy.levels[k], &coarser = hierarchy.levels[k + 1];
      interpolations.push_back(interpolation(transfers[k], finer, coarser));
      operators.push_back(
          galerkin(operators.back(), interpolations.back(), coarser.mesh.points.size()));
    }
  }

  void cycle(std::size_t level, const Vector& b, Vector& x) const {
    const Matrix& a = operators[level];
    if (level + 1 == operators.size()) {
      for (int sweep = 0; sweep < 300; ++sweep) smooth(a, b, x, sweep % 2 == 1);
      return;
    }
    smooth(a, b, x, false);
    const Matrix& p = interpolations[level];
    Vector coarse_b(operators[level + 1].size()), coarse_x(coarse_b.size());
    for (Index i = 0; i < a.size(); ++i) {
      double residual = b[i];
      for (const auto& [j, value] : a[i]) residual -= value * x[j];
      for (const auto& [j, weight] : p[i]) coarse_b[j] += weight * residual;
    }
    cycle(level + 1, coarse_b, coarse_x);
    for (Index i = 0; i < a.size(); ++i)
      for (const auto& [j, weight] : p[i]) x[i] += weight * coarse_x[j];
    smooth(a, b, x, true);
  }

  double energy(const Vector& x) const {
    double sum = 0;
    for (Index i = 0; i < x.size(); ++i)
      for (const auto& [j, value] : operators[0][i]) sum += x[i] * value * x[j];
    return std::sqrt(sum);
  }
};

// By what a cycle shrinks the energy of the error of A x = 0 in the end.
double contraction(const Multigrid& multigrid) {
  const std::size_t n = multigrid.operators[0].size();
  Vector x(n);
  const Vector zero(n);
  Random random(1);
  for (double& value : x) value = random.uniform() - 0.5;
  double before = multigrid.energy(x), factor = 1;
  for (int i = 0; i < 12; ++i) {
    multigrid.cycle(0, zero, x);
    const double after = multigrid.energy(x);
    factor = after / before;
    before = after;
  }
  return factor;
}

// The bounds that a hierarchy has to keep.
struct Bounds {
  double grid_complexity = 1.5, operator_complexity = 2;
};

void expect_good_hierarchy(const std::string& name, const TriangleMesh& mesh, Bounds bounds) {
  const Hierarchy hierarchy = coarsen(mesh, multigrid_profile()).value();
  double nodes = 0;
  std::size_t intersection = 0;
  const auto statistics = hierarchy_statistics(hierarchy);
  for (const LevelStatistics& row : statistics) {
    nodes += static_cast<double>(row.nodes);
    if (row.intersection) intersection = std::max(intersection, row.intersection->max);
  }
  const double grid_complexity = nodes / static_cast<double>(statistics[0].nodes);
  const auto sizes = operator_sizes(hierarchy.levels[0].mesh, transfers_of(hierarchy).value());
  const double factor = contraction(Multigrid(hierarchy));
  std::printf("%-24s levels %zu, last %zu, grid %.2f, operator %.2f, intersection %zu, V %.3f\n",
              name.c_str(), statistics.size(), statistics.back().nodes, grid_complexity,
              operator_complexity(sizes), intersection, factor);
  EXPECT_LE(grid_complexity, bounds.grid_complexity);
  EXPECT_LE(operator_complexity(sizes), bounds.operator_complexity);
  EXPECT_LE(intersection, 30u);
  EXPECT_LE(factor, 0.5);
}

void expect_good_hierarchy(const std::string& file) {
  const auto mesh = test::data_mesh(file);
  if (!mesh) GTEST_SKIP() << "no " << test::data_path(file);
  expect_good_hierarchy(file, *mesh, {});
}

TEST(VCycle, ConvergesOnAirfoil1) { expect_good_hierarchy("thesis/airfoil1"); }
TEST(VCycle, ConvergesOnAirfoil3) { expect_good_hierarchy("thesis/airfoil3_original"); }
TEST(VCycle, ConvergesOnCrack) { expect_good_hierarchy("thesis/crack_float32"); }
TEST(VCycle, ConvergesOnNaca0012) { expect_good_hierarchy("graded/su2_naca0012_inv"); }
TEST(VCycle, ConvergesOnTheNorthSea) { expect_good_hierarchy("graded/thetis_north_sea_demo"); }

TEST(VCycle, ConvergesOnASquareGrid) {
  expect_good_hierarchy("GRID(1)", generate_grid({.nx = 100, .ny = 100}).value(), {});
}

TEST(VCycle, ConvergesOnAStretchedGrid) {
  expect_good_hierarchy("GRID(10)", generate_grid({.nx = 100, .ny = 100, .aspect = 10}).value(),
                        {.grid_complexity = 2.2, .operator_complexity = 3});
}

}  // namespace
}  // namespace wellspaced
