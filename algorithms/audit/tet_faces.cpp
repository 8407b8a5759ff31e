#include "wellspaced/algorithms/audit/tet_faces.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// A face of a tet or a facet: its nodes in ascending order, and whether an odd permutation brought
// them there. item: a face 4t + i or, from 4 * tets on, a facet.
struct Entry {
  Index middle, high;
  Index item;
  bool odd;

  bool same_place(const Entry& other) const { return middle == other.middle && high == other.high; }
  friend bool operator<(const Entry& a, const Entry& b) {
    if (a.middle != b.middle) return a.middle < b.middle;
    return a.high != b.high ? a.high < b.high : a.item < b.item;
  }
};

// Sorts three nodes; returns whether that was an odd permutation.
bool sort_nodes(Face& nodes) {
  bool odd = false;
  const auto order = [&](int i, int j) {
    if (nodes[j] < nodes[i]) std::swap(nodes[i], nodes[j]), odd = !odd;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return odd;
}

// Faces of tets and facets, listed by their lowest node.
class FaceLists {
 public:
  // Those between three chosen nodes.
  FaceLists(Tets tets, std::span<const TetMesh::Facet> facets, std::span<const std::uint8_t> chosen)
      : first_(chosen.size() + 1, 0) {
    for_each(tets, facets, chosen, [&](Index low, const Entry&) { ++first_[low]; });
    Index sum = 0;
    for (Index& first : first_) first = sum += first;
    entries_.resize(sum);
    for_each(tets, facets, chosen, [&](Index low, const Entry& e) { entries_[--first_[low]] = e; });
  }

  Index nodes() const { return static_cast<Index>(first_.size() - 1); }

  std::span<Entry> from(Index low) {
    return {entries_.data() + first_[low], entries_.data() + first_[low + 1]};
  }

  // Calls visit(entries of one face), face by face. Entries are sorted by item.
  template <class Visit>
  void visit_faces(Visit visit) {
    for (Index low = 0; low < nodes(); ++low) {
      const std::span<Entry> list = from(low);
      sort(list);
      for (std::size_t i = 0, end = 0; i < list.size(); i = end) {
        while (end < list.size() && list[end].same_place(list[i])) ++end;
        visit(std::span<const Entry>(list.subspan(i, end - i)));
      }
    }
  }

 private:
  template <class Visit>
  static void for_each(Tets tets, std::span<const TetMesh::Facet> facets,
                       std::span<const std::uint8_t> chosen, Visit visit) {
    const auto tell = [&](Face nodes, Index item) {
      if ((chosen[nodes[0]] & chosen[nodes[1]] & chosen[nodes[2]]) == 0) return;
      const bool odd = sort_nodes(nodes);
      visit(nodes[0], Entry{nodes[1], nodes[2], item, odd});
    };
    const auto faces = static_cast<Index>(4 * tets.size());
    for (Index f = 0; f < faces; ++f) tell(face_nodes(tets, f), f);
    for (Index i = 0; i < facets.size(); ++i) tell(facets[i].points, faces + i);
  }

  std::vector<Index> first_;
  LargeVector<Entry> entries_;
};

// Finds faces that were met before among those with the same lowest node.
class FaceTable {
 public:
  struct Slot {
    Entry face;
    Index low = kNoIndex;
    bool met_twice = false;
  };

  // Makes room for the faces of a list.
  void make_room(std::size_t count) {
    if (2 * count <= slots_.size()) return;
    slots_.assign(std::bit_ceil(2 * count), {});
  }

  // The slot of the face, or the free one where it belongs.
  Slot& find(Index low, const Entry& face) {
    std::size_t i = (face.middle * kSpread ^ face.high) * kSpread >> 32;
    for (;; ++i) {
      Slot& slot = slots_[i & (slots_.size() - 1)];
      if (slot.low != low || slot.face.same_place(face)) return slot;
    }
  }

 private:
  static constexpr std::uint64_t kSpread = 0x9E3779B97F4A7C15u;
  std::vector<Slot> slots_;
};

// Turns what lies on faces, face by face, into the result.
class FacePairing {
 public:
  FacePairing(Tets tets, std::span<const TetMesh::Facet> facets) : tets_(tets), facets_(facets) {
    faces_ = static_cast<Index>(4 * tets.size());
    assign_large(result_.twin, faces_, kNoIndex);
    result_.constrained.assign(faces_, 0);
    result_.facet_face.assign(facets.size(), kNoIndex);
  }

  // All that lies on one face: faces of tets first, because their items are lower.
  void take(std::span<const Entry> entries) {
    const auto sides = take_facets_of(entries);
    if (sides.empty()) return;
    ++result_.faces;
    if (sides.size() > 1) pair_up(sides);
  }

  // The same without the faces of tets, which are returned.
  std::span<const Entry> take_facets_of(std::span<const Entry> entries) {
    const auto is_face = [&](const Entry& e) { return e.item < faces_; };
    const auto split = std::partition_point(entries.begin(), entries.end(), is_face);
    const std::span<const Entry> sides(entries.begin(), split), facets(split, entries.end());
    take_facets(facets, sides);
    return sides;
  }

  // Pairs up the faces of a mesh that has no crowded or disagreeing face and no tet twice; returns
  // false if it has one.
  bool pair_opposites(Index nodes) {
    FaceLists lists(tets_, {}, std::vector<std::uint8_t>(nodes, 1));
    FaceTable table;
    bool good = true;
    for (Index low = 0; low < nodes && good; ++low) {
      const auto faces = lists.from(low);
      table.make_room(faces.size());
      for (const Entry& face : faces) good &= meet(face, low, table.find(low, face));
    }
    if (good) return true;
    result_.twin.assign(faces_, kNoIndex);
    result_.faces = 0;
    return false;
  }

  TetFaces take_result() {
    for (auto* list :
         {&result_.duplicate_tets, &result_.duplicate_facets, &result_.conflicting_facets}) {
      sort_unique(*list);
    }
    return std::move(result_);
  }

 private:
  // Returns whether the face is new, or the other side of one that was met once.
  bool meet(const Entry& face, Index low, FaceTable::Slot& slot) {
    if (slot.low != low) {
      slot = {face, low, false};
      ++result_.faces;
      return true;
    }
    const Index f = face.item, g = slot.face.item;
    if (slot.met_twice || face.odd == slot.face.odd || face_apex(tets_, f) == face_apex(tets_, g))
      return false;
    slot.met_twice = true;
    result_.twin[f] = g;
    result_.twin[g] = f;
    return true;
  }

  void take_facets(std::span<const Entry> facets, std::span<const Entry> sides) {
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const Index facet = facets[i].item - faces_;
      if (!sides.empty()) result_.facet_face[facet] = sides[0].item;
      for (const Entry& side : sides) result_.constrained[side.item] = 1;
      if (i == 0) continue;
      result_.duplicate_facets.push_back(facet);
      if (facets_[facet].marker != facets_[facets[0].item - faces_].marker)
        result_.conflicting_facets.push_back(facet);
    }
  }

  void pair_up(std::span<const Entry> sides) {
    find_duplicates(sides);
    if (sides.size() > 2) return list_face(result_.crowded_faces, sides[0].item);
    if (sides[0].odd == sides[1].odd) return list_face(result_.disagreeing_faces, sides[0].item);
    result_.twin[sides[0].item] = sides[1].item;
    result_.twin[sides[1].item] = sides[0].item;
  }

  void list_face(std::vector<Index>& list, Index f) const {
    for (const Index v : face_nodes(tets_, f)) list.push_back(v);
  }

  // Tets on one face have the same nodes if they have the same apex.
  void find_duplicates(std::span<const Entry> sides) {
    apexes_.clear();
    for (const Entry& side : sides)
      apexes_.push_back(std::uint64_t{face_apex(tets_, side.item)} << 32 | side.item / 4);
    sort(apexes_);
    for (std::size_t i = 1; i < apexes_.size(); ++i)
      if (apexes_[i - 1] >> 32 == apexes_[i] >> 32)
        result_.duplicate_tets.push_back(static_cast<Index>(apexes_[i]));
  }

  Tets tets_;
  std::span<const TetMesh::Facet> facets_;
  Index faces_ = 0;
  TetFaces result_;
  std::vector<std::uint64_t> apexes_;
};

// The nodes of facets, as a set of flags.
std::vector<std::uint8_t> corners_of_facets(std::span<const TetMesh::Facet> facets, Index nodes) {
  std::vector<std::uint8_t> is_corner(nodes, 0);
  for (const TetMesh::Facet& facet : facets)
    for (const Index v : facet.points) is_corner[v] = 1;
  return is_corner;
}

}  // namespace

TetFaces pair_tet_faces(Tets tets, std::span<const TetMesh::Facet> facets, Index nodes) {
  FacePairing pairing(tets, facets);
  if (!pairing.pair_opposites(nodes)) {
    FaceLists(tets, facets, std::vector<std::uint8_t>(nodes, 1)).visit_faces([&](auto entries) {
      pairing.take(entries);
    });
  } else if (!facets.empty()) {
    FaceLists(tets, facets, corners_of_facets(facets, nodes)).visit_faces([&](auto entries) {
      pairing.take_facets_of(entries);
    });
  }
  return pairing.take_result();
}

std::uint64_t count_tet_edges(Tets tets, Index nodes) {
  std::vector<Index> first(nodes + 1, 0);
  const auto for_each = [&](auto visit) {
    for (const auto& tet : tets)
      for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 4; ++j) visit(std::min(tet[i], tet[j]), std::max(tet[i], tet[j]));
  };
  for_each([&](Index low, Index) { ++first[low]; });
  Index sum = 0;
  for (Index& f : first) f = sum += f;
  std::vector<Index> highs(sum);
  for_each([&](Index low, Index high) { highs[--first[low]] = high; });
  std::uint64_t edges = 0;
  std::vector<Index> last_low(nodes, kNoIndex);  // for each higher node
  for (Index low = 0; low < nodes; ++low)
    for (Index i = first[low]; i < first[low + 1]; ++i) {
      edges += last_low[highs[i]] != low;
      last_low[highs[i]] = low;
    }
  return edges;
}

}  // namespace wellspaced::audit
