// How often the report's rule, to take an unknown sign for zero, calls real
// contacts apart.  Two sources of queries, all nudged by a few units in the last
// place:
//
// - those of support/queries.h that touch, rest, slide or lie in a plane;
// - a triangle that sweeps out a tetrahedron past a point at rest in the
//   origin, where two edges of the tetrahedron cross but for rounding.
//
// Prints one line a source: the nudge, the queries, those with a contact, and
// the contacts that are missed.  The same seed gives the same numbers.
#include "arithmetic/exact.h"
#include "arithmetic/published.h"
#include "support/judge.h"
#include "support/support.h"

#include <inttypes.h>
#include <stdio.h>

enum {
    QUERIES = 200000,
    TETRAHEDRA = 1000000
};

/// Where queries come from, and how many are made.
typedef struct source {
    const char *name;
    query (*make)(generator *random, query_kind kind, int ulps);
    query_kind kind;
    int ulps; ///< the farthest nudge of a coordinate
    long count;
} source;

static query nudged_query(generator *random, query_kind kind, int ulps)
{
    query q = query_any(random, kind);
    query_nudge(random, &q, ulps);
    return q;
}

/// Place two corners anywhere in a cube around the origin, and two opposite to
/// them, nearer to it.
static void place_corners(generator *random, double *corner[4])
{
    for (int i = 0; i < 2; i++) {
        double nearer = uniform(random, 0, 1);
        for (int k = 0; k < TF_AXES; k++) {
            corner[i][k] = uniform(random, -1, 1);
            corner[2 + i][k] = -nearer * corner[i][k];
        }
    }
}

/// A query whose triangle has its last vertex alone moving, from the third
/// corner of a tetrahedron to the fourth.
static query swept_tetrahedron(generator *random, query_kind kind, int ulps)
{
    query q = query_new(kind);
    tf_worldline *vertex = query_others(&q);
    place_corners(random, (double *[]){vertex[0].at[0].x, vertex[1].at[0].x,
                                       vertex[2].at[0].x, vertex[2].at[1].x});
    query_nudge(random, &q, ulps);
    for (int k = 0; k < TF_AXES; k++) {
        q.vertex[0].at[0].x[k] = q.vertex[0].at[1].x[k] = 0;
        for (int i = 0; i < 2; i++)
            vertex[i].at[1].x[k] = vertex[i].at[0].x[k];
    }
    return q;
}

static void count(const source *from)
{
    generator random = generator_new(1);
    long contacts = 0, missed = 0;
    for (long i = 0; i < from->count; i++) {
        query q = from->make(&random, from->kind, from->ulps);
        if (ask(&tf_exact, &q).verdict != TF_HIT)
            continue;
        contacts++;
        missed += ask(&tf_published, &q).verdict == TF_APART;
    }
    printf("%-15s %4d %8ld %8ld %7ld\n", from->name, from->ulps, from->count,
           contacts, missed);
    fflush(stdout); // the next takes a while
}

int main(void)
{
    static const source sources[] = {
        {"point-edge", nudged_query, POINT_EDGE, 2, QUERIES},
        {"point-triangle", nudged_query, POINT_TRIANGLE, 2, QUERIES},
        {"edge-edge", nudged_query, EDGE_EDGE, 2, QUERIES},
        {"tetrahedron", swept_tetrahedron, POINT_TRIANGLE, 1, TETRAHEDRA},
        {"tetrahedron", swept_tetrahedron, POINT_TRIANGLE, 2, TETRAHEDRA},
        {"tetrahedron", swept_tetrahedron, POINT_TRIANGLE, 3, TETRAHEDRA},
    };
    printf("seed %" PRIu64 "\n", seed());
    printf("%-15s %4s %8s %8s %7s\n", "source", "ulps", "queries", "contacts",
           "missed");
    for (size_t i = 0; i < sizeof sources / sizeof *sources; i++)
        count(&sources[i]);
    return 0;
}
