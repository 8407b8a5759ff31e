#include "wellspaced/algorithms/audit/solid_winding.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

using Nodes = std::array<Index, 3>;

// For each node the lowest node at the same place.
std::vector<Index> unify_places(std::span<const Point3> points, std::span<const ChainFace> faces) {
  std::vector<Index> nodes, place(points.size());
  std::iota(place.begin(), place.end(), Index{0});
  for (const ChainFace& face : faces)
    nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
  const auto key = [&](Index v) { return std::array{points[v].x, points[v].y, points[v].z}; };
  sort(nodes, [&](Index v, Index w) { return key(v) != key(w) ? key(v) < key(w) : v < w; });
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (points[nodes[i]] == points[nodes[i - 1]]) place[nodes[i]] = place[nodes[i - 1]];
  return place;
}

// Ascending, and whether that took an odd permutation.
std::pair<Nodes, bool> sorted(Nodes n) {
  bool odd = false;
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}})
    if (n[j] < n[i]) std::swap(n[i], n[j]), odd = !odd;
  return {n, odd};
}

// An edge of a face, from its lower to its higher node.
struct Wing {
  Index low, high;
  Index face;
  Index apex;
  bool opens;  // turning counter-clockwise about low -> high, the solid begins at this face
};

class SolidProof {
 public:
  SolidProof(std::span<const Point3> points, std::span<const ChainFace> given)
      : points_(points), given_(given) {
    cancel(unify_places(points, given));
    for (const Nodes& n : faces_)
      boxes_.push_back(box_of(points[n[0]], points[n[1]], points[n[2]]));
  }

  SolidVerdict run() {
    const BoxTree<3> tree(boxes_);
    find_contacts(tree);
    if (!verdict_.improper_contacts.empty()) verdict_.at_most_once = false;
    if (verdict_.at_most_once) join_around_edges();
    if (verdict_.at_most_once) count_inside_each_set(tree);
    return std::move(verdict_);
  }

 private:
  Point3 point(Index v) const { return points_[v]; }
  Corners3 corners(Index f) const {
    const auto& [a, b, c] = faces_[f];
    return {points_[a], points_[b], points_[c]};
  }

  // Keeps, of faces in one place, those that others of opposite orientation do not cancel.
  void cancel(const std::vector<Index>& place) {
    struct Oriented {
      Nodes key;
      bool odd;
      Index given;
    };
    std::vector<Oriented> all;
    for (Index i = 0; i < given_.size(); ++i) {
      const auto& [a, b, c] = given_[i].nodes;
      const auto [key, odd] = sorted({place[a], place[b], place[c]});
      all.push_back({key, odd, i});
    }
    sort(all, [](const Oriented& a, const Oriented& b) {
      return std::tie(a.key, a.odd, a.given) < std::tie(b.key, b.odd, b.given);
    });
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      std::size_t odd = 0;
      for (; end < all.size() && all[end].key == all[i].key; ++end) odd += all[end].odd;
      const std::size_t even = end - i - odd, left = odd > even ? odd - even : even - odd;
      if (left > 1) verdict_.at_most_once = false;
      if (left == 0) continue;
      const Oriented& kept = odd > even ? all[end - 1] : all[i];
      const auto& [a, b, c] = given_[kept.given].nodes;
      faces_.push_back({place[a], place[b], place[c]});
      origin_.push_back(kept.given);
    }
  }

  void find_contacts(const BoxTree<3>& tree) {
    for (Index f = 0; f < faces_.size(); ++f) {
      const Corners3 at_f = corners(f);
      tree.search([&](const Box<3>& box) { return touch(box, boxes_[f]); },
                  [&](Index g) {
                    if (g < f && touch(boxes_[g], boxes_[f]) &&
                        meet_improperly(at_f, faces_[f], corners(g), faces_[g]))
                      verdict_.improper_contacts.push_back({origin_[g], origin_[f]});
                    return true;
                  });
    }
  }

  // ---- Step 3

  std::vector<Wing> wings() const {
    std::vector<Wing> all;
    for (Index f = 0; f < faces_.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Index from = faces_[f][i], to = faces_[f][(i + 1) % 3];
        all.push_back(
            {std::min(from, to), std::max(from, to), f, faces_[f][(i + 2) % 3], from > to});
      }
    sort(all, [](const Wing& a, const Wing& b) {
      return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return all;
  }

  void join_around_edges() {
    set_.resize(faces_.size());
    std::iota(set_.begin(), set_.end(), Index{0});
    std::vector<Wing> all = wings();
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      while (end < all.size() && all[end].low == all[i].low && all[end].high == all[i].high) ++end;
      join_around({all.data() + i, all.data() + end});
    }
  }

  void join_around(std::span<Wing> wings) {
    if (wings.size() > 2) sort_by_angle(wings);
    for (std::size_t i = 0; i < wings.size(); ++i) {
      const Wing& next = wings[(i + 1) % wings.size()];
      if (wings[i].opens == next.opens) verdict_.at_most_once = false;
      if (wings[i].opens) join(wings[i].face, next.face);
    }
  }

  // Counter-clockwise about the edge, from the first wing on. No two are at one angle, because
  // they would meet improperly.
  void sort_by_angle(std::span<Wing> wings) const {
    const Index low = wings[0].low, high = wings[0].high, first = wings[0].apex;
    const auto turn = [&](Index x, Index y) {
      return -orient3d(point(low), point(high), point(x), point(y));
    };
    // 0: the first; 1: within half a turn; 2: opposite; 3: beyond.
    const auto quarter = [&](Index x) { return x == first ? 0 : 2 - turn(first, x); };
    sort(wings, [&](const Wing& a, const Wing& b) {
      const int i = quarter(a.apex), j = quarter(b.apex);
      return i != j ? i < j : turn(a.apex, b.apex) > 0;
    });
  }

  Index root(Index f) {
    while (set_[f] != f) f = set_[f] = set_[set_[f]];
    return f;
  }
  void join(Index f, Index g) {
    const Index a = root(f), b = root(g);
    set_[std::max(a, b)] = std::min(a, b);
  }

  // ---- Step 4

  void count_inside_each_set(const BoxTree<3>& tree) {
    for (Index f = 0; f < faces_.size() && verdict_.at_most_once; ++f)
      if (set_[f] == f && count_inside(f, tree) != 1) verdict_.at_most_once = false;
  }

  // The winding number about the point just inside a face: what leaves less what enters along the
  // ray from there in direction x.
  int count_inside(Index face, const BoxTree<3>& tree) const {
    const auto [a, b, c] = corners(face);
    const TetCorners tet{a, b, c, given_[origin_[face]].apex};
    const Point3 start = tet[0];
    int count = 0;
    tree.search(
        [&](const Box<3>& box) {
          return box.low[1] <= start.y && start.y <= box.high[1] && box.low[2] <= start.z &&
                 start.z <= box.high[2] && start.x <= box.high[0];
        },
        [&](Index f) {
          count += crossing(corners(f), tet);
          return true;
        });
    return count;
  }

  // 1 if the ray leaves through the face, -1 if it enters, 0 if it misses it.
  static int crossing(const Corners3& face, const TetCorners& tet) {
    const auto seen = [](Point3 p) { return Point2{p.y, p.z}; };
    const Point2 a = seen(face[0]), b = seen(face[1]), c = seen(face[2]);
    const int facing = orient2d(a, b, c);
    if (facing == 0) return 0;  // parallel to the ray
    // The sign at the displaced point of a function that is affine: where it vanishes at the first
    // corner, the next corner that it does not vanish at decides.
    const auto sign_near = [&](auto sign_at) {
      for (const Point3& corner : tet)
        if (const int sign = sign_at(corner); sign != 0) return sign;
      return 0;
    };
    for (const auto& edge : {std::pair{a, b}, {b, c}, {c, a}})
      if (sign_near([&](Point3 p) { return orient2d(edge.first, edge.second, seen(p)); }) != facing)
        return 0;
    const int below = sign_near([&](Point3 p) { return orient3d(face[0], face[1], face[2], p); });
    return below == facing ? facing : 0;
  }

  std::span<const Point3> points_;
  std::span<const ChainFace> given_;
  std::vector<Nodes> faces_;   // what is left, by places
  std::vector<Index> origin_;  // its positions in given_
  std::vector<Box<3>> boxes_;
  std::vector<Index> set_;
  SolidVerdict verdict_;
};

}  // namespace

SolidVerdict cover_at_most_once(std::span<const Point3> points, std::span<const ChainFace> faces) {
  return SolidProof(points, faces).run();
}

}  // namespace wellspaced::audit
