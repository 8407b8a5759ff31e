#include "wellspaced/io/formats/point_files.hpp"

#include <cmath>
#include <cstdint>

#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr std::size_t kF64Header = 16;
constexpr std::uint64_t kF64ReportEvery = 1 << 16;  // points

void add_point(Geometry& geometry, const std::array<double, 3>& c) {
  if (geometry.dimension == 2) {
    geometry.mesh.points.push_back({c[0], c[1]});
  } else {
    geometry.solid.points.push_back({c[0], c[1], c[2]});
  }
}

void read_line(Scanner& scanner, Geometry& geometry) {
  const std::size_t fields = scanner.count_fields();
  if (geometry.point_count() == 0 && (fields == 2 || fields == 3))
    geometry.dimension = static_cast<int>(fields);
  const auto expected = static_cast<std::size_t>(geometry.dimension);
  if (fields != expected)
    scanner.fail(ErrorCode::kUnreadable, {fields, " numbers where ", expected, " should stand"});
  if (geometry.point_count() == kNoIndex - 1)
    scanner.fail(ErrorCode::kLimit, "more than 4294967294 points");
  std::array<double, 3> c{};
  for (std::size_t i = 0; i < expected; ++i) c[i] = scanner.number("coordinate");
  if (scanner.ok()) add_point(geometry, c);
}

// Calls `visit` with each coordinate, point by point.
template <class Visit>
void for_each_coordinate(const Geometry& geometry, Visit visit) {
  for (const Point2& p : geometry.mesh.points) visit(p.x), visit(p.y);
  for (const Point3& p : geometry.solid.points) visit(p.x), visit(p.y), visit(p.z);
}

Error wrong(const std::string& name, ErrorCode code, const std::string& what) {
  return {code, {name, ": ", what}, {}};
}

}  // namespace

Result<Geometry> parse_xyz(std::string_view text, const TextSource& source) {
  Scanner scanner(text, source);
  Geometry geometry;
  while (scanner.next_line()) read_line(scanner, geometry);
  if (!scanner.ok()) return scanner.error();
  return geometry;
}

void write_xyz(TextWriter& out, const Geometry& geometry) {
  for (const Point2& p : geometry.mesh.points) out << p.x << ' ' << p.y << '\n';
  for (const Point3& p : geometry.solid.points) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
}

bool looks_like_f64(std::string_view bytes) {
  if (bytes.size() < kF64Header) return false;
  const auto dimension = read_bytes<std::uint64_t>(bytes, 0);
  const auto count = read_bytes<std::uint64_t>(bytes, 8);
  const std::uint64_t doubles = (bytes.size() - kF64Header) / 8;
  return (dimension == 2 || dimension == 3) && bytes.size() % 8 == 0 && doubles % dimension == 0 &&
         count == doubles / dimension;
}

Result<Geometry> parse_f64(std::string_view bytes, const TextSource& source) {
  if (!looks_like_f64(bytes))
    return wrong(source.name, ErrorCode::kUnreadable,
                 "the size does not fit a dimension of 2 or 3 and a count, each of 64 bits, and "
                 "as many doubles");
  Geometry geometry;
  geometry.dimension = static_cast<int>(read_bytes<std::uint64_t>(bytes, 0));
  const auto dimension = static_cast<std::uint64_t>(geometry.dimension);
  const auto count = read_bytes<std::uint64_t>(bytes, 8);
  if (count >= kNoIndex)
    return wrong(source.name, ErrorCode::kLimit, "more than 4294967294 points");
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % kF64ReportEvery == 0 && !source.keep_going(i, count)) return source.cancelled();
    std::array<double, 3> c{};
    for (std::uint64_t k = 0; k < dimension; ++k) {
      c[k] = read_bytes<double>(bytes, kF64Header + 8 * (i * dimension + k));
      if (!std::isfinite(c[k]))
        return wrong(source.name, ErrorCode::kInvalidGeometry,
                     concat({"point ", i, " (counted from 0) is not finite"}));
    }
    add_point(geometry, c);
  }
  return geometry;
}

void write_f64(TextWriter& out, const Geometry& geometry) {
  std::string bytes;
  append_bytes(bytes, static_cast<std::uint64_t>(geometry.dimension));
  append_bytes(bytes, static_cast<std::uint64_t>(geometry.point_count()));
  out << bytes;
  for_each_coordinate(geometry, [&](double coordinate) {
    bytes.clear();
    append_bytes(bytes, coordinate);
    out << bytes;
  });
}

}  // namespace wellspaced
