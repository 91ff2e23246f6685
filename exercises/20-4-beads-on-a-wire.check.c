#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

void string_beads(int beads, const double mass[], double gap, double end[]);

enum {
    MOST = 300
};

static const double rounding = 1e-9;

typedef struct wire {
    const char *name;
    int beads;
    double gap, mass[MOST], proposed[MOST];
} wire;

/// The least sum of squares.  Without gaps, the best place of a bead is the
/// largest, over all beads up to it, of the least mean of a row of beads that
/// begins there and goes at least to this one.
static double least_change(const wire *w)
{
    double sum = 0, masses[MOST + 1] = {0}, moments[MOST + 1] = {0};
    for (int i = 0; i < w->beads; i++) {
        masses[i + 1] = masses[i] + w->mass[i];
        moments[i + 1] =
            moments[i] + w->mass[i] * (w->proposed[i] - i * w->gap);
    }
    for (int i = 0; i < w->beads; i++) {
        double place = -INFINITY;
        for (int first = 0; first <= i; first++) {
            double least = INFINITY;
            for (int end = i + 1; end <= w->beads; end++)
                least = fmin(least, (moments[end] - moments[first]) /
                                        (masses[end] - masses[first]));
            place = fmax(place, least);
        }
        double change = place + i * w->gap - w->proposed[i];
        sum += w->mass[i] * change * change;
    }
    return sum;
}

static void expect_gaps(const wire *w, const double end[])
{
    for (int i = 0; i < w->beads; i++)
        check_that(isfinite(end[i]), "a place", "%s for bead %d",
                   text_real(end[i]), i);
    for (int i = 0; i + 1 < w->beads; i++)
        check_that(end[i + 1] - end[i] >= w->gap - rounding,
                   "beads at least a gap apart", "beads %d and %d at %s and %s",
                   i, i + 1, text_real(end[i]), text_real(end[i + 1]));
}

/// Leaves the ends in `end`.
static void expect(const wire *w, double end[MOST])
{
    memcpy(end, w->proposed, sizeof w->proposed);
    int shown = w->beads < 3 ? w->beads : 3;
    check_input("%s: %d beads, gap %s, the first with masses %s, proposed to "
                "end at %s",
                w->name, w->beads, text_real(w->gap),
                text_point(shown, w->mass), text_point(shown, w->proposed));
    check_call_n(MOST, end, string_beads(w->beads, w->mass, w->gap, end));
    expect_gaps(w, end);
    double before = 0, after = 0, masses = 0, change = 0;
    for (int i = 0; i < w->beads; i++) {
        before += w->mass[i] * w->proposed[i];
        after += w->mass[i] * end[i];
        masses += w->mass[i];
        change += w->mass[i] * pow(end[i] - w->proposed[i], 2);
    }
    check_that(fabs(after - before) <= rounding * masses,
               "the same sum weighted by mass", "%s, which was %s",
               text_real(after), text_real(before));
    double least = least_change(w);
    check_that(change <= 2 * least + rounding, "at most twice the least change",
               "%s, where %s is possible", text_real(change), text_real(least));
}

static void expect_unpushed(const wire *w, const double end[], int bead)
{
    check_that(end[bead] == w->proposed[bead],
               "a bead that ends where it was proposed to",
               "bead %d at %s, not at %s", bead, text_real(end[bead]),
               text_real(w->proposed[bead]));
}

TEST(nothing_to_do)
{
    const wire w = {"beads in order", 3, 0.5, {1, 2, 3}, {0.1, 0.7, 1.3}};
    double end[MOST];
    expect(&w, end);
    for (int i = 0; i < w.beads; i++)
        expect_unpushed(&w, end, i);
}

TEST(two_beads)
{
    const wire w = {"one bead passes another", 3, 0.5, {1, 3, 1}, {1, 0, 7.1}};
    double end[MOST];
    expect(&w, end);
    expect_unpushed(&w, end, 2);
    check_near(-0.125, end[0], rounding);
}

// Only after the last has been pushed does the second touch the first.
TEST(a_push_that_goes_on)
{
    const wire w = {
        "the last comes back", 4, 1, {1, 1, 1, 1}, {0, 1.5, 2.5, -2}};
    double end[MOST];
    expect(&w, end);
}

TEST(a_heap)
{
    wire w = {.name = "beads that all want to be at 0", .gap = 0.01};
    for (w.beads = 0; w.beads < 100; w.beads++)
        w.mass[w.beads] = 1;
    double end[MOST];
    expect(&w, end);
    check_near(-0.495, end[0], rounding);
}

/// Heaps here and there, and far from them a bead at each end of the wire.
TEST(at_random)
{
    generator random = generator_new(0);
    for (int run = 0; run < 40; run++) {
        wire w = {.name = "beads at random", .gap = 0.02};
        w.beads = 3 + below(&random, run < 36 ? 20 : MOST - 2);
        double spread = uniform(&random, 0, 0.3), end[MOST];
        for (int i = 0; i < w.beads; i++) {
            w.mass[i] = pow(10, uniform(&random, -1, 1));
            w.proposed[i] = 0.05 * i + uniform(&random, -spread, spread);
        }
        w.proposed[0] = -40.1;
        w.proposed[w.beads - 1] = 80.3;
        expect(&w, end);
        expect_unpushed(&w, end, 0);
        expect_unpushed(&w, end, w.beads - 1);
    }
}

void run_tests(void)
{
    check_run(1, nothing_to_do);
    check_run(1, two_beads);
    check_run(1, a_push_that_goes_on);
    check_run(1, a_heap);
    check_run(1, at_random);
}
