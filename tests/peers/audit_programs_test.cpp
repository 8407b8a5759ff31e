// The auditor on meshes that tetgen and gmsh make: sound ones pass, and planted faults are found.
// Built only where the programs are found.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/support/data.hpp"
#include "tests/support/temporary_directory.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/polyhedral_domain.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/tet_embedding.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::TemporaryDirectory;

bool run(const std::string& command) {
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

void expect_required_checks_pass(const audit::Report& report, const std::string& what) {
  for (const auto& check : report.checks)
    EXPECT_TRUE(check.pass() || !check.required) << what << ": " << check.name;
}

// ---- TetGen

std::optional<TetMesh> tetgen(const std::string& options, const std::string& input) {
  if (!run(std::string(WELLSPACED_TETGEN) + " " + options + " " + input)) return std::nullopt;
  const auto geometry = read_geometry(input.substr(0, input.rfind('.')) + ".1.node");
  if (!geometry || geometry->solid.tets.empty()) return std::nullopt;
  TetMesh mesh = geometry->solid;
  if (audit::is_negative(mesh))  // TetGen's convention
    for (auto& t : mesh.tets) std::swap(t[2], t[3]);
  return mesh;
}

TEST(AuditOfTetGen, FindsItsDelaunayMeshesSoundAndDelaunay) {
  if (std::string(WELLSPACED_TETGEN).empty()) GTEST_SKIP() << "no tetgen";
  const TemporaryDirectory directory;
  Random random(3);
  std::string text = "400 3 0 0\n";
  for (int i = 0; i < 400; ++i)
    text += std::to_string(i) + " " + std::to_string(random.uniform()) + " " +
            std::to_string(random.uniform()) + " " + std::to_string(random.uniform()) + "\n";
  const auto mesh = tetgen("", directory.write("points.node", text));
  ASSERT_TRUE(mesh);
  const auto report = audit::audit_tet_mesh(*mesh);
  expect_required_checks_pass(report, "points");
  EXPECT_TRUE(report.check("delaunay")->pass());
  EXPECT_EQ(report.measure("boundary_genus")->value, 0);
}

TEST(AuditOfTetGen, FindsItsQualityMeshesOfTheDomainsSoundAndConforming) {
  if (std::string(WELLSPACED_TETGEN).empty()) GTEST_SKIP() << "no tetgen";
  const TemporaryDirectory directory;
  for (const std::string file : {"cgal_cube.smesh", "cgal_cross.smesh", "cgal_corner.smesh",
                                 "cgal_beam.smesh", "cgal_pipe.smesh", "tetgen_example.poly"}) {
    WELLSPACED_REQUIRE_DATA("domains3d/" + file);
    std::ifstream in(test::data_path("domains3d/" + file), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const std::string input = directory.write(file, text);
    const auto system = read_geometry(input);
    ASSERT_TRUE(system) << system.error().message;
    const auto mesh = tetgen("-pq1.4a0.01", input);
    ASSERT_TRUE(mesh) << file;
    const audit::PolyhedralDomain domain = audit::domain_of(to_pls(*system));
    audit::TetAuditOptions options;
    options.domain = &domain;
    options.allowance = 32;  // its files have 16 digits
    const auto report = audit::audit_tet_mesh(*mesh, options);
    expect_required_checks_pass(report, file);
    TetMesh broken = *mesh;
    std::swap(broken.tets[broken.tets.size() / 2][0], broken.tets[broken.tets.size() / 2][1]);
    EXPECT_EQ(audit::audit_tet_mesh(broken).check("no_inverted")->violations, 1u) << file;
    broken = *mesh;
    broken.tets.push_back(broken.tets[3]);
    EXPECT_FALSE(audit::audit_tet_mesh(broken).check("no_overlap")->pass()) << file;
    broken = *mesh;
    broken.tets.erase(broken.tets.begin() + 7);
    EXPECT_FALSE(audit::audit_tet_mesh(broken, options).pass()) << file;
  }
}

// ---- Gmsh

// A square with a triangular hole, graded.
constexpr const char* kGeo =
    "Point(1)={0,0,0,0.1}; Point(2)={1,0,0,0.1}; Point(3)={1,1,0,0.02}; Point(4)={0,1,0,0.1};\n"
    "Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};\n"
    "Point(5)={0.4,0.4,0,0.05}; Point(6)={0.6,0.4,0,0.05}; Point(7)={0.5,0.6,0,0.05};\n"
    "Line(5)={5,6}; Line(6)={6,7}; Line(7)={7,5};\n"
    "Line Loop(1)={1,2,3,4}; Line Loop(2)={5,6,7}; Plane Surface(1)={1,2};\n"
    "v[] = Extrude {0,0,0.5} { Surface{1}; };\n";

// What a text in Medit's format holds, both kinds of elements; all vertices have three coordinates.
struct MeditMesh {
  TriangleMesh plane;
  TetMesh solid;
};

template <std::size_t N>
void read_elements(std::istream& in, std::vector<std::array<Index, N>>& elements) {
  std::size_t count = 0;
  in >> count;
  for (std::size_t i = 0; i < count && in; ++i) {
    std::array<Index, N> nodes{};
    int marker = 0;
    for (Index& v : nodes) in >> v, --v;
    in >> marker;
    elements.push_back(nodes);
  }
}

MeditMesh read_medit(const std::string& path) {
  std::ifstream in(path);
  MeditMesh mesh;
  for (std::string word; in >> word;) {
    if (word == "Vertices") {
      std::size_t count = 0;
      in >> count;
      for (std::size_t i = 0; i < count; ++i) {
        Point3 p;
        int marker = 0;
        in >> p.x >> p.y >> p.z >> marker;
        mesh.solid.points.push_back(p);
        mesh.plane.points.push_back({p.x, p.y});
      }
    }
    if (word == "Triangles") read_elements(in, mesh.plane.triangles);
    if (word == "Tetrahedra") read_elements(in, mesh.solid.tets);
  }
  return mesh;
}

TEST(AuditOfGmsh, FindsAPlaneMeshWithAHoleSound) {
  if (std::string(WELLSPACED_GMSH).empty()) GTEST_SKIP() << "no gmsh";
  const TemporaryDirectory directory;
  const std::string geo =
      directory.write("a.geo", std::string(kGeo).substr(0, std::string(kGeo).find("v[]")));
  const std::string out = directory / "a.mesh";
  ASSERT_TRUE(run(std::string(WELLSPACED_GMSH) + " -2 -format mesh -o " + out + " " + geo));
  TriangleMesh mesh = read_medit(out).plane;
  const auto report = audit::audit_mesh(mesh);
  expect_required_checks_pass(report, "gmsh");
  EXPECT_GT(report.measure("triangles")->value, 100);
  EXPECT_EQ(report.measure("holes")->value, 1);
  EXPECT_NEAR(report.measure("area")->value, 0.98, 1e-9);
  const Pslg domain{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}},
                    {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}, {4, 5, 0}, {5, 6, 0}, {6, 4, 0}},
                    {{0.5, 0.45}},
                    {},
                    {}};
  audit::MeshAuditOptions options;
  options.domain = &domain;
  options.allowance = 128;  // its files have 15 digits
  for (const auto& check : audit::audit_mesh(mesh, options).checks)
    EXPECT_TRUE(check.pass() || !check.required) << check.name << " " << check.violations;
  mesh.triangles.erase(mesh.triangles.begin() + 17);
  EXPECT_FALSE(audit::audit_mesh(mesh, options).pass());
}

TEST(AuditOfGmsh, FindsATetrahedralMeshSound) {
  if (std::string(WELLSPACED_GMSH).empty()) GTEST_SKIP() << "no gmsh";
  const TemporaryDirectory directory;
  const std::string geo = directory.write("a.geo", kGeo), out = directory / "a.mesh";
  ASSERT_TRUE(
      run(std::string(WELLSPACED_GMSH) + " -3 -clscale 2 -format mesh -o " + out + " " + geo));
  TetMesh mesh = read_medit(out).solid;
  if (audit::is_negative(mesh))
    for (auto& t : mesh.tets) std::swap(t[2], t[3]);
  const auto report = audit::audit_tet_mesh(mesh);
  expect_required_checks_pass(report, "gmsh");
  EXPECT_GT(report.measure("tets")->value, 100);
  EXPECT_NEAR(report.measure("volume")->value, 0.49, 1e-9);
  EXPECT_EQ(report.measure("boundary_genus")->value, 1);
}

}  // namespace
}  // namespace wellspaced
