// How long it takes to find the candidates and the contacts of cloth, and how
// that grows with the number of triangles.
//
// Prints a line a cloth: triangles; candidates a triangle; nanoseconds of
// processor time a triangle (the best of several rounds) for the boxes and
// trees, with the candidates, with the contacts, and for describing these alone;
// all of it on two threads, by the clock on the wall; contacts; bytes a triangle.
// Dense cloth has layers at a distance of 3 edge lengths that move by about one,
// sparse 10 and 0.1; in crowded cloth, with 1 and 1, layers pass through each
// other.  With --csv lines "name,value,unit", for figures/measured/library.csv, and also
// how many pairs of elements there are, and what decided the candidates.
#define _POSIX_C_SOURCE 199309L // clock_gettime

#include "arithmetic/exact.h"
#include "bench/layers.h"
#include "bench/measuring.h"
#include "fast/detect.h"
#include "query/edge_edge.h"
#include "query/narrow_phase.h"
#include "query/point_triangle.h"
#include "surface/candidates.h"
#include "surface/surface_memory.h"
#include "threads/threads.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
    SIZES = 6,
    ROUNDS = 3,             // at least
    ALL_TRIANGLES = 1000000 // in all rounds, at least
};

static double nanoseconds(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

// Times -----------------------------------------------------------------------

/// What is measured of a cloth; times in nanoseconds a triangle.
typedef struct result {
    double moving, candidates, contacts, describing, two_threads;
    size_t candidate_count, contact_count, bytes;
    tf_detect_statistics statistics;
    double pairs;
} result;

/// How many pairs of a vertex and a triangle, or of two edges, share no vertex.
static double count_pairs(const layers *cloth, const tf_surface *surface)
{
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    tf_surface_triangles(surface, &triangles);
    int *degree = calloc((size_t)cloth->mesh.vertices, sizeof *degree);
    if (!degree)
        require(TF_OUT_OF_MEMORY);
    for (size_t i = 0; i < 2 * (size_t)edges; i++)
        degree[edge[i]]++;
    double pairs = (double)(cloth->mesh.vertices - 3) * triangles +
                   0.5 * (double)edges * (edges - 1);
    for (int v = 0; v < cloth->mesh.vertices; v++)
        pairs -= 0.5 * degree[v] * (degree[v] - 1);
    free(degree);
    return pairs;
}

static void time_moving(const layers *cloth, tf_surface *surface,
                        result *measured)
{
    tf_error error;
    double start = nanoseconds(CLOCK_PROCESS_CPUTIME_ID);
    require(tf_surface_move(surface, &cloth->motion, false, NULL, &error));
    double time = nanoseconds(CLOCK_PROCESS_CPUTIME_ID) - start;
    measured->moving = fmin(measured->moving, time / cloth->mesh.triangles);
}

static void time_candidates(const layers *cloth, tf_surface *surface,
                            result *measured)
{
    tf_candidates found;
    double start = nanoseconds(CLOCK_PROCESS_CPUTIME_ID);
    require(tf_surface_candidates(surface, &cloth->motion, NULL, &found, NULL));
    double time = nanoseconds(CLOCK_PROCESS_CPUTIME_ID) - start;
    measured->candidates =
        fmin(measured->candidates, time / cloth->mesh.triangles);
    measured->candidate_count = found.point_count + found.edge_count;
}

static tf_contacts time_contacts(const layers *cloth, tf_surface *surface,
                                 const tf_threads *threads, clockid_t clock,
                                 double *best)
{
    tf_detect_options detection = {.narrow_phase = &tf_reference,
                                   .parallel = tf_threads_parallel(threads)};
    tf_contacts found;
    double start = nanoseconds(clock);
    require(
        tf_surface_detect(surface, &cloth->motion, &detection, &found, NULL));
    *best = fmin(*best, (nanoseconds(clock) - start) / cloth->mesh.triangles);
    return found;
}

static void time_describing(const layers *cloth, const tf_contacts *found,
                            result *measured)
{
    double start = nanoseconds(CLOCK_PROCESS_CPUTIME_ID);
    for (size_t i = 0; i < found->count; i++) {
        const tf_surface_contact *row = &found->contact[i];
        tf_contact again;
        require(row->kind == TF_EDGE_EDGE
                    ? tf_edge_edge(&tf_exact, &cloth->motion, row->vertex,
                                   row->vertex + 2, &again)
                    : tf_point_triangle(&tf_exact, &cloth->motion,
                                        row->vertex[0], row->vertex + 1,
                                        &again));
    }
    double time = nanoseconds(CLOCK_PROCESS_CPUTIME_ID) - start;
    measured->describing =
        fmin(measured->describing, time / cloth->mesh.triangles);
}

static void time_round(const layers *cloth, tf_surface *surface,
                       result *measured)
{
    time_moving(cloth, surface, measured);
    time_candidates(cloth, surface, measured);
    if (measured->bytes == 0)
        measured->bytes = tf_surface_memory(surface);
    tf_contacts found = time_contacts(
        cloth, surface, NULL, CLOCK_PROCESS_CPUTIME_ID, &measured->contacts);
    time_describing(cloth, &found, measured);
    measured->statistics = found.statistics;
    measured->contact_count = found.count;
    tf_threads *two;
    require(tf_threads_create(2, &two));
    time_contacts(cloth, surface, two, CLOCK_MONOTONIC, &measured->two_threads);
    tf_threads_free(two);
}

static result measure(const layers *cloth)
{
    tf_surface *surface;
    require(tf_surface_create(&cloth->mesh, &surface, NULL));
    result measured = {.moving = INFINITY,
                       .candidates = INFINITY,
                       .contacts = INFINITY,
                       .describing = INFINITY,
                       .two_threads = INFINITY,
                       .pairs = count_pairs(cloth, surface)};
    int rounds = ROUNDS + ALL_TRIANGLES / cloth->mesh.triangles;
    for (int round = 0; round < rounds; round++)
        time_round(cloth, surface, &measured);
    tf_surface_free(surface);
    return measured;
}

// Output ----------------------------------------------------------------------

static void print_csv(const char *name, int triangles, const result *r)
{
    const struct {
        const char *name, *unit;
        double value;
    } row[] = {
        {"pairs", "", r->pairs},
        {"candidates", "a triangle", (double)r->candidate_count / triangles},
        {"boxes and trees", "ns a triangle", r->moving},
        {"finding candidates", "ns a triangle", r->candidates},
        {"finding contacts", "ns a triangle", r->contacts},
        {"describing contacts", "ns a triangle", r->describing},
        {"finding contacts by two threads", "ns a triangle", r->two_threads},
        {"decided by an axis", "", (double)r->statistics.by_axis},
        {"decided by the filter", "", (double)r->statistics.by_filter},
        {"decided by signs", "", (double)r->statistics.by_signs},
        {"contacts", "", (double)r->contact_count},
        {"memory", "bytes a triangle", (double)r->bytes / triangles},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        printf("%s %d %s,%.*f,%s\n", name, triangles, row[i].name,
               *row[i].unit ? 3 : 0, row[i].value, row[i].unit);
}

static void print(const char *name, int triangles, const result *r)
{
    printf("%-7s %8d %6.2f %7.1f %8.1f %8.1f %8.1f %8.1f %8zu %5.0f\n", name,
           triangles, (double)r->candidate_count / triangles, r->moving,
           r->candidates, r->contacts, r->describing, r->two_threads,
           r->contact_count, (double)r->bytes / triangles);
}

static void measure_cloth(const char *name, int size, double gap, double reach,
                          bool csv)
{
    layers cloth = layers_new(size, gap, reach);
    result measured = measure(&cloth);
    (csv ? print_csv : print)(name, cloth.mesh.triangles, &measured);
    fflush(stdout);
    layers_free(&cloth);
}

int main(int argc, char *argv[])
{
    static const int sizes[SIZES] = {4, 8, 23, 71, 224, 448};
    bool csv = argc > 1 && strcmp(argv[1], "--csv") == 0;
    if (!csv)
        puts("cloth   triangle  cand. ns trees  ns cand ns detct ns descr 2 "
             "threads contacts bytes");
    for (int i = 0; i < SIZES; i++) {
        measure_cloth("dense", sizes[i], 3, 1, csv);
        measure_cloth("sparse", sizes[i], 10, 0.1, csv);
    }
    measure_cloth("crowded", 71, 1, 1, csv);
    return 0;
}
