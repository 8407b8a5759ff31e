#include "wellspaced/io/formats/point_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wellspaced/io/text/bytes.hpp"

namespace wellspaced {
namespace {

std::string f64(std::uint64_t dimension, std::uint64_t count, const std::vector<double>& values) {
  std::string bytes;
  append_bytes(bytes, dimension);
  append_bytes(bytes, count);
  for (const double value : values) append_bytes(bytes, value);
  return bytes;
}

TEST(ParseXyz, ReadsPlaneAndSpaceByTheFirstLine) {
  const auto plane = parse_xyz("# c\n1 2\r\n\n 3\t4", "x.xyz");
  ASSERT_TRUE(plane.ok());
  EXPECT_EQ(plane->mesh.points, (std::vector<Point2>{{1, 2}, {3, 4}}));
  const auto space = parse_xyz("1 2 3\n4 5 6\n", "x.xyz");
  ASSERT_TRUE(space.ok());
  EXPECT_EQ(space->dimension, 3);
  EXPECT_EQ(space->solid.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_TRUE(parse_xyz("", "x.xyz").ok());
}

TEST(ParseXyz, RefusesLinesOfAnotherLength) {
  for (const char* text : {"1", "1 2 3 4", "1 2\n3 4 5", "1 2 3\n4 5", "1 x", "1,2"}) {
    const auto result = parse_xyz(text, "x.xyz");
    ASSERT_FALSE(result.ok()) << text;
    EXPECT_EQ(result.error().code, ErrorCode::kUnreadable) << text;
  }
  EXPECT_EQ(parse_xyz("1 2\n3 nan", "x.xyz").error().message,
            "x.xyz:2: the coordinate 'nan' is not finite");
}

TEST(ParseF64, ReadsLittleEndianDoubles) {
  const std::string bytes("\2\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\x80",
                          32);
  const auto g = parse_f64(bytes, "x.f64");
  ASSERT_TRUE(g.ok());
  ASSERT_EQ(g->mesh.points.size(), 1u);
  EXPECT_EQ(g->mesh.points[0].x, 1);
  EXPECT_TRUE(std::signbit(g->mesh.points[0].y));
  TextWriter out;
  write_f64(out, *g);
  EXPECT_EQ(out.text(), bytes);
}

TEST(ParseF64, RefusesSizesThatDoNotFit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& bytes :
       {std::string(), std::string(15, '\0'), f64(2, 2, {1, 2, 3}), f64(2, 1, {1, 2, 3}),
        f64(4, 1, {1, 2, 3, 4}), f64(0, 0, {}), f64(2, std::uint64_t{1} << 60, {1, 2}),
        f64(3, 6148914691236517206u, {1, 2}), f64(2, 1, {1, 2}) + "x"}) {
    const auto result = parse_f64(bytes, "x.f64");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kUnreadable);
  }
  const auto result = parse_f64(f64(2, 2, {1, 2, 3, nan}), "x.f64");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(result.error().message, "x.f64: point 1 (counted from 0) is not finite");
}

TEST(PointFiles, ReadBackWhatTheyWrite) {
  Geometry g;
  g.dimension = 3;
  g.solid.points = {{0.1, -0.0, 5e-324}, {1e308, -1e-308, 1.0 / 3}};
  TextWriter xyz, binary;
  write_xyz(xyz, g);
  write_f64(binary, g);
  EXPECT_EQ(parse_xyz(xyz.text(), "x")->solid.points, g.solid.points);
  EXPECT_EQ(parse_f64(binary.text(), "x")->solid.points, g.solid.points);
  EXPECT_EQ(xyz.text(), "0.1 -0 5e-324\n1e+308 -1e-308 0.3333333333333333\n");
}

}  // namespace
}  // namespace wellspaced
