#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>

enum {
    MOST = 8,
    SWEEPS = 500
};

void sweep(int walls, const double normal[][2], const double bound[],
           double mass, double d[2], double impulse[]);

/// A bead, its proposal, and walls.
typedef struct corner {
    int walls;
    double normal[MOST][2], bound[MOST], mass, proposal[2];
} corner;

static void tell(const corner *c, int sweeps)
{
    char text[128 * MOST];
    int length = 0;
    for (int i = 0; i < c->walls; i++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%s with the bound %s", i ? ", " : "",
                           text_point(2, c->normal[i]), text_real(c->bound[i]));
    check_input("a mass of %s, the proposal %s, the normals %s, %d sweeps",
                text_real(c->mass), text_point(2, c->proposal), text, sweeps);
}

static void expect(const corner *c, int sweeps, double x, double y)
{
    double d[2] = {c->proposal[0], c->proposal[1]}, impulse[MOST] = {0};
    tell(c, sweeps);
    for (int i = 0; i < sweeps; i++)
        sweep(c->walls, c->normal, c->bound, c->mass, d, impulse);
    check_point(2, ((double[]){x, y}), d, 1e-12);
}

START_TEST(one_wall)
{
    corner c = {.walls = 1, .normal = {{0, 1}}, .mass = 1, .proposal = {2, -1}};
    expect(&c, 1, 2, 0);
    c.bound[0] = 0.5;
    expect(&c, 1, 2, 0.5);
    c.mass = 4;
    expect(&c, 1, 2, 0.5);
    c.proposal[1] = 3;
    expect(&c, 1, 2, 3);
}
END_TEST

START_TEST(two_walls)
{
    corner c = {.walls = 2,
                .normal = {{0, 1}, {1, 0}},
                .mass = 0.5,
                .proposal = {-1, -2}};
    expect(&c, 1, 0, 0);
    c.proposal[0] = 1;
    expect(&c, 1, 1, 0);
}
END_TEST

START_TEST(a_push_is_taken_back)
{
    // The flat wall pushes by 1, and then the steep one makes that needless.
    corner c = {.walls = 2,
                .normal = {{0, 1}, {0.8, 0.6}},
                .mass = 1,
                .proposal = {-5, -1}};
    expect(&c, 1, -1.8, 2.4);
    expect(&c, 2, -1.32, 1.76);
    expect(&c, 3, -1.32, 1.76);
}
END_TEST

static double energy(const corner *c, const double d[2])
{
    return c->mass * (d[0] * d[0] + d[1] * d[1]) / 2;
}

/// Without bounds no sweep raises the energy; in the end the rows hold, and only
/// those that are exactly satisfied have an impulse.
static void expect_solution(const corner *c)
{
    double d[2] = {c->proposal[0], c->proposal[1]}, impulse[MOST] = {0};
    double before = energy(c, d), by_impulses[2] = {d[0], d[1]};
    tell(c, SWEEPS);
    for (int i = 0; i < SWEEPS; i++) {
        sweep(c->walls, c->normal, c->bound, c->mass, d, impulse);
        double after = energy(c, d);
        if (!(after <= before * (1 + 1e-12) + 1e-24))
            check_that(false, "energy that does not rise",
                       "%s after %s, in sweep %d", text_real(after),
                       text_real(before), i);
        before = after;
    }
    for (int i = 0; i < c->walls; i++) {
        const double *n = c->normal[i];
        double parting = n[0] * d[0] + n[1] * d[1];
        check_that(impulse[i] >= 0, "no pull", "an impulse of %s in row %d",
                   text_real(impulse[i]), i);
        check_that(parting > -1e-6, "rows that hold",
                   "a parting of %s in row %d", text_real(parting), i);
        check_that(!(impulse[i] > 1e-6) || parting < 1e-6,
                   "no impulse where the bead leaves",
                   "an impulse of %s and a parting of %s in row %d",
                   text_real(impulse[i]), text_real(parting), i);
        for (int k = 0; k < 2; k++)
            by_impulses[k] += impulse[i] * n[k] / c->mass;
    }
    check_that(hypot(by_impulses[0] - d[0], by_impulses[1] - d[1]) < 1e-6,
               "the displacement that the impulses make", "%s, not %s",
               text_point(2, d), text_point(2, by_impulses));
}

START_TEST(the_least_change_in_the_end)
{
    static const double direction[][2] = {{1, 0},      {0.8, 0.6},  {0.6, 0.8},
                                          {0, 1},      {0.8, -0.6}, {0.6, -0.8},
                                          {-0.6, 0.8}, {0.28, 0.96}};
    generator random = generator_new(18);
    for (int times = 0; times < 100; times++) {
        corner c = {
            .walls = 1 + below(&random, MOST),
            .mass = 1 + below(&random, 3),
            .proposal = {below(&random, 13) - 6, below(&random, 13) - 6}};
        for (int i = 0; i < c.walls; i++) {
            const double *n = direction[below(&random, 8)];
            for (int k = 0; k < 2; k++)
                c.normal[i][k] = n[k];
        }
        expect_solution(&c);
    }
}
END_TEST

void add_tests(TCase *tests)
{
    tcase_add_test(tests, one_wall);
    tcase_add_test(tests, two_walls);
    tcase_add_test(tests, a_push_is_taken_back);
    tcase_add_test(tests, the_least_change_in_the_end);
}
