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
//   estimates decide, that need an expansion, and that need the accumulator,
//   with exact signs;
// - a line a stage: nanoseconds a sign.
// With --header the same as tables in C, for the figures of the book.
#define _POSIX_C_SOURCE 199309L // clock_gettime

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

// Queries ----------------------------------------------------------------------

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

// Stages -----------------------------------------------------------------------

enum {
    STAGES = TF_BY_ACCUMULATOR + 1
};

/// The farthest stage of the query at hand; -1: no sign was asked for.
static int farthest;

static tf_sign note_stage(const tf_differences *differences)
{
    tf_stage stage;
    tf_sign sign = tf_exact_sign(differences, &stage);
    farthest = (int)stage > farthest ? (int)stage : farthest;
    return sign;
}

static void print_shares(const workload *w, bool header)
{
    const tf_arithmetic noting = {
        .name = "noting", .sign = note_stage, .value = tf_exact.value};
    long queries[STAGES + 1] = {0};
    for (long i = 0; i < w->count; i++) {
        farthest = -1;
        answer(w, i, &noting);
        queries[farthest + 1]++;
    }
    printf(header ? "    {\"%s\", \"%s\", {" : "%-8s %-15s", w->name,
           workload_kind(w));
    for (int i = 0; i <= STAGES; i++)
        printf(header ? "%.3f, " : " %11.3f",
               100 * (double)queries[i] / (double)w->count);
    printf(header ? "}},\n" : "\n");
}

// Signs ------------------------------------------------------------------------

enum {
    SIGNS = 2000
};

/// A 3x3 determinant and its events.
typedef struct matrix {
    tf_event to[TF_AXES], from[TF_AXES];
} matrix;

static tf_differences differences_of(const matrix *m)
{
    tf_differences d = {.n = TF_AXES};
    for (int i = 0; i < TF_AXES; i++) {
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

/// Random coordinates; the last row is the second, so that only an exact stage
/// can tell, unless `regular`.
static void fill(generator *random, double (*coordinate)(generator *random),
                 bool regular, matrix *m)
{
    for (int i = 0; i < TF_AXES; i++)
        for (int k = 0; k < TF_AXES; k++) {
            m->to[i].x[k] = coordinate(random);
            m->from[i].x[k] = coordinate(random);
        }
    if (regular)
        return;
    m->to[2] = m->to[1];
    m->from[2] = m->from[1];
}

/// Nanoseconds a sign, of those that `stage` finds.
static double time_signs(const matrix m[SIGNS], tf_stage stage)
{
    double best = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        double start = nanoseconds();
        for (int i = 0; i < SIGNS; i++) {
            tf_differences d = differences_of(&m[i]);
            tf_stage found;
            tf_exact_sign(&d, &found);
            if (found != stage) {
                fprintf(stderr, "bench: a sign of another stage\n");
                exit(2);
            }
        }
        best = fmin(best, (nanoseconds() - start) / SIGNS);
    }
    return best;
}

static void print_stage(const char *name,
                        double (*coordinate)(generator *random), tf_stage stage,
                        bool header)
{
    static matrix m[SIGNS];
    generator random = generator_new(2);
    for (int i = 0; i < SIGNS; i++)
        fill(&random, coordinate, stage == TF_BY_ESTIMATE, &m[i]);
    printf(header ? "    {\"%s\", %.1f},\n" : "%-24s %9.1f\n", name,
           time_signs(m, stage));
}

// Tables -----------------------------------------------------------------------

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

static void print_stages(bool header)
{
    print_stage("estimate", fine, TF_BY_ESTIMATE, header);
    print_stage("expansion", coarse, TF_BY_EXPANSION, header);
    print_stage("accumulator", uneven, TF_BY_ACCUMULATOR, header);
    print_stage("accumulator, any size", of_any_size, TF_BY_ACCUMULATOR,
                header);
}

static void print_header(void)
{
    printf("static const tf_query_time query_times[] = {\n");
    print_workloads(print_times, true);
    printf("};\nstatic const tf_stage_share stage_shares[] = {\n");
    print_workloads(print_shares, true);
    printf("};\nstatic const tf_stage_time stage_times[] = {\n");
    print_stages(true);
    printf("};\n");
}

static void print_tables(void)
{
    printf("%-8s %-15s %-10s %7s %7s %9s %6s\n", "work", "kind", "signs",
           "queries", "hits", "ns", "ratio");
    print_workloads(print_times, false);
    printf("\n%-8s %-15s %11s %11s %11s %11s\n", "work", "kind", "none %",
           "estimate %", "expansion %", "accum. %");
    print_workloads(print_shares, false);
    printf("\n%-24s %9s\n", "sign by", "ns");
    print_stages(false);
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
