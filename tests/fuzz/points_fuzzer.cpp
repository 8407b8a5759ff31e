// Any finite points have a valid Delaunay triangulation.
#include "tests/fuzz/bytes.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"

using namespace wellspaced;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const std::vector<Point2> points = bytes.points(255);
  const Result<Delaunay2> dt = Delaunay2::build(points);
  require(dt.ok());
  require(dt->is_valid());
  for (Index i = 0; i < points.size(); ++i) {
    const Index v = dt->representative(i);
    require(v <= i && dt->is_vertex(v) && points[v] == points[i]);
    if (dt->dimension() < 2) continue;
    require(dt->locate(points[i], i).place == Delaunay2::Place::kVertex);
    require(dt->nearest_vertex(points[i], i) == v);
  }
  return 0;
}
