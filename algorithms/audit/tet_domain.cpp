#include "wellspaced/algorithms/audit/tet_domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/open_facets.hpp"
#include "wellspaced/algorithms/audit/rounding_box.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

using NodePair = std::pair<Index, Index>;  // the lower node first

NodePair node_pair(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

double distance_sq(Point3 a, Point3 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
}

Point2 in_xy(Point3 p) { return {p.x, p.y}; }
Point2 in_yz(Point3 p) { return {p.y, p.z}; }
Point2 in_zx(Point3 p) { return {p.z, p.x}; }

bool near_line(Point3 a, Point3 b, Point3 p, double units) {
  const Point3 half = rounding_box(a, b, units);
  const auto near_in = [&](auto view) {
    return vanishes_near(p, half, [&](Point3 q) { return orient2d(view(a), view(b), view(q)); });
  };
  return near_in(in_xy) && near_in(in_yz) && near_in(in_zx);
}

// How far along from a to b the points are: by the coordinate in which a and b differ most.
class Along {
 public:
  Along(Point3 a, Point3 b) {
    const double extents[] = {b.x - a.x, b.y - a.y, b.z - a.z};
    for (int i = 1; i < 3; ++i)
      if (std::fabs(extents[i]) > std::fabs(extents[axis_])) axis_ = i;
    sign_ = extents[axis_] < 0 ? -1 : 1;
  }
  double operator()(Point3 p) const { return sign_ * (axis_ == 0 ? p.x : axis_ == 1 ? p.y : p.z); }

 private:
  int axis_ = 0;
  double sign_ = 1;
};

// The tets around each node, and the nodes sorted by place.
class MeshIndex {
 public:
  explicit MeshIndex(const TetMesh& mesh)
      : mesh_(mesh), first_(mesh.points.size() + 1, 0), tets_(4 * mesh.tets.size()) {
    for (const auto& tet : mesh.tets)
      for (const Index v : tet) ++first_[v];
    Index sum = 0;
    for (Index& first : first_) first = sum += first;
    for (Index i = 0; i < tets_.size(); ++i) tets_[--first_[mesh.tets[i / 4][i % 4]]] = i / 4;
    nodes_.resize(mesh.points.size());
    std::iota(nodes_.begin(), nodes_.end(), Index{0});
    sort(nodes_, [&](Index v, Index w) { return key(mesh.points[v]) < key(mesh.points[w]); });
  }

  // Some node at a place that is in a tet, or else some node there, or kNoIndex.
  Index node_at(Point3 p) const {
    auto at = std::partition_point(nodes_.begin(), nodes_.end(),
                                   [&](Index v) { return key(mesh_.points[v]) < key(p); });
    Index found = kNoIndex;
    for (; at != nodes_.end() && mesh_.points[*at] == p; ++at)
      if (found == kNoIndex || tets_around(found).empty()) found = *at;
    return found;
  }

  std::span<const Index> tets_around(Index v) const {
    return {tets_.data() + first_[v], tets_.data() + first_[v + 1]};
  }

  // Calls visit(face) for the faces on an edge; a face between two tets is visited from both.
  template <class Visit>
  void for_each_face_on(NodePair edge, Visit visit) const {
    for (const Index t : tets_around(edge.first))
      for (Index f = 4 * t; f < 4 * t + 4; ++f) {
        const Face nodes = face_nodes(mesh_.tets, f);
        if (has(nodes, edge.first) && has(nodes, edge.second)) visit(f);
      }
  }

 private:
  static std::array<double, 3> key(Point3 p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }
  static bool has(const Face& nodes, Index v) { return is_among(v, nodes); }

  const TetMesh& mesh_;
  std::vector<Index> first_, tets_, nodes_;
};

// The mesh edges along the segment from a to b; empty if there is no such chain.
std::vector<NodePair> chain_along(const TetMesh& mesh, const MeshIndex& index, Point3 a, Point3 b,
                                  double units) {
  const Along along(a, b);
  std::vector<NodePair> chain;
  Index at = index.node_at(a);
  while (at != kNoIndex && mesh.points[at] != b && chain.size() < mesh.points.size()) {
    const double here = along(mesh.points[at]);
    double there = along(b);
    Index next = kNoIndex;
    for (const Index t : index.tets_around(at))
      for (const Index w : mesh.tets[t]) {
        const Point3 p = mesh.points[w];
        const bool is_end = next == kNoIndex && p == b;
        const bool is_nearer = here < along(p) && along(p) < there;
        if (!is_end && !(is_nearer && near_line(a, b, p, units))) continue;
        next = w;
        there = along(p);
      }
    if (next == kNoIndex) return {};
    chain.push_back(node_pair(at, next));
    at = next;
  }
  return at == kNoIndex ? std::vector<NodePair>{} : chain;
}

// ---- Facets

// A plane through three points of a facet that are far from each other, and how far from it a node
// may be.
struct FacetPlane {
  Point3 a, b, c;
  Point3 unit;  // of the facet's largest coordinates
  double units = 2;
  double reach = 0;  // but no less than this

  // Whether a, b and c are on one line, as all projections show.
  bool is_degenerate() const {
    const auto flat = [&](auto view) { return orient2d(view(a), view(b), view(c)) == 0; };
    return flat(in_xy) && flat(in_yz) && flat(in_zx);
  }

  bool contains(Point3 p) const {
    const Point3 half{std::max(reach, units * unit.x), std::max(reach, units * unit.y),
                      std::max(reach, units * unit.z)};
    return vanishes_near(p, half, [&](Point3 q) { return orient3d(a, b, c, q); });
  }
};

double area_sq(Point3 a, Point3 b, Point3 c) {
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
  return x * x + y * y + z * z;
}

FacetPlane plane_of(const std::vector<Point3>& points, double units, double flatness) {
  FacetPlane plane{points[0], points[0], points[0], rounding_box(points[0], points[0], 1), units};
  for (const Point3& p : points) {
    const Point3 unit = rounding_box(p, p, 1);
    plane.unit = {std::max(plane.unit.x, unit.x), std::max(plane.unit.y, unit.y),
                  std::max(plane.unit.z, unit.z)};
  }
  const double scale = scale_of(points);
  const auto scaled = [&](Point3 p) { return Point3{scale * p.x, scale * p.y, scale * p.z}; };
  const Point3 a = scaled(plane.a);
  for (const Point3& p : points)
    if (distance_sq(a, scaled(p)) > distance_sq(a, scaled(plane.b))) plane.b = p;
  const Point3 b = scaled(plane.b);
  for (const Point3& p : points)
    if (area_sq(a, b, scaled(p)) > area_sq(a, b, scaled(plane.c))) plane.c = p;
  plane.reach = flatness * std::sqrt(distance_sq(a, b)) / scale;
  const auto holds_all = [&] {
    return all_of(points, [&](Point3 p) { return plane.contains(p); });
  };
  while (plane.units < 0x1p40 && !holds_all()) plane.units *= 2;
  return plane;
}

// Pieces that are in the facet or not, under conditions that tie them together in pairs: a forest
// whose links say "same" or "other". Piece 0 is known to be out.
class InOrOut {
 public:
  Index add() {
    links_.push_back({static_cast<Index>(links_.size()), false});
    return static_cast<Index>(links_.size() - 1);
  }

  // Demands that exactly one of two pieces is in, or else both or none; false if that cannot be.
  bool tie(Index p, Index q, bool exactly_one) {
    const auto [a, a_other] = root(p);
    const auto [b, b_other] = root(q);
    if (a == b) return (a_other != b_other) == exactly_one;
    links_[std::max(a, b)] = {std::min(a, b), (a_other != b_other) != exactly_one};
    return true;
  }

  bool is_in(Index piece) const {
    const auto [r, other] = root(piece);
    return r == 0 && other;
  }

 private:
  struct Link {
    Index to;
    bool other;
  };

  Link root(Index p) const {
    bool other = false;
    while (links_[p].to != p) {
      other = other != links_[p].other;
      p = links_[p].to;
    }
    return {p, other};
  }

  std::vector<Link> links_;
};

// The mesh faces near the plane of a facet, in pieces separated by the facet's edges.
class FacetCover {
 public:
  FacetCover(const TetMesh& mesh, const TetFaces& faces, const MeshIndex& index, FacetPlane plane)
      : mesh_(mesh), faces_(faces), index_(index), plane_(plane) {
    pieces_.add();  // 0: everything else
  }

  // edges: the facet's mesh edges, each with whether it bounds the facet. Returns whether the facet
  // is a union of pieces.
  bool find(const std::map<NodePair, bool>& edges) {
    for (const auto& [edge, bounds] : edges)
      for (const Index f : faces_near_plane(edge)) flood(f, edges);
    bool possible = true;
    for (const auto& [edge, bounds] : edges) possible &= tie_across(edge, bounds);
    return possible;
  }

  // Calls visit for the faces of the union, by one of their numbers.
  template <class Visit>
  void for_each_face(Visit visit) const {
    for (const auto& [f, piece] : piece_of_)
      if (pieces_.is_in(piece)) visit(f);
  }

 private:
  // A face between two tets goes by its lower number.
  Index number(Index f) const {
    return faces_.twin[f] == kNoIndex ? f : std::min(f, faces_.twin[f]);
  }

  bool is_near_plane(Index v) {
    const auto [at, is_new] = near_plane_.try_emplace(v, false);
    if (is_new) at->second = plane_.contains(mesh_.points[v]);
    return at->second;
  }

  std::vector<Index> faces_near_plane(NodePair edge) {
    std::vector<Index> found;
    index_.for_each_face_on(edge, [&](Index f) {
      const Face nodes = face_nodes(mesh_.tets, f);
      if (all_of(nodes, [&](Index v) { return is_near_plane(v); })) found.push_back(number(f));
    });
    sort_unique(found);
    return found;
  }

  // Makes a piece of all faces that can be reached without crossing an edge of the facet. Where a
  // piece ends at another edge, it is out.
  void flood(Index seed, const std::map<NodePair, bool>& edges) {
    if (piece_of_.count(seed) > 0) return;
    const Index piece = pieces_.add();
    std::vector<Index> stack = {seed};
    piece_of_[seed] = piece;
    while (!stack.empty()) {
      const Face nodes = face_nodes(mesh_.tets, stack.back());
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const NodePair edge = node_pair(nodes[i], nodes[(i + 1) % 3]);
        if (edges.count(edge) > 0) continue;
        const auto others = faces_near_plane(edge);
        if (others.size() != 2) pieces_.tie(piece, 0, false);
        for (const Index g : others)
          if (piece_of_.emplace(g, piece).second) stack.push_back(g);
      }
    }
  }

  bool tie_across(NodePair edge, bool bounds) {
    const auto beside = faces_near_plane(edge);
    if (beside.size() > 2) return false;
    std::array<Index, 2> pieces{0, 0};
    for (std::size_t i = 0; i < beside.size(); ++i) pieces[i] = piece_of_.at(beside[i]);
    return pieces_.tie(pieces[0], pieces[1], bounds);
  }

  const TetMesh& mesh_;
  const TetFaces& faces_;
  const MeshIndex& index_;
  FacetPlane plane_;
  InOrOut pieces_;
  std::map<Index, bool> near_plane_;
  std::map<Index, Index> piece_of_;
};

// A mesh that misses more facets than this fails whatever the reason.
constexpr std::size_t kMissingJudged = 1000;

// Segments and facets, each of which may have many edges and faces.
constexpr std::uint64_t kItemsAQuestion = 256;

class DomainAudit {
 public:
  DomainAudit(const TetMesh& mesh, const TetFaces& faces, const SolidToMeet& given)
      : mesh_(mesh),
        faces_(faces),
        domain_(given.domain),
        index_(mesh),
        on_domain_(faces.twin.size(), 0),
        least_allowance_(given.allowance),
        allowance_(given.allowance),
        parts_(given.progress, "audit", 4) {}

  void run(Report& report) {
    audit_points(report);
    audit_segments(report);
    audit_facets(report);
    if (!domain_.facets.empty() && !parts_.stopped()) audit_boundary(report);
    if (!domain_.holes.empty()) audit_holes(report);
    report.add_measure("facet_allowance", allowance_);
  }

 private:
  void audit_points(Report& report) {
    Check& check = report.add_required_check("domain_points_are_nodes", Item::kDomainPoint);
    const std::vector<Index>& inner = domain_.inner_points;
    const Progress progress = parts_.part(0);
    ProgressMeter meter(progress, "audit", domain_.points.size());
    for (Index i = 0; i < domain_.points.size() && meter.step(); ++i)
      if (index_.node_at(domain_.points[i]) == kNoIndex &&
          !std::binary_search(inner.begin(), inner.end(), i))
        check.violate({i});
  }

  void audit_segments(Report& report) {
    Check& check = report.add_required_check("domain_segments_are_edges", Item::kDomainSegment);
    const Progress progress = parts_.part(1);
    ProgressMeter meter(progress, "audit", domain_.segments.size() + domain_.facets.size(),
                        kItemsAQuestion);
    Index number = 0;
    const auto judge = [&](Index a, Index b) {
      if (find_chain(a, b).empty() && domain_.points[a] != domain_.points[b])
        check.violate({number});
      ++number;
    };
    for (const Segment& s : domain_.segments)
      if (meter.step()) judge(s.a, s.b);
    for (const FacetPolygons& facet : domain_.facets)
      for (const auto& polygon : facet)
        if (meter.step()) for_each_edge(polygon, judge);
  }

  // A polygon of two points is one edge, there and back.
  template <class Visit>
  static void for_each_edge(const std::vector<Index>& polygon, Visit visit) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      visit(polygon[i], polygon[(i + 1) % polygon.size()]);
  }

  const std::vector<NodePair>& find_chain(Index a, Index b) {
    const auto [at, is_new] = chains_.try_emplace(node_pair(a, b));
    if (is_new)
      at->second =
          chain_along(mesh_, index_, domain_.points[a], domain_.points[b], least_allowance_);
    return at->second;
  }

  void audit_facets(Report& report) {
    Check& check = report.add_required_check("domain_facets_are_faces", Item::kFacet);
    const Progress progress = parts_.part(2);
    ProgressMeter meter(progress, "audit", domain_.facets.size(), kItemsAQuestion);
    std::vector<Index> missing;
    for (Index i = 0; i < domain_.facets.size() && meter.step(); ++i)
      if (!is_union_of_faces(domain_.facets[i])) missing.push_back(i);
    if (missing.empty() || parts_.stopped()) return;
    const OpenFacets open(domain_);
    for (std::size_t k = 0; k < missing.size(); ++k)
      if (k >= kMissingJudged || !open.is_open(missing[k])) check.violate({missing[k]});
  }

  bool is_union_of_faces(const FacetPolygons& facet) {
    std::vector<Point3> points;
    std::map<NodePair, bool> edges;  // mesh edge: whether it bounds the facet
    for (const auto& polygon : facet)
      for_each_edge(polygon, [&](Index a, Index b) {
        points.push_back(domain_.points[a]);
        for (const NodePair& edge : find_chain(a, b)) edges[edge] = !edges[edge];
      });
    if (edges.empty()) return false;
    const FacetPlane plane = plane_of(points, least_allowance_, domain_.flatness);
    if (plane.is_degenerate()) return false;
    allowance_ = std::max(allowance_, plane.units);
    FacetCover cover(mesh_, faces_, index_, plane);
    if (!cover.find(edges)) return false;
    bool found = false;
    cover.for_each_face([&](Index f) {
      found = true;
      on_domain_[f] = 1;
      if (faces_.twin[f] != kNoIndex) on_domain_[faces_.twin[f]] = 1;
    });
    return found;
  }

  void audit_boundary(Report& report) const {
    Check& check = report.add_required_check("boundary_on_domain", Item::kFace);
    for (Index f = 0; f < faces_.twin.size(); ++f) {
      if (faces_.twin[f] != kNoIndex || on_domain_[f] != 0) continue;
      const Face nodes = face_nodes(mesh_.tets, f);
      check.violate({nodes[0], nodes[1], nodes[2]});
    }
  }

  // Whether a tet, of either orientation, contains p.
  bool contains(const std::array<Index, 4>& tet, Point3 p) const {
    int least = 1, most = -1;
    for (Index i = 0; i < 4; ++i) {
      const auto& [a, b, c] = kFaceCorners[i];
      const int side =
          orient3d(mesh_.points[tet[a]], mesh_.points[tet[b]], mesh_.points[tet[c]], p);
      least = std::min(least, side);
      most = std::max(most, side);
    }
    return least >= 0 || most <= 0;
  }

  void audit_holes(Report& report) {
    std::vector<Box<3>> boxes;
    for (const Point3& p : domain_.holes) boxes.push_back(box_of(p));
    const BoxTree<3> tree(boxes);
    Check& check = report.add_required_check("holes_are_open", Item::kTet);
    const Progress progress = parts_.part(3);
    ProgressMeter meter(progress, "audit", mesh_.tets.size());
    for (Index t = 0; t < mesh_.tets.size() && meter.step(); ++t) {
      const auto& [a, b, c, d] = mesh_.tets[t];
      const Box<3> box = box_of(mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[d]);
      bool filled = false;
      tree.search([&](const Box<3>& other) { return touch(box, other); },
                  [&](Index i) {
                    filled = touch(box, boxes[i]) && contains(mesh_.tets[t], domain_.holes[i]);
                    return !filled;
                  });
      if (filled) check.violate({t});
    }
  }

  const TetMesh& mesh_;
  const TetFaces& faces_;
  const PolyhedralDomain& domain_;
  MeshIndex index_;
  std::map<NodePair, std::vector<NodePair>> chains_;
  std::vector<std::uint8_t> on_domain_;
  double least_allowance_, allowance_;
  ProgressParts parts_;
};

}  // namespace

void audit_tet_domain(const TetMesh& mesh, const TetFaces& faces, const SolidToMeet& domain,
                      Report& report) {
  DomainAudit(mesh, faces, domain).run(report);
}

}  // namespace wellspaced::audit
