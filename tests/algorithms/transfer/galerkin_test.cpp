#include "wellspaced/algorithms/transfer/galerkin.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/cancelling.hpp"
#include "tests/support/grid_meshes.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/transfer/solver_levels.hpp"

namespace wellspaced {
namespace {

using Entries = std::set<std::pair<Index, Index>>;

Entries entries_of(const SparsityPattern& pattern) {
  Entries entries;
  for (Index i = 0; i < pattern.rows(); ++i)
    for (const Index j : pattern.row(i)) entries.insert({i, j});
  return entries;
}

// By the definition: entry (I, J) if a_ij is one with P_iI and P_jJ.
Entries slow_product(const SparsityPattern& a, const SparsityPattern& p) {
  Entries product;
  for (const auto& [i, j] : entries_of(a))
    for (const Index row : p.row(i))
      for (const Index column : p.row(j)) product.insert({row, column});
  return product;
}

TEST(Transposed, ExchangesRowsAndColumns) {
  const SparsityPattern a = operator_pattern(test::grid_mesh({.nx = 3, .ny = 2}));
  EXPECT_EQ(entries_of(transposed(a)), entries_of(a)) << "it is symmetric";
  SparsityPattern b;
  b.columns = 4;
  b.column = {3, 0, 3};
  b.first = {0, 1, 1, 3};
  EXPECT_EQ(entries_of(transposed(b)), (Entries{{3, 0}, {0, 2}, {3, 2}}));
  EXPECT_EQ(transposed(b).rows(), 4u);
  EXPECT_EQ(transposed(b).columns, 3u);
}

TEST(GalerkinPattern, IsThatOfTheProduct) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto mesh = test::grid_mesh({.nx = 12, .ny = 12, .hole = 0.05, .seed = seed});
    CoarseningOptions options = multigrid_profile();
    options.until_nodes = 10;
    const Hierarchy deep = coarsen(mesh, options).value();
    ASSERT_GE(deep.levels.size(), 2u);
    SparsityPattern a = operator_pattern(deep.levels[0].mesh);
    const auto transfers = transfers_of(deep).value();
    const auto sizes = operator_sizes(deep.levels[0].mesh, transfers);
    ASSERT_EQ(sizes.size(), deep.levels.size());
    for (std::size_t k = 0; k < transfers.size(); ++k) {
      const Entries expected = slow_product(a, transfers[k].prolongation);
      a = galerkin_pattern(a, transfers[k].prolongation);
      EXPECT_EQ(entries_of(a), expected);
      EXPECT_EQ(sizes[k + 1].entries, expected.size());
    }
  }
}

TEST(PrepareForSolver, CanBeCancelled) {
  const auto mesh = test::grid_mesh({.nx = 12, .ny = 12});
  const Hierarchy deep = coarsen(mesh, {.factor = 2}).value();
  ASSERT_GE(deep.levels.size(), 3u);
  const auto phases = test::phases_that_cancel(
      [&](const Progress& progress) { return prepare_for_solver(deep, progress); });
  EXPECT_EQ(phases, (std::set<std::string>{"measure", "transfer"}));
}

// The perimeter overflowed, and the table said -nan%.
TEST(PrepareForSolver, TellsWhatIsKeptAtAnyScale) {
  const Hierarchy deep = coarsen(test::grid_mesh({.nx = 12, .ny = 12}), {.factor = 2}).value();
  const auto prepared_at = [&](double scale) {
    Hierarchy scaled = deep;
    for (Level& level : scaled.levels)
      for (Point2& p : level.mesh.points) p = {scale * p.x, scale * p.y};
    return prepare_for_solver(scaled).value();
  };
  const auto usual = prepared_at(1);
  ASSERT_GE(usual.levels.size(), 3u);
  EXPECT_NE(usual.levels.back().perimeter_kept, 1);
  for (const double scale : {0x1p1019, 0x1p-900}) {
    const auto solver = prepared_at(scale);
    ASSERT_EQ(solver.levels.size(), usual.levels.size());
    for (std::size_t k = 0; k < usual.levels.size(); ++k) {
      EXPECT_DOUBLE_EQ(solver.levels[k].area_kept, usual.levels[k].area_kept);
      EXPECT_DOUBLE_EQ(solver.levels[k].perimeter_kept, usual.levels[k].perimeter_kept);
    }
  }
}

TEST(OperatorComplexity, IsTheSumByTheFinest) {
  const std::vector<OperatorSize> sizes = {{100, 7, 8}, {40, 9, 12}, {10, 5, 5}};
  EXPECT_DOUBLE_EQ(operator_complexity(sizes), 1.5);
}

}  // namespace
}  // namespace wellspaced
