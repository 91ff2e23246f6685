#include "check.h"

#include "support/rational.h"
#include "support/support.h"

tf_sign moved_turn(const tf_arithmetic *arithmetic, const tf_event p[3]);

/// Every order of three indices.
static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                 {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

/// The coordinate plus its symbol, 2^(-16 w) with w = 1, 2, 4, ..., 32: each is
/// far smaller than the product of all before.
static void move(const tf_event *p, int rank, int axis, mpq_t moved)
{
    mpq_t x;
    mpq_init(x);
    mpq_set_d(x, p->x[axis]);
    mpq_set_ui(moved, 1, 1);
    mpq_div_2exp(moved, moved, (mp_bitcnt_t)16 << (2 * rank + axis));
    mpq_add(moved, moved, x);
    mpq_clear(x);
}

/// The sign of the moved points' determinant, multiplied out.
static tf_sign turn_when_moved(const tf_event p[3], const int rank[3])
{
    mpq_t x[3][2], product[2];
    mpq_inits(product[0], product[1], NULL);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) {
            mpq_init(x[i][k]);
            move(&p[i], rank[i], k, x[i][k]);
            if (i > 0)
                mpq_sub(x[i][k], x[i][k], x[0][k]);
        }
    mpq_mul(product[0], x[1][0], x[2][1]);
    mpq_mul(product[1], x[1][1], x[2][0]);
    int order = mpq_cmp(product[0], product[1]);
    for (int i = 0; i < 3; i++)
        mpq_clears(x[i][0], x[i][1], NULL);
    mpq_clears(product[0], product[1], NULL);
    return order > 0 ? TF_POSITIVE : order < 0 ? TF_NEGATIVE : TF_ZERO;
}

/// Points with the indices 10, 20 and 30, in the order of the ranks.
static void expect(tf_event p[3], const int rank[3])
{
    for (int i = 0; i < 3; i++)
        p[i].vertex = 10 * rank[i] + 10;
    check_input("vertex %d at %s, vertex %d at %s, vertex %d at %s",
                p[0].vertex, text_point(2, p[0].x), p[1].vertex,
                text_point(2, p[1].x), p[2].vertex, text_point(2, p[2].x));
    tf_sign got;
    check_value(got, moved_turn(&oracle_arithmetic, p));
    tf_sign expected = turn_when_moved(p, rank);
    check_that(got == expected, text_sign(expected), "%s", text_sign(got));
}

TEST(points_in_a_row)
{
    for (int i = 0; i < 6; i++) {
        tf_event p[3] = {{.x = {0, 0}}, {.x = {1, 0}}, {.x = {2, 0}}};
        expect(p, orders[i]);
    }
}

TEST(all_points_of_a_lattice)
{
    for (int i = 0; i < 729; i++)
        for (int j = 0; j < 6; j++) {
            tf_event p[3] = {{.t = 0}};
            for (int k = 0, digits = i; k < 6; k++, digits /= 3)
                p[k / 2].x[k % 2] = digits % 3;
            expect(p, orders[j]);
        }
}

TEST(points_anywhere_on_a_line)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        tf_event p[3];
        double step[2] = {below(&random, 7) - 3, below(&random, 7) - 3};
        for (int j = 0; j < 3; j++) {
            int along = below(&random, 9) - 4;
            p[j] = (tf_event){.x = {along * step[0], along * step[1]}};
        }
        expect(p, orders[below(&random, 6)]);
    }
}

void run_tests(void)
{
    check_run(1, points_in_a_row);
    check_run(1, all_points_of_a_lattice);
    check_run(1, points_anywhere_on_a_line);
}
