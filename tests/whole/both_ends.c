// Detection of what moves as a whole, by up to 1e300, at all scales, against
// the query of every two elements; every contact is among the candidates.
#include "arithmetic/exact.h"
#include "query/query.h"
#include "support/contacts.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "surface/candidates.h"
#include "surface/detect.h"

#include <math.h>
#include <string.h>

static surface_case given;

// Steps -----------------------------------------------------------------------

/// A little, much, or nothing.
static double random_noise(generator *random)
{
    int choice = below(random, 4);
    return choice == 0 ? 0
                       : ldexp(uniform(random, 0, 1), 2 - 12 * (choice - 1));
}

/// Nothing, a few sizes, or any power of ten up to 1e300.
static double random_bulk(generator *random)
{
    int choice = below(random, 4);
    return choice == 0   ? 0
           : choice == 1 ? uniform(random, -4, 4)
                         : uniform(random, -1, 1) *
                               pow(10, below(random, choice == 2 ? 20 : 300));
}

/// The identity, a turn about the last axis, or an expansion, of all starts.
static void map_ends(generator *random, surface_case *made)
{
    int axes = made->mesh.axes, choice = below(random, 3);
    double angle = choice == 1 ? uniform(random, -4, 4) : 0;
    double size = choice == 2 ? uniform(random, -1, 3) : 1;
    for (int v = 0; v < made->mesh.vertices; v++) {
        const double *x = made->start + axes * v;
        double *y = made->end + axes * v;
        memcpy(y, x, sizeof *y * (size_t)axes);
        y[0] = size * (cos(angle) * x[0] - sin(angle) * x[1]);
        y[1] = size * (sin(angle) * x[0] + cos(angle) * x[1]);
        if (axes == 3)
            y[2] = size * x[2];
    }
}

static void random_step(generator *random, int axes, surface_case *made)
{
    static const placement starts[] = {ANYWHERE, ON_LATTICE, IN_PLANE,
                                       IN_POINT};
    random_surface(random, axes, 30, starts[below(random, 4)], made);
    map_ends(random, made);
    int exponent = below(random, 3) ? 0 : below(random, 2001) - 1000;
    double noise = random_noise(random), bulk[3];
    for (int k = 0; k < 3; k++)
        bulk[k] = random_bulk(random);
    int fast = below(random, 4) ? -1 : below(random, made->mesh.vertices);
    for (int i = 0; i < axes * made->mesh.vertices; i++) {
        double own = i / axes == fast ? uniform(random, -100, 100) : 0;
        double end = made->end[i] + uniform(random, -noise, noise) + own;
        made->start[i] = ldexp(made->start[i], exponent);
        // The shift is in units of the scene, unless that overflows.
        double moved = ldexp(end + bulk[i % axes], exponent);
        made->end[i] =
            isfinite(moved) ? moved : ldexp(end, exponent) + bulk[i % axes];
    }
}

// All pairs -------------------------------------------------------------------

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

static bool is_listed(size_t count, const tf_candidate pair[], int i, int j,
                      bool same)
{
    for (size_t k = 0; k < count; k++)
        if ((pair[k].first == i && pair[k].second == j) ||
            (same && pair[k].first == j && pair[k].second == i))
            return true;
    return false;
}

/// What is found, and how many of its rows have been met.
typedef struct rows {
    tf_contacts found;
    tf_candidates candidates;
    size_t met, pairs;
} rows;

static bool row_is(const tf_surface_contact *row, int count, const int a[],
                   int others, const int b[], const tf_contact *contact)
{
    return memcmp(row->vertex, a, sizeof *a * (size_t)count) == 0 &&
           memcmp(row->vertex + count, b, sizeof *b * (size_t)others) == 0 &&
           contacts_are_same(&row->contact, contact);
}

static bool try_pair(rows *all, int count, const int a[], int others,
                     const int b[])
{
    tf_contact contact;
    if (share(count, a, others, b))
        return false;
    all->pairs++;
    ck_assert_int_eq(tf_query_motion(&tf_exact, given.mesh.axes, &given.motion,
                                     count, a, others, b, &contact),
                     TF_OK);
    if (contact.verdict == TF_APART)
        return false;
    ck_assert_msg(all->met < all->found.count &&
                      row_is(&all->found.contact[all->met], count, a, others, b,
                             &contact),
                  "row %zu, seed %llu", all->met, (unsigned long long)seed());
    all->met++;
    return true;
}

static void try_points(rows *all, int corners, int count, const int *element)
{
    for (int v = 0; v < given.mesh.vertices; v++)
        for (int i = 0; i < count; i++)
            if (try_pair(all, 1, &v, corners, element + corners * i))
                ck_assert(is_listed(all->candidates.point_count,
                                    all->candidates.points, v, i, false));
}

static void try_edges(rows *all, int count, const int *edge)
{
    for (int i = 0; i < count; i++)
        for (int j = i + 1; j < count; j++)
            if (try_pair(all, 2, edge + 2 * i, 2, edge + 2 * j))
                ck_assert(is_listed(all->candidates.edge_count,
                                    all->candidates.edges, i, j, true));
}

static size_t rows_met, pairs_tried, candidates_found;

static void check_step(void)
{
    tf_surface *surface = surface_of(&given.mesh),
               *other = surface_of(&given.mesh);
    rows all = {.met = 0};
    ck_assert_int_eq(tf_detect(surface, &given.motion, NULL, &all.found, NULL),
                     TF_OK);
    ck_assert_int_eq(tf_surface_candidates(other, &given.motion, NULL,
                                           &all.candidates, NULL),
                     TF_OK);
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    if (given.mesh.axes == 2) {
        try_points(&all, 2, edges, edge);
    } else {
        try_points(&all, 3, triangles, triangle);
        try_edges(&all, edges, edge);
    }
    ck_assert_uint_eq(all.met, all.found.count);
    rows_met += all.met;
    pairs_tried += all.pairs;
    candidates_found += all.candidates.point_count + all.candidates.edge_count;
    tf_surface_free(surface);
    tf_surface_free(other);
}

START_TEST(steps_of_all_kinds_have_the_rows_of_all_pairs)
{
    generator random = generator_new(900 + (uint64_t)_i);
    for (int i = 0; i < (int)cases(500); i++) {
        random_step(&random, 2 + (_i + i) % 2, &given);
        check_step();
    }
    // They are of many contacts and of many pairs apart.
    ck_assert_uint_gt(rows_met, pairs_tried / 10);
    ck_assert_uint_lt(rows_met, candidates_found);
    ck_assert_uint_lt(candidates_found, pairs_tried);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/both_ends");
    TCase *tcase = tcase_create("both ends");
    tcase_set_timeout(tcase, 0);
    tcase_add_loop_test(tcase, steps_of_all_kinds_have_the_rows_of_all_pairs, 0,
                        4);
    suite_add_tcase(suite, tcase);
    return suite;
}
