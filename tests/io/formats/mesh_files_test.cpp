// What all mesh formats promise: meshes with markers come back as they were, damage is survived.
#include <gtest/gtest.h>

#include "tests/support/damage.hpp"
#include "tests/support/formats.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/solver_files.hpp"

namespace wellspaced {
namespace {

using test::parsed;
using test::written_by;

// What a format keeps besides points, cells and the markers of the boundary.
struct MeshFormat {
  const char* name;
  bool point_markers, cell_markers, segments_in_space, signs;
};

constexpr MeshFormat kMeshFormats[] = {
    {"gmsh", true, true, true, true},        {"gmsh22", true, true, true, true},
    {"gmsh-binary", true, true, true, true}, {"gmsh22-binary", true, true, true, true},
    {"vtu", true, true, true, true},         {"vtu-ascii", true, true, true, true},
    {"vtu-raw", true, true, true, true},     {"vtk", true, true, true, true},
    {"vtk-binary", true, true, true, true},  {"medit", true, true, true, true},
    {"mfem", false, true, false, false},     {"su2", false, false, false, true}};

const Format& format_named(std::string_view name) {
  for (const Format& format : formats())
    if (format.name == name) return format;
  ADD_FAILURE() << name;
  return formats()[0];
}

int some_marker(Random& random, bool signs) {
  return static_cast<int>(random.below(5)) + (signs ? -2 : 1);
}

// A fan of triangles around a point, with markers of every kind.
Geometry random_mesh(std::uint64_t seed, bool signs) {
  Random random(seed);
  Geometry g;
  for (Index i = 0; i < 9; ++i) {
    g.mesh.points.push_back({random.uniform() - 0.5, 1e-7 * random.uniform()});
    g.mesh.point_markers.push_back(some_marker(random, true));
  }
  g.cell_attributes.columns = 1;
  for (Index i = 1; i < 8; ++i) {
    g.mesh.triangles.push_back({0, i, i + 1});
    g.cell_attributes.values.push_back(some_marker(random, signs));
    g.mesh.segments.push_back({i, i + 1, some_marker(random, signs)});
  }
  return g;
}

Geometry random_tet_mesh(std::uint64_t seed, bool signs) {
  Random random(seed);
  Geometry g;
  g.dimension = 3;
  for (Index i = 0; i < 10; ++i) {
    g.solid.points.push_back({random.uniform(), random.uniform(), random.uniform()});
    g.solid.point_markers.push_back(some_marker(random, true));
  }
  g.cell_attributes.columns = 1;
  for (Index i = 2; i < 9; ++i) {
    g.solid.tets.push_back({0, 1, i, i + 1});
    g.cell_attributes.values.push_back(some_marker(random, signs));
    g.solid.facets.push_back({{0, i, i + 1}, some_marker(random, signs)});
    g.solid.segments.push_back({i, i + 1, some_marker(random, signs)});
  }
  return g;
}

TEST(MeshFormats, GiveBackTriangleMeshesWithTheirMarkers) {
  for (const MeshFormat& kept : kMeshFormats) {
    const Format& format = format_named(kept.name);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(kept.name);
      const Geometry g = random_mesh(seed, kept.signs);
      const std::string text = written_by(format.write, g);
      const Geometry back = parsed(format.parse, text);
      ASSERT_EQ(back.dimension, 2);
      EXPECT_EQ(back.mesh.points, g.mesh.points);
      EXPECT_EQ(back.mesh.triangles, g.mesh.triangles);
      if (kept.cell_markers) {
        EXPECT_EQ(cell_markers(back), cell_markers(g));
      }
      if (kept.point_markers) {
        EXPECT_EQ(back.mesh.point_markers, g.mesh.point_markers);
      }
      const bool grouped = std::string_view(kept.name) == "su2";
      if (!grouped) {
        EXPECT_EQ(back.mesh.segments, g.mesh.segments);
      }
      EXPECT_TRUE(written_by(format.write, back) == text) << "it is written again as it was";
    }
  }
}

TEST(MeshFormats, GiveBackTetMeshesWithTheirMarkers) {
  for (const MeshFormat& kept : kMeshFormats) {
    const Format& format = format_named(kept.name);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(kept.name);
      const Geometry g = random_tet_mesh(seed, kept.signs);
      const std::string text = written_by(format.write, g);
      const Geometry back = parsed(format.parse, text);
      ASSERT_EQ(back.dimension, 3);
      EXPECT_EQ(back.solid.points, g.solid.points);
      EXPECT_EQ(back.solid.tets, g.solid.tets);
      if (kept.cell_markers) {
        EXPECT_EQ(cell_markers(back), cell_markers(g));
      }
      if (kept.point_markers) {
        EXPECT_EQ(back.solid.point_markers, g.solid.point_markers);
      }
      if (kept.segments_in_space) {
        EXPECT_EQ(back.solid.facets, g.solid.facets);
        EXPECT_EQ(back.solid.segments, g.solid.segments);
      }
      EXPECT_TRUE(written_by(format.write, back) == text) << "it is written again as it was";
    }
  }
}

TEST(MeshFormats, SurviveDamageAndAreKnownByTheirContent) {
  for (const MeshFormat& kept : kMeshFormats) {
    SCOPED_TRACE(kept.name);
    const Format& format = format_named(kept.name);
    const std::string text = written_by(format.write, random_tet_mesh(1, kept.signs));
    test::expect_survives_damage(format.parse, text);
    const test::TemporaryDirectory directory;
    const auto g = read_geometry(directory.write("unknown", text));
    ASSERT_TRUE(g.ok()) << g.error().message;
    EXPECT_EQ(g->solid.tets.size(), 7u);
  }
}

TEST(MeshFormats, TakeARemarkWithoutHarm) {
  const auto expect_remark_in = [](const char* name) {
    SCOPED_TRACE(name);
    const Format& format = format_named(name);
    Geometry g = random_mesh(3, false);
    const Geometry bare = parsed(format.parse, written_by(format.write, g));
    g.remark = "incomplete: 3 of 4";
    const std::string text = written_by(format.write, g);
    EXPECT_NE(text.find(g.remark), std::string::npos);
    EXPECT_TRUE(format.recognise == nullptr || format.recognise(text));
    const Geometry back = parsed(format.parse, text);
    EXPECT_EQ(back.mesh.points, bare.mesh.points);
    EXPECT_EQ(back.mesh.triangles, bare.mesh.triangles);
    EXPECT_EQ(back.mesh.segments, bare.mesh.segments);
  };
  for (const MeshFormat& kept : kMeshFormats) expect_remark_in(kept.name);
  for (const char* surface : {"off", "obj"}) expect_remark_in(surface);
}

TEST(MeshFormats, KeepTheNamesOfMarkers) {
  Geometry g = random_mesh(3, false);
  g.mesh.segments[0].marker = 1;
  g.mesh.segments[1].marker = 2;
  g.marker_names = {{1, 1, "far field"}, {1, 2, "wall"}};
  for (const char* name : {"gmsh", "gmsh22", "su2"}) {
    const Format& format = format_named(name);
    const Geometry back = parsed(format.parse, written_by(format.write, g));
    for (const MarkerName& known : g.marker_names) {
      const bool found = std::any_of(back.marker_names.begin(), back.marker_names.end(),
                                     [&](const MarkerName& other) {
                                       return other.name == known.name && other.dimension == 1;
                                     });
      EXPECT_TRUE(found) << name << ": " << known.name;
    }
  }
}

}  // namespace
}  // namespace wellspaced
