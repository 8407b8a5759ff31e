// Readers and writers of file formats on texts in memory, and geometries to write.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/support/temporary_directory.hpp"
#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::test {

using Parser = Result<Geometry> (*)(std::string_view, const TextSource&);
using Writer = Status (*)(OutputSet&, const std::string&, const Geometry&);

/// What `parse` makes of a text called "x", which must be legal.
inline Geometry parsed(Parser parse, std::string_view text) {
  auto result = parse(text, "x");
  EXPECT_TRUE(result.ok()) << result.error().message << "\n" << text.substr(0, 500);
  return result.ok() ? *std::move(result) : Geometry{};
}

/// Expects that `parse` refuses a text called "x" with a message of one line that holds `part`.
inline void expect_refused(Parser parse, std::string_view text, const std::string& part) {
  const auto result = parse(text, "x");
  ASSERT_FALSE(result.ok()) << part;
  const std::string& message = result.error().message;
  EXPECT_TRUE(result.error().code == ErrorCode::kUnreadable ||
              result.error().code == ErrorCode::kInvalidGeometry)
      << message;
  EXPECT_EQ(message.substr(0, 1), "x") << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

/// The bytes that `write` makes of `geometry`, which must have a place in the format.
inline std::string written_by(Writer write, const Geometry& geometry) {
  const TemporaryDirectory directory;
  OutputSet outputs;
  const Status status = write(outputs, directory / "x", geometry);
  EXPECT_TRUE(status.ok()) << status.error().message;
  EXPECT_TRUE(outputs.commit().ok());
  return read_bytes(directory / "x");
}

/// Points in space, floats among them, with facets and marked segments; odd seeds have polygons of
/// more than three corners.
inline Geometry random_surface(std::uint64_t seed) {
  Random random(seed);
  Geometry g;
  g.dimension = 3;
  constexpr Index kPoints = 12;
  for (Index i = 0; i < kPoints; ++i)
    g.solid.points.push_back({double(i), double(float(random.uniform())), random.uniform() - 0.5});
  for (Index i = 0; i < 20; ++i) {
    Pls::Facet facet;
    facet.marker = static_cast<int>(i / 5);
    const Index first = static_cast<Index>(random.below(kPoints));
    facet.polygons.push_back({});
    for (Index k = 0; k < 3 + (seed % 2) * (i % 3); ++k)
      facet.polygons[0].push_back((first + k) % kPoints);
    add_facet(g, std::move(facet));
  }
  g.solid.segments = {{0, 5, 3}, {7, 2, -4}};
  return g;
}

}  // namespace wellspaced::test
