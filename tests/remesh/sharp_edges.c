// Sharp edges, on a box of 2 x 2 x 1 squares and on a sheet.
#include "remesh/sharp_edges.h"

#include "support/adaptive_scenes.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/star.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static adaptive_scene scene;
static tf_sharp_edges sharp;

static tf_adaptive_surface *box(void)
{
    static const int low[] = {0, 0, 0}, high[] = {2, 2, 2};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *made = NULL;
    if (tf_adaptive_create(&mesh, scene.position, &made, NULL) != TF_OK)
        abort();
    return made;
}

/// On how many sides of the box a vertex is.
static int sides(const double *x)
{
    int count = 0;
    for (int k = 0; k < 3; k++)
        count += x[k] == 0 || x[k] == 2;
    return count;
}

/// Finds what turns by more than some 25 degrees, and what is kept.
static void find(const tf_adaptive_surface *surface, int keeps,
                 const int keep[])
{
    const tf_sharpness sharpness = {0.906, INFINITY, keeps, keep};
    sharp = (tf_sharp_edges){0};
    ck_assert_int_eq(tf_sharp_edges_find(&sharp, surface, &sharpness, NULL),
                     TF_OK);
}

static void release(tf_adaptive_surface *surface)
{
    tf_sharp_edges_free(&sharp);
    tf_adaptive_free(surface);
}

// What is sharp ---------------------------------------------------------------

START_TEST(vertices_of_a_box_are_free_inside_its_sides)
{
    static const tf_freedom freedom[] = {TF_FREE, TF_FREE, TF_ALONG_SHARP_EDGE,
                                         TF_HELD};
    tf_adaptive_surface *surface = box();
    find(surface, 0, NULL);
    for (int v = 0; v < surface->vertices; v++)
        ck_assert_int_eq(tf_freedom_of(&sharp, v),
                         freedom[sides(coordinates_of(surface, v))]);
    release(surface);
}
END_TEST

START_TEST(vertices_that_are_left_alone_are_corners)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    adaptive_freeze(surface, 4);
    find(surface, 0, NULL);
    ck_assert_int_eq(tf_freedom_of(&sharp, 4), TF_HELD);
    ck_assert_int_eq(tf_freedom_of(&sharp, 1), TF_ALONG_SHARP_EDGE);
    release(surface);
}
END_TEST

START_TEST(the_edges_of_a_box_are_sharp)
{
    tf_adaptive_surface *surface = box();
    find(surface, 0, NULL);
    for (int c = 0; c < 3 * surface->triangles; c++) {
        int v = tf_vertex_at(surface, c);
        int w = tf_vertex_at(surface, tf_corner_after(c));
        const double *a = coordinates_of(surface, v);
        const double *b = coordinates_of(surface, w);
        int common = 0;
        for (int k = 0; k < 3; k++)
            common += a[k] == b[k] && (a[k] == 0 || a[k] == 2);
        ck_assert((tf_find_sharp_edge(&sharp, v, w) != NULL) == (common == 2));
    }
    release(surface);
}
END_TEST

/// A roof whose ridge from 0 to 1 turns by an angle in degrees; its slopes are
/// 1 long.
static tf_adaptive_surface *roof(double degrees)
{
    static const int triangle[] = {0, 1, 2, 1, 0, 3};
    double half = degrees * acos(-1) / 360;
    double position[][3] = {{0, 0, 0},
                            {1, 0, 0},
                            {0, cos(half), -sin(half)},
                            {1, -cos(half), -sin(half)}};
    return adaptive_of(4, position, 2, triangle);
}

START_TEST(the_angle_decides)
{
    for (int degrees = 2; degrees < 170; degrees++) {
        tf_adaptive_surface *surface = roof(degrees);
        const int angles[] = {degrees - 1, degrees + 1};
        for (int i = 0; i < 2; i++) {
            const tf_sharpness sharpness = {
                .cosine = cos(angles[i] * acos(-1) / 180), .depth = INFINITY};
            sharp = (tf_sharp_edges){0};
            ck_assert_int_eq(
                tf_sharp_edges_find(&sharp, surface, &sharpness, NULL), TF_OK);
            ck_assert((tf_find_sharp_edge(&sharp, 0, 1) != NULL) == (i == 0));
            tf_sharp_edges_free(&sharp);
        }
        ck_assert_double_eq_tol(tf_turn_at(surface, 0),
                                2 * sin(degrees * acos(-1) / 360), 1e-14);
        ck_assert_double_eq_tol(tf_height_at(surface, 0), 1, 1e-14);
        tf_adaptive_free(surface);
    }
}
END_TEST

START_TEST(the_depth_decides_too)
{
    tf_adaptive_surface *surface = roof(10);
    double depth = tf_turn_at(surface, 0) * tf_height_at(surface, 0) / 1.5;
    for (int i = 0; i < 2; i++) {
        const tf_sharpness sharpness = {.cosine = -2,
                                        .depth = depth * (i ? 1.001 : 0.999)};
        sharp = (tf_sharp_edges){0};
        ck_assert_int_eq(tf_sharp_edges_find(&sharp, surface, &sharpness, NULL),
                         TF_OK);
        ck_assert((tf_find_sharp_edge(&sharp, 0, 1) != NULL) == (i == 0));
        tf_sharp_edges_free(&sharp);
    }
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(the_boundary_is_sharp)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    static const tf_freedom freedom[] = {
        TF_HELD, TF_ALONG_SHARP_EDGE, TF_HELD, TF_ALONG_SHARP_EDGE,
        TF_FREE, TF_ALONG_SHARP_EDGE, TF_HELD, TF_ALONG_SHARP_EDGE,
        TF_HELD};
    find(sheet, 0, NULL);
    for (int v = 0; v < 9; v++)
        ck_assert_int_eq(tf_freedom_of(&sharp, v), freedom[v]);
    ck_assert(tf_find_sharp_edge(&sharp, 0, 1));
    ck_assert(!tf_find_sharp_edge(&sharp, 0, 4));
    release(sheet);
}
END_TEST

START_TEST(kept_edges_are_sharp)
{
    // Across a flat sheet, through the vertex 12 in its middle; and a corner.
    static const int keep[] = {10, 11, 11, 12, 12, 13, 13, 14, 6, 6, 0, 1};
    tf_adaptive_surface *sheet = adaptive_sheet(4, 4);
    find(sheet, 6, keep);
    ck_assert_int_eq(tf_freedom_of(&sharp, 10), TF_HELD);
    for (int v = 11; v < 14; v++)
        ck_assert_int_eq(tf_freedom_of(&sharp, v), TF_ALONG_SHARP_EDGE);
    ck_assert_int_eq(tf_freedom_of(&sharp, 6), TF_HELD);
    ck_assert_int_eq(tf_freedom_of(&sharp, 7), TF_FREE);
    ck_assert_double_eq(tf_find_sharp_edge(&sharp, 12, 11)->length, 1);
    release(sheet);
}
END_TEST

// How it is handed on ---------------------------------------------------------

/// How many sharp edges a vertex has, and how long they are together.
static int count_at(int vertex, int vertices, double *length)
{
    int count = 0;
    *length = 0;
    for (int v = 0; v < vertices; v++) {
        const tf_sharp_link *link = tf_find_sharp_edge(&sharp, vertex, v);
        const tf_sharp_link *back = tf_find_sharp_edge(&sharp, v, vertex);
        ck_assert((link != NULL) == (back != NULL));
        if (!link)
            continue;
        ck_assert_double_eq(link->length, back->length);
        *length += link->length;
        count++;
    }
    return count;
}

static int side_of(int from, int to)
{
    return tf_find_sharp_edge(&sharp, from, to)->side;
}

// A kept line across a sheet, from the left to the right; the boundary has six
// lines, between corners and the ends of the line.
START_TEST(a_line_keeps_its_sides)
{
    static const int keep[] = {10, 11, 11, 12, 12, 13, 13, 14};
    tf_adaptive_surface *sheet = adaptive_sheet(4, 4);
    find(sheet, 4, keep);
    int forth = side_of(10, 11), back = side_of(11, 10);
    ck_assert_int_eq(sharp.sides, 2 * 7);
    ck_assert_int_ne(forth, back);
    ck_assert_int_eq(side_of(13, 14), forth);
    ck_assert_int_eq(side_of(14, 13), back);
    ck_assert_int_eq(side_of(0, 1), side_of(3, 4));
    ck_assert_int_ne(side_of(0, 1), side_of(1, 0));
    ck_assert_int_ne(side_of(0, 1), side_of(4, 9));
    ck_assert(tf_sharp_edges_extend(&sharp, 26));
    ck_assert(tf_sharp_edges_split(&sharp, 12, 11, 25));
    tf_sharp_edges_collapse(&sharp, 13, 14);
    tf_sharp_edges_collapse(&sharp, 11, 10);
    static const int line[] = {10, 25, 12, 14};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(side_of(line[i], line[i + 1]), forth);
        ck_assert_int_eq(side_of(line[i + 1], line[i]), back);
    }
    release(sheet);
}
END_TEST

START_TEST(a_closed_line_has_two_sides)
{
    static double position[17][3];
    static int triangle[48];
    for (int i = 0; i < 16; i++) {
        position[i][0] = cos(i * acos(-1) / 8);
        position[i][1] = sin(i * acos(-1) / 8);
        memcpy(triangle + 3 * i, (int[]){16, i, (i + 1) % 16},
               3 * sizeof *triangle);
    }
    tf_adaptive_surface *disc = adaptive_of(17, position, 16, triangle);
    find(disc, 0, NULL);
    ck_assert_int_eq(sharp.sides, 2);
    for (int i = 0; i < 16; i++) {
        ck_assert_int_eq(tf_freedom_of(&sharp, i), TF_ALONG_SHARP_EDGE);
        ck_assert_int_eq(side_of(i, (i + 1) % 16), side_of(0, 1));
        ck_assert_int_eq(side_of((i + 1) % 16, i), 1 - side_of(0, 1));
    }
    release(disc);
}
END_TEST

// The boundary of a sheet of 3 x 3 squares goes on as one loop, and as long, after
// any splits and collapses along it.
START_TEST(a_loop_stays_a_loop)
{
    generator random = generator_new(1);
    for (long run = 0; run < cases(200); run++) {
        tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
        int loop[64] = {0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}, count = 12;
        int vertices = 16;
        find(sheet, 0, NULL);
        for (int step = 0; step < 40; step++) {
            int i = (int)uniform(&random, 0, count), next = (i + 1) % count;
            if (count > 4 && uniform(&random, 0, 1) < 0.5) {
                tf_sharp_edges_collapse(&sharp, loop[i], loop[next]);
                memmove(loop + i, loop + i + 1,
                        sizeof *loop * (size_t)(--count - i));
            } else {
                ck_assert(tf_sharp_edges_extend(&sharp, vertices + 1));
                ck_assert(tf_sharp_edges_split(&sharp, loop[i], loop[next],
                                               vertices));
                memmove(loop + i + 2, loop + i + 1,
                        sizeof *loop * (size_t)(count++ - i - 1));
                loop[i + 1] = vertices++;
            }
        }
        double sum = 0, length;
        for (int i = 0; i < count; i++) {
            ck_assert_int_eq(count_at(loop[i], vertices, &length), 2);
            ck_assert(
                tf_find_sharp_edge(&sharp, loop[i], loop[(i + 1) % count]));
            sum += length / 2;
        }
        ck_assert_double_eq_tol(sum, 12, 1e-12);
        release(sheet);
    }
}
END_TEST

// Vertex 1 goes from the middle of the first two edges on.
START_TEST(sliding_divides_two_edges_anew)
{
    static const double place[] = {1.5, 0, 0};
    tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
    find(sheet, 0, NULL);
    tf_sharp_pair pair = tf_sharp_edges_along(&sharp, 1);
    ck_assert_int_eq(pair.link[0]->to + pair.link[1]->to, 2);
    tf_vertex_put(sheet, 1, place);
    tf_sharp_edges_slide(&sharp, sheet, 1);
    double length;
    ck_assert_int_eq(count_at(1, 16, &length), 2);
    ck_assert_double_eq_tol(length, 2, 1e-15);
    ck_assert_double_eq_tol(tf_find_sharp_edge(&sharp, 0, 1)->length, 1.5,
                            1e-15);
    ck_assert_int_eq(count_at(0, 16, &length), 2);
    ck_assert_double_eq_tol(length, 2.5, 1e-15);
    release(sheet);
}
END_TEST

START_TEST(gaps_are_closed)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    int map[] = {0, TF_NONE, 1, 2, TF_NONE, 3, 4, 5, 6};
    find(sheet, 0, NULL);
    tf_sharp_edges_collapse(&sharp, 1, 2);
    tf_sharp_edges copy = {0};
    ck_assert(tf_sharp_edges_copy(&copy, &sharp));
    tf_sharp_edges_compact(&sharp, map);
    ck_assert_int_eq(sharp.vertices, 7);
    for (int a = 0; a < 9; a++)
        for (int b = 0; b < 9; b++) {
            bool before = tf_find_sharp_edge(&copy, a, b);
            if (map[a] != TF_NONE && map[b] != TF_NONE)
                ck_assert((tf_find_sharp_edge(&sharp, map[a], map[b]) !=
                           NULL) == before);
        }
    ck_assert_double_eq(tf_find_sharp_edge(&sharp, 0, 1)->length, 2);
    ck_assert_int_eq(tf_freedom_of(&sharp, 1), TF_HELD);
    ck_assert_int_eq(tf_freedom_of(&sharp, 3), TF_ALONG_SHARP_EDGE);
    tf_sharp_edges_free(&copy);
    release(sheet);
}
END_TEST

// Collapses -------------------------------------------------------------------

/// Expects how the edge of a sheet from `a` to `b` collapses: from which end, or
/// not at all.
static void expect_collapse(int a, int b, int from, bool may_go)
{
    tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
    tf_edge_collapse collapse;
    find(sheet, 0, NULL);
    int corner = tf_find_edge(sheet, a, b);
    ck_assert_int_ne(corner, TF_NONE);
    ck_assert(tf_collapse_freer(sheet, &sharp, corner, 0.999, &collapse) ==
              may_go);
    ck_assert_int_eq(collapse.from, from);
    ck_assert_int_eq(collapse.to, a + b - from);
    ck_assert_mem_eq(collapse.position.x, coordinates_of(sheet, a + b - from),
                     sizeof collapse.position);
    release(sheet);
}

START_TEST(the_freer_vertex_collapses)
{
    expect_collapse(5, 10, 5, true); // both are free
    expect_collapse(0, 5, 5, true);  // a corner, and a free one
    expect_collapse(1, 6, 6, true);  // along an edge, and a free one
    expect_collapse(0, 1, 1, true);  // a corner, and along the edge
    expect_collapse(1, 2, 1, true);  // both along the edge
}
END_TEST

START_TEST(no_vertex_leaves_its_sharp_edge)
{
    // From one side of a sheet that is one square wide to the other.
    tf_adaptive_surface *strip = adaptive_sheet(3, 1);
    tf_edge_collapse collapse;
    find(strip, 0, NULL);
    ck_assert(!tf_collapse_freer(strip, &sharp, tf_find_edge(strip, 1, 6), 0,
                                 &collapse));
    release(strip);
}
END_TEST

// A boundary with a bend: its middle vertex may go if little length is lost.
START_TEST(sharp_edges_keep_their_length)
{
    static const int triangle[] = {0, 1, 3, 1, 2, 3};
    for (int i = 0; i < 2; i++) {
        double height = i ? 0.05 : 0.04; // 0.99875 and 0.99920 of the length
        double position[][3] = {
            {-1, 0, 0}, {0, -height, 0}, {1, 0, 0}, {0, 1, 0}};
        tf_adaptive_surface *bent = adaptive_of(4, position, 2, triangle);
        tf_edge_collapse collapse;
        find(bent, 0, NULL);
        ck_assert(tf_collapse_freer(bent, &sharp, tf_find_edge(bent, 0, 1),
                                    0.999, &collapse) == (i == 0));
        ck_assert_int_eq(collapse.from, 1);
        ck_assert(tf_collapse_freer(bent, &sharp, tf_find_edge(bent, 0, 1), 0,
                                    &collapse));
        release(bent);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/sharp_edges");
    TCase *tcase = tcase_create("sharp edges");
    tcase_add_test(tcase, vertices_of_a_box_are_free_inside_its_sides);
    tcase_add_test(tcase, vertices_that_are_left_alone_are_corners);
    tcase_add_test(tcase, the_edges_of_a_box_are_sharp);
    tcase_add_test(tcase, the_angle_decides);
    tcase_add_test(tcase, the_depth_decides_too);
    tcase_add_test(tcase, the_boundary_is_sharp);
    tcase_add_test(tcase, kept_edges_are_sharp);
    tcase_add_test(tcase, a_line_keeps_its_sides);
    tcase_add_test(tcase, a_closed_line_has_two_sides);
    tcase_add_test(tcase, a_loop_stays_a_loop);
    tcase_add_test(tcase, sliding_divides_two_edges_anew);
    tcase_add_test(tcase, gaps_are_closed);
    tcase_add_test(tcase, the_freer_vertex_collapses);
    tcase_add_test(tcase, no_vertex_leaves_its_sharp_edge);
    tcase_add_test(tcase, sharp_edges_keep_their_length);
    suite_add_tcase(suite, tcase);
    return suite;
}
