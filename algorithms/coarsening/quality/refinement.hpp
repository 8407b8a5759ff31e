// Delaunay refinement whose new points are nodes of the finest mesh.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/quality/editable_level.hpp"
#include "wellspaced/algorithms/coarsening/quality/triangle_shape.hpp"
#include "wellspaced/kernel/graph.hpp"

namespace wellspaced {

/// The node that a walk from `start` to ever nearer neighbours ends at. Cost: the nodes passed.
Index nearest_along_edges(const Graph& graph, std::span<const Point2> points, Index start,
                          Point2 place);

/// spacing: how far apart nodes should be, one value > 0 a node of the finest mesh.
/// least_sine_sq: the squared sine of the angle that triangles should have at least.
/// seed: varies the priorities by up to 5%.
struct RefinementGoals {
  std::span<const double> spacing;
  double least_sine_sq = 0;
  std::uint64_t seed = 1;
};

/// Adds nodes to a level: near the circumcentres of its triangles, or, where the boundary is in the
/// way, in the middle of what a boundary edge hides. (Chew's and Ruppert's refinement, but no point
/// is free: a node may be missing where it is needed, so nothing is guaranteed.)
class Refinement {
 public:
  using KeepGoing = std::function<bool()>;

  /// Requires: graph, of the finest mesh, level and the goals' spacing outlive the refinement;
  /// meanwhile nobody else edits the level.
  Refinement(const Graph& graph, EditableLevel& level, const RefinementGoals& goals);

  /// Adds nodes where the level is coarsest against the spacing, until it has `nodes` or nothing is
  /// left to do. Stops early when told to.
  void grow(std::size_t nodes, const KeepGoing& keep_going);

  /// Adds nodes to triangles with too small an angle, the worst first, until none is left that it
  /// helps, or the level has `nodes`. Stops early when told to.
  void mend(std::size_t nodes, const KeepGoing& keep_going);

 private:
  // A triangle, or a boundary edge (triangle == kNoIndex, two vertices), and the node it calls for.
  struct Candidate {
    double urgency = 0;
    Index node = 0;
    Index triangle = kNoIndex;
    std::array<Index, 3> vertices{};

    friend bool operator<(const Candidate& a, const Candidate& b) {
      if (a.urgency != b.urgency) return a.urgency < b.urgency;
      return std::pair{a.node, a.vertices} > std::pair{b.node, b.vertices};
    }
  };
  using Queue = std::priority_queue<Candidate>;
  enum class Reason { kSize, kAngle };

  void work_off(Queue& queue, Reason reason, std::size_t nodes, const KeepGoing& keep_going);
  bool is_there(const Candidate& candidate) const;
  void attend(const Candidate& candidate, Reason reason);
  void attend_triangle(const Candidate& candidate, Reason reason);
  void insert_at(const Candidate& candidate, const EditableLevel::Site& site, double keep_off_sq);
  bool split(EditableLevel::Wall wall);
  bool split_towards(Point2 place, Index triangle);
  std::optional<EditableLevel::Wall> first_wall_towards(Point2 place, Index triangle) const;
  Index nearest_node(std::span<const Index> vertices, Point2 place) const;
  void note_touched();
  void note_triangle(Index triangle);
  void note_wall(EditableLevel::Wall wall);
  double urgency(double radius, double spacing, Index node) const;
  double mean_spacing(std::span<const Index> vertices) const;

  const Graph& graph_;
  EditableLevel& level_;
  RefinementGoals goals_;
  Queue coarse_, thin_;
};

}  // namespace wellspaced
