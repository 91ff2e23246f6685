// What a mesh must be, and that the first defect is named.
#include "surgery/conditions.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

#include <math.h>

/// A mesh of up to eight vertices, and its first defect.
typedef struct faulty {
    const char *what;
    tf_status status;
    int vertices, triangles;
    double position[8][3];
    int triangle[15];
    int edges, edge[2];
    int bad_triangle, bad[2], crossing[5];
} faulty;

#define NONE                                                                   \
    -1, {-1, -1},                                                              \
    {                                                                          \
        0                                                                      \
    }
#define CORNERS                                                                \
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0},                                           \
    {                                                                          \
        0, 0, 1                                                                \
    }
#define SOLID 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3

static const faulty meshes[] = {
    {"nothing", TF_NO_ELEMENTS, 4, 0, {CORNERS}, {0}, 0, {0}, NONE},
    {"index",
     TF_BAD_INDEX,
     4,
     2,
     {CORNERS},
     {0, 1, 2, 0, 4, 1},
     0,
     {0},
     1,
     {4, -1},
     {0}},
    {"repeated",
     TF_BAD_INDEX,
     4,
     1,
     {CORNERS},
     {2, 1, 2},
     0,
     {0},
     0,
     {2, -1},
     {0}},
    {"loose edge",
     TF_EDGE_NOT_MANIFOLD,
     4,
     1,
     {CORNERS},
     {0, 1, 2},
     1,
     {3, 1},
     -1,
     {3, 1},
     {0}},
    {"not a number",
     TF_NOT_FINITE,
     4,
     1,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, NAN, 0}},
     {0, 1, 2},
     0,
     {0},
     -1,
     {3, -1},
     {0}},
    {"infinite",
     TF_NOT_FINITE,
     3,
     1,
     {{0, 0, 0}, {1, 0, -INFINITY}, {0, 1, 0}},
     {0, 1, 2},
     0,
     {0},
     -1,
     {1, -1},
     {0}},
    {"turned over",
     TF_EDGE_NOT_MANIFOLD,
     4,
     2,
     {CORNERS},
     {0, 1, 2, 0, 1, 3},
     0,
     {0},
     0,
     {0, 1},
     {0}},
    {"three on an edge",
     TF_EDGE_NOT_MANIFOLD,
     5,
     3,
     {CORNERS, {0, -1, -1}},
     {0, 1, 2, 1, 0, 3, 0, 1, 4},
     0,
     {0},
     0,
     {0, 1},
     {0}},
    {"a triangle twice",
     TF_EDGE_NOT_MANIFOLD,
     3,
     2,
     {CORNERS},
     {0, 1, 2, 1, 2, 0},
     0,
     {0},
     0,
     {0, 1},
     {0}},
    {"two fans",
     TF_VERTEX_NOT_MANIFOLD,
     5,
     2,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
     {0, 1, 2, 0, 3, 4},
     0,
     {0},
     -1,
     {0, -1},
     {0}},
    {"collinear",
     TF_COLLINEAR,
     6,
     2,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 3}, {4, 4, 4}, {7, 7, 7}},
     {0, 1, 2, 3, 4, 5},
     0,
     {0},
     1,
     {-1, -1},
     {0}},
    {"pierced",
     TF_NOT_EMBEDDED,
     6,
     2,
     {CORNERS, {0.2, 0.2, -1}, {2, 2, 2}},
     {0, 1, 2, 3, 4, 5},
     0,
     {0},
     -1,
     {-1, -1},
     {1, 2, 3, 4, 5}},
    {"touching",
     TF_NOT_EMBEDDED,
     6,
     2,
     {CORNERS, {1, 1, 1}, {0.25, 0.25, 0}},
     {0, 1, 2, 3, 4, 5},
     0,
     {0},
     -1,
     {-1, -1},
     {5, 0, 1, 2, -1}},
    {"folded",
     TF_NOT_EMBEDDED,
     4,
     2,
     {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0.25, 0.5, 0}},
     {0, 1, 2, 1, 0, 3},
     0,
     {0},
     -1,
     {-1, -1},
     {3, 0, 1, 2, -1}},
};

START_TEST(the_first_defect_is_named)
{
    const faulty *f = &meshes[_i];
    tf_mesh mesh = {3,           f->vertices, f->triangles,
                    f->triangle, f->edges,    f->edge};
    tf_adaptive_surface *made = NULL;
    tf_defect defect;
    tf_status status =
        tf_adaptive_create(&mesh, f->position[0], &made, &defect);
    ck_assert_msg(status == f->status, "%s: %d", f->what, status);
    ck_assert_ptr_null(made);
    ck_assert_int_eq(defect.triangle, f->bad_triangle);
    ck_assert_int_eq(defect.vertex[0], f->bad[0]);
    ck_assert_int_eq(defect.vertex[1], f->bad[1]);
    if (status == TF_NOT_EMBEDDED)
        ck_assert_mem_eq(defect.crossing.vertex, f->crossing,
                         sizeof f->crossing);
    else
        ck_assert_int_eq(defect.crossing.kind, TF_NO_CROSSING);
    ck_assert_int_eq(tf_adaptive_create(&mesh, f->position[0], &made, NULL),
                     status);
}
END_TEST

// Closed or not, inside out or not; and a vertex without triangles may touch.
START_TEST(valid_meshes_are_accepted)
{
    static const int solid[] = {SOLID};
    static const int turned[] = {2, 0, 1, 1, 0, 3, 2, 1, 3, 0, 2, 3};
    static double position[][3] = {CORNERS, {0.25, 0.25, 0}};
    for (int count = 1; count <= 4; count++) {
        tf_adaptive_free(adaptive_of(5, position, count, solid));
        tf_adaptive_free(adaptive_of(5, position, count, turned));
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/conditions");
    TCase *tcase = tcase_create("defects");
    tcase_add_loop_test(tcase, the_first_defect_is_named, 0,
                        sizeof meshes / sizeof *meshes);
    tcase_add_test(tcase, valid_meshes_are_accepted);
    suite_add_tcase(suite, tcase);
    return suite;
}
