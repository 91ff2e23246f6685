// Edges are visited in order, and operations counted.
#include "remesh/remesher.h"

#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"

static tf_remesher *made;

static void begin(void)
{
    made = remesher_begin(adaptive_sheet(2, 2), NULL, 0.5);
}

static void end(void)
{
    remesher_end(made);
}

// Edges -----------------------------------------------------------------------

static tf_edge_row seen[16];
static int count;

static tf_status note_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    ck_assert_ptr_eq(remesher, made);
    ck_assert_int_lt(count, 16);
    seen[count++] = *edge;
    return TF_OK;
}

static int visit(double low, double high, tf_edge_order order)
{
    const tf_edge_pass pass = {"noting", order, note_edge};
    count = 0;
    ck_assert_int_eq(tf_remesher_visit(made, &pass, low, high), TF_OK);
    return count;
}

START_TEST(each_edge_is_visited_once_in_order)
{
    ck_assert_int_eq(visit(0, INFINITY, TF_SHORTEST_FIRST), 16);
    tf_edge_row all[16];
    for (int i = 0; i < 16; i++) {
        all[i] = seen[i];
        ck_assert_double_eq(seen[i].ratio, i < 12 ? 2 : sqrt(8));
        for (int j = 0; j < i; j++)
            ck_assert(seen[i].a != seen[j].a || seen[i].b != seen[j].b);
    }
    ck_assert_int_eq(visit(0, INFINITY, TF_LONGEST_FIRST), 16);
    for (int i = 0; i < 16; i++) {
        ck_assert_int_eq(seen[i].a, all[15 - i].a);
        ck_assert_int_eq(seen[i].b, all[15 - i].b);
    }
    ck_assert_int_eq(visit(2.2, 4, TF_LONGEST_FIRST), 4);
    ck_assert_int_eq(visit(0, 2, TF_SHORTEST_FIRST), 12);
}
END_TEST

static tf_status fail_at_the_third(tf_remesher *remesher,
                                   const tf_edge_row *edge)
{
    return note_edge(remesher, edge) == TF_OK && count == 3 ? TF_BAD_INDEX
                                                            : TF_OK;
}

START_TEST(a_visit_that_fails_is_the_last)
{
    const tf_edge_pass pass = {"failing", TF_SHORTEST_FIRST, fail_at_the_third};
    count = 0;
    ck_assert_int_eq(tf_remesher_visit(made, &pass, 0, INFINITY), TF_BAD_INDEX);
    ck_assert_int_eq(count, 3);
}
END_TEST

// Counts ----------------------------------------------------------------------

START_TEST(operations_are_counted)
{
    tf_remesher_count(made, TF_FLIP, TF_OVERLAPPED);
    tf_remesher_count(made, TF_FLIP, TF_OVERLAPPED);
    tf_remesher_count(made, TF_SMOOTH, TF_COMMITTED);
    ck_assert_uint_eq(made->report.tried[TF_FLIP][TF_OVERLAPPED], 2);
    ck_assert_uint_eq(made->report.tried[TF_SMOOTH][TF_COMMITTED], 1);
}
END_TEST

// Cancelling ------------------------------------------------------------------

static tf_stage told;

/// Goes on until the stage has got that far.
static bool go_on_until(void *context, const tf_stage *stage)
{
    const size_t *until = context;
    told = *stage;
    return stage->total == 0 || stage->done < *until;
}

START_TEST(a_visit_that_is_cancelled_ends_soon)
{
    static const tf_edge_pass pass = {"noting", TF_SHORTEST_FIRST, note_edge};
    size_t until = _i ? 16 : 1;
    tf_watch watch;
    made->surface->watch = tf_watch_begin(&watch, go_on_until, &until);
    count = 0;
    ck_assert_int_eq(tf_remesher_visit(made, &pass, 0, INFINITY), TF_CANCELLED);
    ck_assert_int_eq(count, _i ? 8 : 0);
    ck_assert_str_eq(told.name, "noting");
    ck_assert_uint_eq(told.total, 16);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/remesher");
    TCase *tcase = tcase_create("parts");
    tcase_add_checked_fixture(tcase, begin, end);
    tcase_add_test(tcase, each_edge_is_visited_once_in_order);
    tcase_add_test(tcase, a_visit_that_fails_is_the_last);
    tcase_add_test(tcase, operations_are_counted);
    tcase_add_loop_test(tcase, a_visit_that_is_cancelled_ends_soon, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}
