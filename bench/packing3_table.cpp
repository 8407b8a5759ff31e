// Packing of domains in space. First its CPU time beside that of our own Delaunay triangulation of
// the same nodes, from interleaved runs; then the CPU time a tet beside TetGen and gmsh on a cube
// of constant size, where those programs are installed. They read and write files, we do not; so
// what they take for a hundredth of the tets is taken off.
//
//   packing3_table [RUNS]      default 3
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced::bench {
namespace {

constexpr std::array<std::array<Index, 4>, 6> kSides = {
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};

Pls unit_cube() {
  Pls cube;
  for (int i = 0; i < 8; ++i)
    cube.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  for (const auto& side : kSides) cube.facets.push_back({{{side.begin(), side.end()}}, {}, 1});
  return cube;
}

// ---- Our own triangulation -----------------------------------------------------------------

void print_time(const char* name, const PackingOptions3& options, int runs) {
  std::vector<double> packing, triangulation;
  PackedTets packed;
  for (int run = 0; run < runs; ++run) {
    packing.push_back(timed([&] { packed = *pack_domain3(unit_cube(), options); }));
    int dimension = 0;
    triangulation.push_back(
        timed([&] { dimension = Delaunay3::build(packed.mesh.points)->dimension(); }));
    if (dimension != 3) std::abort();
  }
  std::printf("%-34s %9zu %9zu %9.2f\n", name, packed.mesh.points.size(), packed.mesh.tets.size(),
              median(packing) / median(triangulation));
}

// ---- Other programs ------------------------------------------------------------------------

double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

struct PeerRun {
  double seconds = 0, tets = 0;
};

// The first number after `word` in a file, or at its start for no word; 0 if there is none.
double number_after(const std::string& path, const std::string& word) {
  std::FILE* file = std::fopen(path.c_str(), "r");
  if (file == nullptr) return 0;
  std::array<char, 256> text;
  double number = 0;
  bool is_found = word.empty();
  while (number == 0 && std::fscanf(file, "%255s", text.data()) == 1) {
    if (is_found) number = std::atof(text.data());
    is_found = is_found || word == text.data();
  }
  std::fclose(file);
  return number;
}

PeerRun run_peer(const std::string& command, const std::string& output, const std::string& word) {
  const double before = seconds_of_children();
  if (std::system((command + " >/dev/null 2>&1").c_str()) != 0) return {};
  return {seconds_of_children() - before, number_after(output, word)};
}

PeerRun run_tetgen(double volume) {
  const Pls cube = unit_cube();
  std::FILE* file = std::fopen("packing3_table.poly", "w");
  if (file == nullptr) return {};
  std::fprintf(file, "8 3 0 0\n");
  for (Index v = 0; v < 8; ++v)
    std::fprintf(file, "%u %g %g %g\n", v + 1, cube.points[v].x, cube.points[v].y,
                 cube.points[v].z);
  std::fprintf(file, "6 0\n");
  for (const auto& [a, b, c, d] : kSides)
    std::fprintf(file, "1\n4 %u %u %u %u\n", a + 1, b + 1, c + 1, d + 1);
  std::fprintf(file, "0\n0\n");
  std::fclose(file);
  return run_peer("tetgen -Qpqa" + std::to_string(volume) + " packing3_table.poly",
                  "packing3_table.1.ele", "");
}

PeerRun run_gmsh(double volume) {
  std::FILE* file = std::fopen("packing3_table.geo", "w");
  if (file == nullptr) return {};
  std::fprintf(file, "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n");
  std::fclose(file);
  double size = 0.001;
  while (size * size * size < 8 * volume) size *= 1.01;
  return run_peer("gmsh -3 -nt 1 -format mesh -o packing3_table.mesh -clmax " +
                      std::to_string(size) + " packing3_table.geo",
                  "packing3_table.mesh", "Tetrahedra");
}

// The time a tet of a program, without what it takes to start.
template <class Run>
void print_peer(const char* name, Run run, double seconds_a_tet, double tets) {
  if (!is_installed(name)) {
    std::printf("%-34s is not there\n", name);
    return;
  }
  const PeerRun small = run(100 / tets), whole = run(1 / tets);
  if (!(whole.tets > small.tets)) {
    std::printf("%-34s failed\n", name);
    return;
  }
  const double peer = (whole.seconds - small.seconds) / (whole.tets - small.tets);
  std::printf("%-34s %9s %9.0f %9.2f\n", name, "", whole.tets, seconds_a_tet / peer);
}

void compare_with_peers() {
  PackingOptions3 options;
  options.size = [](Point3) { return 0.03; };
  options.size_slope = 0;
  PackedTets packed;
  const double seconds = timed([&] { packed = *pack_domain3(unit_cube(), options); });
  const auto tets = static_cast<double>(packed.mesh.tets.size());
  print_peer("tetgen", run_tetgen, seconds / tets, tets / 1.6);
  print_peer("gmsh", run_gmsh, seconds / tets, tets);
  for (const char* end : {"poly", "geo", "mesh", "1.node", "1.ele", "1.face", "1.edge"})
    std::remove((std::string("packing3_table.") + end).c_str());
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  std::printf("%-34s %9s %9s %9s\n", "packing a cube (median CPU)", "nodes", "tets", "t/DT");
  PackingOptions3 graded, uniform, coarse;
  graded.size = [](Point3 p) { return 0.02 * (0.5 + p.x); };
  graded.size_slope = 0.02;
  bench::print_time("graded size", graded, runs);
  uniform.size = [](Point3) { return 0.03; };
  uniform.size_slope = 0;
  bench::print_time("constant size", uniform, runs);
  coarse.beta = 30;
  bench::print_time("beta 30", coarse, runs);
  std::printf("\n%-34s %9s %9s %9s\n", "a tet, beside other programs", "", "tets", "ours/it");
  bench::compare_with_peers();
}
