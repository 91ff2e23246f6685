#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST = 10
};

bool is_least_change(int beads, const double mass[], const double proposal[],
                     const double d[]);

/// The least change: where a bead would overtake the next, all that have become
/// one move by their mean; and none moves past the knot.
static void find_least_change(int beads, const double mass[],
                              const double proposal[], double d[])
{
    double weight[MOST], mean[MOST];
    int size[MOST], groups = 0;
    for (int i = 0; i < beads; i++) {
        weight[groups] = mass[i];
        mean[groups] = proposal[i];
        size[groups++] = 1;
        while (groups > 1 && mean[groups - 2] >= mean[groups - 1]) {
            int a = groups - 2, b = groups - 1;
            mean[a] = (weight[a] * mean[a] + weight[b] * mean[b]) /
                      (weight[a] + weight[b]);
            weight[a] += weight[b];
            size[a] += size[b];
            groups--;
        }
    }
    for (int i = 0, bead = 0; i < groups; i++)
        for (int j = 0; j < size[i]; j++)
            d[bead++] = fmin(mean[i], 0);
}

static const char *numbers(int count, const double x[], char text[32 * MOST])
{
    int length = 0;
    for (int i = 0; i < count; i++)
        length += snprintf(text + length, (size_t)(32 * MOST - length), "%s%s",
                           i ? ", " : "", text_real(x[i]));
    return text;
}

static void expect(int beads, const double mass[], const double proposal[],
                   const double d[])
{
    char text[3][32 * MOST];
    double least[MOST];
    find_least_change(beads, mass, proposal, least);
    bool same = true;
    for (int i = 0; i < beads; i++)
        same &= fabs(least[i] - d[i]) < 1e-12;
    check_input("masses %s, proposal %s, displacements %s",
                numbers(beads, mass, text[0]),
                numbers(beads, proposal, text[1]), numbers(beads, d, text[2]));
    bool got;
    check_value(got, is_least_change(beads, mass, proposal, d));
    check_bool(same, got);
}

TEST(one_bead)
{
    const double mass[] = {2};
    expect(1, mass, (double[]){1}, (double[]){0});
    expect(1, mass, (double[]){1}, (double[]){0.5});
    expect(1, mass, (double[]){1}, (double[]){-1});
    expect(1, mass, (double[]){-1}, (double[]){-1});
    expect(1, mass, (double[]){-1}, (double[]){0});
}

TEST(two_beads)
{
    const double equal[] = {1, 1}, mass[] = {1, 3};
    expect(2, equal, (double[]){1, 0}, (double[]){0, 0});
    expect(2, equal, (double[]){1, 0}, (double[]){0.5, 0.5});
    expect(2, equal, (double[]){-1, -3}, (double[]){-2, -2});
    expect(2, equal, (double[]){-1, -3}, (double[]){-3, -3});
    expect(2, equal, (double[]){-3, -1}, (double[]){-2, -2});
    expect(2, equal, (double[]){-3, -1}, (double[]){-3, -1});
    expect(2, equal, (double[]){-3, 1}, (double[]){-3, 0});
    expect(2, equal, (double[]){-3, 1}, (double[]){0, 0});
    expect(2, mass, (double[]){-1, -3}, (double[]){-2.5, -2.5});
    expect(2, mass, (double[]){-1, -3}, (double[]){-2, -2});
}

TEST(some_at_random)
{
    static const double factor[] = {1, 0.5, 0, 2};
    generator random = generator_new(18);
    for (int times = 0; times < 100; times++) {
        double mass[MOST], proposal[MOST], d[MOST];
        int beads = 1 + below(&random, MOST);
        for (int i = 0; i < beads; i++) {
            mass[i] = 1 << below(&random, 3);
            proposal[i] = below(&random, 17) - 12;
        }
        find_least_change(beads, mass, proposal, d);
        expect(beads, mass, proposal, d);
        for (int i = 0; i < 4; i++) { // others that satisfy all constraints
            double other[MOST];
            memcpy(other, d, sizeof other);
            int until = 1 + below(&random, beads);
            for (int j = 0; j < until; j++)
                other[j] = fmin(other[j] - 1 + factor[i], d[0]);
            expect(beads, mass, proposal, other);
            for (int j = 0; j < beads; j++)
                other[j] = factor[i] * d[j];
            expect(beads, mass, proposal, other);
            for (int j = 1; j < until; j++)
                other[j] = other[0];
            expect(beads, mass, proposal, other);
        }
    }
}

void run_tests(void)
{
    check_run(1, one_bead);
    check_run(1, two_beads);
    check_run(1, some_at_random);
}
