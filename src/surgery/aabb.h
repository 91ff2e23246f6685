//: Declare bounding boxes
#pragma once

#include <math.h>
#include <stdbool.h>

/// A closed box with sides along the axes, in the coordinates of the surface,
/// which it has without rounding.
typedef struct tf_aabb {
    double low[3], high[3];
} tf_aabb;

/// Holds nothing, and overlaps none.
static inline tf_aabb tf_aabb_empty(void)
{
    return (tf_aabb){{INFINITY, INFINITY, INFINITY},
                     {-INFINITY, -INFINITY, -INFINITY}};
}

static inline void tf_aabb_add(tf_aabb *box, const double *x)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = x[k] < box->low[k] ? x[k] : box->low[k];
        box->high[k] = x[k] > box->high[k] ? x[k] : box->high[k];
    }
}

//: Join and compare bounding boxes
static inline tf_aabb tf_aabb_union(tf_aabb a, const tf_aabb *b)
{
    for (int k = 0; k < 3; k++) {
        a.low[k] = b->low[k] < a.low[k] ? b->low[k] : a.low[k];
        a.high[k] = b->high[k] > a.high[k] ? b->high[k] : a.high[k];
    }
    return a;
}

static inline bool tf_aabbs_overlap(const tf_aabb *a, const tf_aabb *b)
{
    for (int k = 0; k < 3; k++)
        if (!(a->low[k] <= b->high[k] && b->low[k] <= a->high[k]))
            return false;
    return true;
}
