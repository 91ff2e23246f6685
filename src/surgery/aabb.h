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

//: Choose the scale of a bounding box
/// The power of two, from 2^-1000 to 2^1000, by which the greatest coordinate of
/// a box gets nearest below 1; 1 if the box holds nothing.
static inline double tf_aabb_scale(const tf_aabb *box)
{
    double most = 0;
    int exponent = 0;
    for (int k = 0; k < 3; k++)
        most = fmax(most, fmax(fabs(box->low[k]), fabs(box->high[k])));
    if (isfinite(most))
        frexp(most, &exponent);
    return ldexp(1, exponent < -1000  ? 1000
                    : exponent > 1000 ? -1000
                                      : -exponent);
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
