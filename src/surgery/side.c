//: Include what sides need
#include "surgery/side.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"

#include <float.h>
#include <math.h>

//: Compute a sign by the exact arithmetic
static tf_sign exact_turn(int n, const int axis[], const double *const point[])
{
    tf_event event[TF_AXES + 1];
    tf_differences d = {.n = n};
    for (int i = 0; i <= n; i++) {
        event[i] = (tf_event){.vertex = TF_NO_INDEX};
        for (int k = 0; k < TF_AXES; k++)
            event[i].x[k] = point[i][k];
    }
    for (int i = 0; i < n; i++) {
        d.from[i] = &event[0];
        d.to[i] = &event[i + 1];
        d.axis[i] = axis[i];
    }
    return tf_exact.sign(&d);
}

//: Try the rounded volume first
// Each of the six products goes through seven roundings, as in the filter of the
// exact arithmetic, so the volume is off by less than eight units of round-off
// times the permanent.
#define VOLUME_SHARE (8 * (DBL_EPSILON / 2))

tf_sign tf_side(const double *a, const double *b, const double *c,
                const double *d)
{
    double u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
        w[k] = d[k] - a[k];
    }
    double volume = 0, permanent = 0, row = 1;
    for (int k = 0; k < 3; k++) {
        int l = k == 2 ? 0 : k + 1, m = k == 0 ? 2 : k - 1;
        double one = v[l] * w[m], other = v[m] * w[l];
        volume += u[k] * (one - other);
        permanent += fabs(u[k]) * (fabs(one) + fabs(other));
        row += fabs(u[k]);
    }
    // What underflow can lose rounds away where the permanent is this large.
    if (fabs(volume) > VOLUME_SHARE * permanent && permanent * 0x1p961 > row)
        return volume > 0 ? TF_POSITIVE : TF_NEGATIVE;
    static const int space[] = {0, 1, 2};
    return exact_turn(3, space, (const double *const[]){a, b, c, d});
}

//: Turn in a coordinate plane
const int tf_planes[3][2] = {{0, 1}, {1, 2}, {2, 0}};

// Four roundings a product; and nothing is lost where neither of them, if it is
// not zero, falls below the normal numbers.
#define AREA_SHARE (4 * (DBL_EPSILON / 2))

tf_sign tf_turn(const int axis[2], const double *a, const double *b,
                const double *c)
{
    int k = axis[0], l = axis[1];
    double one = (b[k] - a[k]) * (c[l] - a[l]);
    double other = (b[l] - a[l]) * (c[k] - a[k]);
    double area = one - other, permanent = fabs(one) + fabs(other);
    if (fabs(area) > AREA_SHARE * permanent && permanent > 0x1p-960)
        return area > 0 ? TF_POSITIVE : TF_NEGATIVE;
    return exact_turn(2, axis, (const double *const[]){a, b, c});
}

//: Recognize a collinear triangle
bool tf_are_collinear(const double *a, const double *b, const double *c)
{
    for (int i = 0; i < 3; i++)
        if (tf_turn(tf_planes[i], a, b, c) != TF_ZERO)
            return false;
    return true;
}
