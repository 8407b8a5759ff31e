// The data block of a report: the meshes in few bytes, the statistics as JSON.
#pragma once

#include <string>

#include "wellspaced/io/report/report.hpp"

namespace wellspaced {

/// The report's data as a JSON text for report_data.js, safe within an HTML script element.
///
/// Points: those of all drawn levels, numbered along a Hilbert curve so that neighbours have near
/// numbers; coordinates as 32-bit multiples of a common step from a common origin.
/// Geometries: ascending node numbers as differences less 1; triangles as ranks in that list, each
/// rotated to its lowest rank a and sorted: a as the difference from the triangle before, then b -
/// a and c - b; segments (a, b) as the differences of a from the one before and of b from a.
/// Unsigned where the sign is known, else signed (0, -1, 1, -2, ...); 7 bits a byte, lowest first.
/// Equal geometries are written once.
std::string report_data(const HtmlReport& report);

}  // namespace wellspaced
