#include "wellspaced/algorithms/coarsening/quality/node_exchange.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "wellspaced/algorithms/coarsening/quality/refinement.hpp"
#include "wellspaced/algorithms/coarsening/quality/triangle_shape.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr int kMostPasses = 4;

// A node to take away and one to add; kNoIndex: none.
struct Exchange {
  Index out = kNoIndex, in = kNoIndex;
};

using Nodes = std::array<Index, 3>;

class Exchanger {
 public:
  Exchanger(const Graph& graph, EditableLevel& level, const ExchangeGoals& goals)
      : graph_(graph), level_(level), goals_(goals) {}

  /// The nodes of the triangles with too small an angle, the worst first.
  std::vector<Nodes> thin_triangles() const;
  /// Makes the best exchange for a triangle, if one helps and the triangle is still there.
  bool improve(const Nodes& nodes);

 private:
  Index find(const Nodes& nodes) const;
  double sine_sq(Index triangle) const;
  std::vector<Exchange> proposals(const Nodes& nodes, Index triangle) const;
  bool is_allowed(const Exchange& exchange) const;
  bool make(const Exchange& exchange);
  double worst_after(const Exchange& exchange);
  Index hint() const { return level_.triangulation().edge_from(anchor_).triangle; }

  const Graph& graph_;
  EditableLevel& level_;
  const ExchangeGoals& goals_;
  std::vector<Index> touched_;
  Index anchor_ = 0;  // a vertex near by that stays
};

double Exchanger::sine_sq(Index triangle) const {
  const Delaunay2& delaunay = level_.triangulation();
  return shape_of(delaunay, delaunay.topology().vertices(triangle)).sine_sq();
}

std::vector<Nodes> Exchanger::thin_triangles() const {
  struct Thin {
    double sine_sq = 0;
    Nodes nodes{};
  };
  std::vector<Thin> thin;
  const Triangulation2& topology = level_.triangulation().topology();
  for (Index t = 0; t < topology.size(); ++t) {
    if (!level_.is_inside(t)) continue;
    const double value = sine_sq(t);
    const auto& v = topology.vertices(t);
    if (value < goals_.least_sine_sq)
      thin.push_back({value, {level_.node(v[0]), level_.node(v[1]), level_.node(v[2])}});
  }
  std::ranges::sort(thin, {}, [](const Thin& t) { return std::pair{t.sine_sq, t.nodes}; });
  std::vector<Nodes> list;
  for (const Thin& t : thin) list.push_back(t.nodes);
  return list;
}

// The triangle with these nodes in this order, or kNoIndex.
Index Exchanger::find(const Nodes& nodes) const {
  if (!std::ranges::all_of(nodes, [&](Index v) { return level_.has(v); })) return kNoIndex;
  const Delaunay2& delaunay = level_.triangulation();
  const auto e = delaunay.find_edge(level_.vertex(nodes[0]), level_.vertex(nodes[1]));
  const bool is_there =
      e.triangle != kNoIndex && delaunay.topology().apex(e) == level_.vertex(nodes[2]);
  return is_there ? e.triangle : kNoIndex;
}

std::vector<Exchange> Exchanger::proposals(const Nodes& nodes, Index triangle) const {
  std::vector<Exchange> list;
  const auto propose_around = [&](Index out, Index node) {
    for (const Graph::Arc& arc : graph_.arcs_of(node)) list.push_back({out, arc.target});
  };
  for (const Index out : nodes) {
    list.push_back({out, kNoIndex});
    propose_around(out, out);
  }
  const Delaunay2& delaunay = level_.triangulation();
  const Circle circle = shape_of(delaunay, delaunay.topology().vertices(triangle)).circle;
  std::vector<Index> near;
  for (const Index v : nodes)
    near.push_back(nearest_along_edges(graph_, level_.finest_points(), v, circle.centre));
  sort_unique(near);
  for (const Index v : near) {
    list.push_back({kNoIndex, v});
    propose_around(kNoIndex, v);
  }
  return list;
}

bool Exchanger::is_allowed(const Exchange& exchange) const {
  const bool takes = exchange.out != kNoIndex, adds = exchange.in != kNoIndex;
  if (takes && goals_.stays[exchange.out]) return false;
  if (adds && level_.has(exchange.in)) return false;
  if (takes && !adds) return level_.size() > goals_.least_nodes;
  return takes || level_.size() < goals_.most_nodes;
}

// Leaves the vertices at the triangles it made in touched_.
bool Exchanger::make(const Exchange& exchange) {
  touched_.clear();
  if (exchange.out != kNoIndex) {
    if (!level_.remove(exchange.out)) return false;
    touched_.assign(level_.touched().begin(), level_.touched().end());
  }
  if (exchange.in == kNoIndex) return true;
  if (!level_.add(exchange.in, hint())) {
    if (exchange.out != kNoIndex) level_.add(exchange.out, hint());
    return false;
  }
  touched_.insert(touched_.end(), level_.touched().begin(), level_.touched().end());
  sort_unique(touched_);
  return true;
}

// The squared sine of the smallest angle that an exchange would make; it is made and unmade.
double Exchanger::worst_after(const Exchange& exchange) {
  if (!make(exchange)) return 0;
  double worst = 1;
  for (const Index t : level_.triangles_among(touched_))
    if (level_.is_inside(t)) worst = std::min(worst, sine_sq(t));
  make({exchange.in, exchange.out});
  return worst;
}

bool Exchanger::improve(const Nodes& nodes) {
  const Index triangle = find(nodes);
  if (triangle == kNoIndex) return false;
  double best = sine_sq(triangle);
  Exchange choice;
  for (const Exchange& exchange : proposals(nodes, triangle)) {
    if (!is_allowed(exchange)) continue;
    anchor_ = level_.vertex(nodes[nodes[0] == exchange.out ? 1 : 0]);
    const double worst = worst_after(exchange);
    if (worst <= best) continue;
    best = worst;
    choice = exchange;
  }
  if (choice.out == kNoIndex && choice.in == kNoIndex) return false;
  anchor_ = level_.vertex(nodes[nodes[0] == choice.out ? 1 : 0]);
  return make(choice);
}

}  // namespace

std::size_t exchange_nodes(const Graph& graph, EditableLevel& level, const ExchangeGoals& goals,
                           const std::function<bool()>& keep_going) {
  Exchanger exchanger(graph, level, goals);
  std::size_t changes = 0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const std::size_t before = changes;
    for (const Nodes& nodes : exchanger.thin_triangles()) {
      if (!keep_going()) return changes;
      changes += exchanger.improve(nodes);
    }
    if (changes == before) break;
  }
  return changes;
}

}  // namespace wellspaced
