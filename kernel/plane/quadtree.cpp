#include "wellspaced/kernel/plane/quadtree.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "wellspaced/kernel/radix_sort.hpp"

namespace wellspaced {
namespace {

// The boxes that are split, by depth; the deepest cells are not.
using SplitBoxes = std::array<std::vector<MortonCode>, kMortonDepth>;

void sort_unique_codes(std::vector<MortonCode>& codes) {
  std::vector<KeyedItem> items(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) items[i].key = codes[i];
  radix_sort(items);
  codes.clear();
  for (const KeyedItem& item : items)
    if (codes.empty() || codes.back() != item.key) codes.push_back(item.key);
}

// Which quarters of a box are split, as bits.
using Quarters = unsigned;
constexpr Quarters kWest = 0b0101, kEast = 0b1010, kSouth = 0b0011, kNorth = 0b1100;

// The boxes of one depth that must be split because some quarters of `box`, one of them, are: the
// box itself, and those that would be too large beside these quarters.
class RequiredSplits {
 public:
  RequiredSplits(int depth, QuadtreeBalance balance, std::vector<MortonCode>& required)
      : last_((std::uint32_t{1} << depth) - 1), balance_(balance), required_(required) {}

  void add(MortonCode box, Quarters quarters) {
    required_.push_back(box);
    const int west = morton::column(box) > 0 ? -1 : 0, east = morton::column(box) < last_ ? 1 : 0;
    const int south = morton::row(box) > 0 ? -1 : 0, north = morton::row(box) < last_ ? 1 : 0;
    if (quarters & kWest) add_beside(box, west, 0);
    if (quarters & kEast) add_beside(box, east, 0);
    if (quarters & kSouth) add_beside(box, 0, south);
    if (quarters & kNorth) add_beside(box, 0, north);
    if (balance_ == QuadtreeBalance::kEdge) return;
    if (quarters & kSouth & kWest) add_beside(box, west, south);
    if (quarters & kSouth & kEast) add_beside(box, east, south);
    if (quarters & kNorth & kWest) add_beside(box, west, north);
    if (quarters & kNorth & kEast) add_beside(box, east, north);
  }

 private:
  void add_beside(MortonCode box, int columns, int rows) {
    if (columns != 0 || rows != 0)
      required_.push_back(morton::step_row(morton::step_column(box, columns), rows));
  }

  std::uint32_t last_;
  QuadtreeBalance balance_;
  std::vector<MortonCode>& required_;
};

// Adds what the split boxes require of those of the depth above, from the bottom up.
void close_splits(SplitBoxes& splits, QuadtreeBalance balance) {
  for (int depth = kMortonDepth - 1; depth > 0; --depth) {
    sort_unique_codes(splits[depth]);
    RequiredSplits required(depth - 1, balance, splits[depth - 1]);
    const std::vector<MortonCode>& boxes = splits[depth];
    for (std::size_t i = 0; i < boxes.size();) {
      const MortonCode parent = boxes[i] >> 2;
      Quarters quarters = 0;
      for (; i < boxes.size() && boxes[i] >> 2 == parent; ++i) quarters |= 1u << (boxes[i] & 3);
      required.add(parent, quarters);
    }
  }
  sort_unique_codes(splits[0]);
}

// Along the Z curve: at every place the split boxes that start there, then the leaf.
std::vector<MortonCode> leaf_starts(const SplitBoxes& splits) {
  std::array<std::size_t, kMortonDepth> next{};
  std::vector<MortonCode> starts;
  for (MortonCode at = 0; at < morton::cells_in(0);) {
    int depth = morton::coarsest_depth(at);
    const auto is_split = [&] {
      return depth < kMortonDepth && next[depth] < splits[depth].size() &&
             splits[depth][next[depth]] == morton::ancestor(at, depth);
    };
    for (; is_split(); ++depth) ++next[depth];
    starts.push_back(at);
    at += morton::cells_in(depth);
  }
  return starts;
}

Quadtree balanced_quadtree(const Square& square, SplitBoxes splits, QuadtreeBalance balance) {
  close_splits(splits, balance);
  return Quadtree(square, leaf_starts(splits));
}

std::uint32_t deepest_cell(double offset) {
  constexpr double kCells = 0x1p31;
  return static_cast<std::uint32_t>(std::clamp((offset + 1) * (kCells / 2), 0.0, kCells - 1));
}

// Where a fraction of the deepest cells' count lies in a square: -1 .. 1.
double offset_of(double cells) { return cells * 0x1p-30 - 1; }

Point2 point_at(const Square& square, double columns, double rows) {
  return {square.centre.x + square.half_side * offset_of(columns),
          square.centre.y + square.half_side * offset_of(rows)};
}

Box2 box_of(const Square& square, MortonCode start, int depth) {
  const double low_x = morton::column(start), low_y = morton::row(start);
  const double cells = std::ldexp(1.0, kMortonDepth - depth);
  return {point_at(square, low_x, low_y), point_at(square, low_x + cells, low_y + cells)};
}

}  // namespace

Square Square::around(std::span<const Point2> points) {
  if (points.empty()) return {};
  const Box2 box = Box2::around(points);
  const double half_side = std::max(box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2);
  const Point2 centre{box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2};
  if (half_side > 0) return {centre, half_side};
  return {centre, box.low == box.high ? 1 : std::numeric_limits<double>::denorm_min()};
}

MortonCode Square::cell_of(Point2 p) const {
  return morton::encode(deepest_cell((p.x - centre.x) / half_side),
                        deepest_cell((p.y - centre.y) / half_side));
}

Quadtree::Quadtree(Square square, std::vector<MortonCode> starts)
    : square_(square), starts_(std::move(starts)) {
  assert(!starts_.empty() && starts_.front() == 0);
  starts_.push_back(morton::cells_in(0));
}

double Quadtree::side_at(int depth) const { return std::ldexp(square_.half_side, 1 - depth); }

Point2 Quadtree::centre(Index leaf) const {
  const double half = std::ldexp(0.5, kMortonDepth - depth(leaf));
  return point_at(square_, morton::column(starts_[leaf]) + half, morton::row(starts_[leaf]) + half);
}

Box2 Quadtree::box(Index leaf) const { return box_of(square_, starts_[leaf], depth(leaf)); }

Index Quadtree::locate(MortonCode cell) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end() - 1, cell);
  return static_cast<Index>(after - starts_.begin() - 1);
}

// A box is split if it holds the first and the last of max_points + 1 cells in sorted order.
Quadtree quadtree_of_points(const Square& square, std::span<const Point2> points,
                            std::size_t max_points, QuadtreeBalance balance) {
  std::vector<MortonCode> cells(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) cells[i] = square.cell_of(points[i]);
  sort_unique_codes(cells);
  SplitBoxes splits;
  for (std::size_t i = 0; i + max_points < cells.size(); ++i) {
    const int depth = morton::common_depth(cells[i], cells[i + max_points]);
    splits[depth].push_back(morton::ancestor(cells[i], depth));
  }
  return balanced_quadtree(square, std::move(splits), balance);
}

Quadtree quadtree_of_sizes(const Square& square, std::span<const Point2> points,
                           std::span<const double> sizes, QuadtreeBalance balance) {
  const Quadtree root(square);
  std::array<double, kMortonDepth> sides;
  for (int depth = 0; depth < kMortonDepth; ++depth) sides[depth] = root.side_at(depth);
  SplitBoxes splits;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto small_enough = std::partition_point(sides.begin(), sides.end(),
                                                   [&](double side) { return side > sizes[i]; });
    if (small_enough == sides.begin()) continue;
    const int depth = static_cast<int>(small_enough - sides.begin()) - 1;
    const MortonCode box = morton::ancestor(square.cell_of(points[i]), depth);
    if (splits[depth].empty() || splits[depth].back() != box) splits[depth].push_back(box);
  }
  return balanced_quadtree(square, std::move(splits), balance);
}

// A leaf of the overlay is a leaf of one tree within one of the other: it starts where either does.
Quadtree overlay(const Quadtree& a, const Quadtree& b) {
  std::vector<MortonCode> starts;
  starts.reserve(std::max(a.leaves(), b.leaves()));
  for (Index i = 0, j = 0; i < a.leaves() || j < b.leaves();) {
    const MortonCode start = std::min(a.start(i), b.start(j));  // past the last: the end of all
    i += a.start(i) == start;
    j += b.start(j) == start;
    starts.push_back(start);
  }
  return Quadtree(a.square(), std::move(starts));
}

Result<Quadtree> quadtree_of_spacing(const Square& square,
                                     const std::function<double(const Box2&)>& least_in,
                                     QuadtreeBalance balance, std::size_t max_leaves) {
  const Quadtree root(square);
  SplitBoxes splits;
  std::vector<MortonCode> boxes{0};
  std::size_t leaves = 1;
  for (int depth = 0; depth < kMortonDepth && !boxes.empty(); ++depth) {
    std::vector<MortonCode> quarters;
    for (const MortonCode box : boxes) {
      const Box2 extent = box_of(square, morton::first_in(box, depth), depth);
      if (!(root.side_at(depth) > least_in(extent))) continue;
      splits[depth].push_back(box);
      for (MortonCode quarter = 0; quarter < 4; ++quarter) quarters.push_back(4 * box + quarter);
      leaves += 3;
      if (leaves > max_leaves)
        return Error{
            ErrorCode::kLimit, "the spacing function asks for more leaves than allowed", {}};
    }
    boxes = std::move(quarters);
  }
  return balanced_quadtree(square, std::move(splits), balance);
}

}  // namespace wellspaced
