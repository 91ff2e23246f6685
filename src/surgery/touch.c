//: Include what touching needs
#include "surgery/touch.h"

//: Compare ranges on an axis
static bool is_between(double x, double a, double b)
{
    return (a <= x && x <= b) || (b <= x && x <= a);
}

/// The range of a triangle is that of two of its sides.
static bool is_in_range(int axis, const double *p, const double *const t[3])
{
    double x = p[axis];
    return is_between(x, t[0][axis], t[1][axis]) ||
           is_between(x, t[1][axis], t[2][axis]);
}

/// Whether all of an edge is before all of a triangle, or after it.
static bool is_out_of_range(int axis, const double *p, const double *q,
                            const double *const t[3])
{
    double a = t[0][axis], b = t[1][axis], c = t[2][axis];
    double low = p[axis] < q[axis] ? p[axis] : q[axis];
    double high = p[axis] < q[axis] ? q[axis] : p[axis];
    return (a < low && b < low && c < low) ||
           (a > high && b > high && c > high);
}

//: Find a point in a projected triangle
/// From a point outside, some sides turn left and some right; or the triangle
/// lies on a line with the point, which is not between.
static bool point_in_plane(const int plane[2], const double *p,
                           const double *const t[3])
{
    if (!is_in_range(plane[0], p, t) || !is_in_range(plane[1], p, t))
        return false;
    bool left = false, right = false;
    for (int i = 0; i < 3; i++) {
        tf_sign turn = tf_turn(plane, p, t[i], t[(i + 1) % 3]);
        left |= turn == TF_POSITIVE;
        right |= turn == TF_NEGATIVE;
    }
    return !(left && right);
}

//: Find where projected edges meet
static bool ranges_overlap(int axis, const double *a, const double *b,
                           const double *c, const double *d)
{
    return is_between(a[axis], c[axis], d[axis]) ||
           is_between(b[axis], c[axis], d[axis]) ||
           is_between(c[axis], a[axis], b[axis]);
}

/// Neither edge is on one side of the other's line; on one line, they overlap.
static bool edges_in_plane(const int plane[2], const double *a, const double *b,
                           const double *c, const double *d)
{
    return ranges_overlap(plane[0], a, b, c, d) &&
           ranges_overlap(plane[1], a, b, c, d) &&
           tf_turn(plane, a, b, c) * tf_turn(plane, a, b, d) <= 0 &&
           tf_turn(plane, c, d, a) * tf_turn(plane, c, d, b) <= 0;
}

//: Touch in one plane
// Of elements of one plane, one of the three projections is one to one, also if
// all is on one line, and decides; the others can only agree.
bool tf_point_touches_triangle(const double *p, const double *const t[3])
{
    if (tf_side(t[0], t[1], t[2], p) != TF_ZERO)
        return false;
    for (int i = 0; i < 3; i++)
        if (!point_in_plane(tf_planes[i], p, t))
            return false;
    return true;
}

static bool edges_touch(const double *a, const double *b, const double *c,
                        const double *d)
{
    if (tf_side(a, b, c, d) != TF_ZERO)
        return false;
    for (int i = 0; i < 3; i++)
        if (!edges_in_plane(tf_planes[i], a, b, c, d))
            return false;
    return true;
}

/// Whether an edge touches a triangle that it lies in the plane of, or that is
/// collinear.
static bool edge_touches_flat(const double *p, const double *q,
                              const double *const t[3])
{
    return tf_point_touches_triangle(p, t) || edges_touch(p, q, t[0], t[1]) ||
           edges_touch(p, q, t[1], t[2]) || edges_touch(p, q, t[2], t[0]);
}

//: Touch a triangle with an edge
/// Whether a line, not in the plane of the triangle, misses it: it turns one way
/// around one side, and the other way around another.
static bool line_misses(const double *p, const double *q,
                        const double *const t[3])
{
    bool left = false, right = false;
    for (int i = 0; i < 3; i++) {
        tf_sign turn = tf_side(p, q, t[i], t[i == 2 ? 0 : i + 1]);
        left |= turn == TF_POSITIVE;
        right |= turn == TF_NEGATIVE;
    }
    return left && right;
}

bool tf_edge_touches_triangle(const double *p, const double *q,
                              const double *const t[3])
{
    for (int k = 0; k < 3; k++)
        if (is_out_of_range(k, p, q, t))
            return false;
    tf_sign of_p = tf_side(t[0], t[1], t[2], p);
    tf_sign of_q = tf_side(t[0], t[1], t[2], q);
    if (of_p == of_q)
        return of_p == TF_ZERO && edge_touches_flat(p, q, t);
    return !line_misses(p, q, t);
}

//: Find what two triangles share
/// Which corner of a triangle a vertex is; -1: none.
static int corner_of(const tf_facet *facet, int vertex)
{
    for (int i = 0; i < 3; i++)
        if (facet->vertex[i] == vertex)
            return i;
    return -1;
}

/// How many vertices two triangles share; the corners of `a` that are one of them
/// and one that only `a` has.
static int shared(const tf_facet *a, const tf_facet *b, int *common, int *own)
{
    int count = 0;
    for (int i = 0; i < 3; i++) {
        bool both = corner_of(b, a->vertex[i]) >= 0;
        count += both;
        *(both ? common : own) = i;
    }
    return count;
}

//: Separate triangles by the plane of one
/// Whether all of `b` is strictly on one side of the plane of `a`.
static bool is_beside(const tf_facet *a, const tf_facet *b)
{
    const double *const *t = a->corner;
    tf_sign side = tf_side(t[0], t[1], t[2], b->corner[0]);
    return side != TF_ZERO && tf_side(t[0], t[1], t[2], b->corner[1]) == side &&
           tf_side(t[0], t[1], t[2], b->corner[2]) == side;
}

//: Overlap beyond a common edge
/// Whether two triangles on a common edge lie in one plane, on the same side of
/// that edge.
static bool is_folded(const tf_facet *a, int own_a, const tf_facet *b,
                      int own_b)
{
    const double *p = a->corner[own_a], *q = b->corner[own_b];
    const double *from = a->corner[(own_a + 1) % 3];
    const double *to = a->corner[(own_a + 2) % 3];
    if (tf_side(from, to, p, q) != TF_ZERO)
        return false;
    for (int i = 0; i < 3; i++)
        if (tf_turn(tf_planes[i], from, to, p) *
                tf_turn(tf_planes[i], from, to, q) >
            0)
            return true;
    return false;
}

//: Overlap beyond a common vertex
/// Whether the side of `a` that is opposite to a vertex meets `b`.
static bool far_side_touches(const tf_facet *a, int vertex, const tf_facet *b)
{
    return tf_edge_touches_triangle(a->corner[(vertex + 1) % 3],
                                    a->corner[(vertex + 2) % 3], b->corner);
}

static bool some_side_touches(const tf_facet *a, const tf_facet *b)
{
    for (int i = 0; i < 3; i++)
        if (far_side_touches(a, i, b))
            return true;
    return false;
}

//: Overlap
bool tf_facets_overlap(const tf_facet *a, const tf_facet *b)
{
    int common_a = 0, own_a = 0, common_b = 0, own_b = 0;
    int count = shared(a, b, &common_a, &own_a);
    shared(b, a, &common_b, &own_b);
    if (count == 3)
        return true;
    if (count == 2)
        return is_folded(a, own_a, b, own_b);
    if (count == 1)
        return far_side_touches(a, common_a, b) ||
               far_side_touches(b, common_b, a);
    return !is_beside(a, b) && !is_beside(b, a) &&
           (some_side_touches(a, b) || some_side_touches(b, a));
}
