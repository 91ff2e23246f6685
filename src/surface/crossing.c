//: Find the side on which a point lies
#include "surface/crossing.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"

static tf_event event_at(int axes, const double *x)
{
    tf_event event = {.vertex = TF_NO_INDEX};
    for (int k = 0; k < axes; k++)
        event.x[k] = x[k];
    return event;
}

/// The sign of the volume (in the plane the area) that the points span: of the
/// determinant of their differences from the first of them.
static tf_sign side(int axes, const double *const point[])
{
    tf_event event[TF_AXES + 1];
    tf_differences d = {.n = axes};
    for (int i = 0; i <= axes; i++)
        event[i] = event_at(axes, point[i]);
    for (int k = 0; k < axes; k++) {
        d.from[k] = &event[0];
        d.to[k] = &event[k + 1];
        d.axis[k] = k;
    }
    return tf_exact.sign(&d);
}

static tf_sign side_in_space(const double *a, const double *b, const double *c,
                             const double *d)
{
    const double *const point[] = {a, b, c, d};
    return side(3, point);
}

bool tf_are_coplanar(const double *a, const double *b, const double *c,
                     const double *d)
{
    return side_in_space(a, b, c, d) == TF_ZERO;
}

//: Pass an edge through a triangle
bool tf_edge_crosses_triangle(const double *a, const double *b, const double *c,
                              const double *d, const double *e)
{
    // The ends are on opposite sides of the plane, and the line turns the same
    // way around all three edges.
    tf_sign first = side_in_space(a, c, d, e);
    if (first == TF_ZERO || side_in_space(b, c, d, e) != (tf_sign)-first)
        return false;
    tf_sign turn = side_in_space(a, b, c, d);
    return turn != TF_ZERO && side_in_space(a, b, d, e) == turn &&
           side_in_space(a, b, e, c) == turn;
}

//: Cross two edges in the plane
static tf_sign side_in_plane(const double *a, const double *b, const double *c)
{
    const double *const point[] = {a, b, c};
    return side(2, point);
}

/// Whether two intervals with ends in any order overlap.
static bool intervals_overlap(double a, double b, double c, double d)
{
    double low = a < b ? a : b, high = a < b ? b : a;
    return (c < d ? c : d) <= high && low <= (c < d ? d : c);
}

bool tf_edges_cross(const double *a, const double *b, const double *c,
                    const double *d)
{
    for (int k = 0; k < 2; k++)
        if (!intervals_overlap(a[k], b[k], c[k], d[k]))
            return false;
    // On one line, edges whose intervals overlap cross.  Otherwise neither may
    // lie on one side of the other's line.
    tf_sign of_c = side_in_plane(a, b, c), of_d = side_in_plane(a, b, d);
    tf_sign of_a = side_in_plane(c, d, a), of_b = side_in_plane(c, d, b);
    return of_c * of_d <= 0 && of_a * of_b <= 0;
}
