#include "check.h"

#include "intersect/complementary.h"
#include "support/oracle.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

tf_verdict edge_intersects_triangle(const tf_event edge[2],
                                    const tf_event triangle[3]);

static const char *const verdicts[] = {[TF_UNDECIDED] = "TF_UNDECIDED",
                                       [TF_APART] = "TF_APART",
                                       [TF_HIT] = "TF_HIT"};

/// Whether the five points lie in one plane, by Gaussian elimination in
/// rational numbers.
static bool in_one_plane(const tf_event event[5])
{
    mpq_t row[4][3], factor, product;
    mpq_inits(factor, product, NULL);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            mpq_init(row[i][k]);
            mpq_set_d(row[i][k], event[i + 1].x[k] - event[0].x[k]);
        }
    int rank = 0;
    for (int k = 0; k < 3; k++) {
        int pivot = rank;
        while (pivot < 4 && mpq_sgn(row[pivot][k]) == 0)
            pivot++;
        if (pivot == 4)
            continue;
        for (int j = 0; j < 3; j++)
            mpq_swap(row[pivot][j], row[rank][j]);
        for (int i = rank + 1; i < 4; i++) {
            mpq_div(factor, row[i][k], row[rank][k]);
            for (int j = k; j < 3; j++) {
                mpq_mul(product, factor, row[rank][j]);
                mpq_sub(row[i][j], row[i][j], product);
            }
        }
        rank++;
    }
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            mpq_clear(row[i][k]);
    mpq_clears(factor, product, NULL);
    return rank < 3;
}

static void expect(const tf_event event[5])
{
    oracle_simplex edge = {2, {&event[0], &event[1]}};
    oracle_simplex triangle = {3, {&event[2], &event[3], &event[4]}};
    tf_verdict expected =
        oracle_slices_meet(3, &edge, &triangle) ? TF_HIT : TF_APART;
    check_input("edge %s, %s, triangle %s, %s, %s", text_point(3, event[0].x),
                text_point(3, event[1].x), text_point(3, event[2].x),
                text_point(3, event[3].x), text_point(3, event[4].x));
    tf_verdict got;
    check_value(got, edge_intersects_triangle(event, event + 2));
    check_that(got == expected, verdicts[expected], "%s",
               (unsigned)got <= TF_HIT ? verdicts[got] : "no verdict");
}

TEST(a_simple_triangle)
{
    // Through the interior, past it, short of it, at a corner, from its plane.
    static const double ends[][2][3] = {{{1, 1, 1}, {1, 1, -1}},
                                        {{3, 3, 1}, {3, 3, -1}},
                                        {{1, 1, 2}, {1, 1, 1}},
                                        {{4, 0, 1}, {4, 0, -1}},
                                        {{1, 1, 0}, {9, 1, 2}}};
    for (int i = 0; i < (int)(sizeof ends / sizeof *ends); i++) {
        tf_event event[5] = {{.t = 0},
                             {.t = 0},
                             {.x = {0, 0, 0}},
                             {.x = {4, 0, 0}},
                             {.x = {0, 4, 0}}};
        for (int j = 0; j < 2; j++)
            for (int k = 0; k < 3; k++)
                event[j].x[k] = ends[i][j][k];
        expect(event);
    }
}

/// Five points whose coordinates are among n integers around 0, times a size.
static void expect_lattice(generator *random, int n, double size)
{
    tf_event event[5] = {{.t = 0}};
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            event[i].x[k] = (below(random, n) - n / 2) * size;
    if (!in_one_plane(event))
        expect(event);
}

TEST(small_integers)
{
    generator random = generator_new(0);
    for (int i = 0; i < 600; i++)
        expect_lattice(&random, 3 + i % 4, 1);
}

TEST(large_integers)
{
    generator random = generator_new(1);
    for (int i = 0; i < 300; i++)
        expect_lattice(&random, 3, 0x1p19 - 1);
}

void run_tests(void)
{
    check_run(1, a_simple_triangle);
    check_run(1, small_integers);
    check_run(1, large_integers);
}
