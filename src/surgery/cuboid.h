//: Declare cuboids
#pragma once

#include <math.h>
#include <stdbool.h>

/// A closed box with sides along the axes, in the coordinates of the surface,
/// which it has without rounding.
typedef struct tf_cuboid {
    double low[3], high[3];
} tf_cuboid;

/// Holds nothing, and overlaps none.
static inline tf_cuboid tf_cuboid_empty(void)
{
    return (tf_cuboid){{INFINITY, INFINITY, INFINITY},
                       {-INFINITY, -INFINITY, -INFINITY}};
}

static inline void tf_cuboid_add(tf_cuboid *box, const double *x)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = x[k] < box->low[k] ? x[k] : box->low[k];
        box->high[k] = x[k] > box->high[k] ? x[k] : box->high[k];
    }
}

//: Join and compare cuboids
static inline tf_cuboid tf_cuboid_union(tf_cuboid a, const tf_cuboid *b)
{
    for (int k = 0; k < 3; k++) {
        a.low[k] = b->low[k] < a.low[k] ? b->low[k] : a.low[k];
        a.high[k] = b->high[k] > a.high[k] ? b->high[k] : a.high[k];
    }
    return a;
}

static inline bool tf_cuboids_overlap(const tf_cuboid *a, const tf_cuboid *b)
{
    for (int k = 0; k < 3; k++)
        if (!(a->low[k] <= b->high[k] && b->low[k] <= a->high[k]))
            return false;
    return true;
}
