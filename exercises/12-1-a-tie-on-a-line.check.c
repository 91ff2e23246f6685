#include "check.h"

#include "arithmetic/sign.h"
#include "geometry/event.h"
#include "support/generator.h"

#include <gmp.h>
#include <math.h>

tf_sign farther_right(const tf_event *a, const tf_event *b);

enum {
    INDICES = 8
};

/// The coordinate plus 2^(-1100 (vertex + 1)): less than the spacing of
/// doubles, and each far less than the one before.
static void move(const tf_event *event, mpq_t moved)
{
    mpq_t x;
    mpq_init(x);
    mpq_set_d(x, event->x[0]);
    mpq_set_ui(moved, 1, 1);
    mpq_div_2exp(moved, moved, 1100 * ((mp_bitcnt_t)event->vertex + 1));
    mpq_add(moved, moved, x);
    mpq_clear(x);
}

static void expect(const tf_event *a, const tf_event *b)
{
    mpq_t moved_a, moved_b;
    mpq_inits(moved_a, moved_b, NULL);
    move(a, moved_a);
    move(b, moved_b);
    tf_sign expected =
        mpq_cmp(moved_b, moved_a) > 0 ? TF_POSITIVE : TF_NEGATIVE;
    mpq_clears(moved_a, moved_b, NULL);
    check_input("a: vertex %d at %s, b: vertex %d at %s", a->vertex,
                text_real(a->x[0]), b->vertex, text_real(b->x[0]));
    tf_sign got;
    check_value(got, farther_right(a, b));
    check_that(got == expected, text_sign(expected), "%s", text_sign(got));
}

TEST(few_places_and_indices)
{
    for (int i = 0; i < 3 * 3 * INDICES * INDICES; i++) {
        tf_event a = {.x = {i % 3}, .vertex = i / 9 % INDICES};
        tf_event b = {.x = {i / 3 % 3}, .vertex = i / 9 / INDICES};
        if (a.vertex != b.vertex)
            expect(&a, &b);
    }
}

TEST(places_close_to_each_other)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        tf_event a = {.x = {uniform(&random, -8, 8)},
                      .vertex = below(&random, INDICES)};
        tf_event b = {.x = {nextafter(a.x[0], 100 * (i % 3 - 1))},
                      .vertex = (a.vertex + 1 + below(&random, INDICES - 1)) %
                                INDICES};
        expect(&a, &b);
    }
}

void run_tests(void)
{
    check_run(1, few_places_and_indices);
    check_run(1, places_close_to_each_other);
}
