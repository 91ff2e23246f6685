// Many random and adversarial queries, by as many processes as there are cores:
// exact answers against those of 128-bit integers, where the coordinates are
// integers, and against those with time reversed, where they are not.
//
//     soak COUNT FROM
//
// tries the queries FROM to FROM + COUNT - 1 of TF_SEED's.  Interrupted, it
// prints where to go on.
#define _GNU_SOURCE // MAP_ANONYMOUS

#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "support/invariants.h"
#include "support/judge.h"

#include <math.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

// Families of queries ---------------------------------------------------------

/// The bits of the coordinates that 128-bit integers hold.
static int most_bits(query_kind kind)
{
    return tf_arithmetic_bits(&tf_integer128, kind == POINT_EDGE ? 2 : 3);
}

static query small_integers(generator *random, query_kind kind)
{
    return query_lattice(random, kind, 2 + below(random, 5));
}

static query sheared_integers(generator *random, query_kind kind)
{
    query q = small_integers(random, kind);
    query_shear(random, &q, 8 + below(random, most_bits(kind) - 7));
    return q;
}

/// Sheared integers, some of them off by one.
static query nearby_integers(generator *random, query_kind kind)
{
    query q = small_integers(random, kind);
    query_shear(random, &q, most_bits(kind) - 1);
    for (int moves = 1 + below(random, 3); moves > 0; moves--)
        *query_coordinate(&q, below(random, query_size(&q))) +=
            below(random, 3) - 1;
    return q;
}

static query large_integers(generator *random, query_kind kind)
{
    query q = query_new(kind);
    double most = ldexp(1, most_bits(kind));
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = trunc(uniform(random, -most, most));
    return q;
}

/// A lattice that doubles do not hold exactly.
static query rounded_lattice(generator *random, query_kind kind)
{
    query q = small_integers(random, kind);
    double unit = uniform(random, 0.1, 1), shift = uniform(random, -1, 1);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = *query_coordinate(&q, i) * unit + shift;
    return q;
}

static query nudged_lattice(generator *random, query_kind kind)
{
    query q = small_integers(random, kind);
    query_nudge(random, &q, 1);
    return q;
}

static query nudged_any(generator *random, query_kind kind)
{
    query q = query_any(random, kind);
    query_nudge(random, &q, 1);
    return q;
}

static query scaled_axes(generator *random, query_kind kind)
{
    query q = query_any(random, kind);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, below(random, 1200) - 600);
    return q;
}

static const struct {
    const char *name;
    query (*make)(generator *random, query_kind kind);
    invariant *fault;
} families[] = {
    {"small integers", small_integers, integers_fault},
    {"sheared integers", sheared_integers, integers_fault},
    {"nearby integers", nearby_integers, integers_fault},
    {"large integers", large_integers, integers_fault},
    {"anywhere", query_soup, reversal_fault},
    {"touching", query_touching, reversal_fault},
    {"in a plane", query_tilted, reversal_fault},
    {"at rest", query_resting, reversal_fault},
    {"parallel", query_parallel, reversal_fault},
    {"collapsed", query_collapsed, reversal_fault},
    {"one ulp off those", nudged_any, reversal_fault},
    {"rounded lattice", rounded_lattice, reversal_fault},
    {"nudged lattice", nudged_lattice, reversal_fault},
    {"stretched axes", scaled_axes, reversal_fault},
    {"any magnitude", query_extreme, reversal_fault},
};

enum {
    FAMILIES = sizeof families / sizeof *families,
    BLOCK = 10000, // queries of one stream of random numbers
    SHOWN = 5      // differences of a block, at most
};

// What the processes share ----------------------------------------------------

enum {
    QUERIES,
    CONTACTS,
    DEGENERATE,
    DIFFERENCES,
    COUNTS
};

static struct shared {
    atomic_llong next; ///< the first query that no process has taken yet
    long long end;     ///< the first that none will
    atomic_bool stop;
    atomic_llong count[FAMILIES][COUNTS];
} * all;

static long long total(int what)
{
    long long sum = 0;
    for (int i = 0; i < FAMILIES; i++)
        sum += all->count[i][what];
    return sum;
}

static void stop(int signal)
{
    (void)signal;
    all->stop = true;
}

// Trying queries --------------------------------------------------------------

static void show(const query *q, long long number, const char *fault)
{
    fprintf(stderr, "%s\nquery %lld of seed %llu, %s\n%s", fault, number,
            (unsigned long long)seed(), query_name(q), query_text(q));
}

static void try_query(generator *random, long long number,
                      long long count[FAMILIES][COUNTS])
{
    int family = (int)(number % FAMILIES);
    query_kind kind = (query_kind)(number / FAMILIES % KINDS);
    query q = families[family].make(random, kind);
    tf_contact exact = ask(&tf_exact, &q);
    const char *fault = families[family].fault(random, &q, &exact);
    count[family][QUERIES]++;
    count[family][CONTACTS] += exact.verdict == TF_HIT;
    count[family][DEGENERATE] += exact.classification == TF_DEGENERATE;
    if (fault && count[family][DIFFERENCES]++ < SHOWN)
        show(&q, number, fault);
}

static void try_block(long long begin)
{
    generator random = generator_new((uint64_t)(begin / BLOCK));
    long long count[FAMILIES][COUNTS] = {{0}};
    for (long long i = begin; i < begin + BLOCK && i < all->end; i++)
        try_query(&random, i, count);
    for (int family = 0; family < FAMILIES; family++)
        for (int i = 0; i < COUNTS; i++)
            all->count[family][i] += count[family][i];
}

static void work(void)
{
    while (!all->stop) {
        long long begin = atomic_fetch_add(&all->next, BLOCK);
        if (begin >= all->end)
            break;
        try_block(begin);
    }
}

// Processes -------------------------------------------------------------------

/// Starts as many as there are cores; returns how many.
static int start(void)
{
    int count = 0;
    for (long cores = sysconf(_SC_NPROCESSORS_ONLN); cores > count; count++) {
        pid_t child = fork();
        if (child == 0) {
            work();
            _exit(EXIT_SUCCESS);
        }
        if (child < 0)
            break;
    }
    return count;
}

static void show_progress(double seconds)
{
    double done = (double)total(QUERIES);
    fprintf(stderr, "\r%.0f queries, %.0f a second, %lld differences ", done,
            done / seconds, total(DIFFERENCES));
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/// Waits until all processes have ended; returns how many ended well.
static int watch(int processes, double begin)
{
    const struct timespec pause = {.tv_nsec = 100000000};
    int good = 0;
    for (int ended = 0; ended < processes;) {
        int status;
        pid_t child = waitpid(-1, &status, WNOHANG);
        if (child > 0) {
            good += status == 0;
            ended++;
            continue;
        }
        if (isatty(STDERR_FILENO))
            show_progress(now() - begin);
        nanosleep(&pause, NULL);
    }
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
    return good;
}

// Totals ----------------------------------------------------------------------

static double percent(long long part, long long whole)
{
    return whole ? 100 * (double)part / (double)whole : 0;
}

static void show_row(const char *name, long long queries, long long contacts,
                     long long degenerate, long long differences)
{
    printf("%-18s %12lld %8.1f %% %9.1f %% %12lld\n", name, queries,
           percent(contacts, queries), percent(degenerate, queries),
           differences);
}

static void show_table(void)
{
    printf("%-18s %12s %10s %11s %12s\n", "family", "queries", "contacts",
           "degenerate", "differences");
    for (int i = 0; i < FAMILIES; i++) {
        const atomic_llong *count = all->count[i];
        show_row(families[i].name, count[QUERIES], count[CONTACTS],
                 count[DEGENERATE], count[DIFFERENCES]);
    }
    show_row("all", total(QUERIES), total(CONTACTS), total(DEGENERATE),
             total(DIFFERENCES));
}

static void share(long long from, long long count)
{
    all = mmap(NULL, sizeof *all, PROT_READ | PROT_WRITE,
               MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) {
        perror("soak: mmap");
        exit(EXIT_FAILURE);
    }
    all->next = from;
    all->end = from + count;
}

int main(int argc, char *argv[])
{
    long long count = argc > 1 ? atoll(argv[1]) : 100000000;
    long long from = argc > 2 ? atoll(argv[2]) : 0;
    if (count < 1 || from < 0 || from % BLOCK != 0) {
        fprintf(stderr, "soak: COUNT from 1, FROM a multiple of %d\n", BLOCK);
        return EXIT_FAILURE;
    }
    share(from, count);
    signal(SIGINT, stop);
    signal(SIGTERM, stop);

    double begin = now();
    int processes = start(), good = watch(processes, begin);
    double seconds = now() - begin;
    show_table();
    printf("seed %llu, queries from %lld: %.1f s, %.0f a second, %d "
           "processes\n",
           (unsigned long long)seed(), from, seconds,
           (double)total(QUERIES) / seconds, processes);
    if (all->next < all->end)
        printf("interrupted; go on with FROM=%lld COUNT=%lld\n",
               (long long)all->next, all->end - all->next);
    if (good < processes)
        printf("%d processes broke off\n", processes - good);
    return total(DIFFERENCES) == 0 && good == processes && processes > 0
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
}
