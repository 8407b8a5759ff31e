// A program of a user who has the library as two files.
#include "wellspaced.hpp"

#include <cstdio>

using namespace wellspaced;

int main() {
  GradedMeshOptions options;
  options.nodes = 1000;
  const auto mesh = generate_graded_mesh(GradedDomain::kAirfoil, options);
  if (!mesh) return std::puts(mesh.error().message.c_str()), 1;
  const auto hierarchy = coarsen(*mesh, {});
  if (!hierarchy || hierarchy->levels.size() < 3) return std::puts("too few levels"), 1;
  TextWriter out;
  write_vtu(out, vtk_grid(hierarchy->levels.back().mesh));
  const auto back = parse_vtu(out.text(), "memory");
  if (!back) return std::puts(back.error().message.c_str()), 1;
  return back->mesh.points == hierarchy->levels.back().mesh.points ? 0 : 1;
}
