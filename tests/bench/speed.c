// How fast many queries are decided, beside the time that reading them takes.
//
// Everything is timed in one run, in turns, by processor time, each in the
// median of several rounds, so that ratios mean something; run it on one core
// (taskset).  Prints a line a workload and way: nanoseconds a query, or in the
// last lines a triangle, and the ratio to the first line of the workload.
// - soup and near: reading the queries from memory, 192 bytes each; the filter
//   on the same memory, and on a block that stays in the cache; both narrow
//   phases on the vertices that indices name, and the cubic, with the tolerance
//   that the program gives it.  The reference and the cubic take each query
//   once only; describing takes eight times those that hit.
// - dense: the candidates of cloth of a million triangles, whose vertices are
//   gathered, by both narrow phases.
// - a hard family: both narrow phases, and the percentage of its queries that
//   the filter leaves undecided.
// - cloth: its candidates, and its contacts by both narrow phases.
// With --csv lines "name,value,unit" for figures/measured/library.csv, with --json an
// array of the same lines.

#include "arithmetic/exact.h"
#include "base/simd.h"
#include "bench/layers.h"
#include "bench/measuring.h"
#include "bench/workloads.h"
#include "fast/block_filter.h"
#include "fast/detect.h"
#include "fast/vectorized.h"
#include "linear/cubic.h"
#include "query/edge_edge.h"
#include "query/point_triangle.h"
#include "support/generator.h"
#include "support/memory.h"
#include "surface/candidates.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROUNDS = 11,
    COPIES = 40, // of a workload's queries, so that no cache holds them
    DENSE = 224, // vertices along a side of the cloth of a million triangles
    CLOTH = 71
};

static double nanoseconds(void)
{
    return 1e9 * processor_seconds();
}

// Queries ---------------------------------------------------------------------

/// Queries in all forms that something takes.
typedef struct arrays {
    size_t count;
    tf_query_block *block;
    tf_query_masks *masks;
    double *start, *end;
    int *vertex;
    tf_motion motion;
    tf_queries queries;
    tf_verdict *verdict;
} arrays;

static arrays arrays_new(size_t count, tf_kind kind)
{
    arrays a = {.count = count,
                .block = allocate_lines(count / TF_BLOCK_QUERIES + 1,
                                        sizeof(tf_query_block)),
                .masks = allocate_lines(count / TF_MASK_QUERIES + 1,
                                        sizeof(tf_query_masks)),
                .start = allocate_lines(12 * count, sizeof(double)),
                .end = allocate_lines(12 * count, sizeof(double)),
                .vertex = allocate_lines(4 * count, sizeof(int)),
                .verdict = allocate_lines(count, sizeof(tf_verdict))};
    memset(a.block, 0, (count / TF_BLOCK_QUERIES + 1) * sizeof(tf_query_block));
    a.queries.kind = kind;
    return a;
}

static void arrays_add(arrays *a, size_t i, const query *q)
{
    for (size_t v = 0; v < QUERY_VERTICES; v++) {
        a->vertex[4 * i + v] = (int)(4 * i + v);
        for (size_t k = 0; k < TF_AXES; k++) {
            double start = q->vertex[v].at[0].x[k];
            double end = q->vertex[v].at[1].x[k];
            tf_query_block *block = &a->block[i / TF_BLOCK_QUERIES];
            block->at[0][v][k][i % TF_BLOCK_QUERIES] = start;
            block->at[1][v][k][i % TF_BLOCK_QUERIES] = end;
            a->start[12 * i + 3 * v + k] = start;
            a->end[12 * i + 3 * v + k] = end;
        }
    }
}

/// The queries of a workload, `copies` times.
static arrays arrays_of(const workload *w, int copies)
{
    arrays a = arrays_new((size_t)(w->count * copies),
                          w->vertices == 1 ? TF_POINT_TRIANGLE : TF_EDGE_EDGE);
    for (size_t i = 0; i < a.count; i++)
        arrays_add(&a, i, &w->queries[i % (size_t)w->count]);
    a.motion = (tf_motion){3, (int)(4 * a.count), a.start, a.end};
    return a;
}

static void arrays_free(arrays *a)
{
    free(a->block);
    free(a->masks);
    free(a->start);
    free(a->end);
    free(a->vertex);
    free(a->verdict);
}

// Ways ------------------------------------------------------------------------

/// Does something with queries; returns with how many.
typedef size_t way_function(arrays *a);

static volatile uint64_t used; ///< so that no reading is left out

TF_SIMD static uint64_t read_words(const uint64_t *word, size_t count)
{
    uint64_t sum[32] = {0}, all = 0;
    for (size_t i = 0; i < count; i += 32)
        for (size_t k = 0; k < 32; k++)
            sum[k] |= word[i + k];
    for (size_t k = 0; k < 32; k++)
        all |= sum[k];
    return all;
}

static size_t read_all(arrays *a)
{
    size_t blocks = a->count / TF_BLOCK_QUERIES;
    used = read_words((const uint64_t *)(const void *)a->block,
                      blocks * sizeof *a->block / sizeof(uint64_t));
    return a->count;
}

static size_t filter_count(const arrays *a, size_t count)
{
    require((a->queries.kind == TF_EDGE_EDGE
                 ? tf_filter_edge_edge
                 : tf_filter_point_triangle)(count, a->block, a->masks));
    return count;
}

static size_t filter_streaming(arrays *a)
{
    return filter_count(a, a->count);
}

static size_t filter_in_cache(arrays *a)
{
    size_t done = 0;
    while (done < a->count)
        done += filter_count(a, TF_MASK_QUERIES);
    return done;
}

static size_t decide(arrays *a, const tf_narrow_phase *narrow_phase,
                     size_t count)
{
    size_t separated = 0;
    a->queries.motion = &a->motion;
    a->queries.count = count;
    a->queries.vertices = a->vertex;
    require(narrow_phase->decide(narrow_phase->context, &tf_exact, &a->queries,
                                 a->verdict, &separated));
    return count;
}

static size_t decide_by_reference(arrays *a)
{
    return decide(a, &tf_reference, a->count / COPIES);
}

static size_t decide_by_vectors(arrays *a)
{
    return decide(a, &tf_vectorized, a->count);
}

static size_t solve_cubics(arrays *a)
{
    static const tf_tolerances usual = {.distance = 1e-6};
    for (size_t i = 0; i < a->count / COPIES; i++) {
        const int *v = a->vertex + 4 * i;
        tf_contact contact;
        require(a->queries.kind == TF_EDGE_EDGE
                    ? tf_cubic_edge_edge(&usual, &a->motion, v, v + 2, &contact)
                    : tf_cubic_point_triangle(&usual, &a->motion, *v, v + 1,
                                              &contact));
    }
    return a->count / COPIES;
}

/// Describes a hit; whether it is one is known.
static void describe_hit(const arrays *a, size_t i)
{
    const int *v = a->vertex + 4 * i;
    tf_contact contact;
    require(
        a->queries.kind == TF_EDGE_EDGE
            ? tf_edge_edge(&tf_exact, &a->motion, v, v + 2, &contact)
            : tf_point_triangle(&tf_exact, &a->motion, *v, v + 1, &contact));
}

/// Describes what hits of all queries, several times: what has just been
/// decided is in the cache.
static size_t describe_hits(arrays *a)
{
    size_t hits = 0;
    for (int time = 0; time < 8; time++)
        for (size_t i = 0; i < a->count / COPIES; i++)
            if (a->verdict[i] == TF_HIT) {
                describe_hit(a, i);
                hits++;
            }
    return hits;
}

typedef struct way {
    const char *name;
    way_function *run;
} way;

// Output ----------------------------------------------------------------------

typedef enum format {
    TABLE,
    CSV,
    JSON
} format;

static format chosen;
static bool printed;

static void print_json(const char *name, double value, const char *unit,
                       double ratio)
{
    printf("%s\n{\"name\": \"%s\", \"value\": %.3f, \"unit\": \"%s\"",
           printed ? "," : "", name, value, unit);
    if (isnan(ratio))
        printf("}");
    else
        printf(", \"ratio\": %.3f}", ratio);
}

/// A `ratio` of NaN: there is none.
static void print_row(const char *name, double value, const char *unit,
                      double ratio)
{
    if (chosen == CSV)
        printf("%s,%.3f,%s\n", name, value, unit);
    else if (chosen == JSON)
        print_json(name, value, unit, ratio);
    else if (isnan(ratio))
        printf("%-46s %9.2f %s\n", name, value, unit);
    else
        printf("%-46s %9.2f %-13s %8.2f\n", name, value, unit, ratio);
    printed = true;
    fflush(stdout);
}

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double time[ROUNDS])
{
    qsort(time, ROUNDS, sizeof *time, compare_numbers);
    return time[ROUNDS / 2];
}

/// Times several ways with the same queries, and prints a row of each.
static void race(arrays *a, const char *name, const char *kind,
                 const way ways[], int count)
{
    double time[10][ROUNDS], middle[10];
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < count; i++) {
            double start = nanoseconds();
            size_t done = ways[i].run(a);
            time[i][round] = (nanoseconds() - start) / (double)done;
        }
    for (int i = 0; i < count; i++) {
        char row[100];
        middle[i] = median(time[i]);
        snprintf(row, sizeof row, "%s %s %s", ways[i].name, name, kind);
        print_row(row, middle[i], "ns a query", middle[i] / middle[0]);
    }
}

// Workloads -------------------------------------------------------------------

static void race_random(void)
{
    static const way ways[] = {
        {"read", read_all},
        {"filter streaming", filter_streaming},
        {"filter in cache", filter_in_cache},
        {"vector", decide_by_vectors},
        {"reference", decide_by_reference},
        {"cubic", solve_cubics},
        {"describe hits", describe_hits},
    };
    workload (*const make[])(int vertices) = {workload_soup, workload_near};
    for (int i = 0; i < 4; i++) {
        workload w = make[i / 2](1 + i % 2);
        arrays a = arrays_of(&w, COPIES);
        race(&a, w.name, workload_kind(&w), ways, sizeof ways / sizeof *ways);
        arrays_free(&a);
        workload_free(&w);
    }
}

static double percent_undecided(arrays *a)
{
    size_t undecided = 0;
    filter_streaming(a);
    for (size_t i = 0; i < a->count; i++)
        undecided +=
            a->masks[i / TF_MASK_QUERIES].undecided >> i % TF_MASK_QUERIES & 1;
    return 100 * (double)undecided / (double)a->count;
}

// Hard families ---------------------------------------------------------------

typedef void change_function(generator *random, double *x, int axis);

static void to_next(generator *random, double *x, int axis)
{
    (void)axis;
    *x = nextafter(*x, below(random, 2) ? 9 : -9);
}

static void scale_axis(generator *random, double *x, int axis)
{
    (void)random;
    *x = ldexp(*x, 700 * (axis - 1));
}

static void keep(generator *random, double *x, int axis)
{
    (void)random;
    (void)x;
    (void)axis;
}

static void change_all(workload *w, change_function *change)
{
    generator random = generator_new(3);
    for (long i = 0; i < w->count; i++)
        for (int v = 0; v < QUERY_VERTICES; v++)
            for (int t = 0; t < 2; t++)
                for (int k = 0; k < TF_AXES; k++)
                    change(&random, &w->queries[i].vertex[v].at[t].x[k], k);
}

static void race_hard(void)
{
    static const way ways[] = {{"reference", decide_by_reference},
                               {"vector", decide_by_vectors}};
    static const struct {
        const char *name;
        workload (*make)(int vertices);
        change_function *change;
    } hard[] = {{"lattice", workload_lattice, keep},
                {"rest", workload_rest, keep},
                {"nudged lattice", workload_lattice, to_next},
                {"scaled axes", workload_near, scale_axis}};
    for (int i = 0; i < 8; i++) {
        workload w = hard[i / 2].make(1 + i % 2);
        change_all(&w, hard[i / 2].change);
        arrays a = arrays_of(&w, 1);
        char row[100];
        snprintf(row, sizeof row, "undecided %s %s", hard[i / 2].name,
                 workload_kind(&w));
        print_row(row, percent_undecided(&a), "%", NAN);
        race(&a, hard[i / 2].name, workload_kind(&w), ways, 2);
        arrays_free(&a);
        workload_free(&w);
    }
}

// Cloth -----------------------------------------------------------------------

static tf_surface *surface_of_cloth(const layers *cloth)
{
    tf_surface *surface;
    require(tf_surface_create(&cloth->mesh, &surface, NULL));
    return surface;
}

/// The queries of candidates, that share the vertices of a mesh.
static arrays mesh_queries(const layers *cloth, tf_kind kind, size_t count,
                           const tf_candidate *pair, const int *edge,
                           const int *triangle)
{
    arrays a = {.count = count,
                .vertex = allocate_lines(4 * count, sizeof(int)),
                .verdict = allocate_lines(count, sizeof(tf_verdict)),
                .motion = cloth->motion,
                .queries = {.kind = kind}};
    for (size_t i = 0; i < count; i++) {
        int *v = a.vertex + 4 * i;
        const int *other = kind == TF_EDGE_EDGE
                               ? edge + 2 * (size_t)pair[i].second
                               : triangle + 3 * (size_t)pair[i].second;
        v[0] = pair[i].first;
        if (kind == TF_EDGE_EDGE)
            memcpy(v, edge + 2 * (size_t)pair[i].first, 2 * sizeof *v);
        int own = kind == TF_EDGE_EDGE ? 2 : 1;
        memcpy(v + own, other, (size_t)(4 - own) * sizeof *v);
    }
    return a;
}

static void race_mesh(void)
{
    static const way ways[] = {{"vector", decide_by_vectors},
                               {"reference", decide_by_reference}};
    layers cloth = layers_new(DENSE, 3, 1);
    tf_surface *surface = surface_of_cloth(&cloth);
    tf_candidates found;
    int count;
    require(tf_surface_candidates(surface, &cloth.motion, NULL, &found, NULL));
    const int *edge = tf_surface_edges(surface, &count);
    const int *triangle = tf_surface_triangles(surface, &count);
    for (int i = 0; i < 2; i++) {
        arrays a = mesh_queries(&cloth, i ? TF_EDGE_EDGE : TF_POINT_TRIANGLE,
                                i ? found.edge_count : found.point_count,
                                i ? found.edges : found.points, edge, triangle);
        race(&a, "dense", i ? "edge-edge" : "point-triangle", ways, 2);
        free(a.vertex);
        free(a.verdict);
    }
    tf_surface_free(surface);
    layers_free(&cloth);
}

static double time_candidates(tf_surface *surface, const tf_motion *motion)
{
    tf_candidates found;
    double start = nanoseconds();
    require(tf_surface_candidates(surface, motion, NULL, &found, NULL));
    return nanoseconds() - start;
}

static double time_contacts(tf_surface *surface, const tf_motion *motion,
                            const tf_narrow_phase *narrow_phase)
{
    tf_detect_options detection = {.narrow_phase = narrow_phase};
    tf_contacts found;
    double start = nanoseconds();
    require(tf_surface_detect(surface, motion, &detection, &found, NULL));
    return nanoseconds() - start;
}

static void race_cloth(const char *name, double gap, double reach)
{
    layers cloth = layers_new(CLOTH, gap, reach);
    tf_surface *surface = surface_of_cloth(&cloth);
    static const char *const what[] = {"candidates", "detection by vectors",
                                       "detection by reference"};
    double time[3][ROUNDS], first = 0;
    for (int round = 0; round < ROUNDS; round++) {
        time[0][round] = time_candidates(surface, &cloth.motion);
        time[1][round] = time_contacts(surface, &cloth.motion, &tf_vectorized);
        time[2][round] = time_contacts(surface, &cloth.motion, &tf_reference);
    }
    for (int i = 0; i < 3; i++) {
        char row[100];
        snprintf(row, sizeof row, "%s %s cloth", what[i], name);
        double own = median(time[i]) / cloth.mesh.triangles;
        first = i == 0 ? own : first;
        print_row(row, own, "ns a triangle", own / first);
    }
    tf_surface_free(surface);
    layers_free(&cloth);
}

int main(int count, char **argument)
{
    static const char *const formats[] = {"", "--csv", "--json"};
    for (int i = 1; i < 3 && count == 2; i++)
        if (strcmp(argument[1], formats[i]) == 0)
            chosen = (format)i;
    if (count > 2 || (count == 2 && chosen == TABLE)) {
        fprintf(stderr, "usage: speed [--csv | --json]\n");
        return 2;
    }
    if (chosen == JSON)
        printf("[");
    race_random();
    race_mesh();
    race_hard();
    race_cloth("dense", 3, 1);
    race_cloth("sparse", 10, 0.1);
    if (chosen == JSON)
        printf("\n]\n");
    return 0;
}
