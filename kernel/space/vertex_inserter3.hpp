// One insertion into a Delaunay triangulation of space. Used by Delaunay3.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/space/cavity_search3.hpp"
#include "wellspaced/kernel/space/star_filler3.hpp"
#include "wellspaced/kernel/space/triangulation3.hpp"

namespace wellspaced {

/// What it takes to insert a vertex: the search for its cavity, and what fills that.
struct VertexInserter3 {
  /// A tet that was given another number.
  struct Move {
    Index from = 0, to = 0;
  };

  CavitySearch3 search;
  StarFiller3 filler;
  /// Of the last insertion. Its tets are those that are new or have a new number.
  Triangulation3::Cavity cavity;
  /// The tets that the last insertion renumbered, one after the other.
  std::vector<Move> moves;

  /// Makes point v a vertex.
  /// Requires: the triangulation is Delaunay; tet t is in conflict with the point; the filler has
  /// room for v.
  /// Errors: kLimit beyond max_tets; then nothing has changed.
  Status insert(Triangulation3& topology, std::span<const Point3> points, Index v, Index t,
                Index max_tets);

  /// The second half of insert(): makes v a vertex whose cavity the search has found.
  Status fill(Triangulation3& topology, Index v, Index max_tets);
};

}  // namespace wellspaced
