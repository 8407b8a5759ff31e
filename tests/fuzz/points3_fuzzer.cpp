// Any finite points of space have a valid Delaunay triangulation, and take in any further ones.
#include "tests/fuzz/bytes.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

using namespace wellspaced;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const std::vector<Point3> points = bytes.points3(80);
  Result<Delaunay3> dt = Delaunay3::build(points);
  require(dt.ok());
  for (int more = bytes.byte() % 20; more > 0; --more)
    require(dt->insert(bytes.point3(), bytes.byte()).ok());
  require(is_valid(*dt));
  for (Index i = 0; i < dt->points().size(); ++i) {
    const Point3 p = dt->points()[i];
    const Index v = dt->representative(i);
    require(v <= i && dt->representative(v) == v && dt->points()[v] == p);
    require(nearest_vertex(*dt, p, i) == v);
    if (dt->dimension() == 3) require(dt->locate(p, i).place == Delaunay3::Place::kVertex);
  }
  return 0;
}
