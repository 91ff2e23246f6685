#include "bench/workloads.h"

#include "support/generator.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static workload workload_new(const char *name, int vertices, long capacity)
{
    query *queries = malloc(sizeof(query) * (size_t)capacity);
    if (!queries) {
        fprintf(stderr, "bench: out of memory\n");
        exit(2);
    }
    return (workload){.name = name, .vertices = vertices, .queries = queries};
}

const char *workload_kind(const workload *w)
{
    return w->vertices == 1 ? "point-triangle" : "edge-edge";
}

void workload_free(workload *w)
{
    free(w->queries);
}

// Random vertices -------------------------------------------------------------

enum {
    RANDOM_QUERIES = 20000
};

typedef void fill_query(generator *random, double at[2][TF_AXES],
                        const double corner[TF_AXES], double size);

static workload random_workload(const char *name, int vertices, double size,
                                fill_query *fill)
{
    generator random = generator_new(1);
    workload w = workload_new(name, vertices, RANDOM_QUERIES);
    for (; w.count < RANDOM_QUERIES; w.count++) {
        double corner[TF_AXES];
        for (int k = 0; k < TF_AXES; k++)
            corner[k] = uniform(&random, 0, 1 - size);
        for (int i = 0; i < QUERY_VERTICES; i++) {
            double at[2][TF_AXES];
            fill(&random, at, corner, size);
            tf_worldline *line = &w.queries[w.count].vertex[i];
            *line = tf_worldline_between(TF_AXES, at[0], at[1]);
            tf_worldline_set_vertex(line, i);
        }
    }
    return w;
}

static void fill_displaced(generator *random, double at[2][TF_AXES],
                           const double corner[TF_AXES], double size)
{
    for (int k = 0; k < TF_AXES; k++) {
        at[0][k] = uniform(random, corner[k], corner[k] + size);
        at[1][k] = at[0][k] + uniform(random, -0.1, 0.1);
    }
}

workload workload_soup(int vertices)
{
    return random_workload("soup", vertices, 1, fill_displaced);
}

workload workload_near(int vertices)
{
    return random_workload("near", vertices, 0.1, fill_displaced);
}

static void fill_lattice(generator *random, double at[2][TF_AXES],
                         const double corner[TF_AXES], double size)
{
    (void)corner;
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < TF_AXES; k++)
            at[t][k] = below(random, (int)size);
}

workload workload_lattice(int vertices)
{
    return random_workload("lattice", vertices, 4, fill_lattice);
}

// A cloth at rest -------------------------------------------------------------

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
    tf_worldline line = tf_worldline_between(TF_AXES, x, x);
    tf_worldline_set_vertex(&line, index);
    return line;
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
        for (int i = 0; i < QUERY_VERTICES; i++) {
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
        for (int j = 0; j < QUERY_VERTICES - vertices; j++)
            if (first[i] == second[j])
                return true;
    return false;
}

static void add_pair(workload *w, const int *first, const int *second)
{
    if (share_a_vertex(first, w->vertices, second))
        return;
    query q;
    for (int i = 0; i < QUERY_VERTICES; i++)
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

workload workload_rest(int vertices)
{
    lay_out_cloth();
    return vertices == 1 ? rest_points() : rest_edges();
}

// The grid --------------------------------------------------------------------

enum {
    GRID_BITS = 18 // cells to a unit: 2^18
};

workload workload_rounded(const workload *w)
{
    workload grid = workload_new(w->name, w->vertices, w->count);
    grid.count = w->count;
    grid.rounded = true;
    for (long i = 0; i < w->count; i++) {
        grid.queries[i] = w->queries[i];
        for (int v = 0; v < QUERY_VERTICES; v++)
            for (int t = 0; t < 2; t++)
                for (int k = 0; k < TF_AXES; k++) {
                    double *x = &grid.queries[i].vertex[v].at[t].x[k];
                    *x = rint(ldexp(*x, GRID_BITS));
                }
    }
    return grid;
}
