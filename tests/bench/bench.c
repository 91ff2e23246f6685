// How long queries and signs take, and how far exact signs have to go.  The
// workloads are the same in every run, and all arithmetics are timed in one
// run, in turns and by processor time, so that ratios mean something on a shared
// machine.
//
// Prints three tables:
// - a line a workload and arithmetic: queries, hits, nanoseconds a query (the
//   best of several rounds) and the ratio to `clamped`.  The integers get the
//   same workloads rounded to their grids;
// - a line a workload: the percentage of queries that need no sign, that
//   estimates decide, and that need the accumulator, with exact signs; and of
//   the signs that estimates leave open, the percentage of those with a rounded
//   difference, and of those that the rounded differences would decide;
// - a line a way to a sign: nanoseconds.  The expansion, which the library does
//   without, finds the signs of the same differences as the accumulator does
//   above it.
// With --header the same as tables in C, for the figures of the book.
#define _POSIX_C_SOURCE 199309L // clock_gettime

#include "bench/expansion.h"
#include "bench/workloads.h"
#include "support/generator.h"
#include "tanglefree.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
    ROUNDS = 5
};

/// Processor time.
static double nanoseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

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
    double start = nanoseconds();
    for (int repeat = repetitions(w); repeat > 0; repeat--) {
        *hits = 0;
        for (long i = 0; i < w->count; i++)
            *hits += answer(w, i, arithmetic);
    }
    return (nanoseconds() - start) / ((double)w->count * repetitions(w));
}

/// An arithmetic, and the grid that the workloads have to be rounded to.
typedef struct contender {
    const tf_arithmetic *arithmetic;
    int grid_bits; ///< 0: none
} contender;

// Coordinates of all workloads are below 2 in absolute value.
static const contender contenders[] = {
    {&tf_clamped, 0},   {&tf_report, 0},     {&tf_exact, 0},
    {&tf_perturbed, 0}, {&tf_integer64, 18}, {&tf_integer128, 39},
};

enum {
    CONTENDERS = sizeof contenders / sizeof *contenders
};

static bool needs_grid(const workload *w, const contender *c)
{
    return c->grid_bits > 0 && strcmp(w->name, "lattice") != 0;
}

static void print_time(const workload *w, int c, long hits, double time,
                       double ratio, bool header)
{
    printf(header ? "    {\"%s\", \"%s\", \"%s\", %ld, %ld, %.1f, %.2f},\n"
                  : "%-8s %-15s %-10s %7ld %7ld %9.1f %6.2f\n",
           w->name, workload_kind(w), contenders[c].arithmetic->name, w->count,
           hits, time, ratio);
}

static void print_times(const workload *w, bool header)
{
    workload own[CONTENDERS];
    double best[CONTENDERS];
    long hits[CONTENDERS];
    for (int c = 0; c < CONTENDERS; c++) {
        best[c] = INFINITY;
        own[c] = needs_grid(w, &contenders[c])
                     ? workload_on_grid(w, contenders[c].grid_bits)
                     : *w;
    }
    for (int round = 0; round < ROUNDS; round++)
        for (int c = 0; c < CONTENDERS; c++) {
            double time =
                time_queries(&own[c], contenders[c].arithmetic, &hits[c]);
            best[c] = fmin(best[c], time);
        }
    for (int c = 0; c < CONTENDERS; c++) {
        print_time(w, c, hits[c], best[c], best[c] / best[0], header);
        if (needs_grid(w, &contenders[c]))
            workload_free(&own[c]);
    }
}

// Stages ----------------------------------------------------------------------

enum {
    STAGES = TF_BY_ACCUMULATOR + 1
};

/// What is noted of a workload's signs.
static struct {
    int farthest; ///< stage of the query at hand; -1: no sign was asked for
    long open;    ///< signs that the estimate does not know
    long tails;   ///< those of them with a rounded difference
    long heads;   ///< and of these, that the rounded differences tell
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

static tf_sign note_sign(const tf_differences *differences)
{
    tf_stage stage;
    tf_sign sign = tf_exact_sign(differences, &stage);
    noted.farthest = (int)stage > noted.farthest ? (int)stage : noted.farthest;
    if (stage == TF_BY_ACCUMULATOR) {
        bool tail = has_tail(differences);
        noted.open++;
        noted.tails += tail;
        noted.heads += tail && heads_decide(differences);
    }
    return sign;
}

static double percent(long part, long whole)
{
    return whole == 0 ? 0 : 100 * (double)part / (double)whole;
}

static void print_shares(const workload *w, bool header)
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
    printf(header ? "    {\"%s\", \"%s\", {" : "%-8s %-15s", w->name,
           workload_kind(w));
    for (int i = 0; i <= STAGES; i++)
        printf(header ? "%.3f, " : " %11.3f", percent(queries[i], w->count));
    printf(header ? "}, %.3f, %.3f},\n" : " %11.3f %11.3f\n",
           percent(noted.tails, noted.open), percent(noted.heads, noted.open));
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
/// can tell, unless `regular`.
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

static void expect_stage(tf_stage found, tf_stage expected)
{
    if (found == expected)
        return;
    fprintf(stderr, "bench: a sign of another stage\n");
    exit(2);
}

static tf_sign by_estimate(const tf_differences *differences)
{
    tf_stage stage;
    tf_sign sign = tf_exact_sign(differences, &stage);
    expect_stage(stage, TF_BY_ESTIMATE);
    return sign;
}

static tf_sign by_accumulator(const tf_differences *differences)
{
    tf_stage stage;
    tf_sign sign = tf_exact_sign(differences, &stage);
    expect_stage(stage, TF_BY_ACCUMULATOR);
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
    tf_estimate estimate = tf_differences_estimate(differences);
    double entry[TF_AXES][TF_AXES];
    tf_differences_round(differences, entry);
    if (fabs(estimate.number) > estimate.bound ||
        !expansion_suffices(differences, entry)) {
        fprintf(stderr, "bench: a sign that needs no expansion, or more\n");
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
} race;

// Differences of fine and of coarse coordinates are doubles.
static const race races[] = {
    {"estimate", 3, fine, by_estimate},
    {"accumulator, no tails", 3, fine, by_accumulator},
    {"accumulator", 3, uneven, by_accumulator},
    {"accumulator, any size", 3, of_any_size, by_accumulator},
    {"expansion, no tails", 3, fine, by_expansion},
    {"accumulator, integers", 3, coarse, by_accumulator},
    {"expansion, integers", 3, coarse, by_expansion},
    {"accumulator, plane", 2, fine, by_accumulator},
    {"expansion, plane", 2, fine, by_expansion},
};

enum {
    RACES = sizeof races / sizeof *races
};

static double time_signs(const matrix m[SIGNS], sign_finder *find)
{
    double start = nanoseconds();
    int sum = 0;
    for (int i = 0; i < SIGNS; i++) {
        tf_differences d = differences_of(&m[i]);
        sum += find(&d);
    }
    if (find != by_estimate && sum != 0) {
        fprintf(stderr, "bench: a wrong sign\n");
        exit(2);
    }
    return (nanoseconds() - start) / SIGNS;
}

static void print_signs(bool header)
{
    static matrix m[RACES][SIGNS];
    double best[RACES];
    for (int i = 0; i < RACES; i++) {
        generator random = generator_new(2);
        for (int k = 0; k < SIGNS; k++) {
            m[i][k].n = races[i].n;
            fill(&random, races[i].coordinate, races[i].find == by_estimate,
                 &m[i][k]);
        }
        best[i] = INFINITY;
    }
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < RACES; i++)
            best[i] = fmin(best[i], time_signs(m[i], races[i].find));
    for (int i = 0; i < RACES; i++)
        printf(header ? "    {\"%s\", %.1f},\n" : "%-24s %9.1f\n",
               races[i].name, best[i]);
}

// Tables ----------------------------------------------------------------------

typedef void print_workload(const workload *w, bool header);

static void print_workloads(print_workload *print, bool header)
{
    workload (*const make[])(int vertices) = {workload_soup, workload_near,
                                              workload_rest, workload_lattice};
    for (size_t i = 0; i < sizeof make / sizeof *make; i++)
        for (int vertices = 1; vertices <= 2; vertices++) {
            workload w = make[i](vertices);
            print(&w, header);
            workload_free(&w);
        }
}

static void print_header(void)
{
    printf("static const tf_query_time query_times[] = {\n");
    print_workloads(print_times, true);
    printf("};\nstatic const tf_stage_share stage_shares[] = {\n");
    print_workloads(print_shares, true);
    printf("};\nstatic const tf_stage_time stage_times[] = {\n");
    print_signs(true);
    printf("};\n");
}

static void print_tables(void)
{
    printf("%-8s %-15s %-10s %7s %7s %9s %6s\n", "work", "kind", "signs",
           "queries", "hits", "ns", "ratio");
    print_workloads(print_times, false);
    printf("\n%-8s %-15s %11s %11s %11s %11s %11s\n", "work", "kind", "none %",
           "estimate %", "accum. %", "tails %", "by heads %");
    print_workloads(print_shares, false);
    printf("\n%-24s %9s\n", "sign by", "ns");
    print_signs(false);
}

int main(int count, char **argument)
{
    if (count == 1)
        print_tables();
    else if (count == 2 && strcmp(argument[1], "--header") == 0)
        print_header();
    else {
        fprintf(stderr, "usage: bench [--header]\n");
        return 2;
    }
    return 0;
}
