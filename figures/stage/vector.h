// Vectors of three doubles; every result may be one of the arguments.
#ifndef TF_STAGE_VECTOR_H
#define TF_STAGE_VECTOR_H

#include <math.h>

static inline double tf_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// sum = a + scale b
static inline void tf_add(const double a[3], double scale, const double b[3],
                          double sum[3])
{
    for (int k = 0; k < 3; k++)
        sum[k] = a[k] + scale * b[k];
}

static inline void tf_cross(const double a[3], const double b[3],
                            double product[3])
{
    double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                   a[0] * b[1] - a[1] * b[0]};
    tf_add(c, 0, c, product);
}

/// Scale to length 1, if it is not zero.  Returns the length before.
static inline double tf_normalize(double a[3])
{
    double length = sqrt(tf_dot(a, a));
    for (int k = 0; k < 3 && length > 0; k++)
        a[k] /= length;
    return length;
}

#endif
