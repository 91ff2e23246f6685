//: Include what finding coincident vertices needs
#include "scenes/coincident.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

//: Measure distances
double tf_distance_between(const double x[3], const double y[3])
{
    return hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]);
}

double tf_least_within(int vertices, const double position[])
{
    double greatest = 0;
    for (size_t i = 0; i < 3 * (size_t)vertices; i++)
        greatest = fmax(greatest, fabs(position[i]));
    return 0x1p-50 * greatest;
}

//: Divide space into cells
/// The vertices that coincide with none, in a table of cells of the side
/// 2 `within`, so that a ball of that radius has parts of at most eight.
/// Without a distance each position is a cell.
typedef struct cells {
    const double *x;
    double within;
    int *bucket; ///< the last vertex of each, counted from 1; 0: none
    int *next;   ///< of each vertex, the one before it in its bucket
    size_t buckets;
} cells;

static double cell_of(const cells *c, double coordinate)
{
    return c->within > 0 ? floor(coordinate / (2 * c->within)) : coordinate;
}

static int *bucket_of(const cells *c, const double cell[3])
{
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        double side = cell[k] + 0.0; // which is not -0
        uint64_t bits;
        memcpy(&bits, &side, sizeof bits);
        hash = (hash ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
        hash ^= hash >> 32;
    }
    return &c->bucket[hash & (c->buckets - 1)];
}

static const double *place_of(const cells *c, int vertex)
{
    return c->x + 3 * (size_t)vertex;
}

//: Find the nearest vertex that is left
/// A vertex, -1 for none, and how far it is.
typedef struct neighbor {
    int vertex;
    double distance;
} neighbor;

static void search_bucket(const cells *c, int bucket, const double x[3],
                          neighbor *best)
{
    for (int v = bucket - 1; v >= 0; v = c->next[v] - 1) {
        double distance = tf_distance_between(place_of(c, v), x);
        bool nearer = distance < best->distance ||
                      (distance == best->distance && v < best->vertex);
        if (distance <= c->within && (best->vertex < 0 || nearer))
            *best = (neighbor){v, distance};
    }
}

/// In all cells that have a part of the ball around x.
static int find_nearest(const cells *c, const double x[3])
{
    double low[3], high[3];
    neighbor best = {-1, INFINITY};
    for (int k = 0; k < 3; k++) {
        low[k] = cell_of(c, x[k] - c->within);
        high[k] = cell_of(c, x[k] + c->within);
    }
    for (int i = 0; i < 8; i++) {
        double cell[3];
        bool again = false;
        for (int k = 0; k < 3; k++) {
            bool upper = i >> k & 1;
            cell[k] = upper ? high[k] : low[k];
            again = again || (upper && high[k] == low[k]);
        }
        if (!again)
            search_bucket(c, *bucket_of(c, cell), x, &best);
    }
    return best.vertex;
}

static void put_in_cell(const cells *c, int vertex)
{
    const double *x = place_of(c, vertex);
    double cell[3] = {cell_of(c, x[0]), cell_of(c, x[1]), cell_of(c, x[2])};
    int *bucket = bucket_of(c, cell);
    c->next[vertex] = *bucket;
    *bucket = vertex + 1;
}

//: Find coincident vertices
static bool begin_cells(cells *c, int vertices)
{
    c->buckets = 1;
    while (c->buckets < 2 * (size_t)vertices)
        c->buckets *= 2;
    c->bucket = calloc(c->buckets, sizeof *c->bucket);
    c->next = malloc(((size_t)vertices + 1) * sizeof *c->next);
    return c->bucket && c->next;
}

bool tf_find_coincident(int vertices, const double position[], double within,
                        int first[])
{
    cells c = {.x = position, .within = within};
    bool good = begin_cells(&c, vertices);
    for (int v = 0; v < vertices && good; v++) {
        int nearest = find_nearest(&c, place_of(&c, v));
        first[v] = nearest >= 0 ? nearest : v;
        if (nearest < 0)
            put_in_cell(&c, v);
    }
    free(c.bucket);
    free(c.next);
    return good;
}
