// Any sequence of insertions and removals keeps a triangulation valid.
#include "tests/fuzz/bytes.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"

using namespace wellspaced;
using fuzz::require;

namespace {

void edit(fuzz::Bytes& bytes, Delaunay2& dt) {
  const std::uint8_t what = bytes.byte();
  const Index count = static_cast<Index>(dt.points().size());
  const Index a = count == 0 ? 0 : bytes.byte() % count, b = count == 0 ? 0 : bytes.byte() % count;
  if (what % 4 == 0 || count == 0) {
    const Point2 p = bytes.point();
    const Result<Index> v = dt.insert(p, b);
    require(v.ok() && dt.points()[*v] == p && dt.is_vertex(*v));
  } else if (what % 4 == 1) {
    const bool was_vertex = dt.is_vertex(a);
    require(!dt.remove(a).ok() || (was_vertex && !dt.is_vertex(a)));
  } else if (dt.dimension() < 2) {
    return;
  } else if (what % 4 == 2) {
    const Delaunay2::Edge e{b % dt.topology().size(), a % 3};
    if (dt.topology().is_constrained(e)) dt.remove_constraint(e);
  } else if (dt.is_vertex(a) && dt.is_vertex(b)) {
    const Result<std::vector<Index>> path = dt.insert_constraint(a, b);
    require(!path.ok() || (path->front() == a && path->back() == b));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  Result<Delaunay2> dt = Delaunay2::build(bytes.points(20));
  require(dt.ok());
  for (int step = 0; step < 60 && !bytes.empty(); ++step) {
    edit(bytes, *dt);
    require(dt->is_valid());
  }
  return 0;
}
