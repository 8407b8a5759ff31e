// Bare point sets: .xyz text and .f64 binary.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Reads one point a line: 2 or 3 numbers, the same count on every line, no header.
/// Errors: kUnreadable for malformed text; kInvalidGeometry for NaN and infinity.
Result<Geometry> parse_xyz(std::string_view text, const TextSource& source);
void write_xyz(TextWriter& out, const Geometry& geometry);

/// Reads a 64-bit dimension (2 or 3), a 64-bit count and the coordinates as doubles, point by
/// point, all little-endian. Errors: as parse_xyz; kUnreadable unless the size fits exactly.
Result<Geometry> parse_f64(std::string_view bytes, const TextSource& source);
void write_f64(TextWriter& out, const Geometry& geometry);

/// Whether the header of `bytes` tells their size right.
bool looks_like_f64(std::string_view bytes);

}  // namespace wellspaced
