// How long a query takes, by workload and arithmetic.  The workloads are the
// same in every run, and all arithmetics are timed in one run, in turns, so
// that ratios mean something on a shared machine.  Prints one line a workload
// and arithmetic: queries, hits, nanoseconds a query (the best of several
// rounds) and the ratio to `clamped`.
#define _POSIX_C_SOURCE 199309L // clock_gettime

#include "support/support.h"
#include "tanglefree.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

// A query

typedef struct query {
    tf_worldline vertex[4];
} query;

typedef struct workload {
    const char *name;
    int vertices; // of the first element: 1 point-triangle, 2 edge-edge
    long count;
    query *queries;
} workload;

static workload workload_new(const char *name, int vertices, long capacity)
{
    query *queries = malloc(sizeof(query) * (size_t)capacity);
    if (!queries) {
        fprintf(stderr, "bench: out of memory\n");
        exit(2);
    }
    return (workload){.name = name, .vertices = vertices, .queries = queries};
}

// Soup and near: a vertex anywhere in a cube, displaced by up to 0.1

static query random_query(generator *random, double size)
{
    double corner[TF_AXES];
    for (int k = 0; k < TF_AXES; k++)
        corner[k] = uniform(random, 0, 1 - size);
    query q;
    for (int i = 0; i < 4; i++) {
        double start[TF_AXES], end[TF_AXES];
        for (int k = 0; k < TF_AXES; k++) {
            start[k] = uniform(random, corner[k], corner[k] + size);
            end[k] = start[k] + uniform(random, -0.1, 0.1);
        }
        q.vertex[i] = tf_worldline_between(TF_AXES, start, end);
    }
    return q;
}

static workload random_workload(const char *name, int vertices, double size)
{
    enum {
        COUNT = 20000
    };
    generator random = generator_new(1);
    workload w = workload_new(name, vertices, COUNT);
    while (w.count < COUNT)
        w.queries[w.count++] = random_query(&random, size);
    return w;
}

// Rest: a tilted flat cloth that does not move, as a grid of triangles

enum {
    SIDE = 40,        // vertices along a side
    CELLS = SIDE - 1, // cells along a side
    TRIANGLES = 2 * CELLS * CELLS,
    EDGES = 2 * SIDE * CELLS + CELLS * CELLS,
    MOST_PAIRS = 200000
};

typedef struct element {
    int vertex[3]; // increasing
} element;

/// A vertex of the grid, moved about within the cloth and tilted with it: flat
/// but for the rounding of three coordinates.
static tf_worldline cloth_vertex(int index)
{
    generator random = generator_new((uint64_t)index);
    double u = (index % SIDE + uniform(&random, -0.4, 0.4)) / CELLS - 0.5;
    double v = (index / SIDE + uniform(&random, -0.4, 0.4)) / CELLS - 0.5;
    double x[TF_AXES] = {0.8 * u - 0.36 * v, 0.6 * u + 0.48 * v, 0.8 * v};
    return tf_worldline_between(TF_AXES, x, x);
}

static tf_worldline cloth[SIDE * SIDE];

static void lay_out_cloth(void)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        cloth[i] = cloth_vertex(i);
}

static int cloth_triangles(element triangle[TRIANGLES])
{
    int count = 0;
    for (int cell = 0; cell < CELLS * CELLS; cell++) {
        int a = cell / CELLS * SIDE + cell % CELLS;
        triangle[count++] = (element){{a, a + 1, a + SIDE + 1}};
        triangle[count++] = (element){{a, a + SIDE, a + SIDE + 1}};
    }
    return count;
}

static int cloth_edges(element edge[EDGES])
{
    int count = 0;
    for (int a = 0; a < SIDE * SIDE; a++) {
        bool right = a % SIDE < CELLS, up = a / SIDE < CELLS;
        if (right)
            edge[count++] = (element){{a, a + 1}};
        if (up)
            edge[count++] = (element){{a, a + SIDE}};
        if (right && up)
            edge[count++] = (element){{a, a + SIDE + 1}};
    }
    return count;
}

static bool boxes_overlap(const query *q, int vertices)
{
    for (int k = 0; k < TF_AXES; k++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i < 4; i++) {
            double x = q->vertex[i].at[0].x[k];
            int second = i >= vertices;
            low[second] = fmin(low[second], x);
            high[second] = fmax(high[second], x);
        }
        if (low[0] > high[1] || low[1] > high[0])
            return false;
    }
    return true;
}

static bool share_a_vertex(const int *first, int vertices, const int *second)
{
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < 4 - vertices; j++)
            if (first[i] == second[j])
                return true;
    return false;
}

static void add_pair(workload *w, const int *first, const int *second)
{
    if (share_a_vertex(first, w->vertices, second))
        return;
    query q;
    for (int i = 0; i < 4; i++)
        q.vertex[i] =
            cloth[i < w->vertices ? first[i] : second[i - w->vertices]];
    if (boxes_overlap(&q, w->vertices) && w->count < MOST_PAIRS)
        w->queries[w->count++] = q;
}

static workload rest_points(void)
{
    static element triangle[TRIANGLES];
    int count = cloth_triangles(triangle);
    workload w = workload_new("rest", 1, MOST_PAIRS);
    for (int p = 0; p < SIDE * SIDE; p++)
        for (int i = 0; i < count; i++)
            add_pair(&w, &p, triangle[i].vertex);
    return w;
}

static workload rest_edges(void)
{
    static element edge[EDGES];
    int count = cloth_edges(edge);
    workload w = workload_new("rest", 2, MOST_PAIRS);
    for (int i = 0; i < count; i++)
        for (int j = i + 1; j < count; j++)
            add_pair(&w, edge[i].vertex, edge[j].vertex);
    return w;
}

// Time

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static long run(const workload *w, const tf_arithmetic *arithmetic)
{
    long hits = 0;
    for (long i = 0; i < w->count; i++) {
        const tf_worldline *v = w->queries[i].vertex;
        tf_contact contact;
        tf_query(arithmetic, TF_AXES, w->vertices, v, 4 - w->vertices,
                 v + w->vertices, &contact);
        hits += contact.verdict != TF_APART;
    }
    return hits;
}

static void measure(const workload *w)
{
    enum {
        ROUNDS = 7
    };
    const tf_arithmetic *arithmetics[] = {&tf_clamped, &tf_report, &tf_exact};
    double best[] = {INFINITY, INFINITY, INFINITY};
    long hits[] = {0, 0, 0};
    for (int round = 0; round < ROUNDS; round++)
        for (int a = 0; a < 3; a++) {
            double start = seconds();
            hits[a] = run(w, arithmetics[a]);
            best[a] = fmin(best[a], seconds() - start);
        }

    const char *kind = w->vertices == 1 ? "point-triangle" : "edge-edge";
    for (int a = 0; a < 3; a++)
        printf("%-6s %-15s %-8s %7ld %7ld %9.1f %6.2f\n", w->name, kind,
               arithmetics[a]->name, w->count, hits[a],
               1e9 * best[a] / (double)w->count, best[a] / best[0]);
}

int main(void)
{
    lay_out_cloth();
    workload workloads[] = {
        random_workload("soup", 1, 1),
        random_workload("soup", 2, 1),
        random_workload("near", 1, 0.1),
        random_workload("near", 2, 0.1),
        rest_points(),
        rest_edges(),
    };
    printf("%-6s %-15s %-8s %7s %7s %9s %6s\n", "work", "kind", "signs",
           "queries", "hits", "ns", "ratio");
    for (size_t i = 0; i < sizeof workloads / sizeof *workloads; i++) {
        measure(&workloads[i]);
        free(workloads[i].queries);
    }
    return 0;
}
