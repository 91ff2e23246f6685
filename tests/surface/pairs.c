// Pairs decided in batches, apart from any tree.
#include "surface/pairs.h"

#include "arithmetic/exact.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <stdlib.h>
#include <string.h>

enum {
    SPECKS = 9000
};

static double start[3 * (SPECKS + 3)], end[3 * (SPECKS + 3)];
static const int triangle[] = {SPECKS, SPECKS + 1, SPECKS + 2};

/// Specks that fall through a triangle, every third of them beside it, and the
/// later the higher their index.
static tf_surface *rain(void)
{
    static const double corner[] = {-9, -9, 0, 99, -9, 0, -9, 99, 0};
    tf_mesh mesh = {.axes = 3,
                    .vertices = SPECKS + 3,
                    .triangles = 1,
                    .triangle = triangle};
    for (int i = 0; i < SPECKS; i++) {
        double at[] = {i % 3 == 0 ? -20 : 1, 1, 1 + i};
        memcpy(start + (ptrdiff_t)3 * i, at, sizeof at);
        memcpy(end + (ptrdiff_t)3 * i, at, sizeof at);
        end[3 * i + 2] = -1;
    }
    memcpy(start + 3 * SPECKS, corner, sizeof corner);
    memcpy(end + 3 * SPECKS, corner, sizeof corner);
    return surface_of(&mesh);
}

/// Decides the given specks, by batches.
static tf_contacts decide(tf_surface *surface, tf_contact_selection selection,
                          int count, const int speck[])
{
    static tf_candidate pair[TF_BATCH];
    tf_motion motion = {3, SPECKS + 3, start, end};
    tf_pair_job job = {.surface = surface,
                       .motion = &motion,
                       .arithmetic = &tf_exact,
                       .narrow_phase = &tf_reference,
                       .selection = selection,
                       .kind = TF_POINT_TRIANGLE};
    tf_contacts found = {0};
    ck_assert(tf_pairs_begin(surface, NULL, &job));
    tf_worker *worker = surface->workers.worker[0];
    bool more = true;
    for (int begin = 0; begin < count && more; begin += TF_BATCH) {
        int part = count - begin < TF_BATCH ? count - begin : TF_BATCH;
        for (int i = 0; i < part; i++)
            pair[i] = (tf_candidate){speck[begin + i], 0};
        more = tf_pairs_take(&worker->sink, part, pair);
    }
    ck_assert_int_eq(worker->status, TF_OK);
    ck_assert(tf_pairs_gather(surface, selection, &found));
    return found;
}

/// The numbers to count - 1, shuffled.
static void shuffle(generator *random, int count, int number[])
{
    for (int i = 0; i < count; i++) {
        int j = below(random, i + 1);
        number[i] = number[j];
        number[j] = i;
    }
}

START_TEST(contacts_are_sorted_in_whatever_order_they_come)
{
    static int speck[SPECKS];
    generator random = generator_new(100);
    tf_surface *surface = rain();
    static const int counts[] = {0, 1, 2, 3, 7, 64, 100, 4097, SPECKS};
    int count = counts[_i];
    shuffle(&random, count, speck);
    tf_contacts found = decide(surface, TF_ALL_CONTACTS, count, speck);
    size_t expected = 0;
    for (int v = 0; v < count; v++)
        if (v % 3 != 0) {
            ck_assert_uint_lt(expected, found.count);
            ck_assert_int_eq(found.contact[expected++].vertex[0], v);
        }
    ck_assert_uint_eq(found.count, expected);
    ck_assert_uint_eq(found.statistics.candidates, (size_t)count);
    ck_assert_uint_eq(found.statistics.by_axis, (size_t)((count + 2) / 3));
    tf_surface_free(surface);
}
END_TEST

START_TEST(the_first_contact_or_none_is_listed)
{
    static int speck[SPECKS];
    generator random = generator_new(200);
    tf_surface *surface = rain();
    shuffle(&random, 1000, speck);
    tf_contacts found = decide(surface, TF_FIRST_CONTACT, 1000, speck);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.contact->vertex[0], 1);
    for (int i = 0; i < 1000; i++)
        speck[i] = 1 + 3 * i;
    found = decide(surface, TF_ANY_CONTACT, 1000, speck);
    ck_assert(found.any && found.count == 0);
    tf_surface_free(surface);
}
END_TEST

START_TEST(statistics_add_up)
{
    tf_detect_statistics all = {1, 2, 3, 4, {0}};
    tf_detect_statistics own = {10, 20, 30, 40, {0}};
    tf_detect_statistics_add(&all, &own);
    ck_assert_uint_eq(all.candidates, 11);
    ck_assert_uint_eq(all.by_axis, 22);
    ck_assert_uint_eq(all.by_filter, 33);
    ck_assert_uint_eq(all.by_signs, 44);
}
END_TEST

START_TEST(steady_work_takes_no_more_memory)
{
    static int speck[SPECKS];
    generator random = generator_new(300);
    tf_surface *surface = rain();
    shuffle(&random, SPECKS, speck);
    decide(surface, TF_ALL_CONTACTS, SPECKS, speck);
    size_t bytes = tf_surface_memory(surface);
    for (int i = 0; i < 3; i++)
        decide(surface, TF_ALL_CONTACTS, SPECKS, speck);
    ck_assert_uint_eq(tf_surface_memory(surface), bytes);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/pairs");
    TCase *tcase = tcase_create("specks and a triangle");
    tcase_add_loop_test(tcase, contacts_are_sorted_in_whatever_order_they_come,
                        0, 9);
    tcase_add_test(tcase, the_first_contact_or_none_is_listed);
    tcase_add_test(tcase, statistics_add_up);
    tcase_add_test(tcase, steady_work_takes_no_more_memory);
    suite_add_tcase(suite, tcase);
    return suite;
}
