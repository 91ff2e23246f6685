// What a mesh must be, and that the first defect is named.
#include "surgery/conditions.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

#include <math.h>

/// A mesh of up to eight vertices, and the error about its first defect.
typedef struct faulty {
    const char *what;
    tf_status status;
    int vertices, triangles;
    double position[8][3];
    int triangle[15];
    int edges, edge[2];
    tf_subject subject;
    size_t index;
    int vertex[5]; ///< in the error; those that are missing are 0 here
} faulty;

#define CORNERS                                                                \
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0},                                           \
    {                                                                          \
        0, 0, 1                                                                \
    }
#define SOLID 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3

static const faulty meshes[] = {
    {"nothing", TF_NO_ELEMENTS, 4, 0, {CORNERS}, .index = 0},
    {"a negative count", TF_BAD_COUNT, 4, -1, {CORNERS}, .index = 0},
    {"an absurd count", TF_BAD_COUNT, 4, 1 << 30, {CORNERS}, .index = 0},
    {"index",
     TF_BAD_INDEX,
     4,
     2,
     {CORNERS},
     {0, 1, 2, 0, 4, 1},
     .subject = TF_TRIANGLE,
     .index = 1,
     .vertex = {4}},
    {"repeated",
     TF_BAD_INDEX,
     4,
     1,
     {CORNERS},
     {2, 1, 2},
     .subject = TF_TRIANGLE,
     .index = 0,
     .vertex = {2}},
    {"index of an edge",
     TF_BAD_INDEX,
     4,
     1,
     {CORNERS},
     {2, 1, 0},
     .edges = 1,
     .edge = {3, 7},
     .subject = TF_EDGE,
     .vertex = {7}},
    {"an edge of no triangle",
     TF_EDGE_NOT_MANIFOLD,
     4,
     1,
     {CORNERS},
     {0, 1, 2},
     .edges = 1,
     .edge = {3, 1},
     .subject = TF_EDGE,
     .vertex = {3, 1}},
    {"not a number",
     TF_NOT_FINITE,
     4,
     1,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, NAN, 0}},
     {0, 1, 2},
     .subject = TF_VERTEX,
     .index = 3,
     .vertex = {3}},
    {"infinite",
     TF_NOT_FINITE,
     3,
     1,
     {{0, 0, 0}, {1, 0, -INFINITY}, {0, 1, 0}},
     {0, 1, 2},
     .subject = TF_VERTEX,
     .index = 1,
     .vertex = {1}},
    {"turned over",
     TF_EDGE_NOT_MANIFOLD,
     4,
     2,
     {CORNERS},
     {0, 1, 2, 0, 1, 3},
     .subject = TF_TRIANGLE,
     .index = 0,
     .vertex = {0, 1}},
    {"three on an edge",
     TF_EDGE_NOT_MANIFOLD,
     5,
     3,
     {CORNERS, {0, -1, -1}},
     {0, 1, 2, 1, 0, 3, 0, 1, 4},
     .subject = TF_TRIANGLE,
     .index = 0,
     .vertex = {0, 1}},
    {"a triangle twice",
     TF_EDGE_NOT_MANIFOLD,
     3,
     2,
     {CORNERS},
     {0, 1, 2, 1, 2, 0},
     .subject = TF_TRIANGLE,
     .index = 0,
     .vertex = {0, 1}},
    {"two fans",
     TF_VERTEX_NOT_MANIFOLD,
     5,
     2,
     {{1, 0, 0}, {0, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
     {1, 0, 2, 1, 3, 4},
     .subject = TF_VERTEX,
     .index = 1,
     .vertex = {1}},
    {"collinear",
     TF_COLLINEAR,
     6,
     2,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 3}, {4, 4, 4}, {7, 7, 7}},
     {0, 1, 2, 3, 4, 5},
     .subject = TF_TRIANGLE,
     .index = 1,
     .vertex = {-1}},
    {"pierced",
     TF_NOT_EMBEDDED,
     6,
     2,
     {CORNERS, {0.2, 0.2, -1}, {2, 2, 2}},
     {0, 1, 2, 3, 4, 5},
     .subject = TF_EDGE_TRIANGLE_PAIR,
     .vertex = {1, 2, 3, 4, 5}},
    {"touching",
     TF_NOT_EMBEDDED,
     6,
     2,
     {CORNERS, {1, 1, 1}, {0.25, 0.25, 0}},
     {0, 1, 2, 3, 4, 5},
     .subject = TF_POINT_TRIANGLE_PAIR,
     .vertex = {5, 0, 1, 2}},
    {"folded",
     TF_NOT_EMBEDDED,
     4,
     2,
     {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0.25, 0.5, 0}},
     {0, 1, 2, 1, 0, 3},
     .subject = TF_POINT_TRIANGLE_PAIR,
     .vertex = {3, 0, 1, 2}},
};

/// How many vertices an error has about such a subject with such a status.
static int vertices_of(const faulty *f)
{
    static const int count[] = {[TF_VERTEX] = 1,
                                [TF_EDGE] = 1,
                                [TF_TRIANGLE] = 1,
                                [TF_POINT_TRIANGLE_PAIR] = 4,
                                [TF_EDGE_TRIANGLE_PAIR] = 5};
    return count[f->subject] + (f->status == TF_EDGE_NOT_MANIFOLD);
}

START_TEST(the_first_defect_is_named)
{
    const faulty *f = &meshes[_i];
    tf_mesh mesh = {3,           f->vertices, f->triangles,
                    f->triangle, f->edges,    f->edge};
    tf_adaptive_surface *made = NULL;
    tf_error error;
    tf_status status = tf_adaptive_create(&mesh, f->position[0], &made, &error);
    ck_assert_msg(status == f->status, "%s: %d", f->what, status);
    ck_assert_ptr_null(made);
    ck_assert_int_eq(error.status, status);
    ck_assert_msg(error.subject == f->subject, "%s", f->what);
    ck_assert_uint_eq(error.index, f->index);
    ck_assert_int_eq(error.time, -1);
    for (int i = 0; i < 5; i++)
        ck_assert_msg(error.vertex[i] ==
                          (i < vertices_of(f) ? f->vertex[i] : -1),
                      "%s: vertex %d is %d", f->what, i, error.vertex[i]);
    ck_assert_int_eq(tf_adaptive_create(&mesh, f->position[0], &made, NULL),
                     status);
}
END_TEST

START_TEST(other_axes_than_three_are_refused)
{
    static const int axes[] = {2, 1, 0, -3, 4}, edge[] = {0, 1};
    static const double position[6] = {0, 0, 1, 1};
    for (int i = 0; i < 5; i++) {
        tf_mesh mesh = {axes[i], 2, .edges = 1, .edge = edge};
        tf_adaptive_surface *made = NULL;
        tf_error error;
        ck_assert_int_eq(tf_adaptive_create(&mesh, position, &made, &error),
                         TF_BAD_AXES);
        ck_assert_int_eq(error.status, TF_BAD_AXES);
        ck_assert_ptr_null(made);
    }
}
END_TEST

// An error is set also if there is none.
START_TEST(a_good_mesh_has_no_error)
{
    static const int solid[] = {SOLID};
    static const double position[][3] = {CORNERS};
    tf_mesh mesh = {3, 4, 4, solid, 0, NULL};
    tf_adaptive_surface *made = NULL;
    tf_error error = {.status = TF_COLLINEAR, .subject = TF_EDGE};
    ck_assert_int_eq(tf_adaptive_create(&mesh, position[0], &made, &error),
                     TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    tf_adaptive_free(made);
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
    tcase_add_test(tcase, other_axes_than_three_are_refused);
    tcase_add_test(tcase, a_good_mesh_has_no_error);
    tcase_add_test(tcase, valid_meshes_are_accepted);
    suite_add_tcase(suite, tcase);
    return suite;
}
