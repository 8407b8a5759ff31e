// How Delaunay2::build inserts its points: one after the other, each near the one before it.
//
// Many points are inserted by region: each round is cut where the curve enters the next of a few
// regions of the plane, and in a large round the regions are filled at the same time. A region owns
// the triangles all of whose real vertices lie in it; a triangle with vertices of several regions
// is a border triangle. While regions are filled, a fence keeps border triangles as they are: a
// point whose way or whose hole leads into one is deferred until all regions are done. Neighbours
// have a real vertex in common, so no region ever comes across a triangle of another. Hence no
// thread reads what another writes, and regions that are filled one after the other give the same
// result, to the number of each triangle.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/parallel.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/plane/point_inserter2.hpp"

namespace wellspaced {
namespace {

// A round of fewer points is not worth dividing.
constexpr Index kRoundWorthDividing = Index{1} << 14;
// So many places are known in each region where a walk may start.
constexpr Index kStarts = 256;
// Whoever listens is asked after so many points.
constexpr Index kAskEvery = Index{1} << 13;

// Makes all points vertices, round by round, as long as `progress` does not say stop.
template <class Triangle, class Duplicate>
class BulkInsertion {
 public:
  // Requires: the triangles are the Delaunay triangulation of three of the points, unconstrained.
  BulkInsertion(LargeVector<Triangle>& triangles, std::span<const Point2> points,
                const Delaunay2::Options& options, std::vector<Duplicate>& duplicates)
      : triangles_(triangles),
        points_(points),
        progress_(options.progress),
        duplicates_(duplicates),
        first_(triangles[0].vertex),
        used_(static_cast<Index>(triangles.size())) {
    triangles.resize(2 * points.size());
    inserters_.assign(std::max(options.threads, 1u), Inserter(triangles, points));
  }

  // `ends` and `regions` as in InsertionRuns. Returns false if it was stopped; then the triangles
  // are of no use.
  bool run(std::span<const Index> ends, unsigned regions) {
    Index begin = 0;
    for (std::size_t first = 0; first < ends.size() && !stopped_; first += regions) {
      const Index end = ends[first + regions - 1];
      if (regions > 1 && end - begin >= kRoundWorthDividing)
        insert_by_region(begin, ends.first(first), ends.subspan(first, regions));
      else
        insert_all(begin, end);
      begin = end;
    }
    triangles_.resize(used_);
    return !stopped_;
  }

 private:
  using Inserter = PointInserter2<Triangle>;
  using Outcome = typename Inserter::Outcome;

  struct alignas(kCacheLine) Region {
    std::uint8_t number;
    Index begin, end;       // the points to insert
    Index first_new, next;  // the numbers of their triangles, two a point, and the next of these
    // Triangles near the middle of each of kStarts stretches of the points; kNoIndex where the
    // region does not own it.
    std::vector<Index> starts = {};
    std::vector<Index> deferred = {};
    std::vector<Duplicate> duplicates = {};
  };

  bool is_first(Index v) const { return v == first_[0] || v == first_[1] || v == first_[2]; }

  // Whether to go on at point v. Only the caller's thread asks whoever listens.
  bool go_on(unsigned worker, Index v) {
    if (v % kAskEvery != 0) return true;
    if (worker == 0 && !stopped_) stopped_ = !report(progress_, "triangulate", v, points_.size());
    return !stopped_;
  }

  // One point after the other.
  void insert_all(Index begin, Index end) {
    const Index last = static_cast<Index>(points_.size()) - 1;
    for (Index v = begin; v < end && go_on(0, v); ++v)
      if (!is_first(v) && insert(v, used_, std::min(v + 1, last))) used_ += 2;
  }

  // Returns false if it is a duplicate. Requires: no fence.
  bool insert(Index v, Index first_new, Index next) {
    const Outcome outcome = inserters_[0].insert(v, first_new, next);
    if (outcome == Outcome::kTwin) duplicates_.push_back({v, inserters_[0].twin()});
    return outcome == Outcome::kInserted;
  }

  // ---- By region.

  void insert_by_region(Index begin, std::span<const Index> earlier_ends,
                        std::span<const Index> ends) {
    note_regions(earlier_ends, static_cast<unsigned>(ends.size()));
    const std::vector<Index> border = border_triangles();
    std::vector<Region> regions = make_regions(begin, ends);
    set_fence(border, Inserter::kFence);
    run_parallel(static_cast<unsigned>(inserters_.size()), regions.size(),
                 [&](unsigned worker, std::size_t r) { fill(regions[r], worker); });
    set_fence(border, 0);
    if (!stopped_) join(regions);
  }

  // Writes down the regions of the vertices of earlier rounds.
  void note_regions(std::span<const Index> ends, unsigned regions) {
    Index begin = 0;
    region_of_vertex_.resize(ends.empty() ? 0 : ends.back());
    for (std::size_t run = 0; run < ends.size(); begin = ends[run++])
      std::fill(region_of_vertex_.begin() + begin, region_of_vertex_.begin() + ends[run],
                static_cast<std::uint8_t>(run % regions));
  }

  // The region that owns a triangle, or kBorder.
  std::uint8_t owner(const Triangle& t) const {
    std::uint8_t region = kBorder;
    for (const Index v : t.vertex) {
      if (v == Triangulation2::kGhost) continue;
      if (v >= region_of_vertex_.size()) return kBorder;  // the first triangle came out of turn
      if (region == kBorder) region = region_of_vertex_[v];
      if (region != region_of_vertex_[v]) return kBorder;
    }
    return region;
  }

  std::vector<Region> make_regions(Index begin, std::span<const Index> ends) {
    std::vector<Region> regions;
    for (std::uint8_t r = 0; r < ends.size(); begin = ends[r++]) {
      Region& region = regions.emplace_back(Region{r, begin, ends[r], used_, used_});
      for (Index k = 0; k < kStarts; ++k) region.starts.push_back(start_in(region, k));
      used_ += 2 * (region.end - begin);
    }
    return regions;
  }

  static Index stretch_length(const Region& region) {
    return (region.end - region.begin) / kStarts + 1;
  }

  Index start_in(const Region& region, Index stretch) {
    const Index length = stretch_length(region);
    const Index middle = region.begin + stretch * length + length / 2;
    if (middle >= region.end) return kNoIndex;
    const Index t = inserters_[0].locate(middle);
    return owner(triangles_[t]) == region.number ? t : kNoIndex;
  }

  std::vector<Index> border_triangles() const {
    std::vector<Index> border;
    for (Index t = 0; t < used_; ++t)
      if (owner(triangles_[t]) == kBorder) border.push_back(t);
    return border;
  }

  // Marks the links into border triangles, or takes the marks away.
  void set_fence(std::span<const Index> border, std::uint32_t mark) {
    for (const Index t : border) {
      for (const std::uint32_t link : triangles_[t].link) {
        std::uint32_t& mirror = triangles_[link >> 3].link[link & 3];
        mirror = (mirror & ~Inserter::kFence) | mark;
      }
    }
  }

  // After each point that is deferred the walk starts afresh: a straight way from the last vertex
  // may lead over the fence again and again.
  void fill(Region& region, unsigned worker) {
    Inserter& inserter = inserters_[worker];
    bool is_lost = true;
    for (Index v = region.begin; v < region.end && go_on(worker, v); ++v) {
      if (is_first(v)) continue;
      if (is_lost) inserter.start_at(region.starts[(v - region.begin) / stretch_length(region)]);
      const Outcome outcome = inserter.insert(v, region.next, std::min(v + 1, region.end - 1));
      if (outcome == Outcome::kInserted) region.next += 2;
      if (outcome == Outcome::kTwin) region.duplicates.push_back({v, inserter.twin()});
      if (outcome == Outcome::kFenced) region.deferred.push_back(v);
      is_lost = outcome == Outcome::kFenced;
    }
  }

  // Makes one triangulation of what the regions left.
  void join(std::span<const Region> regions) {
    std::vector<Index> deferred, gaps;  // the first number of every pair that was not used
    for (const Region& region : regions) {
      deferred.insert(deferred.end(), region.deferred.begin(), region.deferred.end());
      duplicates_.insert(duplicates_.end(), region.duplicates.begin(), region.duplicates.end());
      for (Index t = region.next; t < region.first_new + 2 * (region.end - region.begin); t += 2)
        gaps.push_back(t);
    }
    inserters_[0].start_at(0);
    std::size_t filled = 0;
    for (std::size_t k = 0; k < deferred.size(); ++k) {
      const Index next = deferred[std::min(k + 1, deferred.size() - 1)];
      if (insert(deferred[k], gaps[filled], next)) ++filled;
    }
    close(std::span(gaps).subspan(filled));
    inserters_[0].start_at(0);
  }

  // Moves the last pairs of triangles into the gaps, which ascend.
  void close(std::span<const Index> gaps) {
    for (; !gaps.empty(); gaps = gaps.subspan(1)) {
      for (; !gaps.empty() && gaps.back() == used_ - 2; used_ -= 2)
        gaps = gaps.first(gaps.size() - 1);
      if (gaps.empty()) return;
      used_ -= 2;
      move(used_, gaps.front());
      move(used_ + 1, gaps.front() + 1);
    }
  }

  void move(Index from, Index to) {
    triangles_[to] = triangles_[from];
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t link = triangles_[to].link[i];
      triangles_[link >> 3].link[link & 3] = Inserter::packed_link(to, i);
    }
  }

  // No region owns a border triangle.
  static constexpr std::uint8_t kBorder = 255;

  LargeVector<Triangle>& triangles_;
  std::span<const Point2> points_;
  const Progress& progress_;
  std::atomic<bool> stopped_ = false;
  std::vector<Duplicate>& duplicates_;
  std::array<Index, 3> first_;       // the corners of the first triangle
  Index used_;                       // so many triangles are there
  std::vector<Inserter> inserters_;  // one a thread
  std::vector<std::uint8_t> region_of_vertex_;
};

}  // namespace

unsigned Delaunay2::region_count(std::size_t points) {
  constexpr std::size_t kOne = 1;
  return points < kOne << 15 ? 1 : points < kOne << 22 ? 2 : points < kOne << 24 ? 4 : 8;
}

bool Delaunay2::insert_in_order(const InsertionRuns& runs, const Options& options,
                                std::vector<Duplicate>& duplicates) {
  const Options useful{options.progress, std::min(options.threads, runs.regions)};
  BulkInsertion insertion(topology_.triangles_, std::span<const Point2>(points_), useful,
                          duplicates);
  return insertion.run(runs.ends, runs.regions);
}

}  // namespace wellspaced
