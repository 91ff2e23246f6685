#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>

void move_group(int count, const double start[], const double proposed[],
                const double inverse_mass[], double end[]);

enum {
    MOST = 6 ///< vertices of a group
};

typedef struct group {
    int count;
    double start[MOST], proposed[MOST], inverse_mass[MOST];
} group;

/// "(1, 2)", with as many numbers as the group has vertices.
static void list(char text[400], int count, const double x[])
{
    char *at = text;
    for (int i = 0; i < count; i++)
        at += sprintf(at, "%s%.17g", i == 0 ? "(" : ", ", x[i]);
    sprintf(at, ")");
}

static void ask(const group *g, double end[MOST])
{
    char start[400], proposed[400], mass[400];
    list(start, g->count, g->start);
    list(proposed, g->count, g->proposed);
    list(mass, g->count, g->inverse_mass);
    check_input("start = %s\nproposed = %s\ninverse_mass = %s", start, proposed,
                mass);
    for (int i = 0; i < MOST; i++)
        end[i] = NAN;
    check_call_n(
        MOST, end,
        move_group(g->count, g->start, g->proposed, g->inverse_mass, end));
}

/// Expects that each free vertex ends `displacement` after its start, or that
/// close to there, and each scripted one exactly where it was proposed to end.
static void expect(const group *g, double displacement, double tolerance)
{
    double end[MOST];
    ask(g, end);
    for (int i = 0; i < g->count; i++)
        if (g->inverse_mass[i] > 0)
            check_near(g->start[i] + displacement, end[i], tolerance);
        else
            check_near(g->proposed[i], end[i], 0);
}

TEST(all_are_free)
{
    expect(&(group){2, {0, 1}, {1, 1}, {1, 1}}, 0.5, 0);
    expect(&(group){2, {0, 8}, {4, 8}, {1, 3}}, 3, 1e-15);
    expect(&(group){3, {0, 1, 2}, {2, 2, 1}, {0.5, 0.25, 0.25}}, 0.4, 1e-15);
}

TEST(some_are_scripted)
{
    expect(&(group){3, {0, 1, 2}, {5, 1.25, -7}, {1, 0, 1}}, 0.25, 0);
    expect(&(group){4, {0, 1, 2, 9}, {5, 1.25, -7, 9.25}, {1, 0, 1, 0}}, 0.25,
           0);
    expect(&(group){2, {3, 4}, {3.5, 4.5}, {0, 0}}, 0.5, 0);
}

TEST(scripts_disagree)
{
    expect(&(group){3, {0, 1, 2}, {0.5, 1, 2.25}, {0, 1, 0}}, 0.5, 0);
    expect(&(group){3, {0, 1, 2}, {0.5, 1.25, 2.25}, {0, 0, 0}}, 0.5, 0);
    expect(&(group){3, {-1, 1, 2}, {-1, 2, 3}, {0, 0.5, 0}}, 0, 0);
}

TEST(the_displacement_is_no_double)
{
    // 2^-60 - 1 has 60 bits.
    expect(&(group){2, {1, 3}, {0x1p-60, 4}, {0, 1}}, -1, 0);
    expect(&(group){3, {0, 1, 2}, {0x1p60, 0x1p60, 0}, {1, 0, 1}}, 0x1p60, 0);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        group g = {.count = 1 + below(&random, MOST)};
        double mass = 0, momentum = 0;
        for (int v = 0; v < g.count; v++) {
            double m = 1 + below(&random, 9), d = uniform(&random, -1, 1);
            g.start[v] = uniform(&random, -1, 1);
            g.proposed[v] = g.start[v] + d;
            g.inverse_mass[v] = 1 / m;
            mass += m;
            momentum += m * d;
        }
        expect(&g, momentum / mass, 1e-14);
    }
}

void run_tests(void)
{
    check_run(1, all_are_free);
    check_run(1, some_are_scripted);
    check_run(1, scripts_disagree);
    check_run(1, the_displacement_is_no_double);
    check_run(1, at_random);
}
