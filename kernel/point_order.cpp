#include "wellspaced/kernel/point_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

#include "wellspaced/kernel/hilbert_curve.hpp"
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

// As fine a grid as sorting so many points is worth: two cells a point or more.
template <std::size_t Dimension>
int axis_bits_for(std::size_t points) {
  int bits = hilbert::kStepBits<Dimension>;
  while (bits < hilbert::kMaxAxisBits<Dimension> && points >> (Dimension * bits - 1) > 0)
    bits += hilbert::kStepBits<Dimension>;
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
  return hilbert::place(cell, axis_bits);
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
  constexpr int kFinest = hilbert::kMaxAxisBits<std::tuple_size_v<decltype(halved(Point()))>>;
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
      word = Word{place_in(cube, halved(point_of(word)), kFinest)} << kIndexBits | index_of(word);
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
