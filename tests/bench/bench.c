// How long queries and signs take, and how far exact signs have to go.  The
// workloads are the same in every run, and all arithmetics are timed in one
// run, in turns and by processor time, so that ratios mean something on a
// shared machine.
//
// Prints four tables:
// - a line a workload and arithmetic: queries, hits, nanoseconds a query (the
//   best of several rounds) and the ratio to `clamped`.  The integers take part
//   where all coordinates are integers: on the lattice, and on the rounded
//   version of every other workload, on which all arithmetics are timed too;
// - a line a workload: the percentage of queries that need no sign, that
//   estimates decide, that integers on a grid decide, and that need the
//   accumulator, with exact signs; and of the signs that estimates leave open,
//   the percentage of those with a rounded difference, and of those that the
//   rounded differences would decide;
// - a line a workload: how many signs a query takes, clamped and exact, if they
//   are found one by one, and for how many pairs the exact arithmetic estimates
//   six signs at once;
// - a line a way to a sign, or to six estimates: nanoseconds.  The grid and the
//   expansion find the signs of the same differences as the accumulator between
//   them.  The library does without the expansion.
// With --csv the same as lines "name,value,unit", for
// figures/measured/library.csv.
#include "arithmetic/accumulated.h"
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/filter.h"
#include "arithmetic/fixed.h"
#include "arithmetic/functions.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "arithmetic/six.h"
#include "arithmetic/two_sum.h"
#include "bench/measuring.h"
#include "bench/workloads.h"
#include "kit/expansion.h"
#include "query/query.h"
#include "support/generator.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROUNDS = 5
};

// Queries ---------------------------------------------------------------------

static bool answer(const workload *w, long i, const tf_arithmetic *arithmetic)
{
    const tf_worldline *v = w->queries[i].vertex;
    tf_contact contact;
    tf_status status =
        tf_query(arithmetic, TF_AXES, w->vertices, v,
                 QUERY_VERTICES - w->vertices, v + w->vertices, &contact);
    if (status != TF_OK) {
        fprintf(stderr, "bench: %s: %s\n", w->name, tf_status_message(status));
        exit(2);
    }
    return contact.verdict != TF_APART;
}

/// How often to repeat a workload so that the clock can tell its time.
static int repetitions(const workload *w)
{
    return (int)(10000 / w->count) + 1;
}

static double time_queries(const workload *w, const tf_arithmetic *arithmetic,
                           long *hits)
{
    double start = processor_seconds();
    for (int repeat = repetitions(w); repeat > 0; repeat--) {
        *hits = 0;
        for (long i = 0; i < w->count; i++)
            *hits += answer(w, i, arithmetic);
    }
    return 1e9 * (processor_seconds() - start) /
           ((double)w->count * repetitions(w));
}

// The last two need integers.
static const tf_arithmetic *const contenders[] = {
    &tf_clamped,   &tf_published, &tf_exact,
    &tf_perturbed, &tf_integer64, &tf_integer128};

enum {
    CONTENDERS = sizeof contenders / sizeof *contenders,
    OF_DOUBLES = CONTENDERS - 2
};

/// How many of the contenders take a workload's coordinates.
static int contenders_for(const workload *w)
{
    bool integers = w->rounded || strcmp(w->name, "lattice") == 0;
    return integers ? CONTENDERS : OF_DOUBLES;
}

static const char *rounded(const workload *w)
{
    return w->rounded ? "rounded " : "";
}

static void print_time(const workload *w, int c, long hits, double time,
                       double ratio, bool csv)
{
    const char *name = contenders[c]->name, *kind = workload_kind(w);
    if (csv)
        printf("%s %s%s %s,%.1f,ns a query\n%s %s%s %s hits,%ld,\n", name,
               rounded(w), w->name, kind, time, name, rounded(w), w->name, kind,
               hits);
    else
        printf("%-8s%-8s %-15s %-10s %7ld %7ld %9.1f %6.2f\n", rounded(w),
               w->name, kind, name, w->count, hits, time, ratio);
}

static void print_times(const workload *w, bool csv)
{
    double best[CONTENDERS];
    long hits[CONTENDERS];
    int count = contenders_for(w);
    for (int c = 0; c < count; c++)
        best[c] = INFINITY;
    for (int round = 0; round < ROUNDS; round++)
        for (int c = 0; c < count; c++) {
            double time = time_queries(w, contenders[c], &hits[c]);
            best[c] = fmin(best[c], time);
        }
    if (csv)
        printf("%s%s %s queries,%ld,\n", rounded(w), w->name, workload_kind(w),
               w->count);
    for (int c = 0; c < count; c++)
        print_time(w, c, hits[c], best[c], best[c] / best[0], csv);
}

// Stages ----------------------------------------------------------------------

enum {
    BY_ESTIMATE,
    BY_GRID,
    BY_ACCUMULATOR,
    STAGES
};

/// What is noted of a workload's signs.
static struct {
    int farthest; ///< stage of the query at hand; -1: it needed no sign
    long open;    ///< signs that the estimate leaves open
    long tails;   ///< those of them with a rounded difference
    long heads;   ///< and of these, that the rounded differences decide
} noted;

static bool has_tail(const tf_differences *d)
{
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < d->n; j++) {
            int k = d->axis[j];
            if (tf_two_difference(d->to[i]->x[k], d->from[i]->x[k]).lo != 0)
                return true;
        }
    return false;
}

/// Whether the exact determinant of the rounded differences exceeds what their
/// roundings can do: one of each factor, of 7 in 3x3 and 3 in 2x2 that the
/// estimate's bound is made of.
static bool heads_decide(const tf_differences *d)
{
    double entry[TF_AXES][TF_AXES];
    tf_differences_round(d, entry);
    expansion heads;
    expansion_determinant(d->n, entry, &heads);
    double last = heads.count > 0 ? heads.term[heads.count - 1] : 0;
    double share = d->n == 3 ? 3 / 7.0 : 2 / 3.0;
    return fabs(last) > share * tf_differences_estimate(d).bound;
}

/// What finds an exact sign: the estimate, or, where that leaves it open,
/// integers on a grid, or else the superaccumulator.
static int stage_of(const tf_differences *differences)
{
    tf_sign sign;
    if (tf_clamped.sign(differences) != TF_UNKNOWN)
        return BY_ESTIMATE;
    return tf_fixed_sign(differences, &sign) ? BY_GRID : BY_ACCUMULATOR;
}

static tf_sign note_sign(const tf_differences *differences)
{
    int stage = stage_of(differences);
    noted.farthest = stage > noted.farthest ? stage : noted.farthest;
    if (stage != BY_ESTIMATE) {
        bool tail = has_tail(differences);
        noted.open++;
        noted.tails += tail;
        noted.heads += tail && heads_decide(differences);
    }
    return tf_exact.sign(differences);
}

static double percent(long part, long whole)
{
    return whole == 0 ? 0 : 100 * (double)part / (double)whole;
}

/// What is printed of a workload's signs, and how a table heads it.
static const struct share {
    const char *name, *heading;
} shares[] = {
    {"none", "none %"},   {"estimate", "estimate %"},
    {"grid", "grid %"},   {"accumulator", "accum. %"},
    {"tails", "tails %"}, {"heads", "by heads %"},
};

enum {
    SHARES = sizeof shares / sizeof *shares
};

static void find_shares(const workload *w, double found[SHARES])
{
    const tf_arithmetic noting = {
        .name = "noting", .sign = note_sign, .value = tf_exact.value};
    long queries[STAGES + 1] = {0};
    noted.open = noted.tails = noted.heads = 0;
    for (long i = 0; i < w->count; i++) {
        noted.farthest = -1;
        answer(w, i, &noting);
        queries[noted.farthest + 1]++;
    }
    for (int i = 0; i <= STAGES; i++)
        found[i] = percent(queries[i], w->count);
    found[STAGES + 1] = percent(noted.tails, noted.open);
    found[STAGES + 2] = percent(noted.heads, noted.open);
}

static void print_shares(const workload *w, bool csv)
{
    const char *kind = workload_kind(w);
    double found[SHARES];
    find_shares(w, found);
    if (!csv)
        printf("%-8s%-8s %-15s", rounded(w), w->name, kind);
    for (int i = 0; i < SHARES; i++)
        if (csv)
            printf("%s%s %s %s,%.3f,%%\n", rounded(w), w->name, kind,
                   shares[i].name, found[i]);
        else
            printf(" %11.3f%s", found[i], i + 1 < SHARES ? "" : "\n");
}

// Signs a query ---------------------------------------------------------------

static long counted; ///< signs

static tf_sign count_clamped(const tf_differences *differences)
{
    counted++;
    return tf_clamped.sign(differences);
}

static tf_sign count_exact(const tf_differences *differences)
{
    counted++;
    return tf_exact.sign(differences);
}

static void count_pairs(int start_count, const tf_event *const event[TF_SIX],
                        tf_sign sign[TF_SIX])
{
    counted++;
    tf_exact.six_estimates(start_count, event, sign);
}

/// The mean number of pairs of a query whose six signs are estimated.
static double pairs_of(const workload *w)
{
    tf_arithmetic counting = tf_exact;
    counting.six_estimates = count_pairs;
    counted = 0;
    for (long i = 0; i < w->count; i++)
        answer(w, i, &counting);
    return (double)counted / (double)w->count;
}

/// The mean number of signs that a query of the workload takes.
static double signs_of(const workload *w,
                       tf_sign (*sign)(const tf_differences *),
                       const tf_arithmetic *arithmetic)
{
    const tf_arithmetic counting = {
        .name = "counting", .sign = sign, .value = arithmetic->value};
    counted = 0;
    for (long i = 0; i < w->count; i++)
        answer(w, i, &counting);
    return (double)counted / (double)w->count;
}

static void print_counts(const workload *w, bool csv)
{
    double clamped = signs_of(w, count_clamped, &tf_clamped);
    double exact = signs_of(w, count_exact, &tf_exact);
    double pairs = pairs_of(w);
    const char *kind = workload_kind(w);
    if (csv)
        printf("clamped %s%s %s signs,%.2f,a query\n"
               "exact %s%s %s signs,%.2f,a query\n"
               "exact %s%s %s pairs,%.2f,a query\n",
               rounded(w), w->name, kind, clamped, rounded(w), w->name, kind,
               exact, rounded(w), w->name, kind, pairs);
    else
        printf("%-8s%-8s %-15s %8.2f %8.2f %8.2f\n", rounded(w), w->name, kind,
               clamped, exact, pairs);
}

// Signs -----------------------------------------------------------------------

enum {
    SIGNS = 2000
};

/// A determinant and its events.
typedef struct matrix {
    int n;
    tf_event to[TF_AXES], from[TF_AXES];
} matrix;

static tf_differences differences_of(const matrix *m)
{
    tf_differences d = {.n = m->n};
    for (int i = 0; i < m->n; i++) {
        d.to[i] = &m->to[i];
        d.from[i] = &m->from[i];
        d.axis[i] = i;
    }
    return d;
}

static double coarse(generator *random)
{
    return below(random, 1 << 20);
}

static double fine(generator *random)
{
    return uniform(random, 1, 2);
}

static double uneven(generator *random)
{
    return ldexp(uniform(random, 1, 2), 5 * below(random, 20));
}

static double of_any_size(generator *random)
{
    return ldexp(uniform(random, 1, 2), below(random, 2000) - 1000);
}

/// Random coordinates; the last row is the first, so that only an exact stage
/// decides, unless `regular`.
static void fill(generator *random, double (*coordinate)(generator *random),
                 bool regular, matrix *m)
{
    int last = m->n - 1;
    for (int i = 0; i < m->n; i++)
        for (int k = 0; k < m->n; k++) {
            m->to[i].x[k] = coordinate(random);
            m->from[i].x[k] = coordinate(random);
        }
    if (regular)
        return;
    m->to[last] = m->to[0];
    m->from[last] = m->from[0];
}

typedef tf_sign sign_finder(const tf_differences *differences);

static tf_sign by_library(const tf_differences *differences)
{
    return tf_exact.sign(differences);
}

/// Ends the program if the estimate decides a sign that a later stage is timed
/// with.
static void expect_open(const tf_differences *differences)
{
    tf_estimate estimate = tf_differences_estimate(differences);
    if (fabs(estimate.number) > estimate.bound) {
        fprintf(stderr, "bench: a sign that the estimate decides\n");
        exit(2);
    }
}

/// As the stage after the estimate.
static tf_sign by_accumulator(const tf_differences *differences)
{
    expect_open(differences);
    return tf_accumulated_sign(differences);
}

static tf_sign by_grid(const tf_differences *differences)
{
    expect_open(differences);
    tf_sign sign = TF_UNKNOWN;
    tf_fixed_sign(differences, &sign);
    return sign;
}

/// Whether the rounded differences are the true ones and in the range of an
/// expansion.
static bool expansion_suffices(const tf_differences *differences,
                               double entry[TF_AXES][TF_AXES])
{
    for (int i = 0; i < differences->n; i++)
        for (int j = 0; j < differences->n; j++) {
            double size = fabs(entry[i][j]);
            if (size > 0x1p300 || (size < 0x1p-300 && size != 0))
                return false;
        }
    return !has_tail(differences);
}

/// As a stage of the library: after the estimate, and if it may be used.
static tf_sign by_expansion(const tf_differences *differences)
{
    expect_open(differences);
    double entry[TF_AXES][TF_AXES];
    tf_differences_round(differences, entry);
    if (!expansion_suffices(differences, entry)) {
        fprintf(stderr, "bench: a sign that needs more than an expansion\n");
        exit(2);
    }
    expansion determinant;
    expansion_determinant(differences->n, entry, &determinant);
    return expansion_sign(&determinant);
}

/// A way to signs, of n x n determinants of random coordinates.
typedef struct race {
    const char *name;
    int n;
    double (*coordinate)(generator *random);
    sign_finder *find;
    bool open; ///< the estimate leaves the signs open, and they are zero
} race;

// Differences of fine and of coarse coordinates are doubles.
static const race races[] = {
    {"estimate", 3, fine, by_library, false},
    {"grid", 3, fine, by_grid, true},
    {"accumulator", 3, fine, by_accumulator, true},
    {"accumulator with tails", 3, uneven, by_accumulator, true},
    {"accumulator of any size", 3, of_any_size, by_accumulator, true},
    {"expansion", 3, fine, by_expansion, true},
    {"grid of integers", 3, coarse, by_grid, true},
    {"accumulator of integers", 3, coarse, by_accumulator, true},
    {"expansion of integers", 3, coarse, by_expansion, true},
    {"grid in the plane", 2, fine, by_grid, true},
    {"accumulator in the plane", 2, fine, by_accumulator, true},
    {"expansion in the plane", 2, fine, by_expansion, true},
};

enum {
    RACES = sizeof races / sizeof *races
};

static double time_signs(const matrix m[SIGNS], const race *r)
{
    double start = processor_seconds();
    int sum = 0;
    for (int i = 0; i < SIGNS; i++) {
        tf_differences d = differences_of(&m[i]);
        sum += r->find(&d);
    }
    if (r->open && sum != 0) {
        fprintf(stderr, "bench: a wrong sign\n");
        exit(2);
    }
    return 1e9 * (processor_seconds() - start) / SIGNS;
}

/// Nanoseconds for six estimates of a pair.
static double time_six(void)
{
    static tf_event event[SIGNS][TF_SIX];
    generator random = generator_new(3);
    for (int i = 0; i < SIGNS * TF_SIX; i++)
        for (int k = 0; k < TF_AXES; k++)
            event[i / TF_SIX][i % TF_SIX].x[k] = fine(&random);
    double start = processor_seconds();
    for (int i = 0; i < SIGNS; i++) {
        const tf_event *list[TF_SIX];
        tf_sign sign[TF_SIX];
        for (int j = 0; j < TF_SIX; j++)
            list[j] = &event[i][j];
        tf_estimate_six(2 + i % 3, list, sign);
    }
    return 1e9 * (processor_seconds() - start) / SIGNS;
}

static void print_signs(bool csv)
{
    static matrix m[RACES][SIGNS];
    double best[RACES];
    for (int i = 0; i < RACES; i++) {
        generator random = generator_new(2);
        for (int k = 0; k < SIGNS; k++) {
            m[i][k].n = races[i].n;
            fill(&random, races[i].coordinate, !races[i].open, &m[i][k]);
        }
        best[i] = INFINITY;
    }
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < RACES; i++)
            best[i] = fmin(best[i], time_signs(m[i], &races[i]));
    for (int i = 0; i < RACES; i++)
        printf(csv ? "%s,%.1f,ns a sign\n" : "%-24s %9.1f\n", races[i].name,
               best[i]);
    double six = INFINITY;
    for (int round = 0; round < ROUNDS; round++)
        six = fmin(six, time_six());
    printf(csv ? "%s,%.1f,ns a pair\n" : "%-24s %9.1f\n", "six estimates", six);
}

// Tables ----------------------------------------------------------------------

typedef void print_workload(const workload *w, bool csv);

static void print_workloads(print_workload *print, bool csv)
{
    workload (*const make[])(int vertices) = {workload_soup, workload_near,
                                              workload_rest, workload_lattice};
    for (size_t i = 0; i < sizeof make / sizeof *make; i++)
        for (int vertices = 1; vertices <= 2; vertices++) {
            workload w = make[i](vertices);
            print(&w, csv);
            if (contenders_for(&w) < CONTENDERS) {
                workload grid = workload_rounded(&w);
                print(&grid, csv);
                workload_free(&grid);
            }
            workload_free(&w);
        }
}

static void print_csv(void)
{
    print_workloads(print_times, true);
    print_workloads(print_shares, true);
    print_workloads(print_counts, true);
    print_signs(true);
}

static void print_tables(void)
{
    printf("%-16s %-15s %-10s %7s %7s %9s %6s\n", "work", "kind", "signs",
           "queries", "hits", "ns", "ratio");
    print_workloads(print_times, false);
    printf("\n%-16s %-15s", "work", "kind");
    for (int i = 0; i < SHARES; i++)
        printf(" %11s", shares[i].heading);
    printf("\n");
    print_workloads(print_shares, false);
    printf("\n%-16s %-15s %8s %8s %8s\n", "work", "signs of", "clamped",
           "exact", "pairs");
    print_workloads(print_counts, false);
    printf("\n%-24s %9s\n", "sign by", "ns");
    print_signs(false);
}

int main(int count, char **argument)
{
    if (count == 1)
        print_tables();
    else if (count == 2 && strcmp(argument[1], "--csv") == 0)
        print_csv();
    else {
        fprintf(stderr, "usage: bench [--csv]\n");
        return 2;
    }
    return 0;
}
