#include "wellspaced/kernel/space/bulk_insertion3.hpp"

#include <algorithm>

#include "wellspaced/kernel/parallel.hpp"
#include "wellspaced/kernel/space/walk3.hpp"

namespace wellspaced {
namespace {

// A round of fewer points is not worth dividing.
constexpr Index kLargeRound = Index{1} << 13;
// So many points go in between two words to the listener.
constexpr Index kReportEvery = Index{1} << 12;
// Room for the tets that a point adds: on random points 6.8, ghosts included.
constexpr Index kTetsAPoint = 7;
// So many points of a region are tried to find a tet of it.
constexpr Index kMaxStarts = 64;

}  // namespace

// The numbers that the new tets of a region get.
struct BulkInsertion3::TetSupply {
  Index next = 0, end = 0;
  std::vector<Index> returned = {};

  // Lengthens the list to `count` numbers. Returns false if there are not so many.
  bool lengthen(std::vector<Index>& list, std::size_t count) {
    if (list.size() + returned.size() + (end - next) < count) return false;
    for (; list.size() < count && !returned.empty(); returned.pop_back())
      list.push_back(returned.back());
    while (list.size() < count) list.push_back(next++);
    return true;
  }

  // Takes back what the list has beyond `count` numbers.
  void shorten(std::vector<Index>& list, std::size_t count) {
    for (; list.size() > count; list.pop_back()) returned.push_back(list.back());
  }

  void append_unused(std::vector<Index>& list) const {
    list.insert(list.end(), returned.begin(), returned.end());
    for (Index t = next; t < end; ++t) list.push_back(t);
  }
};

struct BulkInsertion3::Region {
  std::uint8_t number;
  Index begin, end;  // the vertices to insert
  TetSupply supply = {};
  Index hint = kNoIndex;  // a tet of the region
  std::vector<Index> deferred = {};
  std::vector<Duplicate> duplicates = {};
};

unsigned BulkInsertion3::region_count(std::size_t points) {
  constexpr std::size_t kOne = 1;
  return points < kOne << 15 ? 1 : points < kOne << 22 ? 2 : points < kOne << 24 ? 4 : 8;
}

BulkInsertion3::BulkInsertion3(Triangulation3& topology, std::span<const Point3> points,
                               const Options& options)
    : topology_(topology), points_(points), options_(options) {}

Status BulkInsertion3::run(std::span<const Index> run_ends, unsigned regions) {
  inserters_.resize(std::clamp(options_.threads, 1u, regions));
  for (VertexInserter3& inserter : inserters_) inserter.filler.reserve_vertices(points_.size());
  if (regions > 1) region_of_vertex_.resize(points_.size());
  Index begin = 0;
  for (std::size_t first = 0; first < run_ends.size(); first += regions) {
    const auto ends = run_ends.subspan(first, regions);
    if (Status s = run_round(begin, ends); !s) return s;
    begin = ends.back();
  }
  return Ok{};
}

Status BulkInsertion3::run_round(Index begin, std::span<const Index> ends) {
  const Index end = ends.back();
  if (ends.size() > 1) note_regions(begin, ends);
  if (ends.size() > 1 && end - begin >= kLargeRound && has_room_for(end - begin)) {
    for (const Index v : insert_by_region(begin, ends))
      if (Status s = insert(v); !s) return s;
    begin = end;
  }
  for (Index v = begin; v < end; ++v)
    if (Status s = insert(v); !s) return s;
  return advance(0, Speaker::kCaller) ? Status{Ok{}} : cancelled();
}

void BulkInsertion3::note_regions(Index begin, std::span<const Index> ends) {
  const auto first = region_of_vertex_.begin();
  for (std::uint8_t r = 0; r < ends.size(); begin = ends[r++])
    std::fill(first + begin, first + ends[r], r);
}

bool BulkInsertion3::has_room_for(std::size_t points) const {
  return topology_.size() + kTetsAPoint * points <= options_.max_tets;
}

// Counts what is done and tells the listener. Returns false once the caller wants to stop.
bool BulkInsertion3::advance(Index points, Speaker speaker) {
  const std::size_t done = std::min(done_ += points, points_.size());
  if (speaker == Speaker::kCaller &&
      !report(options_.progress, "triangulate", done, points_.size()))
    is_cancelled_ = true;
  return !is_cancelled_;
}

Status BulkInsertion3::insert(Index v) {
  if (v % kReportEvery == 0 && !advance(kReportEvery, Speaker::kCaller)) return cancelled();
  const Point3 p = points_[v];
  const Index t = walk(topology_, points_, p, hint_, [](Index) { return true; });
  const Index twin = vertex_at(topology_, points_, t, p);
  if (twin != kNoIndex) {
    if (twin != v) duplicates_.push_back({v, twin});
    return Ok{};
  }
  VertexInserter3& inserter = inserters_[0];
  if (Status s = inserter.insert(topology_, points_, v, t, options_.max_tets); !s) return s;
  hint_ = inserter.cavity.tets.front();
  return Ok{};
}

// ---- Regions -----------------------------------------------------------------------------------

// Returns the vertices that are deferred.
std::vector<Index> BulkInsertion3::insert_by_region(Index begin, std::span<const Index> ends) {
  const std::size_t count = ends.size();
  topology_.reserve(topology_.size() + kTetsAPoint * std::size_t{ends.back() - begin});
  run_parallel(static_cast<unsigned>(inserters_.size()), inserters_.size(),
               [&](unsigned worker, std::size_t) {
                 inserters_[worker].search.fence_off_borders(topology_, region_of_vertex_);
               });
  std::vector<Region> regions;
  for (std::uint8_t r = 0; r < count; begin = ends[r++]) {
    regions.push_back({.number = r, .begin = begin, .end = ends[r]});
    regions.back().hint = first_tet(regions.back());
  }
  for (Region& region : regions) {
    const Index room = kTetsAPoint * (region.end - region.begin);
    const Index first = topology_.append(room);
    region.supply = {first, first + room};
  }
  run_parallel(
      static_cast<unsigned>(inserters_.size()), count, [&](unsigned worker, std::size_t r) {
        fill(regions[r], inserters_[worker], worker == 0 ? Speaker::kCaller : Speaker::kHelper);
      });
  return join(regions);
}

// A tet of the region that may be entered, or kNoIndex if none is found near its first vertices.
Index BulkInsertion3::first_tet(const Region& region) {
  const Index end = std::min(region.end, region.begin + kMaxStarts);
  for (Index v = region.begin; v < end; ++v) {
    hint_ = walk(topology_, points_, points_[v], hint_, [](Index) { return true; });
    if (!inserters_[0].search.is_fenced(hint_) &&
        region_of_vertex_[topology_.vertex(hint_, 0)] == region.number)
      return hint_;
  }
  return kNoIndex;
}

void BulkInsertion3::fill(Region& region, VertexInserter3& inserter, Speaker speaker) {
  for (Index v = region.begin; v < region.end; ++v) {
    if (v % kReportEvery == 0 && !advance(kReportEvery, speaker)) return;
    if (region.hint == kNoIndex || !insert_in_region(v, region, inserter))
      region.deferred.push_back(v);
  }
}

// Returns false if that would lead beyond the region, or there is no more room for its tets.
bool BulkInsertion3::insert_in_region(Index v, Region& region, VertexInserter3& inserter) {
  auto& cavity = inserter.cavity;
  const Point3 p = points_[v];
  const Index t = walk(topology_, points_, p, region.hint,
                       [&](Index met) { return !inserter.search.is_fenced(met); });
  if (t == kNoIndex) return false;
  const Index twin = vertex_at(topology_, points_, t, p);
  if (twin != kNoIndex) {
    if (twin != v) region.duplicates.push_back({v, twin});
    return true;
  }
  if (!inserter.search.run(topology_, points_, t, p, cavity)) return false;
  if (!region.supply.lengthen(cavity.tets, cavity.rim.size())) return false;
  inserter.filler.fill(topology_, cavity, v);
  region.supply.shorten(cavity.tets, cavity.rim.size());
  region.hint = cavity.tets.front();
  return true;
}

// Makes one triangulation of what the regions left. Returns the vertices that are deferred.
std::vector<Index> BulkInsertion3::join(std::span<const Region> regions) {
  std::vector<Index> deferred, unused;
  for (VertexInserter3& inserter : inserters_) inserter.search.remove_fence();
  for (const Region& region : regions) {
    deferred.insert(deferred.end(), region.deferred.begin(), region.deferred.end());
    duplicates_.insert(duplicates_.end(), region.duplicates.begin(), region.duplicates.end());
    region.supply.append_unused(unused);
  }
  topology_.remove(unused);
  hint_ = 0;
  return deferred;
}

}  // namespace wellspaced
