// The .xyz and .f64 readers: what they accept, they write and read back the same.
#include "tests/fuzz/texts.hpp"
#include "wellspaced/io/formats/point_files.hpp"

using namespace wellspaced;

namespace {

bool same_points(const Geometry& a, const Geometry& b) {
  if (a.point_count() == 0 && b.point_count() == 0) return true;
  return a.dimension == b.dimension && a.mesh.points == b.mesh.points &&
         a.solid.points == b.solid.points;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text_of(data, size);
  if (const auto g = parse_xyz(bytes, "x.xyz"); g.ok()) {
    const auto back = parse_xyz(fuzz::written(write_xyz, *g), "x.xyz");
    fuzz::require(back.ok() && same_points(*back, *g), ".xyz reads back");
  }
  if (const auto g = parse_f64(bytes, "x.f64"); g.ok()) {
    fuzz::require(looks_like_f64(bytes), "what is read is recognised");
    fuzz::require(fuzz::written(write_f64, *g) == bytes, ".f64 is written as it was read");
  }
  return 0;
}
