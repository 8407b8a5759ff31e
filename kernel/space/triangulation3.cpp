#include "wellspaced/kernel/space/triangulation3.hpp"

#include <functional>

#include "wellspaced/kernel/parallel.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {

void Triangulation3::reset(Index a, Index b, Index c, Index d) {
  // Tet 0 is real; ghost 1 + i lies behind its facet i.
  tets_.clear();
  tets_.push_back({{a, b, c, d}, {pack(1, 3), pack(2, 3), pack(3, 3), pack(4, 3)}});
  for (unsigned i = 0; i < 4; ++i) {
    const auto [x, y, z] = vertices(Facet{0, i});
    tets_.push_back({{x, y, z, kGhost}, {0, 0, 0, pack(0, i)}});
  }
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned k = 0; k < 3; ++k) {
      // Opposite its corner j of the tet, ghost i meets ghost j opposite corner i of the tet.
      const unsigned j = corner_of(0, vertex(1 + i, k));
      tets_[1 + i].link[k] = pack(1 + j, corner_of(1 + j, vertex(0, i)));
    }
  }
}

void Triangulation3::remove(std::span<Index> dead) {
  // From the highest number down, so that the last tet is never itself to be removed later.
  sort(dead, std::greater<>());
  for (const Index hole : dead) {
    tets_[hole] = tets_.back();
    tets_.pop_back();
    if (hole == tets_.size()) continue;
    for (unsigned k = 0; k < 4; ++k) {
      const Facet outside = mirror({hole, k});
      tets_[outside.tet].link[outside.i] = pack(hole, k);
    }
  }
}

void Triangulation3::renumber_vertices(const std::vector<Index>& number, unsigned threads) {
  run_parallel(threads, threads, [&](unsigned, std::size_t share) {
    const std::size_t end = tets_.size() * (share + 1) / threads;
    for (std::size_t t = tets_.size() * share / threads; t < end; ++t)
      for (Index& v : tets_[t].vertex)
        if (v != kGhost) v = number[v];
  });
}

namespace {

// Whether the two triples turn opposite ways round the same three vertices.
bool are_opposite(const std::array<Index, 3>& a, const std::array<Index, 3>& b) {
  for (unsigned k = 0; k < 3; ++k)
    if (a[0] == b[k] && a[1] == b[(k + 2) % 3] && a[2] == b[(k + 1) % 3]) return true;
  return false;
}

}  // namespace

bool Triangulation3::is_valid() const {
  for (Index t = 0; t < size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      if (i < 3 && vertex(t, i) == kGhost) return false;
      if (neighbor(t, i) >= size()) return false;
      const Facet f{t, i}, m = mirror(f);
      if (mirror(m) != f || !are_opposite(vertices(f), vertices(m))) return false;
    }
  }
  return true;
}

}  // namespace wellspaced
