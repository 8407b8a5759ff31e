// ns per call of each predicate and of each of its rungs, on uniform and on degenerate lines.
//
// "sign" is what callers use. "filter", "fixed" and "big" ask one rung. The rounded lines are
// on a line, plane, circle or sphere up to the rounding of 53-bit coordinates, so that the filter
// cannot tell. Every answer is compared with the big integers' before the clock starts.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/predicate_cases.hpp"
#include "wellspaced/kernel/plane/crossing.hpp"

namespace wellspaced::testing {
namespace {

constexpr int kLines = 1024;

template <class Case>
using Lines = std::vector<typename Case::Coordinates>;

template <class Case>
Lines<Case> hard_lines(Family family) {
  LineGenerator<Case> generator(1);
  Lines<Case> lines;
  for (int i = 0; i < kLines; ++i) lines.push_back(generator.line(family));
  return lines;
}

// A point of the unit circle or sphere without libm: normalized from the cube.
template <class Case>
void put_on_unit_sphere(Random& random, double* p) {
  double length_sq = 0;
  do {
    length_sq = 0;
    for (std::size_t k = 0; k < Case::kDimension; ++k) {
      p[k] = random.uniform(-1, 1);
      length_sq += p[k] * p[k];
    }
  } while (length_sq > 1 || length_sq < 0.01);
  for (std::size_t k = 0; k < Case::kDimension; ++k) p[k] /= std::sqrt(length_sq);
}

// Rounded points of a circle or sphere, or of a line or plane: what a generator of test meshes or
// a CAD program makes.
template <class Case>
Lines<Case> rounded_lines() {
  if (Case::kRows == Rows::kFlat) return hard_lines<Case>(Family::kRounded);
  Random random(2);
  Lines<Case> lines(kLines);
  for (auto& x : lines) {
    for (std::size_t i = 0; i < x.size(); i += Case::kDimension) {
      put_on_unit_sphere<Case>(random, &x[i]);
    }
  }
  return lines;
}

// Points of a small cell of an integer grid 2^20 wide: cospherical and coplanar ones abound.
template <class Case>
Lines<Case> grid_lines() {
  LineGenerator<Case> generator(3);
  Lines<Case> lines;
  for (int i = 0; i < kLines; ++i) {
    lines.push_back(generator.line(Family::kGrid));
    for (double& value : lines.back()) value = value * 0.5 + 1000;
  }
  return lines;
}

// Rounded lines with one coordinate of far smaller scale, such as the sine of a rounded pi.
template <class Case>
Lines<Case> wide_lines() {
  Lines<Case> lines = rounded_lines<Case>();
  for (auto& x : lines) x[1] *= 0x1p-40;
  return lines;
}

enum class Rung { kSign, kFilter, kFixed, kBig };

template <class Case, Rung rung>
int ask(const typename Case::Coordinates& x) {
  if constexpr (rung == Rung::kSign) return Case::sign(x);
  if constexpr (rung == Rung::kFilter) return Case::filter(x);
  if constexpr (rung == Rung::kFixed) return Case::fixed(x).value_or(2);
  if constexpr (rung == Rung::kBig) return Case::big(x);
}

template <class Case, Rung rung>
void check(const Lines<Case>& lines) {
  for (const auto& x : lines) {
    const int answer = ask<Case, rung>(x);
    const bool told = rung == Rung::kFilter ? answer != 0 : answer != 2;
    if (told && answer != Case::big(x)) {
      std::fprintf(stderr, "%s: wrong sign\n", Case::kName);
      std::exit(1);
    }
  }
}

template <class Case, Rung rung>
void measure(benchmark::State& state, const Lines<Case>& lines) {
  check<Case, rung>(lines);
  for (auto _ : state) {
    int sum = 0;
    for (const auto& x : lines) sum += ask<Case, rung>(x);
    benchmark::DoNotOptimize(sum);
  }
  state.counters["ns"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kLines * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Case, Rung rung>
void add(const char* rung_name, const char* input, const Lines<Case>& lines) {
  const std::string name = std::string(Case::kName) + "/" + rung_name + "/" + input;
  benchmark::RegisterBenchmark(
      name.c_str(), [lines](benchmark::State& state) { measure<Case, rung>(state, lines); });
}

template <class Case>
void add_all() {
  const Lines<Case> uniform = hard_lines<Case>(Family::kUniform);
  const Lines<Case> grid = grid_lines<Case>();
  const Lines<Case> rounded = rounded_lines<Case>();
  const Lines<Case> wide = wide_lines<Case>();
  add<Case, Rung::kFilter>("filter", "uniform", uniform);
  add<Case, Rung::kSign>("sign", "uniform", uniform);
  add<Case, Rung::kSign>("sign", "grid", grid);
  add<Case, Rung::kSign>("sign", "rounded", rounded);
  add<Case, Rung::kFixed>("fixed", "grid", grid);
  add<Case, Rung::kFixed>("fixed", "rounded", rounded);
  add<Case, Rung::kFixed>("fixed", "uniform", uniform);
  add<Case, Rung::kFixed>("fixed", "wide", wide);
  add<Case, Rung::kBig>("big", "rounded", rounded);
  add<Case, Rung::kBig>("big", "wide", wide);
  add<Case, Rung::kBig>("big", "spread", hard_lines<Case>(Family::kMixedExponents));
}

std::vector<Crossing> uniform_crossings() {
  Random random(4);
  const auto point = [&random] { return Point2{random.uniform(), random.uniform()}; };
  std::vector<Crossing> crossings;
  while (crossings.size() < kLines) {
    const Crossing p{point(), point(), point(), point()};
    if (relate_segments(p.a, p.b, p.c, p.d) == SegmentRelation::kCross) crossings.push_back(p);
  }
  return crossings;
}

// ask(p, q) for neighbouring crossings p, q.
template <class Ask>
void add_crossing(const char* name, Ask ask) {
  benchmark::RegisterBenchmark(name, [ask](benchmark::State& state) {
    const std::vector<Crossing> crossings = uniform_crossings();
    for (auto _ : state) {
      int sum = 0;
      for (int i = 1; i < kLines; ++i) sum += ask(crossings[i - 1], crossings[i]);
      benchmark::DoNotOptimize(sum);
    }
    state.counters["ns"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * (kLines - 1) * 1e-9,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

void add_crossings() {
  add_crossing("crossing/relate", [](const Crossing& p, const Crossing& q) {
    return static_cast<int>(relate_segments(p.a, p.b, q.a, q.b));
  });
  add_crossing("crossing/side",
               [](const Crossing& p, const Crossing& q) { return orient2d(q.a, q.b, p); });
  add_crossing("crossing/compare",
               [](const Crossing& p, const Crossing& q) { return compare_xy(p, q); });
  add_crossing("crossing/round",
               [](const Crossing& p, const Crossing&) { return round_crossing(p).count; });
}

}  // namespace
}  // namespace wellspaced::testing

int main(int argc, char** argv) {
  using namespace wellspaced::testing;
  add_all<Orient2dCase>();
  add_all<IncircleCase>();
  add_all<Orient3dCase>();
  add_all<InsphereCase>();
  add_crossings();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
