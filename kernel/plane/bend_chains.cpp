#include "wellspaced/kernel/plane/bend_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {
namespace {

// Where a piece may be bent to: between its ends, so that the chain stays in order, or wherever a
// vertex is near.
enum class BendPlace { kBetween, kAnywhere };

// How often pieces may be bent, for each one at the start. A chain in order passes no vertex twice,
// so that bending ends by itself; this bounds it where chains are out of order.
constexpr std::size_t kBendsPerPiece = 64;

constexpr std::uint64_t kBendsAQuestion = 256;

// The double so many steps from x, or the last one on the way.
double stepped(double x, int steps, double towards) {
  for (; steps > 0; --steps) x = std::nextafter(x, towards);
  return x;
}

// Whether segment ab meets the box that reaches so many doubles from p to each side.
bool meets_box_of(Point2 a, Point2 b, Point2 p, int steps) {
  constexpr double kEnd = std::numeric_limits<double>::max();
  const Point2 low{stepped(p.x, steps, -kEnd), stepped(p.y, steps, -kEnd)};
  const Point2 high{stepped(p.x, steps, kEnd), stepped(p.y, steps, kEnd)};
  if (std::max(a.x, b.x) < low.x || std::max(a.y, b.y) < low.y) return false;
  if (high.x < std::min(a.x, b.x) || high.y < std::min(a.y, b.y)) return false;
  bool some_left = false, some_right = false;
  for (const Point2 corner : {low, Point2{high.x, low.y}, high, Point2{low.x, high.y}}) {
    const int side = orient2d(a, b, corner);
    some_left |= side >= 0;
    some_right |= side <= 0;
  }
  return some_left && some_right;
}

// Whether p comes before q in the direction from a to b: by the coordinate in which these differ
// more, then by the other. Points on the segment keep this order when they are rounded to nearest.
bool precedes_along(Point2 a, Point2 b, Point2 p, Point2 q) {
  const auto less = [](double from, double to, double direction) {
    return direction < 0 ? to < from : from < to;
  };
  const double dx = b.x - a.x, dy = b.y - a.y;
  if (std::fabs(dx) < std::fabs(dy)) return p.y != q.y ? less(p.y, q.y, dy) : less(p.x, q.x, dx);
  return p.x != q.x ? less(p.x, q.x, dx) : less(p.y, q.y, dy);
}

class ChainBender {
 public:
  ChainBender(Delaunay2& delaunay, std::span<const Segment> segments)
      : delaunay_(delaunay), segments_(segments) {}

  Result<SegmentEdges> run(const std::vector<std::vector<Index>>& chains, const Progress& progress);

 private:
  using Ends = std::array<Index, 2>;
  struct Piece {
    Index segment;
    Ends ends;
  };

  void wait_for(const std::vector<Index>& chain, Index segment);
  Status lay(const Piece& piece);
  bool bend(const Piece& piece, Ends edge);
  bool can_pass(std::span<const Index> segments, Index v, Ends ends, int steps,
                BendPlace place) const;
  void wait_for_halves(Index segment, Ends ends, Index v);
  SegmentEdges edges() const;

  Delaunay2& delaunay_;
  std::span<const Segment> segments_;
  std::vector<Piece> waiting_;                      // the next one last
  std::map<Ends, std::vector<Index>> segments_of_;  // of each constrained edge
  std::size_t bends_left_ = 0;
};

// Puts the pieces of a chain in line, but for those whose ends have become one vertex.
void ChainBender::wait_for(const std::vector<Index>& chain, Index segment) {
  for (std::size_t i = chain.size() - 1; i-- > 0;) {
    const Ends ends{delaunay_.representative(chain[i]), delaunay_.representative(chain[i + 1])};
    if (ends[0] != ends[1]) waiting_.push_back({segment, ends});
  }
}

void ChainBender::wait_for_halves(Index segment, Ends ends, Index v) {
  waiting_.push_back({segment, {v, ends[1]}});
  waiting_.push_back({segment, {ends[0], v}});
}

// Whether v lies so near to all the segments, which share a piece, and where the place demands it
// between the piece's ends.
bool ChainBender::can_pass(std::span<const Index> segments, Index v, Ends ends, int steps,
                           BendPlace place) const {
  const std::vector<Point2>& p = delaunay_.points();
  const auto is_between = [&](Point2 a, Point2 b) {
    const bool forward = precedes_along(a, b, p[ends[0]], p[ends[1]]);
    return precedes_along(a, b, p[ends[0]], p[v]) == forward &&
           precedes_along(a, b, p[v], p[ends[1]]) == forward;
  };
  return all_of(segments, [&](Index s) {
    const Point2 a = p[segments_[s].a], b = p[segments_[s].b];
    return (place == BendPlace::kAnywhere || is_between(a, b)) && meets_box_of(a, b, p[v], steps);
  });
}

// Bends the piece through an end of the constrained edge that it crosses, or the edge through an
// end of the piece: whichever is nearest to the segments.
bool ChainBender::bend(const Piece& piece, Ends edge) {
  const auto found = segments_of_.find(edge);
  for (const BendPlace place : {BendPlace::kBetween, BendPlace::kAnywhere})
    for (const int steps : {0, 1, 2}) {
      for (const Index v : edge) {
        if (!can_pass({&piece.segment, 1}, v, piece.ends, steps, place)) continue;
        wait_for_halves(piece.segment, piece.ends, v);
        return true;
      }
      for (const Index v : piece.ends) {
        if (!can_pass(found->second, v, edge, steps, place)) continue;
        delaunay_.remove_constraint(delaunay_.find_edge(edge[0], edge[1]));
        waiting_.push_back(piece);
        for (const Index s : found->second) wait_for_halves(s, edge, v);
        segments_of_.erase(found);
        return true;
      }
    }
  return false;
}

// Makes a piece an edge, or edges between the vertices on it; or bends what it crosses, or itself.
Status ChainBender::lay(const Piece& piece) {
  const Result<std::vector<Index>> path = delaunay_.insert_constraint(piece.ends[0], piece.ends[1]);
  if (path) {
    for (std::size_t i = 0; i + 1 < path->size(); ++i) {
      const auto [low, high] = std::minmax((*path)[i], (*path)[i + 1]);
      segments_of_[{low, high}].push_back(piece.segment);
    }
    return Ok{};
  }
  const auto [low, high] = std::minmax(path.error().ids[2], path.error().ids[3]);
  const Index s = piece.segment, t = segments_of_[{low, high}].front();
  if (bends_left_-- > 0 && bend(piece, {low, high})) return Ok{};
  return Error{ErrorCode::kInvalidGeometry,
               {"segments ", s, " and ", t,
                " meet where no vertex within two doubles was found to bend them apart; scale "
                "the input up to whole numbers, or move one of them"},
               {s, t}};
}

SegmentEdges ChainBender::edges() const {
  SegmentEdges edges(segments_.size());
  for (const auto& [ends, segments] : segments_of_)
    for (const Index s : segments) edges[s].push_back(ends);
  return edges;
}

Result<SegmentEdges> ChainBender::run(const std::vector<std::vector<Index>>& chains,
                                      const Progress& progress) {
  for (Index s = static_cast<Index>(chains.size()); s-- > 0;) wait_for(chains[s], s);
  bends_left_ = kBendsPerPiece * waiting_.size();
  ProgressMeter meter(progress, "bend", 0, kBendsAQuestion);
  while (!waiting_.empty()) {
    if (!meter.step()) return cancelled();
    const Piece piece = waiting_.back();
    waiting_.pop_back();
    if (Status status = lay(piece); !status) return status.error();
  }
  return edges();
}

}  // namespace

Result<SegmentEdges> bend_chains(Delaunay2& delaunay, std::span<const Segment> segments,
                                 const std::vector<std::vector<Index>>& chains,
                                 const Progress& progress) {
  return ChainBender(delaunay, segments).run(chains, progress);
}

}  // namespace wellspaced
