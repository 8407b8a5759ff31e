// The readers of Triangle's files: .node, .poly, .ele and .edge, parted by bytes 0xFF; then the
// preparation of the mesh, and every writer.
#include <algorithm>

#include "tests/fuzz/texts.hpp"
#include "wellspaced/algorithms/mesh/prepare_mesh.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/pictures/svg.hpp"

using namespace wellspaced;

namespace {

void check_indices(const Geometry& g) {
  const std::size_t count = g.point_count();
  for (const Segment& s : g.mesh.segments)
    fuzz::require(std::max(s.a, s.b) < count, "segments end at points");
  for (const auto& t : g.mesh.triangles)
    for (const Index v : t) fuzz::require(v < count, "triangles have points as corners");
  for (const auto& t : g.solid.tets)
    for (const Index v : t) fuzz::require(v < count, "tetrahedra have points as corners");
}

void check_round_trip(const Geometry& g) {
  const std::string node = fuzz::written(write_node, g);
  const auto points = parse_node(node, "x.node");
  fuzz::require(points.ok(), "a written .node is read");
  Geometry back = *points;
  if (g.point_count() == 0) return;  // its index base is lost
  if (g.dimension == 2) {
    const std::string poly = fuzz::written(write_poly, g, PolyPoints::kInNodeFile);
    const auto domain = parse_poly(poly, "x.poly", &*points);
    fuzz::require(domain.ok(), "a written .poly is read");
    back = *domain;
    fuzz::require(fuzz::written(write_poly, back, PolyPoints::kInNodeFile) == poly,
                  "a .poly is written as it was read");
  }
  const std::string ele = fuzz::written(write_ele, g);
  fuzz::require(parse_ele(ele, "x.ele", back).ok(), "a written .ele is read");
  fuzz::require(fuzz::written(write_ele, back) == ele, "an .ele is written as it was read");
  fuzz::require(fuzz::written(write_node, back) == node, "a .node is written as it was read");
  fuzz::require(parse_edge(fuzz::written(write_edge, back), "x.edge", back).ok(),
                "a written .edge is read");
}

void draw(const Geometry& g) {
  TextWriter out;
  const VtkGrid grid = g.dimension == 2 ? vtk_grid(g.mesh) : vtk_grid(g.solid);
  write_vtu(out, grid, VtuEncoding::kRaw);
  write_vtu(out, grid, VtuEncoding::kBase64);
  write_vtk(out, grid, VtkEncoding::kAscii);
  write_mesh_svg(out, g.mesh);
}

void check_prepared(Geometry g) {
  if (!prepare_mesh(g.mesh).ok()) return;
  const auto again = prepare_mesh(g.mesh);
  fuzz::require(again.ok(), "a prepared mesh is valid");
  fuzz::require(!again->turned && again->recovered_segments == 0 && again->repeated_segments == 0,
                "nothing is left to prepare");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string_view> texts = fuzz::parts(fuzz::text_of(data, size));
  texts.resize(4);
  const auto points = parse_node(texts[0], "x.node");
  const auto domain = parse_poly(texts[1], "x.poly", points.ok() ? &*points : nullptr);
  if (!points.ok() && !domain.ok()) return 0;
  Geometry g = domain.ok() ? *domain : *points;
  const auto edges = parse_edge(texts[3], "x.edge", g);
  if (edges.ok() && g.dimension == 2)
    g.mesh.segments.insert(g.mesh.segments.end(), edges->begin(), edges->end());
  Geometry with_cells = g;
  if (parse_ele(texts[2], "x.ele", with_cells).ok()) g = std::move(with_cells);
  check_indices(g);
  check_round_trip(g);
  draw(g);
  check_prepared(std::move(g));
  return 0;
}
