#include "wellspaced/io/cli/hole_seeds.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::cli {
namespace {

std::vector<Box2> boxes_of_seeds(const std::vector<Point2>& seeds) {
  std::vector<Box2> boxes;
  for (const Point2 p : seeds) boxes.push_back({p, p});
  return boxes;
}

std::vector<std::uint8_t> filled_seeds(const TriangleMesh& mesh, const std::vector<Point2>& seeds) {
  std::vector<std::uint8_t> filled(seeds.size());
  const BoxTree tree(boxes_of_seeds(seeds));
  for (const auto& t : mesh.triangles) {
    const std::array corners = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    const auto& [a, b, c] = corners;
    tree.for_each_meeting(Box2::around(corners), [&, a = a, b = b, c = c](std::size_t i) {
      if (orient2d(a, b, seeds[i]) >= 0 && orient2d(b, c, seeds[i]) >= 0 &&
          orient2d(c, a, seeds[i]) >= 0)
        filled[i] = 1;
    });
  }
  return filled;
}

}  // namespace

void leave_out_filled_holes(const std::string& name, HoleRule rule, Session& session,
                            Geometry& geometry) {
  if (geometry.holes.empty()) return;
  const std::vector<std::uint8_t> filled = filled_seeds(geometry.mesh, geometry.holes);
  const auto first = std::find(filled.begin(), filled.end(), 1);
  if (first == filled.end()) return;
  const auto count = std::count(filled.begin(), filled.end(), 1);
  session.note(concat({name, ": ", count, count == 1 ? " hole seed lies" : " hole seeds lie",
                       " in the mesh and not in a hole, the first: seed ", first - filled.begin(),
                       " (counted from 0); left out: ",
                       rule == HoleRule::kSeeds ? "seeds must lie off the segments"
                                                : "only --holes seeds makes holes of them"}));
  std::vector<Point2> open;
  for (std::size_t i = 0; i < filled.size(); ++i)
    if (!filled[i]) open.push_back(geometry.holes[i]);
  geometry.holes = std::move(open);
}

}  // namespace wellspaced::cli
