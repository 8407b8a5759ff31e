#include "wellspaced/kernel/point_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// What is sorted: round, place on the curve (at most 32 bits), point number (28), in one word.
using Word = std::uint64_t;
constexpr int kIndexBits = 28;
constexpr unsigned kMaxRounds = 16;
constexpr Word kIndexMask = (Word{1} << kIndexBits) - 1;

Index index_of(Word word) { return static_cast<Index>(word & kIndexMask); }

// The Hilbert curve of the plane as an automaton that reads four bits of x and of y at a time. The
// state says how the curve is turned in the current square: bit 0 swaps the axes, bit 1 mirrors
// both. By state << 8 | cell of 16 x 16: next state << 8 | place.
using PlaneCurve = std::array<std::uint16_t, 1024>;

constexpr PlaneCurve make_plane_curve() {
  PlaneCurve table{};
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
      table[start << 8 | cell] = static_cast<std::uint16_t>(state << 8 | place);
    }
  }
  return table;
}

constexpr PlaneCurve kPlaneCurve = make_plane_curve();

// The Hilbert curve of space as an automaton that reads two bits of x, y and z at a time (Hamilton,
// Compact Hilbert indices, 2006). The state 3 * entry + axis says how the curve is turned in the
// current cube: the corner where it enters, and the axis along which it leaves. By state << 6 |
// cell of 4 x 4 x 4: next state << 6 | place.
using SpaceCurve = std::array<std::uint16_t, 24 * 64>;

constexpr unsigned rotate3(unsigned bits, unsigned by) {
  return (bits << by | bits >> (3 - by)) & 7u;
}

constexpr SpaceCurve make_space_curve() {
  // By the octant's place on the untilted curve: its entry corner and its direction.
  constexpr std::array<unsigned, 8> kEntry{0, 0, 0, 3, 3, 6, 6, 5};
  constexpr std::array<unsigned, 8> kAxis{0, 1, 1, 2, 2, 1, 1, 0};
  SpaceCurve table{};
  for (unsigned start = 0; start < 24; ++start) {
    for (unsigned cell = 0; cell < 64; ++cell) {
      unsigned entry = start / 3, axis = start % 3, place = 0;
      for (unsigned bit = 2; bit-- > 0;) {
        const unsigned x = cell >> (4 + bit) & 1, y = cell >> (2 + bit) & 1, z = cell >> bit & 1;
        const unsigned turn = (axis + 1) % 3;
        const unsigned gray = rotate3((x | y << 1 | z << 2) ^ entry, 3 - turn);
        const unsigned octant = gray ^ gray >> 1 ^ gray >> 2;
        place = place << 3 | octant;
        entry ^= rotate3(kEntry[octant], turn);
        axis = (axis + kAxis[octant] + 1) % 3;
      }
      const unsigned state = 3 * entry + axis;
      table[start << 6 | cell] = static_cast<std::uint16_t>(state << 6 | place);
    }
  }
  return table;
}

constexpr SpaceCurve kSpaceCurve = make_space_curve();

// The place on the curve of a cell of a grid of 2^axis_bits x 2^axis_bits cells. Requires: a
// multiple of 4, at most 16.
std::uint32_t curve_place(const std::array<std::uint32_t, 2>& cell, int axis_bits) {
  std::uint32_t place = 0, entry = 0;
  for (int shift = axis_bits - 4; shift >= 0; shift -= 4) {
    const std::uint32_t part = ((cell[0] >> shift) & 15u) << 4 | ((cell[1] >> shift) & 15u);
    entry = kPlaneCurve[(entry & ~255u) | part];
    place = place << 8 | (entry & 255u);
  }
  return place;
}

// The same in space. Requires: a multiple of 2, at most 10.
std::uint32_t curve_place(const std::array<std::uint32_t, 3>& cell, int axis_bits) {
  std::uint32_t place = 0, entry = 0;
  for (int shift = axis_bits - 2; shift >= 0; shift -= 2) {
    const std::uint32_t part =
        ((cell[0] >> shift) & 3u) << 4 | ((cell[1] >> shift) & 3u) << 2 | ((cell[2] >> shift) & 3u);
    entry = kSpaceCurve[(entry & ~63u) | part];
    place = place << 6 | (entry & 63u);
  }
  return place;
}

std::array<double, 2> halved(Point2 p) { return {p.x / 2, p.y / 2}; }
std::array<double, 3> halved(Point3 p) { return {p.x / 2, p.y / 2, p.z / 2}; }

// The square or cube in which the curve runs. Coordinates are halved, so that no difference
// overflows.
template <std::size_t Dimension>
struct Cube {
  std::array<double, Dimension> half_low;
  double half_side;
};

template <class Range, class PointOf>
auto bounding_cube(const Range& range, PointOf point_of) {
  auto low = halved(point_of(*range.begin())), high = low;
  for (const auto& item : range) {
    const auto half = halved(point_of(item));
    for (std::size_t k = 0; k < half.size(); ++k) {
      low[k] = std::min(low[k], half[k]);
      high[k] = std::max(high[k], half[k]);
    }
  }
  double side = 0;
  for (std::size_t k = 0; k < low.size(); ++k) side = std::max(side, high[k] - low[k]);
  return Cube<std::tuple_size_v<decltype(low)>>{low, side};
}

// The grids that the curve's automaton can number: 2^16 cells along an axis at most, 2^10 in space.
template <std::size_t Dimension>
constexpr int kStepBits = Dimension == 2 ? 4 : 2;
template <std::size_t Dimension>
constexpr int kMaxAxisBits = Dimension == 2 ? 16 : 10;

// As fine a grid as sorting so many points is worth: two cells a point or more.
template <std::size_t Dimension>
int axis_bits_for(std::size_t points) {
  int bits = kStepBits<Dimension>;
  while (bits < kMaxAxisBits<Dimension> && points >> (Dimension * bits - 1) > 0)
    bits += kStepBits<Dimension>;
  return bits;
}

template <std::size_t Dimension>
std::uint32_t place_in(const Cube<Dimension>& cube, const std::array<double, Dimension>& half,
                       int axis_bits) {
  const double cells = static_cast<double>(1 << axis_bits);
  std::array<std::uint32_t, Dimension> cell;
  for (std::size_t k = 0; k < Dimension; ++k) {
    const double c = (half[k] - cube.half_low[k]) / cube.half_side * cells;
    cell[k] = static_cast<std::uint32_t>(std::min(c, cells - 1));
  }
  return curve_place(cell, axis_bits);
}

// Stable radix sort by `key_bits` bits above the point number, back and forth between two arrays.
// Returns the one that the result is in.
std::span<Word> sort_words(std::span<Word> words, std::span<Word> other, int key_bits) {
  constexpr int kMostDigitBits = 10;  // what one pass scatters to fits into the fastest cache
  const int digits = (key_bits + kMostDigitBits - 1) / kMostDigitBits;
  const int digit_bits = (key_bits + digits - 1) / digits;
  const std::size_t buckets = std::size_t{1} << digit_bits;
  std::vector<Index> counts(static_cast<std::size_t>(digits) * buckets);
  const auto digit = [=](Word word, int d) {
    return static_cast<std::size_t>(word >> (kIndexBits + d * digit_bits)) & (buckets - 1);
  };
  for (const Word word : words)
    for (int d = 0; d < digits; ++d) ++counts[d * buckets + digit(word, d)];
  for (int d = 0; d < digits; ++d) {
    Index* const start = &counts[d * buckets];
    Index sum = 0;
    for (std::size_t b = 0; b < buckets; ++b) sum += std::exchange(start[b], sum);
    for (const Word word : words) other[start[digit(word, d)]++] = word;
    std::swap(words, other);
  }
  return words;
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
// pass divides the side by 2^16 (2^10 in space), so there are at most 2098 / 16 passes over any
// point (2098 / 10).
template <class Point>
void refine_crowds(std::span<const Point> points, std::span<Word> words) {
  constexpr std::size_t kDimension = std::tuple_size_v<decltype(halved(Point()))>;
  std::vector<Range> crowds;
  find_crowds(words, {0, words.size()}, crowds);
  const auto point_of = [&](Word word) { return points[index_of(word)]; };
  while (!crowds.empty()) {
    const Range range = crowds.back();
    crowds.pop_back();
    const std::span<Word> crowd(words.data() + range.first, range.second - range.first);
    const auto cube = bounding_cube(crowd, point_of);
    if (!(cube.half_side > 0)) continue;
    for (Word& word : crowd)
      word = Word{place_in(cube, halved(point_of(word)), kMaxAxisBits<kDimension>)} << kIndexBits |
             index_of(word);
    std::sort(crowd.begin(), crowd.end());
    find_crowds(words, range, crowds);
  }
}

template <class Point>
std::vector<Index> refined_order(std::span<const Point> points, std::span<Word> words) {
  refine_crowds(points, words);
  std::vector<Index> order;
  reserve_large(order, words.size());
  order.resize(words.size());
  std::transform(words.begin(), words.end(), order.begin(), index_of);
  return order;
}

// A point stays out of the last round with probability 2^-thinning, out of the last two with the
// square of that, and so on. In space more and smaller rounds pay, because they make the cavities
// smaller.
constexpr unsigned kPlaneThinning = 3;
constexpr unsigned kSpaceThinning = 2;
constexpr std::size_t kFirstRound = 256;

unsigned round_count(std::size_t points, unsigned thinning) {
  unsigned rounds = 1;
  while (rounds < kMaxRounds && (points >> (rounds * thinning)) > kFirstRound) ++rounds;
  return rounds;
}

unsigned round_of_point(std::size_t i, unsigned rounds, unsigned thinning) {
  const unsigned back = static_cast<unsigned>(std::countr_zero(splitmix64(i))) / thinning;
  return rounds - 1 - std::min(back, rounds - 1);
}

// How the points are sorted: by round, and in a round by place on the curve.
struct SortKey {
  unsigned rounds, thinning;
  int round_bits, axis_bits, place_bits;
};

template <class Point>
SortKey sort_key_of(std::span<const Point> points, unsigned rounds, unsigned thinning) {
  constexpr std::size_t kDimension = std::tuple_size_v<decltype(halved(Point()))>;
  const int axis_bits = axis_bits_for<kDimension>(points.size());
  return {rounds, thinning, static_cast<int>(std::bit_width(rounds - 1)), axis_bits,
          static_cast<int>(kDimension) * axis_bits};
}

// The words of all points in order, but for crowded cells. They lie in `memory`, which has room for
// two words a point.
template <class Point>
std::span<Word> sorted_words(std::span<const Point> points, std::span<Word> memory,
                             const SortKey& key) {
  assert(points.size() <= kMaxOrderedPoints && memory.size() == 2 * points.size());
  const auto words = memory.first(points.size()), other = memory.last(points.size());
  if (points.empty()) return words;
  const auto cube = bounding_cube(points, [](Point p) { return p; });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Word place = cube.half_side > 0 ? place_in(cube, halved(points[i]), key.axis_bits) : 0;
    const Word round = round_of_point(i, key.rounds, key.thinning);
    words[i] = (round << key.place_bits | place) << kIndexBits | i;
  }
  return sort_words(words, other, key.round_bits + key.place_bits);
}

template <class Point>
std::vector<Index> curve_order(std::span<const Point> points) {
  LargeVector<Word> memory(2 * points.size());
  return refined_order(points, sorted_words(points, std::span(memory), sort_key_of(points, 1, 1)));
}

// The first of the sorted words at or behind a place on the curve in a round.
std::size_t first_word(std::span<const Word> words, const SortKey& key, Word round, Word place) {
  const Word first = (round << key.place_bits | place) << kIndexBits;
  return static_cast<std::size_t>(std::lower_bound(words.begin(), words.end(), first) -
                                  words.begin());
}

// Cuts the rounds of the sorted words into runs, where the curve cuts the last round evenly.
std::vector<Index> run_ends(std::span<const Word> words, const SortKey& key, unsigned regions) {
  const std::size_t last_begin = first_word(words, key, key.rounds - 1, 0);
  const std::size_t last_count = words.size() - last_begin;
  std::vector<Index> ends;
  for (unsigned round = 0; round < key.rounds; ++round) {
    for (unsigned region = 1; region < regions; ++region) {
      const Word cut = words[last_begin + last_count * region / regions] >> kIndexBits;
      const Word place = cut & ((Word{1} << key.place_bits) - 1);
      ends.push_back(static_cast<Index>(first_word(words, key, round, place)));
    }
    const bool is_last = round + 1 == key.rounds;
    ends.push_back(
        static_cast<Index>(is_last ? words.size() : first_word(words, key, round + 1, 0)));
  }
  return ends;
}

template <class Point>
InsertionRuns runs_in(std::span<Word> memory, std::span<const Point> points, unsigned regions,
                      unsigned thinning) {
  const SortKey key = sort_key_of(points, round_count(points.size(), thinning), thinning);
  const auto words = sorted_words(points, memory, key);
  InsertionRuns runs{regions, {}, {}};
  if (!points.empty()) runs.ends = run_ends(words, key, regions);
  runs.order = refined_order(points, words);
  return runs;
}

}  // namespace

std::vector<Index> hilbert_order(std::span<const Point2> points) { return curve_order(points); }

std::vector<Index> hilbert_order(std::span<const Point3> points) { return curve_order(points); }

std::vector<Index> insertion_order(std::span<const Point2> points) {
  LargeVector<Point2> memory(points.size());
  return insertion_runs(points, 1, std::as_writable_bytes(std::span(memory))).order;
}

std::vector<Index> insertion_order(std::span<const Point3> points) {
  return insertion_runs(points, 1).order;
}

InsertionRuns insertion_runs(std::span<const Point2> points, unsigned regions,
                             std::span<std::byte> memory) {
  assert(memory.size() == 2 * sizeof(Word) * points.size());
  const std::span words(reinterpret_cast<Word*>(memory.data()), 2 * points.size());
  return runs_in(words, points, regions, kPlaneThinning);
}

InsertionRuns insertion_runs(std::span<const Point3> points, unsigned regions) {
  LargeVector<Word> memory(2 * points.size());
  return runs_in(std::span(memory), points, regions, kSpaceThinning);
}

std::vector<Index> insertion_order(std::span<const Index> along_curve) {
  const unsigned rounds = round_count(along_curve.size(), kPlaneThinning);
  std::array<std::size_t, kMaxRounds + 1> next{};  // where each round's next point goes
  for (const Index v : along_curve) ++next[round_of_point(v, rounds, kPlaneThinning) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Index> order(along_curve.size());
  for (const Index v : along_curve) order[next[round_of_point(v, rounds, kPlaneThinning)]++] = v;
  return order;
}

}  // namespace wellspaced
