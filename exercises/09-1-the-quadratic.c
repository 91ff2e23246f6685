/* Exercise 9.1.  The quadratic of a point and an edge.
 *
 * A point and the two ends of an edge move in the plane, each in a straight
 * line, and the edge stays straight.  The determinant of the edge and the way
 * from its first end to the point is a polynomial c[0] + c[1] t + c[2] t^2 in
 * time.  Find its coefficients.
 *
 * Section: Where the quadratic comes from.
 *
 * Hint 1: Two difference vectors matter: from the first end of the edge to the
 *     second, and from the first end to the point.  Each of them is d + t v.
 * Hint 2: v is the difference of the two displacements, end minus start.
 * Hint 3: The determinant of a + t b and d + t v is a x d, plus t times two
 *     mixed determinants, plus t^2 times b x v.
 */
#include "geometry/event.h"

static double det(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/// A vector that changes at a constant rate: at[k] + t rate[k].
typedef struct moving_vector {
    double at[2], rate[2];
} moving_vector;

static moving_vector between(const tf_worldline *from, const tf_worldline *to)
{
    moving_vector v;
    for (int k = 0; k < 2; k++) {
        v.at[k] = to->at[0].x[k] - from->at[0].x[k];
#if defined TF_WRONG_1 // takes the end of the step for the rate
        v.rate[k] = to->at[1].x[k] - from->at[1].x[k];
#else
        v.rate[k] = to->at[1].x[k] - from->at[1].x[k] - v.at[k];
#endif
    }
    return v;
}

void find_quadratic(const tf_worldline *point, const tf_worldline edge[2],
                    double c[3])
{
    moving_vector e = between(&edge[0], &edge[1]);
    moving_vector p = between(&edge[0], point);
    c[0] = det(e.at, p.at);
#if defined TF_SOLUTION || defined TF_WRONG_1
    c[1] = det(e.at, p.rate) + det(e.rate, p.at);
    c[2] = det(e.rate, p.rate);
#elif defined TF_WRONG_2 // forgets that the edge moves, too
    c[1] = det(e.at, p.rate);
    c[2] = 0;
#elif defined TF_WRONG_3 // swaps the columns of one of the two
    c[1] = det(e.at, p.rate) + det(p.at, e.rate);
    c[2] = det(e.rate, p.rate);
#else
    // Your turn: two more coefficients.
    c[1] = c[2] = 0;
#endif
}
