// Reading a fuzzer's bytes as points and numbers that are likely to be degenerate.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::fuzz {

/// Ends the process, so that the fuzzer reports the input.
inline void require(bool promise) {
  if (!promise) std::abort();
}

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  std::uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }

  /// A finite double: any bits, a small whole number, or a third of one, as the first byte says.
  double coordinate() {
    const std::uint8_t kind = byte();
    if (kind < 128) return kind % 16;
    if (kind < 176) return (kind % 16) / 3.0;
    if (kind < 208) return std::ldexp(byte(), (kind % 32) * 66 - 1074);
    if (kind < 240) return std::nextafter(kind % 4, kind % 2 == 0 ? 9. : -9.);
    std::uint8_t raw[sizeof(double)];
    for (std::uint8_t& b : raw) b = byte();
    double value;
    std::memcpy(&value, raw, sizeof value);
    return std::isfinite(value) ? value : 1;
  }

  Point2 point() {
    const double x = coordinate();
    return {x, coordinate()};
  }

  Point3 point3() {
    const Point2 p = point();
    return {p.x, p.y, coordinate()};
  }

  std::vector<Point3> points3(std::size_t most) {
    std::vector<Point3> points;
    for (std::size_t n = byte() % (most + 1); n > 0 && !empty(); --n) points.push_back(point3());
    return points;
  }

  std::vector<Point2> points(std::size_t most) {
    std::vector<Point2> points;
    for (std::size_t n = byte() % (most + 1); n > 0 && !empty(); --n) points.push_back(point());
    return points;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace wellspaced::fuzz
