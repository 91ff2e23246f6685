// What a query evaluates: signs decide, and only what is described has values.
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "intersect/cascade.h"
#include "intersect/separation.h"
#include "query/query.h"
#include "support/counting_arithmetic.h"
#include "support/judge.h"
#include "support/scenes.h"

/// Lattice queries, those made to be hard, and those anywhere.
static query any_query(generator *random, query_kind kind)
{
    switch (below(random, 3)) {
    case 0:
        return query_lattice(random, kind, 3);
    case 1:
        return query_any(random, kind);
    default:
        return query_soup(random, kind);
    }
}

/// Query the elements by counted exact signs.
static evaluations count(const query *q, tf_contact *contact)
{
    tf_arithmetic arithmetic = counting(&tf_exact);
    *contact = ask(&arithmetic, q);
    return counted();
}

static void fail_query(const char *what, evaluations found, const query *q)
{
    ck_abort_msg("%s: %d signs, %d values\nseed %llu, %s\n%s", what,
                 found.signs, found.values, (unsigned long long)seed(),
                 query_name(q), query_text(q));
}

START_TEST(elements_apart_take_no_values)
{
    generator random = generator_new((uint64_t)_i);
    long apart = 0, separated = 0, all = cases(20000);
    for (long i = 0; i < all; i++) {
        query q = any_query(&random, (query_kind)_i);
        tf_contact contact;
        evaluations found = count(&q, &contact);
        if (contact.verdict != TF_APART)
            continue;
        apart++;
        if (found.values != 0)
            fail_query("values of what is apart", found, &q);
        if (!tf_elements_separated(q.axes, q.vertices, q.vertex, q.others,
                                   query_const_others(&q)))
            continue;
        separated++;
        if (found.signs != 0)
            fail_query("signs of what an axis separates", found, &q);
    }
    ck_assert_int_gt(20 * separated, all);
    ck_assert_int_gt(20 * (apart - separated), all);
}
END_TEST

/// What it takes to decide each pair of simplices by itself, how many
/// intersect, and how the last of them does.
typedef struct pair_decisions {
    int signs, hits;
    tf_classification last;
} pair_decisions;

static pair_decisions decide_pairs(const query *q)
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(q->vertices, q->vertex, s);
    tf_sweep(q->others, query_const_others(q), r);
    tf_arithmetic arithmetic = counting(&tf_exact);
    pair_decisions all = {.last = TF_UNCLASSIFIED};
    for (int i = 0; i < q->vertices; i++)
        for (int j = 0; j < q->others; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], q->axes);
            tf_intersection found =
                tf_intersect(&arithmetic, &pair, TF_ONLY_VERDICT);
            if (found.verdict != TF_HIT)
                continue;
            all.hits++;
            all.last = found.classification;
        }
    all.signs = counted().signs;
    return all;
}

START_TEST(a_generic_contact_takes_the_values_of_its_pair_and_normal)
{
    generator random = generator_new((uint64_t)(10 + _i));
    long tried = 0, all = cases(20000);
    for (long i = 0; i < all; i++) {
        query q = any_query(&random, (query_kind)_i);
        pair_decisions pairs = decide_pairs(&q);
        if (pairs.hits != 1 || pairs.last != TF_GENERIC)
            continue;
        tried++;
        tf_contact contact;
        evaluations found = count(&q, &contact);
        int events = q.axes + 3;
        if (found.values != events + q.axes)
            fail_query("values of one generic contact", found, &q);
        if (found.signs != pairs.signs)
            fail_query("signs but those of the pairs", found, &q);
    }
    ck_assert_int_gt(20 * tried, all);
}
END_TEST

START_TEST(a_verdict_alone_takes_no_values)
{
    static const int index[QUERY_VERTICES] = {0, 1, 2, 3};
    generator random = generator_new((uint64_t)(20 + _i));
    long hits = 0, all = cases(20000);
    for (long i = 0; i < all; i++) {
        query q = any_query(&random, (query_kind)_i);
        scene s = scene_of(&q, index);
        tf_motion motion = scene_motion(&s);
        tf_arithmetic arithmetic = counting(&tf_exact);
        tf_verdict verdict;
        ck_assert_int_eq(tf_query_verdict(&arithmetic, q.axes, &motion,
                                          q.vertices, index, q.others,
                                          index + q.vertices, &verdict,
                                          &(bool){false}),
                         TF_OK);
        hits += verdict == TF_HIT;
        if (counted().values != 0)
            fail_query("values of a verdict", counted(), &q);
    }
    ck_assert_int_gt(20 * hits, all);
}
END_TEST

// The two queries of README.md ------------------------------------------------

static evaluations count_rows(query_kind kind, const double row[])
{
    query q = query_new(kind);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = row[i];
    tf_contact contact;
    evaluations found = count(&q, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    return found;
}

START_TEST(the_first_query_takes_few_signs)
{
    static const double row[] = {1, 2, 0, 0, 3, 1, 1, -1, 0, 0, 3, 1};
    evaluations found = count_rows(POINT_EDGE, row);
    ck_assert_int_le(found.signs, 8);
    ck_assert_int_eq(found.values, 5 + 2);
}
END_TEST

START_TEST(the_example_takes_few_signs)
{
    // Two pairs touch in the contact.  The six values of each give its time;
    // only the first is described, by its six values and those of a normal.
    static const double row[] = {0.25, 0.25, 1,  0, 0, 0, 1, 0, 0, 0, 1, 0,
                                 0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    evaluations found = count_rows(POINT_TRIANGLE, row);
    ck_assert_int_le(found.signs, 16);
    ck_assert_int_le(found.values, 3 * TF_SIX + 3);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("evaluations");
    TCase *tcase = tcase_create("evaluations");
    tcase_add_loop_test(tcase, elements_apart_take_no_values, 0, KINDS);
    tcase_add_loop_test(
        tcase, a_generic_contact_takes_the_values_of_its_pair_and_normal, 0,
        KINDS);
    tcase_add_loop_test(tcase, a_verdict_alone_takes_no_values, 0, KINDS);
    tcase_add_test(tcase, the_first_query_takes_few_signs);
    tcase_add_test(tcase, the_example_takes_few_signs);
    suite_add_tcase(suite, tcase);
    return suite;
}
