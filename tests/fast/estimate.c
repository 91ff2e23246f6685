// Estimated contacts, against exact ones.
#include "fast/estimate.h"

#include "arithmetic/exact.h"
#include "query/edge_edge.h"
#include "query/point_triangle.h"
#include "support/query_batch.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BATCH = 500
};

static const double tolerance = 0x1p-18;

static query_kind kind_of(int i)
{
    return i % 2 ? EDGE_EDGE : POINT_TRIANGLE;
}

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/// The vertices of a query, those of each element in order.
static void vertices_of(const batch *b, size_t i, int vertex[4])
{
    size_t first = b->queries.kind == TF_EDGE_EDGE ? 2 : 1;
    memcpy(vertex, b->vertex + 4 * i, 4 * sizeof *vertex);
    qsort(vertex, first, sizeof *vertex, compare);
    qsort(vertex + first, 4 - first, sizeof *vertex, compare);
}

static tf_contact exact_contact(const batch *b, const int vertex[4])
{
    tf_contact contact;
    tf_status status =
        b->queries.kind == TF_EDGE_EDGE
            ? tf_edge_edge(&tf_exact, &b->motion, vertex, vertex + 2, &contact)
            : tf_point_triangle(&tf_exact, &b->motion, *vertex, vertex + 1,
                                &contact);
    ck_assert_int_eq(status, TF_OK);
    return contact;
}

/// How far two vectors of some numbers are from each other, as a share of the
/// largest number of the first.
static double difference(int count, const double a[], const double b[])
{
    double most = 0, size = 0;
    for (int i = 0; i < count; i++) {
        most = fmax(most, fabs(a[i] - b[i]));
        size = fmax(size, fabs(a[i]));
    }
    return size > 0 ? most / size : most;
}

/// What is wrong with an estimate; NULL: nothing.
static const char *fault_of(const tf_contact *found, const tf_contact *expected)
{
    if (expected->verdict != TF_HIT || found->verdict != TF_HIT)
        return "the elements do not meet";
    if (found->classification != TF_GENERIC || !(found->toi_lo > 0))
        return "it is not generic";
    if (found->toi_lo != found->toi_hi ||
        fabs(found->toi_lo - expected->toi_lo) > tolerance)
        return "the time is wrong";
    // Of pieces that meet at nearly the same time it may choose another.
    if (memcmp(found->pivot, expected->pivot, sizeof found->pivot) != 0)
        return NULL;
    if (difference(6, expected->barycentric[0], found->barycentric[0]) >
        tolerance)
        return "the place is wrong";
    if (difference(3, expected->velocity, found->velocity) > tolerance)
        return "the velocity is wrong";
    if (difference(3, expected->normal, found->normal) > tolerance)
        return "the normal is wrong";
    if (fabs(expected->normal_velocity - found->normal_velocity) >
        tolerance * fabs(expected->velocity[0]) +
            tolerance * fabs(expected->velocity[1]) +
            tolerance * fabs(expected->velocity[2]))
        return "the normal velocity is wrong";
    return NULL;
}

typedef struct counts {
    int hits, estimates, others; ///< others: between other pieces
} counts;

static void try_query(const batch *b, size_t i, const char *name, counts *all)
{
    int vertex[4];
    vertices_of(b, i, vertex);
    tf_contact expected = exact_contact(b, vertex), found;
    all->hits += expected.verdict == TF_HIT;
    if (!tf_contact_estimate(b->queries.kind, &b->motion, vertex, &found))
        return;
    all->estimates++;
    all->others += memcmp(found.pivot, expected.pivot, sizeof found.pivot) != 0;
    const char *fault = fault_of(&found, &expected);
    query q = batch_query(b, i);
    ck_assert_msg(!fault, "%s: %s, seed %llu\n%s", name, fault,
                  (unsigned long long)seed(), query_text(&q));
}

START_TEST(an_estimate_is_near_the_contact)
{
    const family *source = &families[_i / 2];
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    counts all = {0};
    for (long i = cases(5000); i > 0; i -= BATCH) {
        batch_fill(&b, &random, source, kind_of(_i), BATCH);
        b.queries.motion = &b.motion;
        for (size_t j = 0; j < BATCH; j++)
            try_query(&b, j, source->name, &all);
    }
    if (_i / 2 < RANDOM_FAMILIES) {
        ck_assert_int_gt(all.hits, 0);
        ck_assert_int_ge(100 * all.estimates, 95 * all.hits);
        ck_assert_int_le(1000 * all.others, all.estimates);
    }
    batch_free(&b);
}
END_TEST

// A contact at the start, at a corner, and in the plane -------------------------

/// The point (0, 0.13, z) falls by 2.  The triangle has its corner at (-1, 0, 0),
/// and the side across from it is where x is `side`.
static bool is_estimated(tf_kind kind, double z, double side)
{
    const double start[] = {0, 0.13, z, -1, 0, 0, side, -1, 0, side, 1, 0};
    double end[12];
    memcpy(end, start, sizeof end);
    end[2] -= 2;
    tf_motion motion = {3, 4, start, end};
    const int vertex[] = {0, 1, 2, 3};
    tf_contact contact;
    return tf_contact_estimate(kind, &motion, vertex, &contact);
}

START_TEST(uncertain_contacts_are_not_estimated)
{
    ck_assert(is_estimated(TF_POINT_TRIANGLE, 1.1, 1));
    ck_assert(!is_estimated(TF_POINT_TRIANGLE, 0, 1));
    ck_assert(!is_estimated(TF_POINT_TRIANGLE, 1.1, 0));
    ck_assert(!is_estimated(TF_POINT_TRIANGLE, 1.1, 0x1p-40));
    ck_assert(!is_estimated(TF_POINT_TRIANGLE, 1.1, -0x1p-40));
    ck_assert(!is_estimated(TF_POINT_TRIANGLE, 3, 1));
    ck_assert(!is_estimated(TF_POINT_EDGE, 1.1, 1));
}
END_TEST

// Small and large scenes, at whose ends squares of lengths vanish or overflow ---

static void scale(batch *b, int exponent)
{
    for (size_t i = 0; i < (size_t)12 * BATCH; i++) {
        b->start[i] = ldexp(b->start[i], exponent);
        b->end[i] = ldexp(b->end[i], exponent);
    }
}

START_TEST(the_size_of_a_scene_does_not_matter)
{
    generator random = generator_new(7);
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[0], kind_of(_i), BATCH);
    b.queries.motion = &b.motion;
    counts all = {0};
    for (size_t j = 0; j < BATCH; j++)
        try_query(&b, j, "random", &all);
    static const int exponents[] = {-1000, -600, -200, 200, 280, 600, 1000};
    for (int e = 0; e < 7; e++) {
        scale(&b, exponents[e]);
        counts own = {0};
        for (size_t j = 0; j < BATCH; j++)
            try_query(&b, j, "scaled", &own);
        ck_assert_int_eq(own.hits, all.hits);
        if (abs(exponents[e]) == 200)
            ck_assert_int_eq(own.estimates, all.estimates);
        scale(&b, -exponents[e]);
    }
    batch_free(&b);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/estimate");
    TCase *c = tcase_create("estimates");
    tcase_add_loop_test(c, an_estimate_is_near_the_contact, 0, 2 * FAMILIES);
    tcase_add_test(c, uncertain_contacts_are_not_estimated);
    tcase_add_loop_test(c, the_size_of_a_scene_does_not_matter, 0, 2);
    suite_add_tcase(suite, c);
    return suite;
}
