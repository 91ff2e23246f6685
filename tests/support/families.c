#include "support/families.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

// Families --------------------------------------------------------------------

/// A tenth of the space, and moves as long.
static query near_queries(generator *random, query_kind kind)
{
    query q = query_new(kind);
    int half = query_size(&q) / 2;
    for (int i = 0; i < half; i++) {
        double x = uniform(random, 0, 0.1);
        *query_coordinate(&q, i) = x;
        *query_coordinate(&q, i + half) = x + uniform(random, -0.1, 0.1);
    }
    return q;
}

static query lattice(generator *random, query_kind kind)
{
    return query_lattice(random, kind, 2 + below(random, 5));
}

/// A cloth at rest: flat but for rounding.
static query flat_rest(generator *random, query_kind kind)
{
    query q = query_tilted(random, kind);
    for (int v = 0; v < QUERY_VERTICES; v++)
        for (int k = 0; k < TF_AXES; k++)
            q.vertex[v].at[1].x[k] = q.vertex[v].at[0].x[k];
    return q;
}

static query scaled_by(generator *random, query q, int exponent)
{
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, (below(random, 3) - 1) * exponent);
    return q;
}

static query scaled_axes(generator *random, query_kind kind)
{
    return scaled_by(random, query_any(random, kind), 700);
}

/// Around the ends of the range that the filter decides.
static query at_the_limits(generator *random, query_kind kind)
{
    query q = query_any(random, kind);
    return scaled_by(random, q, 295 + below(random, 10));
}

static query ulp_off(generator *random, query_kind kind)
{
    query q = query_touching(random, kind);
    query_nudge(random, &q, 1);
    return q;
}

/// Nudged integers: determinants of the size of their errors.
static query ulp_off_lattice(generator *random, query_kind kind)
{
    query q = lattice(random, kind);
    query_nudge(random, &q, 1);
    return q;
}

static query scaled_any(generator *random, query_kind kind, int exponent)
{
    query q = below(random, 2) ? query_any(random, kind)
                               : query_lattice(random, kind, 4);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, exponent);
    return q;
}

static query subnormal(generator *random, query_kind kind)
{
    // The coordinates themselves, or only products of three.
    int exponent = below(random, 2) ? -1070 : -365;
    return scaled_any(random, kind, exponent + below(random, 50));
}

static query huge(generator *random, query_kind kind)
{
    return scaled_any(random, kind, 990 + below(random, 30));
}

/// Neighbors in a flat sheet, sheared or not: at rest, moved as a whole, or each
/// vertex on its own way in the plane.
static query flat_grid(generator *random, query_kind kind)
{
    query q = query_new(kind);
    double shear = below(random, 5) / 4.0, drift[2] = {0, 0};
    bool rests = below(random, 3) == 0, bends = below(random, 3) == 0;
    for (int k = 0; k < 2 && !rests; k++)
        drift[k] = uniform(random, -2, 2);
    for (int v = 0; v < QUERY_VERTICES; v++) {
        double x = below(random, 4), y = below(random, 4);
        const double at[2] = {x + shear * y, y};
        for (int k = 0; k < 2; k++) {
            double bend = bends ? uniform(random, -1, 1) : 0;
            q.vertex[v].at[0].x[k] = at[k];
            q.vertex[v].at[1].x[k] = at[k] + drift[k] + bend;
        }
    }
    return q;
}

static query ulp_off_flat(generator *random, query_kind kind)
{
    query q = flat_grid(random, kind);
    query_nudge(random, &q, 1);
    for (int v = 0; v < QUERY_VERTICES; v++)
        for (int t = 0; t < 2; t++)
            q.vertex[v].at[t].x[2] = 0;
    return q;
}

/// Turns what lies in the plane z = 0 into another, by two turns.
static void turn(const double angle[2], double x[3])
{
    double y = cos(angle[0]) * x[0] - sin(angle[0]) * x[1];
    double z = sin(angle[0]) * x[0] + cos(angle[0]) * x[1];
    x[0] = cos(angle[1]) * y;
    x[1] = z;
    x[2] = sin(angle[1]) * y;
}

/// Flat but for rounding at each end, turned on the way or not.
static query flat_and_turned(generator *random, query_kind kind)
{
    query q = flat_grid(random, kind);
    double angle[2][2];
    for (int k = 0; k < 2; k++) {
        angle[0][k] = uniform(random, -4, 4);
        angle[1][k] = angle[0][k];
    }
    if (below(random, 2))
        angle[1][below(random, 2)] += uniform(random, -1, 1);
    for (int v = 0; v < QUERY_VERTICES; v++)
        for (int t = 0; t < 2; t++)
            turn(angle[t], q.vertex[v].at[t].x);
    return q;
}

const family families[FAMILIES] = {
    {"soup", query_soup},
    {"near", near_queries},
    {"lattice", lattice},
    {"tilted", query_tilted},
    {"flat at rest", flat_rest},
    {"flat", flat_grid},
    {"flat and turned", flat_and_turned},
    {"an ulp off flat", ulp_off_flat},
    {"resting", query_resting},
    {"axes scaled by 2^700", scaled_axes},
    {"axes scaled by 2^300", at_the_limits},
    {"an ulp off contact", ulp_off},
    {"an ulp off lattice", ulp_off_lattice},
    {"subnormal", subnormal},
    {"about 1e300", huge},
};
