// Queries whose coordinates are integers, small ones above all: every
// degeneracy there is comes up, over and over.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/integer.h"
#include "support/judge.h"

#include <math.h>

static const tf_arithmetic *const exact_ones[] = {&tf_exact, &tf_integer64,
                                                  &tf_integer128};
enum {
    EXACT_ONES = sizeof exact_ones / sizeof *exact_ones
};

/// Compare all that knows the answer with the oracle and with each other.
static void judge(const query *q, truth *known)
{
    tf_contact contact[EXACT_ONES], clamped;
    truth_find(q, known);
    for (int i = 0; i < EXACT_ONES; i++) {
        expect_no_fault(exact_fault(q, exact_ones[i], known, &contact[i]), q);
        if (!known->hit)
            continue;
        expect_no_fault(geometry_fault(q, &contact[i]), q);
        if (contact[i].classification != contact[0].classification)
            expect_no_fault("the exact arithmetics decide differently", q);
    }
    expect_no_fault(sound_fault(q, &tf_clamped, known, &clamped), q);
}

/// Count the query up, its first coordinate first; false after the last.
static bool next_query(query *q, int values)
{
    for (int i = 0; i < query_size(q); i++) {
        double *x = query_coordinate(q, i);
        if (++*x < values)
            return true;
        *x = 0;
    }
    return false;
}

/// All of them only at 100 percent.
START_TEST(every_point_edge_query_of_three_values_is_answered_right)
{
    truth known;
    truth_init(&known);
    query q = query_new(POINT_EDGE);
    const long all = 531441, stride = all / cases(all);
    long count = 0;
    do {
        if (count++ % stride == 0)
            judge(&q, &known);
    } while (next_query(&q, 3));
    ck_assert_int_eq(count, all);
    truth_clear(&known);
}
END_TEST

static void judge_many(long count, int values)
{
    generator random = generator_new((uint64_t)values);
    truth known;
    truth_init(&known);
    for (int kind = 0; kind < KINDS; kind++)
        for (long i = 0; i < count; i++) {
            query q = query_lattice(&random, (query_kind)kind, values);
            judge(&q, &known);
        }
    truth_clear(&known);
}

START_TEST(random_queries_of_three_values_are_answered_right)
{
    judge_many(cases(100000), 3);
}
END_TEST

START_TEST(random_queries_of_five_values_are_answered_right)
{
    judge_many(cases(20000), 5);
}
END_TEST

/// Coordinates at and next to the ends of what an integer arithmetic holds, and
/// zero.
static query largest_integers(generator *random, query_kind kind, int bits)
{
    query q = query_lattice(random, kind, 3);
    for (int i = 0; i < query_size(&q); i++) {
        double *x = query_coordinate(&q, i);
        *x = (*x - 1) * (ldexp(1, bits) - 1 - below(random, 2));
    }
    return q;
}

START_TEST(the_largest_integers_that_fit_are_answered_right)
{
    generator random = generator_new(64);
    truth known;
    truth_init(&known);
    for (int kind = 0; kind < KINDS; kind++)
        for (long i = 0; i < 2 * cases(10000); i++) {
            const tf_arithmetic *wide = exact_ones[1 + i % 2];
            int axes = query_new((query_kind)kind).axes;
            query q =
                largest_integers(&random, (query_kind)kind, wide->bits[axes]);
            truth_find(&q, &known);
            tf_contact contact;
            expect_no_fault(exact_fault(&q, wide, &known, &contact), &q);
            expect_truth(&q, &known);
        }
    truth_clear(&known);
}
END_TEST

Suite *suite(void)
{
    Suite *lattice = suite_create("lattice");
    TCase *queries = tcase_create("queries");
    tcase_add_test(queries,
                   every_point_edge_query_of_three_values_is_answered_right);
    tcase_add_test(queries, random_queries_of_three_values_are_answered_right);
    tcase_add_test(queries, random_queries_of_five_values_are_answered_right);
    tcase_add_test(queries, the_largest_integers_that_fit_are_answered_right);
    suite_add_tcase(lattice, queries);
    return lattice;
}
