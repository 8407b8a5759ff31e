#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/io/c/wellspaced.h"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/report/audit_report.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/memory.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

#ifndef WELLSPACED_VERSION
#define WELLSPACED_VERSION "unknown"
#endif

struct wellspaced_context {
  wellspaced::Geometry geometry;    // without a hierarchy
  wellspaced::Hierarchy hierarchy;  // or its levels
  std::size_t level = 0;
  std::string message;
  std::string report;  // of the last audit, JSON
  wellspaced_progress progress = nullptr;
  void* user = nullptr;
};

namespace wellspaced {
namespace {

Point2 point2_at(const double* p) { return {p[0], p[1]}; }
Point3 point3_at(const double* p) { return {p[0], p[1], p[2]}; }

wellspaced_status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return WELLSPACED_USAGE;
    case ErrorCode::kUnreadable:
      return WELLSPACED_UNREADABLE;
    case ErrorCode::kInvalidGeometry:
      return WELLSPACED_INVALID_GEOMETRY;
    case ErrorCode::kLimit:
      return WELLSPACED_LIMIT;
    case ErrorCode::kCancelled:
      return WELLSPACED_CANCELLED;
    case ErrorCode::kInternal:
      break;
  }
  return WELLSPACED_INTERNAL;
}

// Runs `operation`, which returns a Status, and turns what comes of it into a status and a message.
template <class Operation>
wellspaced_status run_on(wellspaced_context* context, const Operation& operation) {
  context->message.clear();
  const Status status = within_memory([&]() -> Status {
    Status result = operation();
    if (!result) context->message = printable(result.error().message);
    return result;
  });
  if (status.ok()) return WELLSPACED_OK;
  if (context->message.empty()) context->message = status.error().message;  // "out of memory"
  return status_of(status.error().code);
}

Progress progress_of(const wellspaced_context& context) {
  if (context.progress == nullptr) return {};
  return [call = context.progress, user = context.user](std::string_view phase, std::uint64_t done,
                                                        std::uint64_t total) {
    return call(user, std::string(phase).c_str(), done, total) != 0;
  };
}

Status check_counts(std::size_t points, std::size_t others) {
  if (points < kNoIndex && others < kNoIndex) return Ok{};
  return Error{ErrorCode::kLimit, "more than 4294967294 points, segments or triangles"};
}

Result<std::vector<Segment>> take_segments(const uint32_t* ends, const int* markers,
                                           std::size_t count, std::size_t points) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const Segment s{ends[2 * i], ends[2 * i + 1], markers == nullptr ? 0 : markers[i]};
    if (std::max(s.a, s.b) >= points)
      return Error{ErrorCode::kInvalidGeometry,
                   {"segment ", i, " ends at a point that does not exist"},
                   {static_cast<Index>(i)}};
    segments.push_back(s);
  }
  return segments;
}

template <class Point, std::size_t kDimension, class At>
Result<std::vector<Point>> take_points(const double* coordinates, std::size_t count, At at) {
  std::vector<Point> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* const p = coordinates + kDimension * i;
    if (!std::all_of(p, p + kDimension, [](double c) { return std::isfinite(c); }))
      return Error{
          ErrorCode::kInvalidGeometry, {"point ", i, " is not finite"}, {static_cast<Index>(i)}};
    points.push_back(at(p));
  }
  return points;
}

Result<std::vector<Point2>> take_points2(const double* coordinates, std::size_t count) {
  return take_points<Point2, 2>(coordinates, count, point2_at);
}

void hold(wellspaced_context& context, Geometry geometry) {
  context.geometry = std::move(geometry);
  context.hierarchy = {};
  context.level = 0;
  context.report.clear();
}

const TriangleMesh& held_mesh(const wellspaced_context& context) {
  const auto& levels = context.hierarchy.levels;
  return levels.empty() ? context.geometry.mesh : levels[context.level].mesh;
}

bool is_plane(const wellspaced_context& context) { return context.geometry.dimension == 2; }

// Size-first: `fill` writes all values, one after another, through the pointer that it gets.
template <class Value, class Fill>
std::size_t get_values(std::size_t size, Value* buffer, std::size_t capacity, Fill fill) {
  if (buffer != nullptr && capacity >= size) fill(buffer);
  return size;
}

template <std::size_t kCorners>
std::size_t get_rows(const std::vector<std::array<Index, kCorners>>& rows, uint32_t* buffer,
                     std::size_t capacity) {
  return get_values(kCorners * rows.size(), buffer, capacity, [&](uint32_t* out) {
    for (const auto& row : rows) out = std::copy(row.begin(), row.end(), out);
  });
}

std::span<const Segment> held_segments(const wellspaced_context& context) {
  return is_plane(context) ? held_mesh(context).segments : context.geometry.solid.segments;
}

Status coarsen_held(wellspaced_context& context, const CoarseningOptions& options) {
  if (!is_plane(context) || held_mesh(context).triangles.empty())
    return Error{ErrorCode::kUsage, "there is no triangle mesh to coarsen"};
  auto hierarchy = coarsen(held_mesh(context), options);
  if (!hierarchy) return hierarchy.error();
  if (!hierarchy->complete) return Error{ErrorCode::kCancelled, "coarsening was cancelled"};
  context.hierarchy = *std::move(hierarchy);
  context.level = context.hierarchy.levels.size() - 1;
  context.report.clear();
  return Ok{};
}

audit::Report audit_held(const wellspaced_context& context) {
  const Progress progress = progress_of(context);
  if (!is_plane(context))
    return audit::audit_tet_mesh(context.geometry.solid, {.progress = progress});
  return audit::audit_mesh(held_mesh(context), {.progress = progress});
}

Status read_into(wellspaced_context& context, const char* path, const char* format) {
  auto geometry = read_geometry(
      path, {.format = format == nullptr ? "" : format, .progress = progress_of(context)});
  if (!geometry) return geometry.error();
  if (!geometry->mesh.triangles.empty())
    if (Status status = prepare_geometry(*geometry, path, progress_of(context)); !status)
      return status;
  hold(context, *std::move(geometry));
  return Ok{};
}

Status write_from(const wellspaced_context& context, const char* path, const char* format) {
  OutputSet outputs(progress_of(context));
  const bool levels = !context.hierarchy.levels.empty();
  const Geometry geometry = levels ? to_geometry(held_mesh(context)) : context.geometry;
  Status status = write_geometry(outputs, path, format == nullptr ? "" : format, geometry);
  return status.ok() ? outputs.commit() : status;
}

}  // namespace
}  // namespace wellspaced

using namespace wellspaced;

const char* wellspaced_version(void) { return WELLSPACED_VERSION; }

int wellspaced_orient2d(const double a[2], const double b[2], const double c[2]) {
  return orient2d(point2_at(a), point2_at(b), point2_at(c));
}

int wellspaced_incircle(const double a[2], const double b[2], const double c[2],
                        const double d[2]) {
  return incircle(point2_at(a), point2_at(b), point2_at(c), point2_at(d));
}

int wellspaced_orient3d(const double a[3], const double b[3], const double c[3],
                        const double d[3]) {
  return orient3d(point3_at(a), point3_at(b), point3_at(c), point3_at(d));
}

int wellspaced_insphere(const double a[3], const double b[3], const double c[3], const double d[3],
                        const double e[3]) {
  return insphere(point3_at(a), point3_at(b), point3_at(c), point3_at(d), point3_at(e));
}

wellspaced_context* wellspaced_create(void) { return new (std::nothrow) wellspaced_context; }

void wellspaced_destroy(wellspaced_context* context) { delete context; }

const char* wellspaced_message(const wellspaced_context* context) {
  return context->message.c_str();
}

void wellspaced_set_progress(wellspaced_context* context, wellspaced_progress progress,
                             void* user) {
  context->progress = progress;
  context->user = user;
}

wellspaced_status wellspaced_triangulate2(wellspaced_context* context, const double* points,
                                          size_t point_count, const uint32_t* segments,
                                          const int* segment_markers, size_t segment_count,
                                          const double* hole_points, size_t hole_count, int holes) {
  return run_on(context, [&]() -> Status {
    if (Status status = check_counts(point_count, segment_count); !status) return status;
    if (holes < WELLSPACED_HOLES_NONE || holes > WELLSPACED_HOLES_OUTER)
      return Error{ErrorCode::kUsage, "the rule for holes does not exist"};
    Pslg graph;
    auto taken = take_points2(points, point_count);
    auto ends = take_segments(segments, segment_markers, segment_count, point_count);
    auto seeds = take_points2(hole_points, hole_count);
    if (!taken) return taken.error();
    if (!ends) return ends.error();
    if (!seeds) return seeds.error();
    graph.points = *std::move(taken);
    graph.segments = *std::move(ends);
    graph.holes = *std::move(seeds);
    constexpr HoleRule kRules[] = {HoleRule::kNone, HoleRule::kParity, HoleRule::kSeeds,
                                   HoleRule::kOuter};
    TriangulateOptions options;
    options.holes = kRules[holes];
    options.progress = progress_of(*context);
    const auto result = triangulate(graph, options);
    if (!result) return result.error();
    TriangleMesh mesh;
    mesh.points = result->delaunay.points();
    mesh.triangles = result->triangles();
    mesh.segments = result->segments;
    hold(*context, to_geometry(std::move(mesh)));
    return Ok{};
  });
}

wellspaced_status wellspaced_triangulate3(wellspaced_context* context, const double* points,
                                          size_t point_count) {
  return run_on(context, [&]() -> Status {
    if (Status status = check_counts(point_count, 0); !status) return status;
    auto taken = take_points<Point3, 3>(points, point_count, point3_at);
    if (!taken) return taken.error();
    const auto delaunay = Delaunay3::build(*taken, {.progress = progress_of(*context)});
    if (!delaunay) return delaunay.error();
    Geometry geometry;
    geometry.dimension = 3;
    geometry.solid.points = *std::move(taken);
    geometry.solid.tets = real_tets(*delaunay);
    hold(*context, std::move(geometry));
    return Ok{};
  });
}

wellspaced_status wellspaced_set_mesh(wellspaced_context* context, const double* points,
                                      size_t point_count, const uint32_t* triangles,
                                      size_t triangle_count, const uint32_t* segments,
                                      const int* segment_markers, size_t segment_count) {
  return run_on(context, [&]() -> Status {
    if (Status status = check_counts(point_count, std::max(segment_count, triangle_count)); !status)
      return status;
    auto taken = take_points2(points, point_count);
    auto ends = take_segments(segments, segment_markers, segment_count, point_count);
    if (!taken) return taken.error();
    if (!ends) return ends.error();
    Geometry geometry;
    geometry.mesh.points = *std::move(taken);
    geometry.mesh.segments = *std::move(ends);
    for (std::size_t t = 0; t < triangle_count; ++t)
      geometry.mesh.triangles.push_back(
          {triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]});
    if (Status status = prepare_geometry(geometry, "the mesh", progress_of(*context)); !status)
      return status;
    hold(*context, std::move(geometry));
    return Ok{};
  });
}

wellspaced_status wellspaced_set_tet_mesh(wellspaced_context* context, const double* points,
                                          size_t point_count, const uint32_t* tets,
                                          size_t tet_count) {
  return run_on(context, [&]() -> Status {
    if (Status status = check_counts(point_count, tet_count); !status) return status;
    auto taken = take_points<Point3, 3>(points, point_count, point3_at);
    if (!taken) return taken.error();
    Geometry geometry;
    geometry.dimension = 3;
    geometry.solid.points = *std::move(taken);
    for (const uint32_t* t = tets; t != tets + 4 * tet_count; t += 4) {
      if (std::any_of(t, t + 4, [&](uint32_t v) { return v >= point_count; }))
        return Error{ErrorCode::kInvalidGeometry,
                     {"tetrahedron ", (t - tets) / 4, " has a corner that does not exist"},
                     {static_cast<Index>((t - tets) / 4)}};
      geometry.solid.tets.push_back({t[0], t[1], t[2], t[3]});
    }
    hold(*context, std::move(geometry));
    return Ok{};
  });
}

wellspaced_status wellspaced_coarsen(wellspaced_context* context, double beta, double factor,
                                     uint64_t seed) {
  return run_on(context, [&]() -> Status {
    CoarseningOptions options;
    if (beta != 0) options.beta = beta;
    if (factor != 0) options.factor = factor;
    options.seed = seed;
    options.progress = progress_of(*context);
    return coarsen_held(*context, options);
  });
}

size_t wellspaced_level_count(const wellspaced_context* context) {
  return context->hierarchy.levels.size();
}

wellspaced_status wellspaced_select_level(wellspaced_context* context, size_t level) {
  return run_on(context, [&]() -> Status {
    if (level >= context->hierarchy.levels.size())
      return Error{ErrorCode::kUsage, {"there is no level ", level}};
    context->level = level;
    context->report.clear();
    return Ok{};
  });
}

wellspaced_status wellspaced_audit(wellspaced_context* context, int* pass) {
  return run_on(context, [&]() -> Status {
    const audit::Report report = audit_held(*context);
    if (!report.complete) return Error{ErrorCode::kCancelled, "the audit was cancelled"};
    JsonWriter json;
    json.begin_object();
    append_audit_json(json, report);
    json.end_object();
    context->report = json.text();
    *pass = report.pass() ? 1 : 0;
    return Ok{};
  });
}

wellspaced_status wellspaced_read(wellspaced_context* context, const char* path,
                                  const char* format) {
  return run_on(context, [&] { return read_into(*context, path, format); });
}

wellspaced_status wellspaced_write(wellspaced_context* context, const char* path,
                                   const char* format) {
  return run_on(context, [&] { return write_from(*context, path, format); });
}

int wellspaced_dimension(const wellspaced_context* context) { return context->geometry.dimension; }

size_t wellspaced_get_points(const wellspaced_context* context, double* buffer, size_t capacity) {
  if (!is_plane(*context)) {
    const auto& points = context->geometry.solid.points;
    return get_values(3 * points.size(), buffer, capacity, [&](double* out) {
      for (const Point3& p : points) *out++ = p.x, *out++ = p.y, *out++ = p.z;
    });
  }
  const auto& points = held_mesh(*context).points;
  return get_values(2 * points.size(), buffer, capacity, [&](double* out) {
    for (const Point2& p : points) *out++ = p.x, *out++ = p.y;
  });
}

size_t wellspaced_get_cells(const wellspaced_context* context, uint32_t* buffer, size_t capacity) {
  return is_plane(*context) ? get_rows(held_mesh(*context).triangles, buffer, capacity)
                            : get_rows(context->geometry.solid.tets, buffer, capacity);
}

size_t wellspaced_get_segments(const wellspaced_context* context, uint32_t* buffer,
                               size_t capacity) {
  const auto segments = held_segments(*context);
  return get_values(2 * segments.size(), buffer, capacity, [&](uint32_t* out) {
    for (const Segment& s : segments) *out++ = s.a, *out++ = s.b;
  });
}

size_t wellspaced_get_segment_markers(const wellspaced_context* context, int* buffer,
                                      size_t capacity) {
  const auto segments = held_segments(*context);
  return get_values(segments.size(), buffer, capacity, [&](int* out) {
    for (const Segment& s : segments) *out++ = s.marker;
  });
}

size_t wellspaced_get_origin(const wellspaced_context* context, uint32_t* buffer, size_t capacity) {
  const auto& levels = context->hierarchy.levels;
  if (levels.empty()) return 0;
  const auto& origin = levels[context->level].origin;
  return get_values(origin.size(), buffer, capacity,
                    [&](uint32_t* out) { std::copy(origin.begin(), origin.end(), out); });
}

size_t wellspaced_get_report(const wellspaced_context* context, char* buffer, size_t capacity) {
  const std::string& report = context->report;
  if (report.empty()) return 0;
  return get_values(report.size() + 1, buffer, capacity,
                    [&](char* out) { std::copy_n(report.c_str(), report.size() + 1, out); });
}
