#include "wellspaced/io/cli/packing_progress.hpp"

#include <algorithm>

#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/io/cli/stopwatch.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::size_t kSampleSide = 64;

// What finishing and writing a mesh takes, of the memory that it takes in all; measured.
constexpr double kMemoryToWrite = 0.55;

double seconds_for(const PackedMesh& sample) {
  const Stopwatch watch;
  const std::vector<double> spacing = packed_spacing(sample, 2);
  return watch.elapsed().cpu / static_cast<double>(spacing.size());
}

// Processor time for the spacing at a node; the least of three.
double seconds_a_node() {
  PackedMesh sample;
  sample.mesh.points = grid_points(kSampleSide, kSampleSide);
  sample.radius.assign(sample.mesh.points.size(), 1);
  const double first = seconds_for(sample), second = seconds_for(sample);
  return std::min({first, second, seconds_for(sample)});
}

// How much longer things take than their processor time: other programs run, too.
double load_of(const PhaseTime& time) {
  return time.cpu > 0 ? std::max(1.0, time.wall / time.cpu) : 1;
}

}  // namespace

Progress packing_progress(Session& session, double node_cost) {
  const Stopwatch watch;
  const double seconds = session.options().time_limit ? node_cost * seconds_a_node() : 0;
  return [&session, watch, seconds, ask = session.progress()](
             std::string_view phase, std::uint64_t done, std::uint64_t total) {
    const bool packs = phase == "pack";
    session.leave_memory_to_write(packs ? kMemoryToWrite : 0);
    if (packs && seconds > 0)
      session.leave_time_to_write(load_of(watch.elapsed()) * seconds * static_cast<double>(done));
    return ask(phase, done, total);
  };
}

}  // namespace wellspaced::cli
