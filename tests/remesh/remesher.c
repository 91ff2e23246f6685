// What the passes of remeshing have in common.
#include "remesh/remesher.h"

#include "remesh/measure.h"
#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"

static tf_remesher *made;

static void begin(void)
{
    made = remesher_begin(adaptive_sheet(2, 2), 0.5);
}

static void end(void)
{
    remesher_end(made);
}

START_TEST(each_edge_is_listed_once_the_shortest_first)
{
    ck_assert(tf_remesher_list(made, 0, INFINITY));
    ck_assert_int_eq(made->rows, 16);
    const tf_edge_row *row = made->row.data;
    for (int i = 0; i < 16; i++) {
        ck_assert_double_eq(row[i].length, i < 12 ? 1 : sqrt(2));
        for (int j = 0; j < i; j++)
            ck_assert(row[i].a != row[j].a || row[i].b != row[j].b);
    }
    ck_assert(tf_remesher_list(made, 1.1, 2));
    ck_assert_int_eq(made->rows, 4);
    ck_assert(tf_remesher_list(made, 0, 1));
    ck_assert_int_eq(made->rows, 12);
}
END_TEST

static int progress;

static void note_progress(void *context, const tf_remesh_report *so_far)
{
    ck_assert_ptr_eq(context, &progress);
    ck_assert_ptr_eq(so_far, made->report);
    progress++;
}

START_TEST(operations_are_counted_and_shown)
{
    tf_remesher_count(made, TF_FLIP, TF_OVERLAPPED);
    tf_remesh_options showing = {.progress = note_progress,
                                 .context = &progress};
    made->options = &showing;
    tf_remesher_count(made, TF_FLIP, TF_OVERLAPPED);
    tf_remesher_count(made, TF_SMOOTH, TF_COMMITTED);
    ck_assert_uint_eq(made->report->tried[TF_FLIP][TF_OVERLAPPED], 2);
    ck_assert_uint_eq(made->report->tried[TF_SMOOTH][TF_COMMITTED], 1);
    ck_assert_int_eq(progress, 2);
}
END_TEST

START_TEST(what_is_near_is_projected)
{
    tf_vector near = {{0.5, 0.25, 0.375}}, far = {{0.5, 0.25, 0.75}};
    near = tf_remesher_project(made, near);
    ck_assert_double_eq_tol(near.x[0], 0.5, 1e-15);
    ck_assert_double_eq(near.x[2], 0);
    ck_assert_double_eq(tf_remesher_project(made, far).x[2], 0.75);
}
END_TEST

START_TEST(stars_get_no_worse)
{
    static const struct {
        tf_vector place;
        bool good;
    } rows[] = {{{{1, 1, 0}}, true},
                {{{1.1, 1.1, 0}}, true},
                {{{1.9, 1, 0}}, false},  // thin
                {{{1, 1, 0.9}}, false},  // bent
                {{{1, 2.5, 0}}, false}}; // turned over
    for (int i = 0; i < 5; i++)
        ck_assert(tf_star_stays_good(made, 4, TF_NONE, rows[i].place) ==
                  rows[i].good);
    // The triangles at 8 would be turned over, but they vanish.
    tf_vector at_8 = {{2, 2, 0}};
    ck_assert(!tf_star_stays_good(made, 4, TF_NONE, at_8));
    ck_assert(!tf_star_stays_good(made, 4, 8, at_8));
    tf_vector beyond = {{1.1, 1.1, 0}};
    ck_assert(tf_star_stays_good(made, 4, 8, beyond));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/remesher");
    TCase *tcase = tcase_create("parts");
    tcase_add_checked_fixture(tcase, begin, end);
    tcase_add_test(tcase, each_edge_is_listed_once_the_shortest_first);
    tcase_add_test(tcase, operations_are_counted_and_shown);
    tcase_add_test(tcase, what_is_near_is_projected);
    tcase_add_test(tcase, stars_get_no_worse);
    suite_add_tcase(suite, tcase);
    return suite;
}
