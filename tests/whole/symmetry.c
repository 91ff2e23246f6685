// What may not change an answer: another naming of the axes, of space's left
// and right, of the elements, of past and future, and another unit of length.
#include "support/judge.h"
#include "support/query_changes.h"

// Each change keeps the first contact's time, so that the truth of the query
// before the change judges the answer after it.

static void turn_axes(generator *random, query *q)
{
    int first = below(random, q->axes);
    query_turn_axes(q, first, below(random, 2));
}

static void mirror(generator *random, query *q)
{
    query_mirror(q, below(random, q->axes));
}

static void swap_elements(generator *random, query *q)
{
    (void)random;
    query_swap_elements(q);
}

static void change_unit(generator *random, query *q)
{
    int exponent = below(random, 201); // up, where no bit is lost
    ck_assert(query_change_unit(q, exponent));
}

typedef void change(generator *random, query *q);

static query hard_query(generator *random, query_kind kind)
{
    query q = below(random, 2) ? query_lattice(random, kind, 3)
                               : query_any(random, kind);
    if (below(random, 2))
        query_nudge(random, &q, 1);
    return q;
}

static void judge_change(change *make, uint64_t stream)
{
    generator random = generator_new(stream);
    truth known;
    truth_init(&known);
    for (int kind = 0; kind < KINDS; kind++)
        for (long i = cases(10000); i > 0; i--) {
            query q = hard_query(&random, (query_kind)kind);
            truth_find(&q, &known);
            make(&random, &q);
            expect_truth(&q, &known);
        }
    truth_clear(&known);
}

START_TEST(renaming_axes_renames_the_contact)
{
    judge_change(turn_axes, 1);
}
END_TEST

START_TEST(mirroring_an_axis_mirrors_the_contact)
{
    judge_change(mirror, 2);
}
END_TEST

START_TEST(swapping_elements_swaps_the_contact)
{
    judge_change(swap_elements, 3);
}
END_TEST

START_TEST(another_unit_scales_the_contact)
{
    judge_change(change_unit, 4);
}
END_TEST

// Past and future -------------------------------------------------------------

/// Whether the exact earliest times of a step and of its reverse leave room
/// for the contacts in between: the last of one is the first of the other.
static bool in_order(const truth *forth, const truth *back)
{
    mpq_t last;
    mpq_init(last);
    mpq_set_ui(last, 1, 1);
    mpq_sub(last, last, back->toi);
    bool order = mpq_cmp(forth->toi, last) <= 0;
    mpq_clear(last);
    return order;
}

START_TEST(reversed_time_keeps_the_verdict)
{
    generator random = generator_new(5);
    truth forth, back;
    truth_init(&forth);
    truth_init(&back);
    for (int kind = 0; kind < KINDS; kind++)
        for (long i = cases(10000); i > 0; i--) {
            query q = hard_query(&random, (query_kind)kind);
            query reversed = query_reversed(&q);
            truth_find(&q, &forth);
            truth_find(&reversed, &back);
            if (forth.hit != back.hit ||
                (forth.hit && !in_order(&forth, &back)))
                expect_no_fault("the oracle depends on time's sense", &q);
            expect_truth(&q, &forth);
            expect_truth(&reversed, &back);
        }
    truth_clear(&forth);
    truth_clear(&back);
}
END_TEST

Suite *suite(void)
{
    Suite *symmetry = suite_create("symmetry");
    TCase *changes = tcase_create("changes");
    tcase_add_test(changes, renaming_axes_renames_the_contact);
    tcase_add_test(changes, mirroring_an_axis_mirrors_the_contact);
    tcase_add_test(changes, swapping_elements_swaps_the_contact);
    tcase_add_test(changes, another_unit_scales_the_contact);
    tcase_add_test(changes, reversed_time_keeps_the_verdict);
    suite_add_tcase(symmetry, changes);
    return symmetry;
}
