// Making many points vertices of a Delaunay triangulation of space, on several threads. Used by
// Delaunay3.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/space/triangulation3.hpp"
#include "wellspaced/kernel/space/vertex_inserter3.hpp"

namespace wellspaced {

/// Inserts points in the order and the runs of InsertionRuns, round by round.
///
/// In a large round the regions are filled at the same time. A region owns the tets all of whose
/// real vertices lie in it; a tet with vertices of several regions is a border tet. While regions
/// are filled, border tets keep their vertices: a point whose way or whose cavity leads into one is
/// deferred, and inserted when all regions are done. Neighbours have at least two real vertices in
/// common, so no region ever comes across a tet of another. Hence no thread reads what another
/// writes, and regions that are filled one after the other give the same result, to the number of
/// each tet: every region takes these from a supply of its own.
class BulkInsertion3 {
 public:
  struct Options {
    Progress progress = {};
    Index max_tets = Triangulation3::kMaxTets;
    unsigned threads = 1;
  };
  struct Duplicate {
    Index point, vertex;
  };

  /// How many regions pay for so many points.
  static unsigned region_count(std::size_t points);

  /// `points` in insertion order: vertex v is points[v].
  BulkInsertion3(Triangulation3& topology, std::span<const Point3> points, const Options& options);

  /// Makes all points vertices that are none yet. `run_ends` and `regions` as in InsertionRuns.
  /// Requires: the topology is the Delaunay triangulation of some of the points.
  /// Errors: kLimit beyond max_tets; kCancelled.
  Status run(std::span<const Index> run_ends, unsigned regions);

  /// The points that have the coordinates of a vertex.
  const std::vector<Duplicate>& duplicates() const { return duplicates_; }

 private:
  struct TetSupply;
  struct Region;
  // Which thread asks: only the caller's may tell the listener.
  enum class Speaker { kCaller, kHelper };

  Status run_round(Index begin, std::span<const Index> ends);
  void note_regions(Index begin, std::span<const Index> ends);
  bool has_room_for(std::size_t points) const;
  Status insert(Index v);
  std::vector<Index> insert_by_region(Index begin, std::span<const Index> ends);
  Index first_tet(const Region& region);
  void fill(Region& region, VertexInserter3& inserter, Speaker speaker);
  bool insert_in_region(Index v, Region& region, VertexInserter3& inserter);
  std::vector<Index> join(std::span<const Region> regions);
  bool advance(Index points, Speaker speaker);

  Triangulation3& topology_;
  std::span<const Point3> points_;
  Options options_;
  std::vector<VertexInserter3> inserters_;  // one a thread
  std::vector<std::uint8_t> region_of_vertex_;
  std::vector<Duplicate> duplicates_;
  Index hint_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> is_cancelled_ = false;
};

}  // namespace wellspaced
