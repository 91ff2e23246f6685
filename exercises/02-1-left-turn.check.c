#include "arithmetic/functions.h"
#include "check.h"

#include "support/rational.h"
#include "support/support.h"

tf_sign left_turn(const tf_event *a, const tf_event *b, const tf_event *c);

static void expect(const tf_event *a, const tf_event *b, const tf_event *c,
                   tf_sign expected)
{
    check_input("a = %s, b = %s, c = %s", text_point(2, a->x),
                text_point(2, b->x), text_point(2, c->x));
    tf_sign got;
    check_value(got, left_turn(a, b, c));
    check_that(got == expected, text_sign(expected), "%s", text_sign(got));
}

TEST(turns_on_a_lattice)
{
    tf_event a = {.x = {0, 0}}, b = {.x = {1, 0}};
    expect(&a, &b, &(tf_event){.x = {2, 1}}, TF_POSITIVE);
    expect(&a, &b, &(tf_event){.x = {2, -1}}, TF_NEGATIVE);
    expect(&a, &b, &(tf_event){.x = {3, 0}}, TF_ZERO);
}

TEST(turns_anywhere)
{
    generator random = generator_new(0);
    for (long i = 0; i < 500; i++) {
        tf_event e[3];
        for (int j = 0; j < 6; j++)
            e[j / 2].x[j % 2] = (below(&random, 17) - 8) / 8.0;
        tf_differences rows = {.n = 2,
                               .to = {&e[1], &e[2]},
                               .from = {&e[0], &e[0]},
                               .axis = {0, 1}};
        expect(&e[0], &e[1], &e[2], oracle_arithmetic.sign(&rows));
    }
}

void run_tests(void)
{
    check_run(1, turns_on_a_lattice);
    check_run(1, turns_anywhere);
}
