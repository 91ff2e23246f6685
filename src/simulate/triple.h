//: Declare triples of coordinates
#pragma once

#include <math.h>
#include <stddef.h>
#include <string.h>

/// A point of space, or a vector from one to another.
typedef struct tf_triple {
    double x[3];
} tf_triple;

static inline tf_triple tf_triple_at(const double x[], int vertex)
{
    tf_triple of;
    memcpy(of.x, x + (ptrdiff_t)3 * vertex, sizeof of.x);
    return of;
}

/// a + factor b.
static inline tf_triple tf_triple_sum(tf_triple a, double factor, tf_triple b)
{
    return (tf_triple){{a.x[0] + factor * b.x[0], a.x[1] + factor * b.x[1],
                        a.x[2] + factor * b.x[2]}};
}

/// The vector from a to b.
static inline tf_triple tf_triple_between(tf_triple a, tf_triple b)
{
    return tf_triple_sum(b, -1, a);
}

//: Multiply triples
static inline double tf_triple_dot(tf_triple a, tf_triple b)
{
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

static inline double tf_triple_length(tf_triple a)
{
    return sqrt(tf_triple_dot(a, a));
}

/// Of length 1; of a vector that has a length.
static inline tf_triple tf_triple_unit(tf_triple a)
{
    return tf_triple_sum((tf_triple){{0}}, 1 / tf_triple_length(a), a);
}

static inline tf_triple tf_triple_cross(tf_triple a, tf_triple b)
{
    return (tf_triple){{a.x[1] * b.x[2] - a.x[2] * b.x[1],
                        a.x[2] * b.x[0] - a.x[0] * b.x[2],
                        a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
