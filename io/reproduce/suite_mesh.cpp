#include "wellspaced/io/reproduce/suite_mesh.hpp"

#include <cmath>
#include <utility>

#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/reproduce/published.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/sha256.hpp"

namespace wellspaced {
namespace {

constexpr double kGridSide = 1000;
constexpr double kCutOtherWay = 0.13;  // CHOICES 12: fits the published size of level 1

struct GridSource {
  std::string_view name, title;
  double aspect;
};
constexpr GridSource kGrids[] = {
    {"grid1", "GRID(1)", 1}, {"grid10", "GRID(10)", 10}, {"grid20", "GRID(20)", 20}};

// file: in the folder of the data. The thesis measured CRACK and AIRFOIL 3 re-triangulated for
// Table 8.1 and coarsened the triangles as they were distributed (CHOICES 5).
struct MeshSource {
  std::string_view name, title, file;
  GradedDomain stand_in;
  Index nodes;
};
constexpr MeshSource kSources[] = {
    {"crack", "CRACK", "crack_float32", GradedDomain::kCrack, 10183},
    {"airfoil1", "AIRFOIL 1", "airfoil1", GradedDomain::kAirfoil, 4253},
    {"airfoil3", "AIRFOIL 3", "airfoil3_original", GradedDomain::kAirfoil, 15606},
    {"crack_triangulated", "CRACK", "crack", GradedDomain::kCrack, 10183},
    {"airfoil3_triangulated", "AIRFOIL 3", "airfoil3", GradedDomain::kAirfoil, 15606},
};

SuiteMesh grid_mesh(const GridSource& source, double scale) {
  const auto side = static_cast<Index>(std::fmax(2, std::floor(kGridSide * scale + 0.5)));
  const GridOptions options{.nx = side,
                            .ny = side,
                            .aspect = source.aspect,
                            .diagonals = GridDiagonals::kMixed,
                            .mixed = kCutOtherWay};
  SuiteMesh mesh{.name = std::string(source.name), .title = std::string(source.title)};
  mesh.origin =
      concat({"grid of ", side, " by ", side, " nodes, 13% of the cells cut the other way"});
  mesh.identity = concat({mesh.name, " of side ", side});
  mesh.is_original = scale == 1;
  mesh.make = [options](std::uint64_t seed) {
    GridOptions seeded = options;
    seeded.seed = seed;
    return generate_grid(seeded);
  };
  return mesh;
}

// The numbers of a mesh's arrays, hashed as text: the same on every machine.
std::string fingerprint(const TriangleMesh& mesh) {
  TextWriter text;
  for (const Point2& p : mesh.points) text << p.x << ' ' << p.y << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << a << ' ' << b << ' ' << c << '\n';
  for (const Segment& s : mesh.segments) text << s.a << ' ' << s.b << '\n';
  return sha256(text.text());
}

SuiteMesh fixed_mesh(const MeshSource& source, TriangleMesh triangles) {
  SuiteMesh mesh{.name = std::string(source.name), .title = std::string(source.title)};
  mesh.identity = concat({mesh.name, " ", fingerprint(triangles)});
  mesh.make = [triangles = std::move(triangles)](std::uint64_t) {
    return Result<TriangleMesh>(triangles);
  };
  return mesh;
}

Result<SuiteMesh> original_mesh(const MeshSource& source, const std::string& folder) {
  const std::string file(source.file);
  auto geometry = read_mesh(concat({folder, "/", file}));
  if (!geometry) return geometry.error();
  const bool is_original = geometry->mesh.points.size() == source.nodes;
  SuiteMesh mesh = fixed_mesh(source, std::move(geometry->mesh));
  mesh.is_original = is_original;
  mesh.origin = concat({file, is_original ? "" : ", which is not the thesis' mesh"});
  const auto special = special_points_of(source.name);
  if (is_original && !special.empty()) mesh.fixed = {special.begin(), special.end()};
  return mesh;
}

std::string stand_in_command(const MeshSource& source) {
  const bool is_crack = source.stand_in == GradedDomain::kCrack;
  return concat({"generate ", is_crack ? "crack" : "airfoil", " --nodes ", source.nodes});
}

Result<SuiteMesh> stand_in_mesh(const MeshSource& source, const Progress& progress) {
  auto triangles = generate_graded_mesh(source.stand_in, {.nodes = source.nodes}, progress);
  if (!triangles) return triangles.error();
  SuiteMesh mesh = fixed_mesh(source, std::move(*triangles));
  mesh.origin = concat({"a stand-in, not the thesis' mesh: ", stand_in_command(source)});
  return mesh;
}

}  // namespace

Result<SuiteMesh> make_suite_mesh(const std::string& name, const std::string& data, double scale,
                                  const Progress& progress) {
  for (const GridSource& grid : kGrids)
    if (grid.name == name) return grid_mesh(grid, scale);
  for (const MeshSource& source : kSources)
    if (source.name == name)
      return data.empty() ? stand_in_mesh(source, progress) : original_mesh(source, data);
  return Error{ErrorCode::kInternal, {"no mesh of the name ", name}};
}

}  // namespace wellspaced
