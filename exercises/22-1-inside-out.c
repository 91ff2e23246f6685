/* Exercise 22.1.  Inside out: the volume that a surface encloses.
 *
 * A closed surface is given as an adaptive surface lends it: three vertices for
 * each triangle, counterclockwise as seen from outside, and gaps, triangles
 * that are gone, whose first vertex is -1.  The coordinates are whole numbers
 * of at most 1000 in absolute value.  Return six times the volume that the
 * surface encloses: negative if it is inside out.
 *
 * Section: A surface that changes.
 *
 * Hint 1: Join each triangle to the origin.  The volumes of these tetrahedra,
 *     with their signs, add up to that of the surface, wherever the origin is.
 * Hint 2: Six times the volume of the tetrahedron of the origin and a triangle
 *     abc is the determinant of a, b and c.
 * Hint 3: A determinant of whole numbers is a whole number.  There is nothing
 *     to divide and nothing to round.
 */
#include <stdlib.h>

/// The determinant of three columns.
static long determinant(const int a[3], const int b[3], const int c[3])
{
    long sum = 0;
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;
        sum += (long)a[k] * ((long)b[l] * c[m] - (long)b[m] * c[l]);
    }
    return sum;
}

long six_volumes(int triangles, const int triangle[][3], const int place[][3])
{
    long sum = 0;
    for (int t = 0; t < triangles; t++) {
        const int *v = triangle[t];
#if defined TF_SOLUTION
        if (v[0] >= 0)
            sum += determinant(place[v[0]], place[v[1]], place[v[2]]);
#elif defined TF_WRONG_1 // a volume is never negative
        if (v[0] >= 0)
            sum += labs(determinant(place[v[0]], place[v[1]], place[v[2]]));
#elif defined TF_WRONG_2 // rounds each part
        if (v[0] >= 0)
            sum += determinant(place[v[0]], place[v[1]], place[v[2]]) / 6 * 6;
#elif defined TF_WRONG_3 // the other side is out
        if (v[0] >= 0)
            sum += determinant(place[v[0]], place[v[2]], place[v[1]]);
#elif defined TF_WRONG_4 // stops at the first gap
        if (v[0] < 0)
            break;
        sum += determinant(place[v[0]], place[v[1]], place[v[2]]);
#else
        // Your turn: what does a triangle contribute?
        sum += v[0] >= 0 && determinant(place[0], place[0], place[0]);
#endif
    }
    return sum;
}
