// Queries to try: two moving elements, made at random to be hard.
#ifndef SUPPORT_QUERIES_H
#define SUPPORT_QUERIES_H

#include "geometry/event.h"
#include "support/support.h"

typedef enum query_kind {
    POINT_EDGE,
    POINT_TRIANGLE,
    EDGE_EDGE
} query_kind;

enum {
    KINDS = EDGE_EDGE + 1,
    QUERY_VERTICES = 4
};

/// The vertices of the first element, then those of the second.
typedef struct query {
    int axes, vertices, others;
    tf_worldline vertex[QUERY_VERTICES];
} query;

/// The query of a kind with everything at the origin.
query query_new(query_kind kind);

/// How many coordinates a query has, and the i-th: by time, vertex and axis, as
/// in a query file.
int query_size(const query *q);
double *query_coordinate(query *q, int i);

/// The second element's vertices.
tf_worldline *query_others(query *q);
const tf_worldline *query_const_others(const query *q);

/// "point-edge", "point-triangle" or "edge-edge".
const char *query_name(const query *q);

/// Number the vertices: first element, then second.
void query_number(query *q);

/// The rows of a query file in hexadecimal floats.  Static storage.
const char *query_text(const query *q);

/// Coordinates from 0, 1, ..., n - 1: degenerate most of the time.
query query_lattice(generator *random, query_kind kind, int n);

/// Coordinates anywhere in [-1, 1).
query query_soup(generator *random, query_kind kind);

/// Two elements, as query_soup, shifted to touch at a random time.
query query_touching(generator *random, query_kind kind);

/// All of it on one slanted plane, but for rounding, moving in the plane.
query query_tilted(generator *random, query_kind kind);

/// An element at rest on another that does not move: on a vertex, on an edge or
/// inside.
query query_resting(generator *random, query_kind kind);

/// The first element moves along the first edge of the second, in parallel if
/// it is an edge.
query query_parallel(generator *random, query_kind kind);

/// As query_soup, but some of the vertices of an element coincide.
query query_collapsed(generator *random, query_kind kind);

/// Magnitudes from 4.9e-324 to 1.7e308, mixed.
query query_extreme(generator *random, query_kind kind);

/// One of the above, but lattice and extreme.
query query_any(generator *random, query_kind kind);

/// Move each coordinate by -ulps..ulps units in the last place.
void query_nudge(generator *random, query *q, int ulps);

/// Multiply the coordinates of one axis by 2^exponent.
void query_scale(query *q, int axis, int exponent);

/// Take vertices whose coordinates are integers up to 16 in absolute value by a
/// random affine map to integers below 2^bits, bits = 8 to 53.  What was on a
/// line or in a plane remains so.
void query_shear(generator *random, query *q, int bits);

/// The point of an element's staircase sweep at the time t, 0 to 1, that has
/// the given weights of the vertices.
void staircase_point(int axes, int vertices, const tf_worldline element[],
                     const double weight[], double t, double point[]);

#endif
