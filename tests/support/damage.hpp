// Damaged texts: a reader must refuse or read each of them, never crash or hang.
#pragma once

#include "tests/support/formats.hpp"

namespace wellspaced::test {

inline void expect_sound(const Geometry& g) {
  const std::size_t count = g.point_count();
  for (const auto& t : g.mesh.triangles)
    for (const Index v : t) ASSERT_LT(v, count);
  for (const Segment& s : g.mesh.segments) ASSERT_LT(std::max(s.a, s.b), count);
  for (const auto& t : g.solid.tets)
    for (const Index v : t) ASSERT_LT(v, count);
  for (const auto& f : g.solid.facets)
    for (const Index v : f.points) ASSERT_LT(v, count);
  for (const auto& f : g.polygons)
    for (const auto& polygon : f.polygons)
      for (const Index v : polygon) ASSERT_LT(v, count);
  for (const Segment& s : g.solid.segments) ASSERT_LT(std::max(s.a, s.b), count);
  ASSERT_TRUE(g.point_markers().empty() || g.point_markers().size() == count);
}

/// Cuts `text` everywhere (at 500 places if it is longer) and changes up to three bytes of it at
/// random, 2000 times: whatever `parse` accepts is sound, what it refuses has a message of one
/// line, and it refuses something.
inline void expect_survives_damage(Parser parse, const std::string& text) {
  Random random(7);
  int refused = 0;
  const auto check = [&](std::string_view damaged) {
    const auto result = parse(damaged, "x");
    if (result.ok()) return expect_sound(*result);
    ++refused;
    ASSERT_EQ(result.error().message.find('\n'), std::string::npos) << result.error().message;
    ASSERT_EQ(result.error().message.find('x'), 0u) << result.error().message;
  };
  const std::size_t step = text.size() / 500 + 1;
  for (std::size_t length = 0; length < text.size(); length += step)
    check(std::string_view(text).substr(0, length));
  for (int round = 0; round < 2000; ++round) {
    std::string damaged = text;
    for (std::uint64_t hits = 1 + random.below(3); hits > 0; --hits)
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    check(damaged);
  }
  EXPECT_GT(refused, 100);
}

}  // namespace wellspaced::test
