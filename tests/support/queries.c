#include "support/queries.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

query query_new(query_kind kind)
{
    query q = {.axes = kind == POINT_EDGE ? 2 : 3,
               .vertices = kind == EDGE_EDGE ? 2 : 1,
               .others = kind == POINT_TRIANGLE ? 3 : 2};
    for (int i = 0; i < QUERY_VERTICES; i++) {
        q.vertex[i].at[1].t = 1;
        tf_worldline_set_vertex(&q.vertex[i], TF_NO_INDEX);
    }
    return q;
}

int query_size(const query *q)
{
    return 2 * (q->vertices + q->others) * q->axes;
}

double *query_coordinate(query *q, int i)
{
    int all = q->vertices + q->others, row = i / q->axes;
    return &q->vertex[row % all].at[row / all].x[i % q->axes];
}

tf_worldline *query_others(query *q)
{
    return q->vertex + q->vertices;
}

const tf_worldline *query_const_others(const query *q)
{
    return q->vertex + q->vertices;
}

const char *query_name(const query *q)
{
    return q->axes == 2       ? "point-edge"
           : q->vertices == 2 ? "edge-edge"
                              : "point-triangle";
}

void query_number(query *q)
{
    for (int i = 0; i < q->vertices + q->others; i++)
        tf_worldline_set_vertex(&q->vertex[i], i);
}

const char *query_text(const query *q)
{
    static char text[2048];
    query copy = *q;
    int length = 0;
    for (int i = 0; i < query_size(q); i++)
        length += snprintf(text + length, sizeof text - (size_t)length, "%a%s",
                           *query_coordinate(&copy, i),
                           i % q->axes == q->axes - 1 ? "\n" : ",");
    return text;
}

query query_lattice(generator *random, query_kind kind, int n)
{
    query q = query_new(kind);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = below(random, n);
    return q;
}

query query_soup(generator *random, query_kind kind)
{
    query q = query_new(kind);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = uniform(random, -1, 1);
    return q;
}

// Weights ---------------------------------------------------------------------

/// Weights of vertices that sum to 1; about half are zero where possible.
static void random_weights(generator *random, int vertices, double weight[])
{
    double sum = 0;
    for (int i = 0; i < vertices; i++)
        sum += weight[i] = below(random, 2) ? uniform(random, 0, 1) : 0;
    if (sum == 0)
        sum = weight[below(random, vertices)] = 1;
    for (int i = 0; i < vertices; i++)
        weight[i] /= sum;
}

void staircase_point(int axes, int vertices, const tf_worldline element[],
                     const double weight[], double t, double point[])
{
    for (int k = 0; k < axes; k++)
        point[k] = 0;

    // The last vertices are at t = 1, with t of the weight, the others at 0.
    double left = t;
    for (int i = vertices - 1; i >= 0; i--) {
        double late = fmin(weight[i], left);
        left -= late;
        for (int k = 0; k < axes; k++)
            point[k] += late * element[i].at[1].x[k] +
                        (weight[i] - late) * element[i].at[0].x[k];
    }
}

// Makers ----------------------------------------------------------------------

static void shift(query *q, const double by[])
{
    for (int i = 0; i < q->vertices; i++)
        for (int t = 0; t < 2; t++)
            for (int k = 0; k < q->axes; k++)
                q->vertex[i].at[t].x[k] += by[k];
}

query query_touching(generator *random, query_kind kind)
{
    query q = query_soup(random, kind);
    double weight[2][QUERY_VERTICES], point[2][TF_AXES], by[TF_AXES];
    double t = below(random, 4) / 3.0;
    random_weights(random, q.vertices, weight[0]);
    random_weights(random, q.others, weight[1]);
    staircase_point(q.axes, q.vertices, q.vertex, weight[0], t, point[0]);
    staircase_point(q.axes, q.others, query_others(&q), weight[1], t, point[1]);
    for (int k = 0; k < q.axes; k++)
        by[k] = point[1][k] - point[0][k];
    shift(&q, by);
    return q;
}

query query_tilted(generator *random, query_kind kind)
{
    query q = query_soup(random, kind);
    double slope[2] = {uniform(random, -1, 1), uniform(random, -1, 1)};
    double drift = below(random, 2) ? uniform(random, -1, 1) : 0;
    int last = q.axes - 1;
    for (int i = 0; i < q.vertices + q.others; i++)
        for (int t = 0; t < 2; t++) {
            double *x = q.vertex[i].at[t].x, height = t * drift;
            for (int k = 0; k < last; k++)
                height += slope[k] * x[k];
            x[last] = height;
        }
    return q;
}

/// The position `x` for a vertex at both ends.
static void hold(int axes, tf_worldline *vertex, const double x[])
{
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < axes; k++)
            vertex->at[t].x[k] = x[k];
}

query query_resting(generator *random, query_kind kind)
{
    query q = query_soup(random, kind);
    double weight[QUERY_VERTICES], point[TF_AXES];
    for (int i = 0; i < q.others; i++)
        hold(q.axes, &query_others(&q)[i], query_others(&q)[i].at[0].x);
    random_weights(random, q.others, weight);
    staircase_point(q.axes, q.others, query_others(&q), weight, 0, point);
    hold(q.axes, &q.vertex[0], point);
    return q;
}

query query_parallel(generator *random, query_kind kind)
{
    query q = query_soup(random, kind);
    const tf_event *a = &query_others(&q)[0].at[0];
    const tf_event *b = &query_others(&q)[1].at[0];
    for (int t = 0; t < 2; t++)
        for (int i = 0; i < q.vertices; i++) {
            // Quarters, so that some points fall on the ends exactly.
            double along = (below(random, 13) - 4) / 4.0;
            for (int k = 0; k < q.axes; k++)
                q.vertex[i].at[t].x[k] = a->x[k] + along * (b->x[k] - a->x[k]);
        }
    if (below(random, 2))
        for (int i = 0; i < q.others; i++)
            hold(q.axes, &query_others(&q)[i], query_others(&q)[i].at[0].x);
    return q;
}

query query_collapsed(generator *random, query_kind kind)
{
    query q = query_touching(random, kind);
    tf_worldline *other = query_others(&q);
    int ends = 1 + below(random, 3); // a bit an end of the step
    for (int t = 0; t < 2; t++)
        if (ends & 1 << t)
            other[1 + below(random, q.others - 1)].at[t] = other[0].at[t];
    if (q.vertices > 1 && below(random, 2))
        q.vertex[1] = q.vertex[0];
    return q;
}

/// A magnitude of any exponent that a double has.
static double any_magnitude(generator *random)
{
    double x = ldexp(uniform(random, 0.5, 1), below(random, 2098) - 1073);
    return x == 0 ? DBL_TRUE_MIN : x;
}

query query_extreme(generator *random, query_kind kind)
{
    // A few magnitudes a query, so that degenerate cases come up, and signs
    // that let the elements overlap.
    double pool[5] = {0, DBL_TRUE_MIN, 1};
    pool[3] = below(random, 2) ? DBL_MAX : any_magnitude(random);
    pool[4] = any_magnitude(random);
    bool free = below(random, 2);
    query q = query_new(kind);
    for (int i = 0; i < query_size(&q); i++) {
        double x = free ? any_magnitude(random) : pool[below(random, 5)];
        *query_coordinate(&q, i) = below(random, 2) ? -x : x;
    }
    return q;
}

query query_any(generator *random, query_kind kind)
{
    static query (*const makers[])(generator *, query_kind) = {
        query_soup,    query_touching, query_tilted,
        query_resting, query_parallel, query_collapsed,
    };
    int count = (int)(sizeof makers / sizeof *makers);
    return makers[below(random, count)](random, kind);
}

// Changes ---------------------------------------------------------------------

void query_nudge(generator *random, query *q, int ulps)
{
    for (int i = 0; i < query_size(q); i++) {
        int steps = below(random, 2 * ulps + 1) - ulps;
        double *x = query_coordinate(q, i);
        for (; steps > 0; steps--)
            *x = nextafter(*x, DBL_MAX);
        for (; steps < 0; steps++)
            *x = nextafter(*x, -DBL_MAX);
    }
}

void query_scale(query *q, int axis, int exponent)
{
    for (int i = axis; i < query_size(q); i += q->axes)
        *query_coordinate(q, i) = ldexp(*query_coordinate(q, i), exponent);
}

/// An integer below 2^bits in absolute value, of any number of bits up to that.
static double any_integer(generator *random, int bits)
{
    int own = below(random, bits + 1);
    double x = own == 0 ? 0 : (double)(next_bits(random) >> (64 - own));
    return below(random, 2) ? -x : x;
}

void query_shear(generator *random, query *q, int bits)
{
    // 3 * 16 * 2^(bits - 7) + 2^(bits - 1) is less than 2^bits.
    double factor[TF_AXES][TF_AXES] = {{0}}, shift[TF_AXES] = {0};
    for (int i = 0; i < q->axes; i++) {
        shift[i] = any_integer(random, bits - 1);
        for (int k = 0; k < q->axes; k++)
            factor[i][k] = any_integer(random, bits - 7);
    }
    for (int row = 0; row < query_size(q); row += q->axes) {
        double x[TF_AXES];
        for (int k = 0; k < q->axes; k++)
            x[k] = *query_coordinate(q, row + k);
        for (int i = 0; i < q->axes; i++) {
            double sum = shift[i];
            for (int k = 0; k < q->axes; k++)
                sum += factor[i][k] * x[k];
            *query_coordinate(q, row + i) = sum;
        }
    }
}
