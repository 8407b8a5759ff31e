/* The C interface, from C. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wellspaced/io/c/wellspaced.h"

static int failures = 0;

#define EXPECT(condition)                                                  \
  do {                                                                     \
    if (!(condition)) {                                                    \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                          \
    }                                                                      \
  } while (0)

static const double kSquare[8] = {0, 0, 1, 0, 1, 1, 0, 1};
static const uint32_t kRim[8] = {0, 1, 1, 2, 2, 3, 3, 0};

static void predicates_are_exact(void) {
  const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {0, 1, 0}, below[3] = {0, 0, -1e-300};
  const double inside[3] = {0.25, 0.25, -0.25};
  const double tiny[2] = {0.5, 0x1p-1074};
  EXPECT(wellspaced_orient2d(a, b, tiny) == 1);
  EXPECT(wellspaced_orient2d(a, b, b) == 0);
  EXPECT(wellspaced_incircle(a, b, c, tiny) == 1);
  EXPECT(wellspaced_incircle(kSquare, kSquare + 2, kSquare + 4, kSquare + 6) == 0);
  EXPECT(wellspaced_orient3d(a, b, c, below) == 1);
  EXPECT(wellspaced_insphere(a, b, c, (double[3]){0, 0, -1}, inside) == 1);
}

static void triangulates_a_square_with_markers(wellspaced_context* context) {
  const int markers[4] = {5, 6, 7, 8};
  EXPECT(wellspaced_triangulate2(context, kSquare, 4, kRim, markers, 4, NULL, 0,
                                 WELLSPACED_HOLES_PARITY) == WELLSPACED_OK);
  EXPECT(wellspaced_dimension(context) == 2);
  EXPECT(wellspaced_get_points(context, NULL, 0) == 8);
  EXPECT(wellspaced_get_cells(context, NULL, 0) == 6);
  EXPECT(wellspaced_get_segments(context, NULL, 0) == 8);
  double points[8];
  EXPECT(wellspaced_get_points(context, points, 8) == 8);
  EXPECT(memcmp(points, kSquare, sizeof points) == 0);
  uint32_t cells[6] = {9, 9, 9, 9, 9, 9};
  EXPECT(wellspaced_get_cells(context, cells, 5) == 6);
  EXPECT(cells[0] == 9); /* too small a buffer stays as it was */
  EXPECT(wellspaced_get_cells(context, cells, 6) == 6);
  EXPECT(cells[0] < 4 && cells[5] < 4);
  int read_back[4];
  EXPECT(wellspaced_get_segment_markers(context, read_back, 4) == 4);
  int sum = 0;
  for (int i = 0; i < 4; ++i) sum += read_back[i];
  EXPECT(sum == 26);
  EXPECT(wellspaced_get_origin(context, NULL, 0) == 0);
}

static void errors_name_what_is_wrong_and_keep_the_mesh(wellspaced_context* context) {
  const double bad[4] = {0, 0, NAN, 1};
  const uint32_t far_away[2] = {0, 4};
  EXPECT(wellspaced_triangulate2(context, bad, 2, NULL, NULL, 0, NULL, 0, WELLSPACED_HOLES_NONE) ==
         WELLSPACED_INVALID_GEOMETRY);
  EXPECT(strcmp(wellspaced_message(context), "point 1 is not finite") == 0);
  EXPECT(wellspaced_triangulate2(context, kSquare, 4, far_away, NULL, 1, NULL, 0,
                                 WELLSPACED_HOLES_NONE) == WELLSPACED_INVALID_GEOMETRY);
  EXPECT(strstr(wellspaced_message(context), "segment 0") != NULL);
  EXPECT(wellspaced_triangulate2(context, kSquare, 4, NULL, NULL, 0, NULL, 0,
                                 9) == WELLSPACED_USAGE);
  EXPECT(wellspaced_read(context, "/does/not/exist.node", NULL) == WELLSPACED_UNREADABLE);
  EXPECT(wellspaced_write(context, "/does/not/exist.vtu", NULL) == WELLSPACED_USAGE);
  EXPECT(wellspaced_select_level(context, 0) == WELLSPACED_USAGE);
  EXPECT(wellspaced_get_cells(context, NULL, 0) == 6);
}

static void triangulates_a_cube(wellspaced_context* context) {
  double cube[24];
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) cube[3 * i + k] = i >> k & 1;
  EXPECT(wellspaced_triangulate3(context, cube, 8) == WELLSPACED_OK);
  EXPECT(wellspaced_dimension(context) == 3);
  EXPECT(wellspaced_get_points(context, NULL, 0) == 24);
  EXPECT(wellspaced_get_cells(context, NULL, 0) >= 4 * 5);
  EXPECT(wellspaced_coarsen(context, 0, 0, 1) == WELLSPACED_USAGE);
}

/* A grid of n by n points. */
static void set_grid(wellspaced_context* context, uint32_t n) {
  double* const points = malloc(sizeof *points * 2 * n * n);
  uint32_t* const cells = malloc(sizeof *cells * 6 * n * n);
  size_t count = 0;
  for (uint32_t i = 0; i < n * n; ++i) {
    points[2 * i] = i % n;
    points[2 * i + 1] = i / n;
    if (i % n + 1 == n || i / n + 1 == n) continue;
    const uint32_t corners[6] = {i, i + 1, i + n + 1, i, i + n + 1, i + n};
    memcpy(cells + 3 * count, corners, sizeof corners);
    count += 2;
  }
  EXPECT(wellspaced_set_mesh(context, points, n * n, cells, count, NULL, NULL, 0) ==
         WELLSPACED_OK);
  free(points);
  free(cells);
}

static void coarsens_a_grid(wellspaced_context* context) {
  set_grid(context, 30);
  EXPECT(wellspaced_coarsen(context, 25, 8, 1) == WELLSPACED_OK);
  const size_t levels = wellspaced_level_count(context);
  EXPECT(levels >= 2);
  size_t before = 1000000;
  for (size_t level = 0; level < levels; ++level) {
    EXPECT(wellspaced_select_level(context, level) == WELLSPACED_OK);
    const size_t points = wellspaced_get_points(context, NULL, 0) / 2;
    EXPECT(points < before);
    EXPECT(wellspaced_get_origin(context, NULL, 0) == points);
    before = points;
  }
  EXPECT(wellspaced_select_level(context, levels) == WELLSPACED_USAGE);
  EXPECT(wellspaced_coarsen(context, 0.5, 8, 1) == WELLSPACED_USAGE);
}

static int refuse(void* user, const char* phase, uint64_t done, uint64_t total) {
  EXPECT(phase != NULL && done <= total);
  ++*(int*)user;
  return 0;
}

static void cancels_when_the_callback_says_so(wellspaced_context* context) {
  int calls = 0;
  set_grid(context, 10);
  wellspaced_set_progress(context, refuse, &calls);
  EXPECT(wellspaced_coarsen(context, 0, 0, 1) == WELLSPACED_CANCELLED);
  EXPECT(calls == 1);
  EXPECT(wellspaced_get_points(context, NULL, 0) == 200);
  wellspaced_set_progress(context, NULL, NULL);
}

static void audits_what_it_holds(wellspaced_context* context) {
  int pass = -1;
  set_grid(context, 5);
  EXPECT(wellspaced_get_report(context, NULL, 0) == 0);
  EXPECT(wellspaced_audit(context, &pass) == WELLSPACED_OK && pass == 1);
  char report[100000] = "";
  const size_t size = wellspaced_get_report(context, report, sizeof report);
  EXPECT(size == strlen(report) + 1);
  EXPECT(strstr(report, "\"verdict\":\"pass\"") != NULL);
  const double points[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t twice[8] = {0, 1, 2, 3, 0, 1, 2, 3}, far_away[4] = {0, 1, 2, 4};
  EXPECT(wellspaced_set_tet_mesh(context, points, 4, far_away, 1) == WELLSPACED_INVALID_GEOMETRY);
  EXPECT(wellspaced_get_report(context, NULL, 0) == size);
  EXPECT(wellspaced_set_tet_mesh(context, points, 4, twice, 2) == WELLSPACED_OK);
  EXPECT(wellspaced_audit(context, &pass) == WELLSPACED_OK && pass == 0);
}

static void writes_and_reads_files(wellspaced_context* context, const char* path) {
  set_grid(context, 4);
  EXPECT(wellspaced_write(context, path, "gmsh22") == WELLSPACED_OK);
  EXPECT(wellspaced_read(context, path, NULL) == WELLSPACED_OK);
  EXPECT(wellspaced_get_cells(context, NULL, 0) == 3 * 18);
  remove(path);
}

int main(int argc, char** argv) {
  EXPECT(argc == 2);
  wellspaced_context* const context = wellspaced_create();
  EXPECT(context != NULL && strlen(wellspaced_version()) > 0);
  EXPECT(strcmp(wellspaced_message(context), "") == 0);
  predicates_are_exact();
  triangulates_a_square_with_markers(context);
  errors_name_what_is_wrong_and_keep_the_mesh(context);
  triangulates_a_cube(context);
  coarsens_a_grid(context);
  cancels_when_the_callback_says_so(context);
  audits_what_it_holds(context);
  writes_and_reads_files(context, argv[1]);
  wellspaced_destroy(context);
  wellspaced_destroy(NULL);
  return failures == 0 ? 0 : 1;
}
