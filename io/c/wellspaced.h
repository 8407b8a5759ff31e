/* The library from C, and from every language that can call C: exact predicates, triangulation,
 * coarsening, files.
 *
 * All work is done on a context, which holds one mesh, or the levels of one hierarchy, and the text
 * of the last error. Distinct contexts may be used from distinct threads; nothing else is shared.
 *
 * Getters are size-first: each returns how many values there are and, if the buffer takes so many,
 * fills it. Call with (NULL, 0) to ask, then again with a buffer of that size.
 *
 * Points are rows of 2 or 3 doubles; triangles, tetrahedra and segments rows of 3, 4 or 2 indices,
 * counted from 0. Triangles are counter-clockwise.
 */
#ifndef WELLSPACED_H
#define WELLSPACED_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define WELLSPACED_API __declspec(dllexport)
#else
#define WELLSPACED_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct wellspaced_context wellspaced_context;

/* What an operation returns. The numbers are the exit codes of the program, where it has them. */
typedef enum wellspaced_status {
  WELLSPACED_OK = 0,
  WELLSPACED_USAGE = 2,            /* an argument is out of its range */
  WELLSPACED_UNREADABLE = 3,       /* a file is missing or malformed */
  WELLSPACED_INVALID_GEOMETRY = 4, /* the data describe no valid mesh or domain */
  WELLSPACED_LIMIT = 5,            /* a limit of size was hit, or memory ran out */
  WELLSPACED_INTERNAL = 6,         /* a bug of the library */
  WELLSPACED_CANCELLED = 7         /* the progress callback asked to stop */
} wellspaced_status;

WELLSPACED_API const char* wellspaced_version(void);

/* ---- Predicates: the exact sign, -1, 0 or 1, for all finite doubles -------------------------- */

/* 1 if a, b, c turn left. */
WELLSPACED_API int wellspaced_orient2d(const double a[2], const double b[2], const double c[2]);
/* 1 if d is inside the circle through a, b, c, which turn left. */
WELLSPACED_API int wellspaced_incircle(const double a[2], const double b[2], const double c[2],
                                       const double d[2]);
/* 1 if d lies below the plane of a, b, c, which turn left seen from above. */
WELLSPACED_API int wellspaced_orient3d(const double a[3], const double b[3], const double c[3],
                                       const double d[3]);
/* 1 if e is inside the sphere through a, b, c, d, for which orient3d is 1. */
WELLSPACED_API int wellspaced_insphere(const double a[3], const double b[3], const double c[3],
                                       const double d[3], const double e[3]);

/* ---- Contexts -------------------------------------------------------------------------------- */

/* NULL if memory has run out. */
WELLSPACED_API wellspaced_context* wellspaced_create(void);
/* NULL is legal. */
WELLSPACED_API void wellspaced_destroy(wellspaced_context* context);
/* One line about the last error, "" if there was none; valid until the next call with `context`. */
WELLSPACED_API const char* wellspaced_message(const wellspaced_context* context);

/* Called now and then during an operation; returns 0 to cancel it. It must not use the context. */
typedef int (*wellspaced_progress)(void* user, const char* phase, uint64_t done, uint64_t total);
WELLSPACED_API void wellspaced_set_progress(wellspaced_context* context,
                                            wellspaced_progress progress, void* user);

/* ---- Operations: each replaces what the context holds; after an error it holds what it held -- */

/* Whether regions that segments enclose belong to the domain. */
typedef enum wellspaced_holes {
  WELLSPACED_HOLES_NONE = 0,   /* all of them, up to the convex hull */
  WELLSPACED_HOLES_PARITY = 1, /* those an odd number of segments deep */
  WELLSPACED_HOLES_SEEDS = 2,  /* those enclosed, but for the ones that hold a hole point */
  WELLSPACED_HOLES_OUTER = 3   /* those enclosed */
} wellspaced_holes;

/* The constrained Delaunay triangulation in the plane. segments: 2 indices each, segment_markers:
 * one each, or NULL; hole_points: 2 coordinates each. Input points keep their numbers, points at
 * crossings of segments follow. holes: one of wellspaced_holes; an int, so that any other value is
 * refused. */
WELLSPACED_API wellspaced_status
wellspaced_triangulate2(wellspaced_context* context, const double* points, size_t point_count,
                        const uint32_t* segments, const int* segment_markers, size_t segment_count,
                        const double* hole_points, size_t hole_count, int holes);

/* The Delaunay triangulation in space. */
WELLSPACED_API wellspaced_status wellspaced_triangulate3(wellspaced_context* context,
                                                         const double* points, size_t point_count);

/* Takes a triangle mesh, checks and completes it: boundary edges that are not listed join the
 * segments. */
WELLSPACED_API wellspaced_status
wellspaced_set_mesh(wellspaced_context* context, const double* points, size_t point_count,
                    const uint32_t* triangles, size_t triangle_count, const uint32_t* segments,
                    const int* segment_markers, size_t segment_count);

/* Takes a tetrahedral mesh. Facets of its boundary are not listed. */
WELLSPACED_API wellspaced_status wellspaced_set_tet_mesh(wellspaced_context* context,
                                                         const double* points, size_t point_count,
                                                         const uint32_t* tets, size_t tet_count);

/* Coarsens the triangle mesh by the thesis' function-based method: level 0 is the mesh. The context
 * then holds the levels, the last one selected. beta > 1, factor > 1; 0 stands for the default. */
WELLSPACED_API wellspaced_status wellspaced_coarsen(wellspaced_context* context, double beta,
                                                    double factor, uint64_t seed);
WELLSPACED_API size_t wellspaced_level_count(const wellspaced_context* context);
/* Selects the level that the getters speak of, 0 the finest. */
WELLSPACED_API wellspaced_status wellspaced_select_level(wellspaced_context* context, size_t level);

/* Judges the mesh, or the selected level, with exact arithmetic: *pass is 1 if it passes all
 * required checks, otherwise 0. A mesh that fails is no error. wellspaced_get_report() tells the
 * details. */
WELLSPACED_API wellspaced_status wellspaced_audit(wellspaced_context* context, int* pass);

/* Reads or writes a file in any format that the program knows; by extension where `format` is NULL.
 * A file appears complete or not at all. */
WELLSPACED_API wellspaced_status wellspaced_read(wellspaced_context* context, const char* path,
                                                 const char* format);
WELLSPACED_API wellspaced_status wellspaced_write(wellspaced_context* context, const char* path,
                                                  const char* format);

/* ---- Getters, of the mesh or the selected level ---------------------------------------------- */

/* 2 or 3. */
WELLSPACED_API int wellspaced_dimension(const wellspaced_context* context);
/* Coordinates: dimension times the number of points. */
WELLSPACED_API size_t wellspaced_get_points(const wellspaced_context* context, double* buffer,
                                            size_t capacity);
/* Corners: 3 for each triangle in the plane, 4 for each tetrahedron in space. */
WELLSPACED_API size_t wellspaced_get_cells(const wellspaced_context* context, uint32_t* buffer,
                                           size_t capacity);
/* Ends: 2 for each segment. */
WELLSPACED_API size_t wellspaced_get_segments(const wellspaced_context* context, uint32_t* buffer,
                                              size_t capacity);
WELLSPACED_API size_t wellspaced_get_segment_markers(const wellspaced_context* context, int* buffer,
                                                     size_t capacity);
/* Of each point of the selected level, its number in level 0; nothing without a hierarchy. */
WELLSPACED_API size_t wellspaced_get_origin(const wellspaced_context* context, uint32_t* buffer,
                                            size_t capacity);

/* The last audit of what the context holds, as the JSON object that `wellspaced audit --json`
 * prints, with an end of string; nothing before an audit. */
WELLSPACED_API size_t wellspaced_get_report(const wellspaced_context* context, char* buffer,
                                            size_t capacity);

#ifdef __cplusplus
}
#endif

#endif /* WELLSPACED_H */
