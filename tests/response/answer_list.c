// The list of answers: its order, and where impulses come from.
#include "response/answer_list.h"

#include "support/support.h"

#include <string.h>

static tf_answer_list list;

static tf_surface_contact contact_of(tf_kind kind, int a, int b, int c, int d)
{
    return (tf_surface_contact){
        .kind = kind, .vertex = {a, b, c, d}, .contact = {.toi_lo = 0.25 * a}};
}

/// A constraint that pushes only some of the vertices, with a number to know it
/// by.
static tf_constraint constraint_of(int a, int b, double number)
{
    return (tf_constraint){.vertex = {a, b, -1, -1},
                           .coefficient = {1, -1},
                           .normal = {0, 0, 1},
                           .impulse = number,
                           .friction = {2 * number, 3 * number, 0}};
}

/// One whose push tells of its constraint.
static tf_contact_gap gap_of(const tf_constraint *constraint)
{
    return (tf_contact_gap){.push = 4 * constraint->impulse};
}

static void add(tf_response_level level, int round, int count,
                const tf_surface_contact contact[],
                const tf_constraint constraint[])
{
    tf_contacts contacts = {true, (size_t)count, contact, {0}};
    if (constraint) {
        tf_contact_gap *gap;
        tf_constraint *to = tf_answers_extend(&list, (size_t)count, &gap);
        ck_assert_ptr_nonnull(to);
        memcpy(to, constraint, sizeof *to * (size_t)count);
        for (int i = 0; i < count; i++)
            gap[i] = gap_of(&constraint[i]);
    }
    ck_assert(
        tf_answers_add(&list, &contacts, level, round, (size_t)round, NULL));
}

/// Two contacts that two rounds of zones answer, the first one twice, and one
/// that the failsafe does.
static const tf_answered_contact *lend(void)
{
    const tf_surface_contact first[] = {
        contact_of(TF_EDGE_EDGE, 1, 2, 3, 4),
        contact_of(TF_POINT_TRIANGLE, 3, 1, 4, 5)};
    const tf_constraint zones[] = {constraint_of(1, 4, 10),
                                   constraint_of(3, 5, 11),
                                   constraint_of(2, 3, 12)};
    const tf_constraint other[] = {constraint_of(3, 1, 0)};
    const tf_constraint pushes[] = {constraint_of(1, 3, 7),
                                    constraint_of(3, 4, 8)};
    tf_answers_clear(&list);
    add(TF_IMPULSES, 0, 2, first, pushes);
    add(TF_ZONES, 0, 2, first, NULL);
    add(TF_ZONES, 2, 1, first, NULL);
    add(TF_FAILSAFE, 0, 1, first + 1, other);
    const tf_contact_gap gaps[] = {gap_of(&zones[0]), gap_of(&zones[1]),
                                   gap_of(&zones[2])};
    ck_assert(tf_answers_lend(&list, zones, gaps));
    ck_assert_uint_eq(list.answers, 6);
    return list.row.data;
}

START_TEST(rows_are_sorted_by_elements_then_by_levels_and_rounds)
{
    static const struct {
        tf_kind kind;
        tf_response_level level;
        int round;
        double impulse;
    } expected[] = {{TF_POINT_TRIANGLE, TF_IMPULSES, 0, 8},
                    {TF_POINT_TRIANGLE, TF_ZONES, 0, 11},
                    {TF_POINT_TRIANGLE, TF_FAILSAFE, 0, 0},
                    {TF_EDGE_EDGE, TF_IMPULSES, 0, 7},
                    {TF_EDGE_EDGE, TF_ZONES, 0, 10},
                    {TF_EDGE_EDGE, TF_ZONES, 2, 12}};
    const tf_answered_contact *row = lend();
    const double *push = list.push.data;
    for (int i = 0; i < 6; i++) {
        ck_assert_int_eq(row[i].kind, expected[i].kind);
        ck_assert_int_eq(row[i].level, expected[i].level);
        ck_assert_int_eq(row[i].round, expected[i].round);
        ck_assert_double_eq(row[i].impulse, expected[i].impulse);
        ck_assert_double_eq(push[i], 4 * expected[i].impulse);
        ck_assert_double_eq(row[i].friction[1], 3 * expected[i].impulse);
        ck_assert_double_eq(row[i].normal[2], 1);
        ck_assert_double_eq(row[i].toi, 0.25 * row[i].vertex[0]);
    }
}
END_TEST

START_TEST(coefficients_are_those_of_the_vertices_in_the_row)
{
    const tf_answered_contact *row = lend();
    const double point[] = {1, 0, 0, -1}, edges[] = {1, 0, 0, -1},
                 again[] = {0, 1, -1, 0};
    ck_assert_mem_eq(row[1].coefficient, point, sizeof point);
    ck_assert_mem_eq(row[4].coefficient, edges, sizeof edges);
    ck_assert_mem_eq(row[5].coefficient, again, sizeof again);
}
END_TEST

/// Adds a contact that a round of zones answers, as each part has.
static void add_part(int number)
{
    const tf_surface_contact contact = contact_of(TF_POINT_EDGE, 1, 2, 3, -1);
    const tf_constraint zones[] = {constraint_of(1, 2, 0),
                                   constraint_of(1, 2, number)};
    const tf_constraint push = constraint_of(2, 3, 100 + number);
    const tf_contact_gap gaps[] = {gap_of(&zones[0]), gap_of(&zones[1])};
    add(TF_IMPULSES, 0, 1, &contact, &push);
    add(TF_ZONES, 1, 1, &contact, NULL);
    if (number == 2) { // tried again
        tf_answers_drop(&list);
        add(TF_ZONES, 1, 1, &contact, NULL);
    }
    ck_assert(tf_answers_settle(&list, zones, gaps, number, 4));
}

// Each part has its own constraints of zones; times are those of the whole step.
START_TEST(parts_are_settled_one_after_another)
{
    static const double impulses[] = {100, 0, 101, 1, 2, 103, 3};
    static const int parts[] = {0, 0, 1, 1, 2, 3, 3};
    tf_answers_clear(&list);
    for (int i = 0; i < 4; i++)
        add_part(i);
    ck_assert(tf_answers_lend(&list, NULL, NULL));
    ck_assert_uint_eq(list.answers, 7);
    const tf_answered_contact *row = list.row.data;
    const double *push = list.push.data;
    for (int i = 0; i < 7; i++) {
        ck_assert_double_eq(row[i].impulse, impulses[i]);
        ck_assert_double_eq(push[i], 4 * impulses[i]);
        ck_assert_double_eq(row[i].toi, (parts[i] + 0.25) / 4);
        ck_assert_int_eq(row[i].level,
                         impulses[i] >= 100 ? TF_IMPULSES : TF_ZONES);
    }
}
END_TEST

START_TEST(rows_are_made_once)
{
    const tf_answered_contact *row = lend();
    const tf_constraint other = constraint_of(1, 2, 99);
    ck_assert(tf_answers_lend(&list, &other, NULL));
    ck_assert_ptr_eq(list.row.data, row);
    ck_assert_double_eq(row[1].impulse, 11);
}
END_TEST

START_TEST(a_list_that_is_cleared_is_empty)
{
    lend();
    size_t bytes = tf_answers_memory(&list);
    ck_assert_uint_ge(bytes, 6 * sizeof(tf_answered_contact));
    tf_answers_clear(&list);
    ck_assert(tf_answers_lend(&list, NULL, NULL));
    ck_assert_uint_eq(list.answers, 0);
    const tf_surface_contact only = contact_of(TF_POINT_EDGE, 7, 8, 9, -1);
    const tf_constraint constraint = constraint_of(7, 9, 5);
    add(TF_IMPULSES, 0, 1, &only, &constraint);
    ck_assert(tf_answers_lend(&list, NULL, NULL));
    const tf_answered_contact *row = list.row.data;
    ck_assert_int_eq(row->vertex[0], 7);
    ck_assert_double_eq(row->impulse, 5);
    lend();
    ck_assert_uint_eq(tf_answers_memory(&list), bytes);
    tf_answers_free(&list);
    ck_assert_uint_eq(tf_answers_memory(&list), 0);
}
END_TEST

static bool refuse(void *context, const tf_stage *stage)
{
    (void)context, (void)stage;
    return false;
}

START_TEST(a_caller_who_cancels_is_heard)
{
    const tf_surface_contact contact = contact_of(TF_POINT_EDGE, 1, 2, 3, -1);
    const tf_contacts contacts = {true, 1, &contact, {0}};
    tf_watch storage, *watch = tf_watch_begin(&storage, refuse, NULL);
    tf_answers_clear(&list);
    ck_assert(!tf_watch_done(watch, 0));
    ck_assert(!tf_answers_add(&list, &contacts, TF_ZONES, 0, 0, watch));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/answer_list");
    TCase *tcase = tcase_create("rows");
    tcase_add_test(tcase,
                   rows_are_sorted_by_elements_then_by_levels_and_rounds);
    tcase_add_test(tcase, coefficients_are_those_of_the_vertices_in_the_row);
    tcase_add_test(tcase, rows_are_made_once);
    tcase_add_test(tcase, parts_are_settled_one_after_another);
    tcase_add_test(tcase, a_list_that_is_cleared_is_empty);
    tcase_add_test(tcase, a_caller_who_cancels_is_heard);
    suite_add_tcase(suite, tcase);
    return suite;
}
