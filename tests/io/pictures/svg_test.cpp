#include "wellspaced/io/pictures/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <set>

#include "wellspaced/io/pictures/pen.hpp"

namespace wellspaced {
namespace {

using Line = std::pair<std::pair<int, int>, std::pair<int, int>>;

// The lines that the data of a path draw, each with its lower end first.
std::multiset<Line> drawn(const std::string& data) {
  std::multiset<Line> lines;
  const std::regex token("[Ml]|-?[0-9]+");
  std::vector<int> numbers;
  std::pair<int, int> at;
  bool moves = false;
  for (std::sregex_iterator i(data.begin(), data.end(), token), end; i != end; ++i) {
    if (i->str() == "M" || i->str() == "l") {
      moves = i->str() == "M";
      continue;
    }
    numbers.push_back(std::stoi(i->str()));
    if (numbers.size() < 2) continue;
    const std::pair<int, int> to = moves ? std::pair(numbers[0], numbers[1])
                                         : std::pair(at.first + numbers[0], at.second + numbers[1]);
    if (!moves) lines.insert(std::minmax(at, to));
    at = to;
    numbers.clear();
  }
  return lines;
}

std::string mesh_svg(const TriangleMesh& mesh) {
  TextWriter out;
  write_mesh_svg(out, mesh);
  return out.text();
}

TriangleMesh square() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.segments = {{0, 1, 1}};
  return mesh;
}

TEST(PathData, DrawsALineOnce) {
  EXPECT_EQ(path_data({{{0, 0}, {5, -3}}}), "M0 0l5-3");
  EXPECT_EQ(path_data({{{0, 0}, {5, 3}}, {{5, 3}, {0, 0}}, {{1, 1}, {1, 1}}}), "M0 0l5 3");
  EXPECT_EQ(path_data({}), "");
}

TEST(PathData, DrawsExactlyTheLinesInFewStrokes) {
  std::vector<GridLine> lines;
  std::multiset<Line> expected;
  const auto add = [&](GridPoint a, GridPoint b) {
    lines.push_back({b, a});
    expected.insert(std::minmax(std::pair(a.x, a.y), std::pair(b.x, b.y)));
  };
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y) {
      add({x, y}, {x + 1, y});
      add({x, y}, {x, y + 1});
      add({x, y}, {x + 1, y + 1});
    }
  const std::string data = path_data(lines);
  EXPECT_EQ(drawn(data), expected);
  EXPECT_LT(std::count(data.begin(), data.end(), 'M'), 50);
}

TEST(Canvas, MapsTheBoxToTheWidthWithYDownwards) {
  const std::vector<Point2> points = {{-1, 2}, {3, 4}};
  const Canvas canvas(points, 100);
  EXPECT_EQ(canvas.height(), 50);
  EXPECT_EQ(canvas.place({-1, 4}), (GridPoint{0, 0}));
  EXPECT_EQ(canvas.place({3, 2}), (GridPoint{100, 50}));
}

TEST(Canvas, TakesEveryFiniteBox) {
  const double max = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<std::vector<Point2>> sets = {{},
                                                 {{1, 1}},
                                                 {{-max, -max}, {max, max}},
                                                 {{0, 0}, {tiny, tiny}},
                                                 {{0, 0}, {0, max}},
                                                 {{0, 0}, {tiny, max}},
                                                 {{max, 0}, {max, tiny}}};
  for (const auto& points : sets) {
    const Canvas canvas(points, 1000);
    EXPECT_LE(canvas.height(), 4000);
    for (const Point2& p : points) {
      const GridPoint q = canvas.place(p);
      EXPECT_TRUE(q.x >= 0 && q.x <= 1000 && q.y >= 0 && q.y <= canvas.height());
    }
  }
}

TEST(MeshSvg, DrawsEdgesAndSegments) {
  const std::string svg = mesh_svg(square());
  EXPECT_EQ(svg.rfind("<svg xmlns=", 0), 0u);
  EXPECT_NE(svg.find("viewBox=\"0 0 8100 8100\""), std::string::npos);
  EXPECT_NE(svg.find("non-scaling-stroke"), std::string::npos);
  const std::regex path(" d=\"([^\"]*)\"");
  std::vector<std::size_t> counts;
  for (std::sregex_iterator i(svg.begin(), svg.end(), path), end; i != end; ++i)
    counts.push_back(drawn((*i)[1]).size());
  EXPECT_EQ(counts, (std::vector<std::size_t>{5, 1}));
}

TEST(MeshSvg, DrawsBarePointsAndNothing) {
  TriangleMesh mesh;
  EXPECT_NE(mesh_svg(mesh).find("</svg>"), std::string::npos);
  mesh.points = {{0, 0}, {2, 1}};
  EXPECT_NE(mesh_svg(mesh).find("M0 4000h0M8000 0h0"), std::string::npos);
}

TEST(PanelsSvg, SetsMeshesSideBySideWithTheirCaptions) {
  const TriangleMesh mesh = square();
  const std::vector<Panel> panels = {{&mesh, "level 0"}, {&mesh, "a < b & c"}, {&mesh, "last"}};
  TextWriter out;
  write_panels_svg(out, panels, 2, {.width = 100});
  EXPECT_NE(out.text().find("viewBox=\"0 0 2200 2680\""), std::string::npos);
  EXPECT_NE(out.text().find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_NE(out.text().find("translate(50 1390)"), std::string::npos);
  TextWriter none;
  write_panels_svg(none, {}, 3);
  EXPECT_NE(none.text().find("</svg>"), std::string::npos);
}

TEST(MeshSvg, AZoomShowsThePartAroundItsCentre) {
  TriangleMesh mesh = square();
  mesh.points.push_back({0.5, 0.25});
  mesh.triangles = {{0, 1, 4}, {2, 3, 4}};
  TextWriter out;
  write_mesh_svg(out, mesh, {.width = 100, .zoom = 4, .centre = Point2{0.5, 0}});
  const std::string svg = out.text();
  EXPECT_NE(svg.find("width=\"110\" height=\"110\""), svg.npos) << svg;
  // 400 pixels wide as a whole: the centre is at (2000, 4000), the part begins at (1500, 3500).
  EXPECT_NE(svg.find("translate(-1450 -3450)"), svg.npos) << svg;
  EXPECT_EQ(svg.find("M0 0"), svg.npos) << "the upper edge is out of sight: " << svg;
}

TEST(DisksSvg, DrawsADiskOfItsRadiusAroundEachPoint) {
  TextWriter out;
  write_disks_svg(out, square(), std::vector<double>{0.5, 0.25, 0, 0.5}, {.width = 100});
  const std::string svg = out.text();
  for (const char* disk : {"cx=\"0\" cy=\"1000\" r=\"500\"", "cx=\"1000\" cy=\"1000\" r=\"250\"",
                           "cx=\"1000\" cy=\"0\" r=\"5\"", "cx=\"0\" cy=\"0\" r=\"500\""})
    EXPECT_NE(svg.find(disk), svg.npos) << disk << '\n' << svg;
}

}  // namespace
}  // namespace wellspaced
