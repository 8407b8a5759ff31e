#include "wellspaced/algorithms/generate/grid.hpp"

#include <cmath>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

constexpr std::uint64_t kMaxGridNodes = std::uint64_t{1} << 29;

Status check(const GridOptions& options) {
  if (options.nx < 2 || options.ny < 2)
    return Error{ErrorCode::kUsage, "a grid needs at least 2 nodes in each direction", {}};
  if (!(options.aspect > 0) || !std::isfinite(options.aspect * (options.ny - 1.0)))
    return Error{ErrorCode::kUsage, "the aspect of a grid must be positive, its height finite", {}};
  if (!(options.mixed >= 0 && options.mixed <= 1))
    return Error{ErrorCode::kUsage, "the share of mixed diagonals must lie in [0, 1]", {}};
  if (std::uint64_t{options.nx} * options.ny > kMaxGridNodes)
    return Error{ErrorCode::kLimit, "a grid may have at most 2^29 nodes", {}};
  return Ok{};
}

std::vector<Point2> lattice(const GridOptions& options, ProgressMeter& meter) {
  std::vector<Point2> points;
  points.reserve(std::size_t{options.nx} * options.ny);
  for (Index j = 0; j < options.ny && meter.step(options.nx); ++j)
    for (Index i = 0; i < options.nx; ++i)
      points.push_back({static_cast<double>(i), options.aspect * j});
  return points;
}

// Whether cell (i, j) is cut from its lower right to its upper left corner.
bool is_backslash(Index i, Index j, const GridOptions& options, Random& random) {
  switch (options.diagonals) {
    case GridDiagonals::kSlash:
      return false;
    case GridDiagonals::kAlternating:
      return ((i + j) & 1u) != 0;
    case GridDiagonals::kMixed:
      return random.uniform() < options.mixed;
  }
  return false;
}

std::vector<std::array<Index, 3>> cut_cells(const GridOptions& options, ProgressMeter& meter) {
  Random random(options.seed);
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(2 * std::size_t{options.nx - 1} * (options.ny - 1));
  for (Index j = 0; j + 1 < options.ny && meter.step(options.nx); ++j)
    for (Index i = 0; i + 1 < options.nx; ++i) {
      const Index a = j * options.nx + i, b = a + 1, c = b + options.nx, d = a + options.nx;
      const bool backslash = is_backslash(i, j, options, random);
      triangles.push_back({a, b, backslash ? d : c});
      triangles.push_back({backslash ? b : a, c, d});
    }
  return triangles;
}

// `count` boundary edges from node `first`, each `stride` further (modulo 2^32).
void append_side(std::vector<Segment>& segments, Index first, Index stride, Index count,
                 int marker) {
  for (Index a = first; count > 0; --count, a += stride)
    segments.push_back({a, a + stride, marker});
}

std::vector<Segment> boundary(Index nx, Index ny) {
  std::vector<Segment> segments;
  segments.reserve(2 * (std::size_t{nx} + ny - 2));
  append_side(segments, 0, 1, nx - 1, 1);
  append_side(segments, nx - 1, nx, ny - 1, 2);
  append_side(segments, nx * ny - 1, Index{0} - 1, nx - 1, 3);
  append_side(segments, nx * (ny - 1), Index{0} - nx, ny - 1, 4);
  return segments;
}

}  // namespace

Result<TriangleMesh> generate_grid(const GridOptions& options, const Progress& progress) {
  if (Status valid = check(options); !valid) return valid.error();
  const std::uint64_t nodes = std::uint64_t{options.nx} * options.ny;
  ProgressMeter meter(progress, "generate", 2 * nodes - options.nx);
  TriangleMesh mesh;
  mesh.points = lattice(options, meter);
  mesh.triangles = cut_cells(options, meter);
  if (meter.stopped()) return cancelled();
  mesh.segments = boundary(options.nx, options.ny);
  return mesh;
}

}  // namespace wellspaced
