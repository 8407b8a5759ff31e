#include "wellspaced/kernel/space/triangulation3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/kernel/space/star_filler3.hpp"

namespace wellspaced {
namespace {

constexpr Index kGhost = Triangulation3::kGhost;

TEST(Triangulation3, OneTetHasAGhostBehindEveryFacet) {
  Triangulation3 topology;
  topology.reset(0, 1, 2, 3);
  EXPECT_EQ(topology.size(), 5u);
  EXPECT_TRUE(topology.is_valid());
  for (unsigned i = 0; i < 4; ++i) EXPECT_TRUE(topology.is_ghost(topology.neighbor(0, i)));
}

TEST(Triangulation3, MirroringAFacetTwiceGivesItBack) {
  Triangulation3 topology;
  topology.reset(4, 1, 2, 3);
  for (Index t = 0; t < 5; ++t)
    for (unsigned i = 0; i < 4; ++i)
      EXPECT_EQ(topology.mirror(topology.mirror({t, i})), (Triangulation3::Facet{t, i}));
}

TEST(Triangulation3, VerticesAreRenumberedButNotTheGhost) {
  Triangulation3 topology;
  topology.reset(0, 1, 2, 3);
  topology.renumber_vertices({7, 5, 6, 4});
  EXPECT_EQ(topology.vertices(0), (std::array<Index, 4>{7, 5, 6, 4}));
  EXPECT_EQ(topology.vertex(1, 3), kGhost);
  EXPECT_TRUE(topology.is_valid());
}

// All facets between the tets of the list and the others.
Triangulation3::Cavity cavity_of(const Triangulation3& topology, std::vector<Index> tets) {
  Triangulation3::Cavity cavity{std::move(tets), {}};
  for (const Index t : cavity.tets)
    for (unsigned i = 0; i < 4; ++i)
      if (std::count(cavity.tets.begin(), cavity.tets.end(), topology.neighbor(t, i)) == 0)
        cavity.rim.push_back({topology.vertices(t), topology.links(t)[i], i});
  return cavity;
}

// Fills a cavity as an insertion does: new tets get the numbers of those that vanish, then new
// ones; numbers that are left over go to the last tets.
void fill(StarFiller3& filler, Triangulation3& topology, Triangulation3::Cavity& cavity,
          Index apex) {
  const std::size_t new_tets = cavity.rim.size();
  while (cavity.tets.size() < new_tets) cavity.tets.push_back(topology.append(1));
  filler.fill(topology, cavity, apex);
  topology.remove(std::span(cavity.tets).subspan(new_tets));
}

TEST(StarFiller3, SplitsATetIntoFour) {
  Triangulation3 topology;
  topology.reset(0, 1, 2, 3);
  StarFiller3 filler;
  filler.reserve_vertices(5);
  auto cavity = cavity_of(topology, {0});
  fill(filler, topology, cavity, 4);
  EXPECT_EQ(topology.size(), 8u);
  EXPECT_TRUE(topology.is_valid());
  EXPECT_EQ(cavity.tets, (std::vector<Index>{0, 5, 6, 7}));
}

TEST(StarFiller3, LeavesTetsBehindThatVanish) {
  Triangulation3 topology;
  topology.reset(0, 1, 2, 3);
  StarFiller3 filler;
  filler.reserve_vertices(7);
  auto cavity = cavity_of(topology, {0});
  fill(filler, topology, cavity, 4);
  cavity = cavity_of(topology, {0});
  fill(filler, topology, cavity, 5);
  ASSERT_EQ(topology.size(), 11u);  // 7 within the first tet, 4 ghosts, some numbered in between
  std::vector<Index> real;
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) real.push_back(t);
  cavity = cavity_of(topology, real);
  fill(filler, topology, cavity, 6);
  EXPECT_EQ(topology.size(), 8u);
  EXPECT_TRUE(topology.is_valid());
}

TEST(Triangulation3, AGhostAtAnotherCornerIsNotValid) {
  Triangulation3 topology;
  topology.reset(0, 1, 2, 3);
  topology.renumber_vertices({kGhost, 1, 2, 3});
  EXPECT_FALSE(topology.is_valid());
}

}  // namespace
}  // namespace wellspaced
