#include "wellspaced/kernel/point_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// What is sorted: round (4 bits), place on the curve (32), point number (28), in one word.
using Word = std::uint64_t;
constexpr int kIndexBits = 28;
constexpr int kCurveBits = 32;
constexpr int kMaxRounds = 16;
constexpr Word kIndexMask = (Word{1} << kIndexBits) - 1;

Index index_of(Word word) { return static_cast<Index>(word & kIndexMask); }

// The Hilbert curve as an automaton that reads four bits of x and of y at a time. The state says
// how the curve is turned in the current square: bit 0 swaps the axes, bit 1 mirrors both.
struct CurveTable {
  std::array<std::uint8_t, 1024> place{};
  std::array<std::uint8_t, 1024> state{};
};

constexpr CurveTable make_curve_table() {
  CurveTable table;
  for (unsigned start = 0; start < 4; ++start) {
    for (unsigned cell = 0; cell < 256; ++cell) {
      unsigned state = start, place = 0;
      for (int bit = 3; bit >= 0; --bit) {
        unsigned x = (cell >> (4 + bit)) & 1, y = (cell >> bit) & 1;
        if (state & 2) x ^= 1, y ^= 1;
        if (state & 1) std::swap(x, y);
        const unsigned quadrant = (3 * x) ^ y;
        place = place << 2 | quadrant;
        if (quadrant == 0) state ^= 1;
        if (quadrant == 3) state ^= 3;
      }
      table.place[start << 8 | cell] = static_cast<std::uint8_t>(place);
      table.state[start << 8 | cell] = static_cast<std::uint8_t>(state);
    }
  }
  return table;
}

constexpr CurveTable kCurve = make_curve_table();

// The place on the curve of cell (x, y) of a 2^16 x 2^16 grid.
std::uint32_t curve_place(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0, state = 0;
  for (int shift = 12; shift >= 0; shift -= 4) {
    const std::uint32_t entry = state << 8 | ((x >> shift) & 15u) << 4 | ((y >> shift) & 15u);
    place = place << 8 | kCurve.place[entry];
    state = kCurve.state[entry];
  }
  return place;
}

// The square in which the curve runs. Coordinates are halved, so that no difference overflows.
struct Square {
  double half_x = 0, half_y = 0, half_side = 0;
};

template <class Range, class PointOf>
Square bounding_square(const Range& range, PointOf point_of) {
  Point2 low = point_of(*range.begin()), high = low;
  for (const auto& item : range) {
    const Point2 p = point_of(item);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double side = std::max(high.x / 2 - low.x / 2, high.y / 2 - low.y / 2);
  return {low.x / 2, low.y / 2, side};
}

std::uint32_t grid_coordinate(double half, double half_low, double half_side) {
  const double cell = (half - half_low) / half_side * 65536.0;
  return cell >= 65535.0 ? 65535u : static_cast<std::uint32_t>(cell);
}

std::uint32_t place_in(const Square& square, Point2 p) {
  return curve_place(grid_coordinate(p.x / 2, square.half_x, square.half_side),
                     grid_coordinate(p.y / 2, square.half_y, square.half_side));
}

// Stable radix sort by the bits above the point number.
void sort_words(std::vector<Word>& words) {
  constexpr int kDigitBits = 12, kDigits = 3;
  static_assert(kDigitBits * kDigits == 64 - kIndexBits);
  constexpr std::size_t kBuckets = std::size_t{1} << kDigitBits;
  std::vector<std::size_t> counts(kDigits * kBuckets);
  const auto digit = [](Word word, int d) {
    return static_cast<std::size_t>(word >> (kIndexBits + d * kDigitBits)) & (kBuckets - 1);
  };
  for (const Word word : words)
    for (int d = 0; d < kDigits; ++d) ++counts[d * kBuckets + digit(word, d)];
  std::vector<Word> other(words.size());
  for (int d = 0; d < kDigits; ++d) {
    std::size_t* start = &counts[d * kBuckets];
    std::size_t sum = 0;
    for (std::size_t b = 0; b < kBuckets; ++b) sum += std::exchange(start[b], sum);
    for (const Word word : words) other[start[digit(word, d)]++] = word;
    words.swap(other);
  }
}

// Cells with more points than this are refined.
constexpr std::size_t kCrowd = 8;

using Range = std::pair<std::size_t, std::size_t>;

// Appends the runs of words[begin, end) that share round and place and are crowded.
void find_crowds(std::span<const Word> words, Range range, std::vector<Range>& crowds) {
  for (std::size_t i = range.first; i < range.second;) {
    std::size_t j = i + 1;
    while (j < range.second && words[j] >> kIndexBits == words[i] >> kIndexBits) ++j;
    if (j - i > kCrowd) crowds.emplace_back(i, j);
    i = j;
  }
}

// Sorts crowded cells along a curve through their own square, until the squares are points. Every
// pass divides the side by 2^16, so there are at most 2098 / 16 passes over any point.
void refine_crowds(std::span<const Point2> points, std::vector<Word>& words) {
  std::vector<Range> crowds;
  find_crowds(words, {0, words.size()}, crowds);
  const auto point_of = [&](Word word) { return points[index_of(word)]; };
  while (!crowds.empty()) {
    const Range range = crowds.back();
    crowds.pop_back();
    const std::span<Word> crowd(words.data() + range.first, range.second - range.first);
    const Square square = bounding_square(crowd, point_of);
    if (!(square.half_side > 0)) continue;
    for (Word& word : crowd)
      word = Word{place_in(square, point_of(word))} << kIndexBits | index_of(word);
    std::sort(crowd.begin(), crowd.end());
    find_crowds(words, range, crowds);
  }
}

template <class RoundOf>
std::vector<Index> order_by(std::span<const Point2> points, RoundOf round_of) {
  assert(points.size() <= kMaxOrderedPoints);
  std::vector<Index> order(points.size());
  if (points.empty()) return order;
  const Square square = bounding_square(points, [](Point2 p) { return p; });
  std::vector<Word> words(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Word place = square.half_side > 0 ? place_in(square, points[i]) : 0;
    words[i] = (Word{round_of(i)} << kCurveBits | place) << kIndexBits | i;
  }
  sort_words(words);
  refine_crowds(points, words);
  std::transform(words.begin(), words.end(), order.begin(), index_of);
  return order;
}

// A point stays out of the last round with probability 2^-kRoundBits, out of the last two with the
// square of that, and so on.
constexpr int kRoundBits = 3;
constexpr std::size_t kFirstRound = 256;

}  // namespace

std::vector<Index> hilbert_order(std::span<const Point2> points) {
  return order_by(points, [](std::size_t) { return 0u; });
}

std::vector<Index> insertion_order(std::span<const Point2> points) {
  unsigned rounds = 1;
  while (rounds < kMaxRounds && (points.size() >> (rounds * kRoundBits)) > kFirstRound) ++rounds;
  return order_by(points, [&](std::size_t i) {
    const unsigned back =
        static_cast<unsigned>(std::countr_zero(splitmix64(i))) / unsigned{kRoundBits};
    return rounds - 1 - std::min(back, rounds - 1);
  });
}

}  // namespace wellspaced
