// Detection, against every pair of elements by the query of two.
#include "surface/detect.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "query/edge_edge.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

// Brute force -----------------------------------------------------------------

enum {
    MOST_CONTACTS = 400000
};

/// What all pairs of elements answer, in the order of a detection's rows.
typedef struct answers {
    const tf_arithmetic *arithmetic;
    const tf_motion *motion;
    size_t count;
    tf_surface_contact *contact;
} answers;

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

static void try_pair(answers *all, tf_kind kind, int count, const int a[],
                     int others, const int b[])
{
    tf_surface_contact row = {.kind = kind, .vertex = {-1, -1, -1, -1}};
    memcpy(row.vertex, a, sizeof *a * (size_t)count);
    memcpy(row.vertex + count, b, sizeof *b * (size_t)others);
    if (share(count, a, others, b))
        return;
    tf_status status =
        kind == TF_POINT_EDGE
            ? tf_point_edge(all->arithmetic, all->motion, *a, b, &row.contact)
        : kind == TF_POINT_TRIANGLE
            ? tf_point_triangle(all->arithmetic, all->motion, *a, b,
                                &row.contact)
            : tf_edge_edge(all->arithmetic, all->motion, a, b, &row.contact);
    ck_assert_int_eq(status, TF_OK);
    if (row.contact.verdict == TF_APART)
        return;
    ck_assert_uint_lt(all->count, MOST_CONTACTS);
    all->contact[all->count++] = row;
}

static void try_points(answers *all, tf_kind kind, int vertices, int elements,
                       const int *element)
{
    int corners = kind == TF_POINT_EDGE ? 2 : 3;
    for (int v = 0; v < vertices; v++)
        for (int i = 0; i < elements; i++)
            try_pair(all, kind, 1, &v, corners, element + corners * i);
}

static void try_edges(answers *all, int edges, const int *edge)
{
    for (int i = 0; i < edges; i++)
        for (int j = i + 1; j < edges; j++)
            try_pair(all, TF_EDGE_EDGE, 2, edge + 2 * i, 2, edge + 2 * j);
}

static void try_all(answers *all, const surface_case *given,
                    tf_surface *surface)
{
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    all->motion = &given->motion;
    all->count = 0;
    if (given->mesh.axes == 2) {
        try_points(all, TF_POINT_EDGE, given->mesh.vertices, edges, edge);
        return;
    }
    try_points(all, TF_POINT_TRIANGLE, given->mesh.vertices, triangles,
               triangle);
    try_edges(all, edges, edge);
}

// Comparison ------------------------------------------------------------------

static bool same_number(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static bool same_contact(const tf_contact *a, const tf_contact *b)
{
    bool same = a->verdict == b->verdict &&
                a->classification == b->classification &&
                same_number(a->toi_lo, b->toi_lo) &&
                same_number(a->toi_hi, b->toi_hi) &&
                same_number(a->normal_velocity, b->normal_velocity);
    for (int i = 0; i < 3; i++)
        same &= same_number(a->normal[i], b->normal[i]) &&
                same_number(a->velocity[i], b->velocity[i]) &&
                same_number(a->barycentric[0][i], b->barycentric[0][i]) &&
                same_number(a->barycentric[1][i], b->barycentric[1][i]);
    return same;
}

static bool same_row(const tf_surface_contact *a, const tf_surface_contact *b)
{
    return a->kind == b->kind &&
           memcmp(a->vertex, b->vertex, sizeof a->vertex) == 0 &&
           same_contact(&a->contact, &b->contact);
}

static void compare(const tf_contacts *found, const answers *all)
{
    ck_assert_uint_eq(found->count, all->count);
    ck_assert_int_eq(found->any, all->count > 0);
    for (size_t i = 0; i < all->count; i++)
        ck_assert_msg(same_row(&found->contact[i], &all->contact[i]),
                      "row %zu, seed %llu", i, (unsigned long long)seed());
}

static void check_statistics(const tf_detect_statistics *statistics)
{
    ck_assert_uint_eq(statistics->by_axis + statistics->by_filter +
                          statistics->by_signs,
                      statistics->candidates);
}

static size_t first_of(const answers *all)
{
    size_t first = 0;
    for (size_t i = 1; i < all->count; i++)
        if (all->contact[i].contact.toi_lo < all->contact[first].contact.toi_lo)
            first = i;
    return first;
}

static void compare_extents(tf_surface *surface, const answers *all)
{
    tf_detect_options detection = {.selection = TF_FIRST_CONTACT,
                                   .arithmetic = all->arithmetic};
    tf_contacts found;
    ck_assert_int_eq(tf_detect(surface, all->motion, &detection, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, all->count > 0);
    if (all->count > 0)
        ck_assert(same_row(found.contact, &all->contact[first_of(all)]));
    detection.selection = TF_ANY_CONTACT;
    ck_assert_int_eq(tf_detect(surface, all->motion, &detection, &found, NULL),
                     TF_OK);
    ck_assert_int_eq(found.any, all->count > 0);
    ck_assert_uint_eq(found.count, 0);
}

static surface_case given;

static void compare_surface(const tf_arithmetic *arithmetic,
                            tf_surface *surface, answers *all)
{
    all->arithmetic = arithmetic;
    try_all(all, &given, surface);
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    tf_detect_options detection = {.arithmetic = arithmetic};
    tf_contacts found;
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(
            tf_detect(surface, &given.motion, &detection, &found, NULL), TF_OK);
        compare(&found, all);
        check_statistics(&found.statistics);
        detection.parallel = &parallel;
    }
    compare_extents(surface, all);
}

static void compare_surfaces(const tf_arithmetic *arithmetic, int count,
                             int elements, placement placed, int stream)
{
    generator random = generator_new((uint64_t)stream);
    answers all = {.contact = malloc(sizeof *all.contact * MOST_CONTACTS)};
    for (int i = 0; i < count; i++) {
        random_surface(&random, 2 + i % 2, elements, placed, &given);
        tf_surface *surface = surface_of(&given.mesh);
        compare_surface(arithmetic, surface, &all);
        tf_surface_free(surface);
    }
    free(all.contact);
}

START_TEST(all_contacts_are_those_of_all_pairs)
{
    compare_surfaces(&tf_exact, (int)cases(60), 12, (placement)_i, 100 + _i);
}
END_TEST

START_TEST(all_contacts_of_larger_surfaces_are_found)
{
    compare_surfaces(&tf_exact, (int)cases(8), 60, (placement)_i, 200 + _i);
}
END_TEST

START_TEST(all_contacts_of_what_moves_together_are_found)
{
    compare_surfaces(&tf_exact, (int)cases(500), 12, TOGETHER, 500 + _i);
}
END_TEST

START_TEST(every_arithmetic_finds_its_contacts)
{
    static const tf_arithmetic *const tried[] = {&tf_clamped, &tf_published,
                                                 &tf_perturbed, &tf_integer64,
                                                 &tf_integer128};
    compare_surfaces(tried[_i], (int)cases(30), 10, ON_LATTICE, 300 + _i);
}
END_TEST

// Sequences -------------------------------------------------------------------

START_TEST(a_surface_that_moved_before_is_like_a_new_one)
{
    generator random = generator_new(400);
    answers all = {.arithmetic = &tf_exact,
                   .contact = malloc(sizeof *all.contact * MOST_CONTACTS)};
    random_surface(&random, 3, 20, ANYWHERE, &given);
    tf_surface *surface = surface_of(&given.mesh);
    for (int step = 0; step < (int)cases(30); step++) {
        memcpy(given.start, given.end, sizeof given.start);
        for (int i = 0; i < 3 * given.mesh.vertices; i++)
            given.end[i] += uniform(&random, -0.3, 0.3);
        compare_surface(&tf_exact, surface, &all);
    }
    tf_surface_free(surface);
    free(all.contact);
}
END_TEST

// Trouble ---------------------------------------------------------------------

static const int one_triangle[] = {0, 1, 2};
static const tf_mesh simple = {
    .axes = 3, .vertices = 4, .triangles = 1, .triangle = one_triangle};

static tf_status try_positions(const double *start, const double *end,
                               const tf_arithmetic *arithmetic, tf_error *error)
{
    tf_surface *surface = surface_of(&simple);
    tf_motion motion = {3, 4, start, end};
    tf_detect_options detection = {.arithmetic = arithmetic};
    tf_contacts found;
    tf_status status = tf_detect(surface, &motion, &detection, &found, error);
    tf_surface_free(surface);
    return status;
}

START_TEST(positions_that_are_not_finite_are_named)
{
    double good[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    double bad[12];
    tf_error error;
    static const double worse[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 12; i++) {
        memcpy(bad, good, sizeof bad);
        bad[i] = worse[i % 3];
        for (int t = 0; t < 2; t++) {
            ck_assert_int_eq(
                try_positions(t ? good : bad, t ? bad : good, NULL, &error),
                TF_NOT_FINITE);
            ck_assert_int_eq(error.subject, TF_VERTEX);
            ck_assert_uint_eq(error.index, (size_t)(i / 3));
        }
    }
    ck_assert_int_eq(try_positions(good, good, NULL, NULL), TF_OK);
}
END_TEST

START_TEST(positions_out_of_range_are_named)
{
    double good[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    double bad[12];
    tf_error error;
    for (int i = 0; i < 12; i++) {
        memcpy(bad, good, sizeof bad);
        bad[i] = i % 2 ? 0.5 : 0x1p19;
        ck_assert_int_eq(try_positions(good, bad, &tf_integer64, &error),
                         TF_OUT_OF_RANGE);
        ck_assert_uint_eq(error.index, (size_t)(i / 3));
        ck_assert_int_eq(try_positions(bad, good, &tf_integer64, &error),
                         TF_OUT_OF_RANGE);
    }
}
END_TEST

START_TEST(another_number_of_vertices_is_refused)
{
    double x[15] = {0};
    tf_surface *surface = surface_of(&simple);
    tf_motion motion = {3, 5, x, x};
    tf_contacts found;
    tf_error error;
    ck_assert_int_eq(tf_detect(surface, &motion, NULL, &found, &error),
                     TF_BAD_COUNT);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/detect");
    TCase *tcase = tcase_create("all pairs");
    tcase_set_timeout(tcase, 0);
    tcase_add_loop_test(tcase, all_contacts_are_those_of_all_pairs, 0,
                        PLACEMENTS);
    tcase_add_loop_test(tcase, all_contacts_of_larger_surfaces_are_found, 0,
                        PLACEMENTS);
    tcase_add_loop_test(tcase, all_contacts_of_what_moves_together_are_found, 0,
                        4);
    tcase_add_loop_test(tcase, every_arithmetic_finds_its_contacts, 0, 5);
    tcase_add_test(tcase, a_surface_that_moved_before_is_like_a_new_one);
    suite_add_tcase(suite, tcase);

    TCase *trouble = tcase_create("trouble");
    tcase_add_test(trouble, positions_that_are_not_finite_are_named);
    tcase_add_test(trouble, positions_out_of_range_are_named);
    tcase_add_test(trouble, another_number_of_vertices_is_refused);
    suite_add_tcase(suite, trouble);
    return suite;
}
