#include "wellspaced/algorithms/generate/mis_degradation.hpp"

#include <numeric>
#include <vector>

#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr unsigned kMostLevels = 8;
constexpr double kShear = 0x1p-20;

Index power(Index base, unsigned exponent) {
  Index result = 1;
  while (exponent-- > 0) result *= base;
  return result;
}

// How many steps of the pattern the node in that column and row outlives.
unsigned levels_outlived(Index column, Index row, unsigned levels) {
  unsigned level = 0;
  while (level < levels && column % 2 == 0 && row % 3 == 0) {
    column /= 2;
    row /= 3;
    ++level;
  }
  return level;
}

}  // namespace

Result<TriangleMesh> generate_mis_degradation(unsigned levels) {
  if (levels < 1 || levels > kMostLevels)
    return Error{ErrorCode::kUsage, "the pattern has 1 to 8 levels", {}};
  const Index columns = power(2, levels) + 1, rows = power(3, levels) + 1;
  std::vector<Index> order(std::size_t{columns} * rows), number(order.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto outlived = [=](Index place) {
    return levels_outlived(place % columns, place / columns, levels);
  };
  sort(order, [&](Index p, Index q) { return outlived(p) > outlived(q); });

  TriangleMesh mesh;
  for (Index v = 0; v < order.size(); ++v) {
    const double x = order[v] % columns, y = order[v] / columns;
    mesh.points.push_back({x - kShear * y, y});
    number[order[v]] = v;
  }
  for (Index y = 0; y + 1 < rows; ++y) {
    for (Index x = 0; x + 1 < columns; ++x) {
      const Index lower = y * columns + x, upper = lower + columns;
      const Index a = number[lower], b = number[lower + 1], c = number[upper + 1],
                  d = number[upper];
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

}  // namespace wellspaced
