#include "wellspaced/io/formats/triangle_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

constexpr const char* kSquareNodes = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";

Geometry node(std::string_view text) {
  auto result = parse_node(text, "x.node");
  EXPECT_TRUE(result.ok()) << result.error().message;
  return result.ok() ? *std::move(result) : Geometry{};
}

Geometry poly(std::string_view text) {
  auto result = parse_poly(text, "x.poly");
  EXPECT_TRUE(result.ok()) << result.error().message;
  return result.ok() ? *std::move(result) : Geometry{};
}

template <class T>
void expect_error(const Result<T>& result, ErrorCode code, const std::string& part) {
  ASSERT_FALSE(result.ok()) << part;
  EXPECT_EQ(result.error().code, code) << result.error().message;
  EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
}

std::string written(void (*write)(TextWriter&, const Geometry&), const Geometry& geometry) {
  TextWriter out;
  write(out, geometry);
  return out.text();
}

// ---- .node ---------------------------------------------------------------------------------

TEST(ParseNode, ReadsPointsAttributesAndMarkers) {
  const Geometry g = node("2 2 2 1\n0 1.5 -2 10 20 7\n1 3 4 30 40 -1\n");
  EXPECT_EQ(g.mesh.points, (std::vector<Point2>{{1.5, -2}, {3, 4}}));
  EXPECT_EQ(g.point_attributes.columns, 2u);
  EXPECT_EQ(g.point_attributes.values, (std::vector<double>{10, 20, 30, 40}));
  EXPECT_EQ(g.mesh.point_markers, (std::vector<int>{7, -1}));
  EXPECT_EQ(g.index_base, 0u);
}

TEST(ParseNode, TakesTheIndexBaseFromTheFirstPoint) {
  EXPECT_EQ(node(kSquareNodes).index_base, 1u);
  EXPECT_EQ(node("1 2 0 0\n0 5 5").index_base, 0u);
  EXPECT_EQ(node("0 2 0 0").index_base, 0u);
  expect_error(parse_node("1 2 0 0\n2 5 5", "x.node"), ErrorCode::kUnreadable,
               "x.node:2: the first point has number 2");
  expect_error(parse_node("2 2 0 0\n1 5 5\n3 6 6", "x.node"), ErrorCode::kUnreadable,
               "x.node:3: point number 3 where 2 should follow");
}

TEST(ParseNode, ReadsPointsInSpace) {
  const Geometry g = node("2 3 0 1\n1 1 2 3 9\n2 4 5 6 8\n");
  EXPECT_EQ(g.dimension, 3);
  EXPECT_EQ(g.solid.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(g.solid.point_markers, (std::vector<int>{9, 8}));
}

TEST(ParseNode, AcceptsWhatTheFormatAllows) {
  const Geometry plain = node(kSquareNodes);
  for (const std::string& text :
       {std::string("4\n1 0 0\n2 1 0\n3 1 1\n4 0 1"),  // only the count
        std::string("# c\n\n4 2 # c\n1 0 0\n2 1 0 # c\n3 1 1\n4 0 1\n# end"),
        std::string("4\t2\t0\t0\r\n1\t0\t0\r\n2 1 0\r\n\r\n3 1 1\r\n4 0 1\r\n"),
        std::string("\xEF\xBB\xBF") + kSquareNodes,
        std::string("4 2 0 0\n1 0 0 ignored 5\n2 1e0 -0\n3 +1 0x1p0\n4 .0 1.\n")})
    EXPECT_EQ(node(text).mesh.points, plain.mesh.points) << text;
}

TEST(ParseNode, KeepsDuplicatesAndSignedZerosAndSubnormals) {
  const Geometry g = node("4 2 0 0\n0 -0 5e-324\n1 -0 5e-324\n2 -1e-400 1e-400\n3 0 0");
  EXPECT_EQ(g.mesh.points.size(), 4u);
  EXPECT_TRUE(std::signbit(g.mesh.points[0].x));
  EXPECT_EQ(g.mesh.points[0].y, std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::signbit(g.mesh.points[2].x));
  EXPECT_FALSE(std::signbit(g.mesh.points[2].y));
}

TEST(ParseNode, RefusesMalformedHeaders) {
  for (const char* text : {"", "# nothing", "x", "-1 2 0 0", "1.5 2", "2 4 0 0", "2 1 0 0",
                           "1 2 -1 0", "1 2 0 -1", "1 2 9999999999 0", "nan", "1e400", "4 2 0 0",
                           "\x80\x81\x82", "99999999999999999999 2 0 0"})
    expect_error(parse_node(text, "x.node"), ErrorCode::kUnreadable, "x.node");
}

TEST(ParseNode, RefusesHostileCountsBeforeItAllocates) {
  for (const char* text : {"4000000000 2 0 0\n1 0 0\n", "9223372036854775807 2 0 0\n1 0 0",
                           "3 2 1000000 1\n1 0 0\n", "1000 2 0 0\n1 0 0\n2 1 1\n"})
    expect_error(parse_node(text, "x.node"), ErrorCode::kUnreadable, "too short");
}

TEST(ParseNode, RefusesTruncatedAndOverlongFiles) {
  expect_error(parse_node("3 2 0 0\n1 0 0\n2 1 0.000000000", "x.node"), ErrorCode::kUnreadable,
               "ends before its 3 points do");
  expect_error(parse_node("2 2 0 0\n1 0.25 0.25\n2 1", "x.node"), ErrorCode::kUnreadable,
               "x.node:3: the y coordinate is missing");
  expect_error(parse_node("1 2 0 0\n1 0 0\n2 1 1", "x.node"), ErrorCode::kUnreadable,
               "x.node:3: more lines");
}

TEST(ParseNode, NamesTheLineOfNanInfinityAndOverflow) {
  expect_error(parse_node("2 2 0 0\n1 0 0\n2 1 nan", "x.node"), ErrorCode::kInvalidGeometry,
               "x.node:3: the y coordinate 'nan' is not finite");
  expect_error(parse_node("1 2 0 0\n1 -inf 0\n", "x.node"), ErrorCode::kInvalidGeometry, ":2:");
  expect_error(parse_node("1 2 0 0\n1 1e309 0\n", "x.node"), ErrorCode::kUnreadable, "too large");
}

// ---- .poly ---------------------------------------------------------------------------------

TEST(ParsePoly, ReadsSegmentsHolesAndRegions) {
  const Geometry g = poly(
      "4 2 0 1\n1 0 0 5\n2 4 0 5\n3 4 4 6\n4 0 4 6\n"
      "3 1\n1 1 2 10\n2 2 3 20\n3 3 4 -30\n"
      "1\n1 0.5 0.25\n"
      "2\n1 1 1 7 0.1\n2 2 2 8\n");
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 10}, {1, 2, 20}, {2, 3, -30}}));
  EXPECT_EQ(g.mesh.point_markers, (std::vector<int>{5, 5, 6, 6}));
  EXPECT_EQ(g.holes, (std::vector<Point2>{{0.5, 0.25}}));
  ASSERT_EQ(g.regions.size(), 2u);
  EXPECT_EQ(g.regions[0].attribute, 7);
  EXPECT_EQ(g.regions[0].max_area, 0.1);
  EXPECT_EQ(g.regions[1].max_area, 8) << "a missing area is the attribute, as in Triangle";
}

TEST(ParsePoly, LetsTheLastSectionsBeMissing) {
  EXPECT_TRUE(poly("2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 2").holes.empty());
  EXPECT_TRUE(poly("2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 2\n0").regions.empty());
}

TEST(ParsePoly, TakesPointsAndBaseFromTheNodeFile) {
  EXPECT_TRUE(poly_refers_to_node("# c\n0 2 0 1\n1 0\n1 1 2\n0"));
  EXPECT_FALSE(poly_refers_to_node("1 2 0 0\n"));
  EXPECT_FALSE(poly_refers_to_node("x"));
  const Geometry points = node(kSquareNodes);
  const auto g = parse_poly("0 2 0 1\n1 1\n1 4 1 3\n0\n", "x.poly", &points);
  ASSERT_TRUE(g.ok());
  EXPECT_EQ(g->mesh.points, points.mesh.points);
  EXPECT_EQ(g->mesh.segments, (std::vector<Segment>{{3, 0, 3}}));
}

TEST(ParsePoly, RefusesEndsThatAreNoPoints) {
  const std::string points = "2 2 0 0\n1 0 0\n2 1 0\n";
  for (const char* end : {"0", "3", "-1", "4294967297", "9223372036854775807"})
    expect_error(parse_poly(points + "1 0\n1 1 " + end + "\n0", "x.poly"),
                 ErrorCode::kInvalidGeometry, "x.poly:5: point ");
  expect_error(parse_poly(points + "1 0\n1 1 x\n0", "x.poly"), ErrorCode::kUnreadable, "'x'");
  expect_error(parse_poly("0 2 0 0\n1 0\n1 0 0\n", "x.poly"), ErrorCode::kInvalidGeometry,
               "there are none");
}

TEST(ParsePoly, RefusesMiscountedSections) {
  const std::string points = "2 2 0 0\n1 0 0\n2 1 0\n";
  expect_error(parse_poly(points, "x.poly"), ErrorCode::kUnreadable, "number of segments");
  expect_error(parse_poly(points + "3 0\n1 1 2\n0\n0", "x.poly"), ErrorCode::kUnreadable, "short");
  expect_error(parse_poly(points + "1 0\n1 1 2\n5\n1 1 1", "x.poly"), ErrorCode::kUnreadable,
               "too short for the 5 holes");
  expect_error(parse_poly(points + "1 0\n1 1 2\n0\n0\n1 2 3", "x.poly"), ErrorCode::kUnreadable,
               "more lines");
  expect_error(parse_poly(points + "1 0\n1 1 2\n1\n1 inf 0", "x.poly"), ErrorCode::kInvalidGeometry,
               "not finite");
}

// ---- .ele and .edge ------------------------------------------------------------------------

TEST(ParseEle, ReadsTrianglesWithAttributes) {
  Geometry g = node(kSquareNodes);
  ASSERT_TRUE(parse_ele("2 3 1\n1 1 2 3 0.5\n2 1 3 4 7\n", "x.ele", g).ok());
  EXPECT_EQ(g.mesh.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(g.cell_attributes.values, (std::vector<double>{0.5, 7}));
}

TEST(ParseEle, ReadsTetrahedraOverPointsInSpace) {
  Geometry g = node("4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  ASSERT_TRUE(parse_ele("1 4 0\n0 0 1 2 3\n", "x.ele", g).ok());
  EXPECT_EQ(g.solid.tets, (std::vector<std::array<Index, 4>>{{0, 1, 2, 3}}));
}

TEST(ParseEle, RefusesIndicesOfAnotherBase) {
  Geometry g = node(kSquareNodes);
  expect_error(parse_ele("2 3 0\n0 0 1 2\n1 0 2 3\n", "x.ele", g), ErrorCode::kInvalidGeometry,
               "x.ele:2: point 0 is not among the points: they are numbered from 1 to 4");
}

TEST(ParseEle, RefusesOtherElementsAndMiscounts) {
  for (const char* text : {"1 6 0\n1 1 2 3 4 1 2\n", "1 4 0\n1 1 2 3 4\n", "1 0 0\n1 1 2 3\n",
                           "2 3 0\n1 1 2 3\n", "1 3 0\n1 1 2\n", "1 3 1\n1 1 2 3\n",
                           "1 3 0\n1 1 2 3\n2 1 3 4\n", "", "4000000000 3 0\n1 1 2 3\n"}) {
    Geometry g = node(kSquareNodes);
    expect_error(parse_ele(text, "x.ele", g), ErrorCode::kUnreadable, "x.ele");
  }
}

TEST(ParseEdge, ReadsEdgesAndTheirMarkers) {
  const Geometry g = node(kSquareNodes);
  const auto edges = parse_edge("2 1\n1 1 2 3\n2 2 4 0\n", "x.edge", g);
  ASSERT_TRUE(edges.ok());
  EXPECT_EQ(*edges, (std::vector<Segment>{{0, 1, 3}, {1, 3, 0}}));
  expect_error(parse_edge("1 1\n1 1 5 3\n", "x.edge", g), ErrorCode::kInvalidGeometry, "point 5");
}

// ---- Writing -------------------------------------------------------------------------------

Geometry random_geometry(std::uint64_t seed) {
  Random random(seed);
  Geometry g;
  g.index_base = static_cast<Index>(seed % 2);
  const auto any_double = [&] {
    for (;;)
      if (const double x = std::bit_cast<double>(random.bits()); std::isfinite(x)) return x;
  };
  constexpr Index kPoints = 50;
  for (Index i = 0; i < kPoints; ++i) g.mesh.points.push_back({any_double(), any_double()});
  for (Index i = 0; i < kPoints; ++i)
    g.mesh.point_markers.push_back(static_cast<int>(random.bits()));
  g.point_attributes.columns = 2;
  for (Index i = 0; i < 2 * kPoints; ++i) g.point_attributes.values.push_back(any_double());
  const auto any_index = [&] { return static_cast<Index>(random.below(kPoints)); };
  g.cell_attributes.columns = 1;
  for (Index i = 0; i < 20; ++i) {
    g.mesh.triangles.push_back({any_index(), any_index(), any_index()});
    g.cell_attributes.values.push_back(any_double());
    g.mesh.segments.push_back({any_index(), any_index(), static_cast<int>(random.bits())});
    g.holes.push_back({any_double(), any_double()});
    g.regions.push_back({{any_double(), any_double()}, any_double(), any_double()});
  }
  return g;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

TEST(WriteTriangleText, ReadsBackBitForBitAndWritesTheSameAgain) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Geometry g = random_geometry(seed);
    TextWriter poly_text;
    write_poly(poly_text, g, PolyPoints::kInside);
    auto back = parse_poly(poly_text.text(), "x.poly");
    ASSERT_TRUE(back.ok()) << back.error().message;
    ASSERT_TRUE(parse_ele(written(write_ele, g), "x.ele", *back).ok());
    EXPECT_EQ(back->index_base, g.index_base);
    EXPECT_EQ(back->mesh.points, g.mesh.points);
    EXPECT_EQ(back->mesh.point_markers, g.mesh.point_markers);
    EXPECT_EQ(back->mesh.triangles, g.mesh.triangles);
    EXPECT_EQ(back->mesh.segments, g.mesh.segments);
    EXPECT_EQ(back->holes, g.holes);
    EXPECT_TRUE(same_bits(back->point_attributes.values, g.point_attributes.values));
    EXPECT_TRUE(same_bits(back->cell_attributes.values, g.cell_attributes.values));
    EXPECT_EQ(written(write_node, *back), written(write_node, g));
    TextWriter again;
    write_poly(again, *back, PolyPoints::kInside);
    EXPECT_EQ(again.text(), poly_text.text());
  }
}

TEST(WriteTriangleText, WritesWholeAttributesWithoutAPoint) {
  Geometry g = node("1 2 1 0\n0 1 2 7\n");
  EXPECT_EQ(written(write_node, g), "1 2 1 0\n0 1 2 7\n");
}

TEST(WriteEdge, WritesEachEdgeOnceWithTheMarkerOfItsSegment) {
  Geometry g = node(kSquareNodes);
  g.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  g.mesh.segments = {{1, 0, 9}};
  EXPECT_EQ(written(write_edge, g), "5 1\n1 1 2 9\n2 1 3 0\n3 1 4 0\n4 2 3 0\n5 3 4 0\n");
}

// ---- Damage --------------------------------------------------------------------------------

std::string sample_poly() {
  TextWriter out;
  write_poly(out, random_geometry(1), PolyPoints::kInside);
  return out.text();
}

TEST(ParsePoly, SurvivesEveryTruncation) {
  const std::string text = sample_poly();
  int refused = 0;
  for (std::size_t length = 0; length < text.size(); ++length)
    refused += !parse_poly(std::string_view(text).substr(0, length), "x.poly").ok();
  EXPECT_GT(refused, static_cast<int>(text.size() / 2));
}

TEST(ParsePoly, SurvivesRandomDamage) {
  Random random(7);
  const std::string text = sample_poly();
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string damaged = text;
    for (std::uint64_t hits = 1 + random.below(3); hits > 0; --hits)
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    const auto result = parse_poly(damaged, "x.poly");
    if (result.ok()) {
      for (const Segment& s : result->mesh.segments)
        ASSERT_LT(std::max(s.a, s.b), result->mesh.points.size());
    } else {
      ++refused;
      ASSERT_FALSE(result.error().message.empty());
    }
  }
  EXPECT_GT(refused, 5000);
}

TEST(ParseNode, SurvivesBinaryGarbage) {
  Random random(8);
  for (int round = 0; round < 2000; ++round) {
    std::string garbage(random.below(200), '\0');
    for (char& c : garbage) c = static_cast<char>(random.bits());
    EXPECT_FALSE(parse_node(garbage, "x.node").ok());
  }
}

}  // namespace
}  // namespace wellspaced
