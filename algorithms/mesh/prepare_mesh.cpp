#include "wellspaced/algorithms/mesh/prepare_mesh.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "wellspaced/algorithms/mesh/coincident_points.hpp"
#include "wellspaced/algorithms/mesh/directed_edges.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using Triangle = std::array<Index, 3>;

// One preparation: the mesh, and how messages count.
class Preparer {
 public:
  Preparer(TriangleMesh& mesh, Index base, const Progress& progress)
      : mesh_(mesh), base_(base), parts_(progress, "check", 4) {}

  Result<MeshPreparation> run();

 private:
  Status go_on(std::uint64_t parts);
  Status check_indices() const;
  Status orient();
  Status check_edges(const DirectedEdges& edges) const;
  Status check_segments(const DirectedEdges& edges);
  void drop_repeated_segments();
  void recover_boundary(std::span<const DirectedEdges::Edge> boundary);
  Status check_coincidences(std::span<const DirectedEdges::Edge> boundary);

  std::uint64_t number(Index i) const { return std::uint64_t{i} + base_; }
  std::string name(Index t) const {
    const auto [a, b, c] = mesh_.triangles[t];
    return concat({"triangle ", number(t), " (", number(a), ", ", number(b), ", ", number(c), ")"});
  }
  std::string name(Index a, Index b) const { return concat({number(a), "-", number(b)}); }
  int orientation(Index t) const {
    const auto [a, b, c] = mesh_.triangles[t];
    return orient2d(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }
  static Error invalid(std::string message, std::vector<Index> ids) {
    return {ErrorCode::kInvalidGeometry, std::move(message), std::move(ids)};
  }

  TriangleMesh& mesh_;
  Index base_;
  ProgressParts parts_;
  MeshPreparation found_;
};

// Tells how many of the parts of run() are done.
Status Preparer::go_on(std::uint64_t parts) {
  if (parts_.go_on(parts)) return Ok{};
  return cancelled();
}

Status Preparer::check_indices() const {
  const std::size_t points = mesh_.points.size();
  for (Index t = 0; t < mesh_.triangles.size(); ++t)
    for (const Index v : mesh_.triangles[t])
      if (v >= points)
        return invalid(concat({"triangle ", number(t), " names point ", number(v),
                               ", but there are ", points, " points"}),
                       {t});
  for (Index s = 0; s < mesh_.segments.size(); ++s)
    if (const Index v = std::max(mesh_.segments[s].a, mesh_.segments[s].b); v >= points)
      return invalid(concat({"segment ", number(s), " names point ", number(v), ", but there are ",
                             points, " points"}),
                     {s});
  return Ok{};
}

Status Preparer::orient() {
  const auto count = static_cast<Index>(mesh_.triangles.size());
  const int first = count == 0 ? 1 : orientation(0);
  for (Index t = 0; t < count; ++t) {
    const int sign = orientation(t);
    if (sign == 0)
      return invalid(concat({name(t), " has no area; remove it or move a corner"}), {t});
    if (sign != first)
      return invalid(concat({name(t), " is ", sign > 0 ? "counter-" : "", "clockwise, but ",
                             name(0), " is not; orient all the same way"}),
                     {t, 0});
  }
  found_.turned = first < 0;
  if (found_.turned)
    for (Triangle& t : mesh_.triangles) std::swap(t[1], t[2]);
  return Ok{};
}

Status Preparer::check_edges(const DirectedEdges& edges) const {
  const auto conflict = edges.find_conflict();
  if (!conflict) return Ok{};
  const auto& [edge, t, other] = *conflict;
  return invalid(concat({"edge ", name(edge[0], edge[1]), " has triangles ", number(t), " and ",
                         number(other), " on the same side; remove one of them"}),
                 {t, other});
}

Status Preparer::check_segments(const DirectedEdges& edges) {
  const Progress progress = parts_.part(2);
  ProgressMeter meter(progress, "check", mesh_.segments.size());
  for (Index s = 0; s < mesh_.segments.size(); ++s) {
    if (!meter.step()) return go_on(2);
    const auto [a, b, marker] = mesh_.segments[s];
    if (!edges.has_edge(a, b))
      return invalid(concat({"segment ", number(s), " (", name(a, b),
                             ") is no edge of a triangle; remove it or mesh along it"}),
                     {s});
  }
  return Ok{};
}

std::pair<Index, Index> ends(const Segment& s) { return std::minmax(s.a, s.b); }

void Preparer::drop_repeated_segments() {
  std::vector<Index> order(mesh_.segments.size());
  for (Index s = 0; s < order.size(); ++s) order[s] = s;
  const auto key = [&](Index s) { return std::pair(ends(mesh_.segments[s]), s); };
  sort(order, [&](Index s, Index t) { return key(s) < key(t); });
  std::vector<char> repeated(order.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
    repeated[order[i]] = ends(mesh_.segments[order[i]]) == ends(mesh_.segments[order[i - 1]]);
  std::size_t kept = 0;
  for (std::size_t s = 0; s < order.size(); ++s)
    if (repeated[s] == 0) mesh_.segments[kept++] = mesh_.segments[s];
  found_.repeated_segments = static_cast<Index>(order.size() - kept);
  mesh_.segments.resize(kept);
}

void Preparer::recover_boundary(std::span<const DirectedEdges::Edge> boundary) {
  std::vector<std::pair<Index, Index>> listed;
  for (const Segment& s : mesh_.segments) listed.push_back(ends(s));
  sort(listed);
  for (const auto& [from, to] : boundary)
    if (!std::binary_search(listed.begin(), listed.end(), ends({from, to})))
      mesh_.segments.push_back({from, to, 1});
  found_.recovered_segments = static_cast<Index>(mesh_.segments.size() - listed.size());
}

// A boundary edge between classes of coincident points.
struct ClassEdge {
  std::pair<Index, Index> classes;  // of from and to
  Index from, to;
};

bool operator<(const ClassEdge& a, const ClassEdge& b) {
  return std::tuple(a.classes, a.from, a.to) < std::tuple(b.classes, b.from, b.to);
}

// Marks the points that have a partner across a slit: a boundary edge from -> to faces a boundary
// edge that runs the other way between points that coincide with `to` and `from`.
std::vector<char> find_slit_points(std::span<const DirectedEdges::Edge> boundary,
                                   std::span<const Index> first) {
  std::vector<ClassEdge> edges;
  for (const auto& [from, to] : boundary) edges.push_back({{first[from], first[to]}, from, to});
  sort(edges);
  std::vector<char> paired(first.size(), 0);
  for (const ClassEdge& edge : edges) {
    const std::pair facing(edge.classes.second, edge.classes.first);
    const auto found =
        std::lower_bound(edges.begin(), edges.end(), facing,
                         [](const ClassEdge& e, auto key) { return e.classes < key; });
    if (found == edges.end() || found->classes != facing) continue;
    if (found->to != edge.from) paired[edge.from] = 1;
    if (found->from != edge.to) paired[edge.to] = 1;
  }
  return paired;
}

Status Preparer::check_coincidences(std::span<const DirectedEdges::Edge> boundary) {
  std::vector<char> used(mesh_.points.size(), 0);
  for (const Triangle& t : mesh_.triangles)
    for (const Index v : t) used[v] = 1;
  found_.unused_points = static_cast<Index>(std::count(used.begin(), used.end(), 0));

  const std::vector<Index> first = first_coincident(mesh_.points);
  const std::vector<char> paired = find_slit_points(boundary, first);
  found_.slit_points = static_cast<Index>(std::count(paired.begin(), paired.end(), 1));
  std::vector<Index> last_used(mesh_.points.size(), kNoIndex);  // by class
  for (Index v = 0; v < mesh_.points.size(); ++v) {
    if (used[v] == 0) continue;
    const Index other = std::exchange(last_used[first[v]], v);
    if (other == kNoIndex || (paired[v] != 0 && paired[other] != 0)) continue;
    return invalid(concat({"points ", number(other), " and ", number(v),
                           " coincide, but are no pair across a slit; merge them"}),
                   {other, v});
  }
  return Ok{};
}

Result<MeshPreparation> Preparer::run() {
  if (Status status = check_indices(); !status) return status.error();
  if (Status status = orient(); !status) return status.error();
  if (Status status = go_on(1); !status) return status.error();
  const DirectedEdges edges(mesh_.triangles);
  if (Status status = go_on(2); !status) return status.error();
  if (Status status = check_edges(edges); !status) return status.error();
  if (Status status = check_segments(edges); !status) return status.error();
  const std::vector<DirectedEdges::Edge> boundary = edges.boundary();
  if (Status status = go_on(3); !status) return status.error();
  if (Status status = check_coincidences(boundary); !status) return status.error();
  drop_repeated_segments();
  recover_boundary(boundary);
  if (Status status = go_on(4); !status) return status.error();
  return found_;
}

}  // namespace

Result<MeshPreparation> prepare_mesh(TriangleMesh& mesh, Index base, const Progress& progress) {
  return Preparer(mesh, base, progress).run();
}

}  // namespace wellspaced
