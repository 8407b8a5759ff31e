// The reader of one format, WELLSPACED_FUZZED_FORMAT: what it accepts has indices in range, what it
// refuses gets a message of one line.
#include <algorithm>

#include "tests/fuzz/texts.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/metis.hpp"

using namespace wellspaced;

namespace {

void require_points(const auto& corners, std::size_t count) {
  for (const Index v : corners) fuzz::require(v < count, "corners are points");
}

void check_indices(const Geometry& g) {
  const std::size_t count = g.point_count();
  for (const auto& t : g.mesh.triangles) require_points(t, count);
  for (const auto& t : g.solid.tets) require_points(t, count);
  for (const auto& f : g.solid.facets) require_points(f.points, count);
  for (const auto& f : g.polygons)
    for (const auto& polygon : f.polygons) require_points(polygon, count);
  for (const Segment& s : g.mesh.segments) require_points(std::array{s.a, s.b}, count);
  for (const Segment& s : g.solid.segments) require_points(std::array{s.a, s.b}, count);
  const bool marked = !g.point_markers().empty();
  fuzz::require(!marked || g.point_markers().size() == count, "every point has its marker");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  if (std::string_view(WELLSPACED_FUZZED_FORMAT) == "metis") {
    const auto graph = parse_metis_graph(text, "x");
    for (std::size_t i = 0; graph.ok() && i < graph->edges.size(); ++i)
      fuzz::require(graph->edges[i].a < graph->edges[i].b && graph->edges[i].b < graph->vertices,
                    "edges ascend and join vertices");
    return 0;
  }
  const auto all = formats();
  const auto format = std::find_if(
      all.begin(), all.end(), [](const Format& f) { return f.name == WELLSPACED_FUZZED_FORMAT; });
  fuzz::require(format != all.end(), "the format exists");
  format->recognise(text);
  const auto g = format->parse(text, "x");
  if (g.ok()) {
    check_indices(*g);
  } else {
    fuzz::require(g.error().message.find('\n') == std::string::npos, "a message is one line");
  }
  return 0;
}
