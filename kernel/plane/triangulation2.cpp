#include "wellspaced/kernel/plane/triangulation2.hpp"

#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {

void Triangulation2::reset(Index a, Index b, Index c) {
  // Triangle 0 is real; ghost 1 + i lies behind its edge i, with the ghost vertex at corner 0.
  triangles_.assign({{{a, b, c}, {pack(1, 0), pack(2, 0), pack(3, 0)}},
                     {{kGhost, c, b}, {pack(0, 0), pack(3, 2), pack(2, 1)}},
                     {{kGhost, a, c}, {pack(0, 1), pack(1, 2), pack(3, 1)}},
                     {{kGhost, b, a}, {pack(0, 2), pack(2, 2), pack(1, 1)}}});
}

void Triangulation2::fill_with_star(std::span<const Index> hole, std::span<const RimEdge> rim,
                                    Index apex) {
  assert(rim.size() == hole.size() + 2);
  const Index first_new = size();
  triangles_.resize(first_new + 2);
  const std::size_t last = rim.size() - 1;
  const auto slot = [&](std::size_t i) {
    return i < hole.size() ? hole[i] : first_new + static_cast<Index>(i - hole.size());
  };
  Index before = slot(last), here = slot(0);
  for (std::size_t i = 0; i <= last; ++i) {
    const bool wraps = i == last;
    const Index after = wraps ? slot(0) : slot(i + 1);
    const std::uint32_t outside = rim[i].outside;
    triangles_[here] = {{apex, rim[i].origin, wraps ? rim[0].origin : rim[i + 1].origin},
                        {outside, pack(after, 2), pack(before, 1)}};
    triangles_[outside >> 3].link[outside & 3] = pack(here, 0) | (outside & kConstrained);
    before = here;
    here = after;
  }
}

void Triangulation2::flip(Edge e) {
  const Edge m = mirror(e);
  Triangle& t = triangles_[e.triangle];
  Triangle& u = triangles_[m.triangle];
  const Index a = t.vertex[next(e.i)], b = t.vertex[previous(e.i)];
  const Index c = t.vertex[e.i], d = u.vertex[m.i];
  const std::uint32_t bc = t.link[next(e.i)], ca = t.link[previous(e.i)];
  const std::uint32_t ad = u.link[next(m.i)], db = u.link[previous(m.i)];
  const auto attach = [this](std::uint32_t outside, Index triangle, unsigned i) {
    triangles_[outside >> 3].link[outside & 3] = pack(triangle, i) | (outside & kConstrained);
  };
  t = {{c, a, d}, {ad, pack(m.triangle, 1), ca}};
  u = {{d, b, c}, {bc, pack(e.triangle, 1), db}};
  attach(ad, e.triangle, 0);
  attach(ca, e.triangle, 2);
  attach(bc, m.triangle, 0);
  attach(db, m.triangle, 2);
}

Index Triangulation2::add(Index a, Index b, Index c) {
  triangles_.push_back({{a, b, c}, {0, 0, 0}});
  return size() - 1;
}

void Triangulation2::link(Edge e, Edge f, bool constrained) {
  const std::uint32_t flag = constrained ? kConstrained : 0;
  triangles_[e.triangle].link[e.i] = pack(f.triangle, f.i) | flag;
  triangles_[f.triangle].link[f.i] = pack(e.triangle, e.i) | flag;
}

void Triangulation2::move(Index from, Index to) {
  triangles_[to].vertex = triangles_[from].vertex;
  for (unsigned i = 0; i < 3; ++i) link({to, i}, mirror({from, i}), is_constrained({from, i}));
}

void Triangulation2::move_into(std::span<const Index> slots) {
  const Index kept = size() - static_cast<Index>(slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) move(kept + static_cast<Index>(k), slots[k]);
  triangles_.resize(kept);
}

std::size_t Triangulation2::degree(Edge e) const {
  std::size_t degree = 0;
  Edge f = e;
  do {
    ++degree;
    f = next_around_origin(f);
  } while (f != e);
  return degree;
}

Index Triangulation2::merge_star(Edge e, std::vector<std::pair<Index, Index>>& moved) {
  std::array<Index, 3> slots, corners;
  std::array<std::uint32_t, 3> outside;
  for (unsigned k = 0; k < 3; ++k, e = next_around_origin(e)) {
    slots[k] = e.triangle;
    corners[k] = destination(e);
    outside[previous(k)] = triangles_[e.triangle].link[next(e.i)];
  }
  sort(slots);
  const Index t = slots[0];
  triangles_[t].vertex = corners;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t o = outside[k];
    link({t, k}, {o >> 3, o & 3}, (o & kConstrained) != 0);
  }
  for (unsigned k = 2; k > 0; --k) {
    const Index last = size() - 1;
    if (slots[k] != last) {
      move(last, slots[k]);
      moved.emplace_back(last, slots[k]);
    }
    triangles_.pop_back();
  }
  return t;
}

void Triangulation2::set_constrained(Edge e, bool constrained) {
  const Edge m = mirror(e);
  for (const Edge side : {e, m}) {
    std::uint32_t& link = triangles_[side.triangle].link[side.i];
    link = constrained ? link | kConstrained : link & ~kConstrained;
  }
}

bool Triangulation2::is_valid() const {
  for (Index t = 0; t < size(); ++t) {
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t link = triangles_[t].link[i];
      if (link >> 3 >= size() || (link & 3) == 3) return false;
      const Edge e{t, i}, m = mirror(e);
      if (mirror(m) != e || is_constrained(m) != is_constrained(e)) return false;
      if (origin(m) != destination(e) || destination(m) != origin(e)) return false;
    }
  }
  return true;
}

}  // namespace wellspaced
