/* Exercise 22.2.  Does a moving triangle sweep over an edge?
 *
 * A corner of a triangle moves from `from` to `to` in a straight line; the two
 * others, x and y, are at rest.  So is an edge from p to q, which has no corner
 * in common with the triangle.  Return whether the edge and the triangle meet
 * at any time, exactly, without looking at any time in between.
 *
 * `tf_side` and `tf_edge_touches_triangle` are in "surgery/touch.h".
 *
 * Section: Five tests.
 *
 * Hint 1: The triangle sweeps over the tetrahedron of `from`, `to`, x and y.
 *     Does the edge meet it?
 * Hint 2: An edge may meet a tetrahedron without touching any of its faces.
 * Hint 3: A point is inside if, put in the place of any of the corners, it
 *     leaves the sign of the volume as it is.
 */
#include "surgery/touch.h"

/// Whether a point is inside a tetrahedron, which may be flat: then it is not.
static bool is_inside(const double *const corner[4], const double *p)
{
    tf_sign whole = tf_side(corner[0], corner[1], corner[2], corner[3]);
    for (int i = 0; i < 4; i++) {
        const double *x[4];
        for (int j = 0; j < 4; j++)
            x[j] = j == i ? p : corner[j];
        if (tf_side(x[0], x[1], x[2], x[3]) != whole)
            return false;
    }
#if defined TF_WRONG_1 // an edge inside touches no face, either
    return whole == TF_ZERO;
#else
    return whole != TF_ZERO;
#endif
}

bool is_swept_over(const double from[3], const double to[3], const double x[3],
                   const double y[3], const double p[3], const double q[3])
{
    const double *const corner[] = {from, to, x, y};
#if defined TF_SOLUTION || defined TF_WRONG_1
    for (int i = 0; i < 4; i++) {
        const double *face[3];
        for (int j = 0; j < 3; j++)
            face[j] = corner[(i + 1 + j) % 4];
        if (tf_edge_touches_triangle(p, q, face))
            return true;
    }
    return is_inside(corner, p);
#elif defined TF_WRONG_2 // looks only at the start and the end
    for (int i = 0; i < 2; i++) {
        const double *face[3] = {corner[i], x, y};
        if (tf_edge_touches_triangle(p, q, face))
            return true;
    }
    return is_inside(corner, p);
#elif defined TF_WRONG_3 // looks only at the ends of the edge
    return is_inside(corner, p) || is_inside(corner, q);
#else
    // Your turn: what does the triangle sweep over, and what of it may an edge
    // meet?
    return is_inside(corner, p);
#endif
}
