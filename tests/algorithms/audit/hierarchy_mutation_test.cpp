// Plants faults in clean hierarchies: each must be found by exactly the checks that should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "wellspaced/algorithms/audit/hierarchy_audit.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::Names;
using test::operator+;

struct Sequence {
  std::string name;
  std::vector<audit::HierarchyLevel> levels;
  std::vector<Index> fixed;
  double beta, factor;
};

using Fault = test::Fault<Sequence>;

Sequence coarsened(const std::string& name, const TriangleMesh& mesh, double beta, double factor) {
  CoarseningOptions options;
  options.beta = beta;
  options.factor = factor;
  const Hierarchy hierarchy = coarsen(mesh, options).value();
  Sequence sequence{name, {}, hierarchy.levels[0].mesh.fixed, beta, factor};
  for (const Level& level : hierarchy.levels)
    sequence.levels.push_back({level.mesh, level.origin, level.spacing});
  return sequence;
}

const std::vector<Sequence>& clean_sequences() {
  static const std::vector<Sequence> sequences = [] {
    std::vector<Sequence> all;
    const auto grid = generate_grid({.nx = 40, .ny = 40}).value();
    all.push_back(coarsened("grid", grid, 4, 2));
    for (const auto& [name, mesh] : test::clean_meshes())
      if (name == "random, larger" || name == "slit" || name == "thesis/airfoil1")
        all.push_back(coarsened(name, mesh, 25, 8));
    return all;
  }();
  return sequences;
}

audit::Report audit_of(const Sequence& sequence) {
  audit::HierarchyAuditOptions options;
  options.beta = sequence.beta;
  options.factor = sequence.factor;
  options.fixed = sequence.fixed;
  return audit::audit_hierarchy(sequence.levels, options);
}

// Consequences of another set of triangles or nodes on a level.
const Names kShape = {"gabriel", "boundary_gabriel", "circumcentres_inside", "euclidean_spacing"};

audit::HierarchyLevel& some_level(Sequence& sequence, Random& random) {
  return sequence.levels[1 + random.below(sequence.levels.size() - 1)];
}

std::set<Index> boundary_nodes(const TriangleMesh& mesh) {
  std::set<Index> nodes;
  for (const Segment& s : mesh.segments) nodes.insert({s.a, s.b});
  return nodes;
}

// A node by a unit in the last place aside, so that no triangle turns over.
bool move_node(Sequence& sequence, Random& random) {
  auto& level = some_level(sequence, random);
  Point2& p = level.mesh.points[random.below(level.mesh.points.size())];
  p.x = std::nextafter(p.x, 1e9);
  return true;
}

bool swap_origins(Sequence& sequence, Random& random) {
  auto& level = some_level(sequence, random);
  const std::size_t n = level.origin.size();
  const std::size_t i = random.below(n), j = random.below(n);
  if (level.mesh.points[i] == level.mesh.points[j]) return false;
  std::swap(level.origin[i], level.origin[j]);
  return true;
}

// A node that the level before has not, though the finest has.
bool skip_a_level(Sequence& sequence, Random&) {
  if (sequence.levels.size() < 3) return false;
  sequence.levels.insert(sequence.levels.begin() + 2, sequence.levels[0]);
  return true;
}

bool flip_an_edge(Sequence& sequence, Random& random) {
  TriangleMesh& mesh = some_level(sequence, random).mesh;
  for (std::size_t tries = 0; tries < 2000; ++tries) {
    auto& t = mesh.triangles[random.below(mesh.triangles.size())];
    auto& u = mesh.triangles[random.below(mesh.triangles.size())];
    const int i = static_cast<int>(random.below(3)), j = static_cast<int>(random.below(3));
    const Index a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], d = u[(j + 2) % 3];
    if (u[j] != b || u[(j + 1) % 3] != a) continue;
    const auto& p = mesh.points;
    if (incircle(p[a], p[b], p[c], p[d]) == 0) continue;
    if (orient2d(p[c], p[d], p[a]) * orient2d(p[c], p[d], p[b]) >= 0) continue;
    t = {c, a, d};
    u = {d, b, c};
    return true;
  }
  return false;
}

// Gives all segments of a marker, or of all but one, that of another.
bool lose_a_marker(Sequence& sequence, Random& random) {
  auto& level = some_level(sequence, random);
  if (level.mesh.segments.empty()) return false;
  const int lost = level.mesh.segments[random.below(level.mesh.segments.size())].marker;
  for (Segment& s : level.mesh.segments)
    if (s.marker == lost) s.marker = 77;
  return true;
}

bool fill_a_hole(Sequence& sequence, Random&) {
  // The coarsest level's hole, if it is a triangle: its edges in the other direction.
  TriangleMesh& mesh = sequence.levels.back().mesh;
  std::set<std::array<Index, 2>> rim;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) rim.insert({t[i], t[(i + 1) % 3]});
  for (const auto& [a, b] : rim) {
    if (rim.count({b, a}) > 0) continue;
    for (const auto& [c, d] : rim) {
      if (c != b || rim.count({d, c}) > 0 || rim.count({d, a}) == 0 || rim.count({a, d}) > 0)
        continue;
      mesh.triangles.push_back({b, a, d});
      return true;
    }
  }
  return false;
}

// Where all nodes are special points none of them is judged.
bool stretch_the_spacing(Sequence& sequence, Random& random) {
  auto& level = some_level(sequence, random);
  for (double& f : level.spacing) f *= 1000;
  return level.mesh.points.size() > sequence.fixed.size();
}

// One value rises to three times the largest that its neighbours allow along edges of the level.
bool raise_a_value(Sequence& sequence, Random& random) {
  auto& level = some_level(sequence, random);
  const auto v = static_cast<Index>(random.below(level.spacing.size()));
  double least = INFINITY;
  for (const auto& t : level.mesh.triangles)
    for (const Index w : t) {
      const Point2 p = level.mesh.points[v], q = level.mesh.points[w];
      if (w != v && std::count(t.begin(), t.end(), v) > 0)
        least = std::min(least, level.spacing[w] + std::hypot(p.x - q.x, p.y - q.y));
    }
  level.spacing[v] = 3 * least;
  return level.spacing.size() > 3;
}

bool lose_a_special_point(Sequence& sequence, Random& random) {
  // A special point that never was: a node of the finest level alone.
  const auto& last = sequence.levels.back().origin;
  for (int tries = 0; tries < 100; ++tries) {
    const Index v = static_cast<Index>(random.below(sequence.levels[0].mesh.points.size()));
    if (std::find(last.begin(), last.end(), v) != last.end()) continue;
    sequence.fixed.push_back(v);
    return true;
  }
  return false;
}

bool repeat_a_level(Sequence& sequence, Random&) {
  sequence.levels.push_back(sequence.levels.back());
  sequence.levels.back().spacing.clear();
  return true;
}

// A triangle on the rim goes, and an inner node becomes a boundary node.
bool cut_a_notch(Sequence& sequence, Random& random) {
  TriangleMesh& mesh = some_level(sequence, random).mesh;
  const std::set<Index> outer = boundary_nodes(mesh);
  std::set<std::array<Index, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert({t[i], t[(i + 1) % 3]});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Index a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      const Index c = mesh.triangles[t][(i + 2) % 3];
      if (edges.count({b, a}) > 0 || outer.count(c) > 0) continue;
      std::erase_if(mesh.segments, [&](const Segment& s) {
        return (s.a == a && s.b == b) || (s.a == b && s.b == a);
      });
      mesh.segments.push_back({b, c, 1});
      mesh.segments.push_back({c, a, 1});
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      return true;
    }
  return false;
}

std::vector<Fault> faults() {
  const Names sums = {"levels_valid", "levels_constrained_delaunay"};
  return {
      {"node moved by a unit in the last place",
       move_node,
       {"node_nested", "levels_valid"},
       kShape + Names{"fixed_nodes_kept", "constrained_delaunay", "delaunay",
                      "levels_constrained_delaunay", "graph_spacing", "no_hanging_node",
                      "no_overlap"}},
      {"origins swapped",
       swap_origins,
       {"node_nested", "levels_valid"},
       kShape + Names{"fixed_nodes_kept", "boundary_nested"}},
      {"finest level put in the middle",
       skip_a_level,
       {"node_nested", "fewer_nodes", "levels_valid"},
       kShape + Names{"graph_spacing", "graph_lipschitz", "boundary_nested"}},
      {"edge flipped on a level",
       flip_an_edge,
       {"constrained_delaunay", "delaunay", "levels_constrained_delaunay", "levels_valid"},
       kShape + Names{"graph_spacing"}},
      {"marker lost", lose_a_marker, {"markers_kept"}, {}},
      {"hole filled",
       fill_a_hole,
       {"holes_kept"},
       kShape + sums + Names{"delaunay", "constrained_delaunay"}},
      {"spacing a thousand times too large",
       stretch_the_spacing,
       {"graph_spacing", "euclidean_spacing"},
       {"graph_lipschitz"}},
      {"value raised to break Lipschitz in the graph",
       raise_a_value,
       {"graph_lipschitz"},
       {"graph_spacing", "euclidean_spacing"}},
      {"special point lost", lose_a_special_point, {"fixed_nodes_kept"}, {}},
      {"level repeated", repeat_a_level, {"fewer_nodes"}, {}},
      {"notch cut into a level",
       cut_a_notch,
       {"boundary_nested"},
       kShape + Names{"graph_spacing", "manifold_nodes", "no_unused_node"}},
  };
}

// Levels each selected from the finest mesh by itself: some nodes of one are not in the level
// before.
Sequence from_finest() {
  CoarseningOptions options;
  options.scheme = CoarseningScheme::kFromFinest;
  options.beta = 4, options.factor = 2;
  const auto grid = generate_grid({.nx = 30, .ny = 30}).value();
  const Hierarchy hierarchy = coarsen(grid, options).value();
  Sequence sequence{"from finest", {}, hierarchy.levels[0].mesh.fixed, 4, 2};
  for (const Level& level : hierarchy.levels)
    sequence.levels.push_back({level.mesh, level.origin, level.spacing});
  return sequence;
}

TEST(HierarchyNesting, IsRequiredUnlessItIsNotPromised) {
  const Sequence sequence = from_finest();
  const auto promised = audit::audit_hierarchy(sequence.levels);
  EXPECT_FALSE(promised.pass());
  EXPECT_TRUE(promised.check("node_nested")->required);
  EXPECT_EQ(promised.check("nodes_of_finest"), nullptr);

  const auto report =
      audit::audit_hierarchy(sequence.levels, {.nesting = audit::Nesting::kNotPromised});
  EXPECT_TRUE(report.pass());
  EXPECT_FALSE(report.check("node_nested")->required);
  EXPECT_FALSE(report.check("node_nested")->promised);
  EXPECT_EQ(report.check("node_nested")->violations, promised.check("node_nested")->violations);
  EXPECT_TRUE(report.check("nodes_of_finest")->pass());
}

TEST(HierarchyNesting, NotPromisedStillAsksForNodesOfTheFinestMesh) {
  Sequence sequence = from_finest();
  Point2& p = sequence.levels[2].mesh.points[7];
  p.x = std::nextafter(p.x, 1e9);
  const auto report =
      audit::audit_hierarchy(sequence.levels, {.nesting = audit::Nesting::kNotPromised});
  EXPECT_FALSE(report.pass());
  for (const audit::Check& check : report.checks)
    if (check.name == "nodes_of_finest")
      EXPECT_EQ(check.ids, check.level == 2 ? std::vector<Index>{7} : std::vector<Index>{});
}

TEST(HierarchyTheorems, HoldForCleanHierarchies) {
  for (const Sequence& sequence : clean_sequences()) {
    const auto report = audit_of(sequence);
    EXPECT_GE(report.theorems.size(), 3 * (sequence.levels.size() - 1)) << sequence.name;
    for (const auto& theorem : report.theorems)
      EXPECT_TRUE(theorem.holds || !theorem.applies())
          << sequence.name << " " << theorem.name << ": " << theorem.left << " " << theorem.right;
  }
}

TEST(HierarchyMeasures, TellTheCoarseningFunctionFromAnother) {
  Sequence sequence = clean_sequences()[0];
  const auto of_level_1 = [&](const char* name) {
    for (const auto& measure : audit_of(sequence).measures)
      if (measure.name == name && measure.level == Index{1}) return measure.value;
    return std::nan("");
  };
  EXPECT_NEAR(of_level_1("spacing_to_coarsened_min"), 1, 1e-12);
  EXPECT_NEAR(of_level_1("spacing_to_coarsened_max"), 1, 1e-12);
  sequence.levels[1].spacing[3] *= 0.5;
  EXPECT_NEAR(of_level_1("spacing_to_coarsened_min"), 0.5, 1e-12);
  EXPECT_NEAR(of_level_1("spacing_to_coarsened_max"), 1, 1e-12);
}

TEST(HierarchyMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  test::MutationTest<Sequence> table(audit_of, kShape);
  for (const Sequence& sequence : clean_sequences()) {
    EXPECT_TRUE(audit_of(sequence).pass()) << sequence.name;
    table.add_clean(sequence.name, sequence, 3);
  }
  table.run(faults(), 1);
}

}  // namespace
}  // namespace wellspaced
