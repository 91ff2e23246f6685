/* Exercise 6.2.  Is the origin in a tetrahedron?
 *
 * In the frame of the point a query is whether the origin of space lies in a
 * tetrahedron.  Decide that for corners with small integer coordinates and a
 * volume that is not zero.  The surface belongs to the tetrahedron.  A function
 * for the determinant of three corners is given.
 *
 * Section: Ten determinants.
 *
 * Hint 1: Up to a common factor, the barycentric coordinate of corner i is
 *     (-1)^i times the determinant of the other three corners.
 * Hint 2: The origin is in the tetrahedron if no two of the four coordinates
 *     have opposite signs.
 * Hint 3: So det(1, 2, 3), -det(0, 2, 3), det(0, 1, 3) and -det(0, 1, 2) must
 *     all be >= 0, or all be <= 0.
 */
#include <stdbool.h>

static double det(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) +
           a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

bool holds_origin(const double p[4][3])
{
    const double c[4] = {det(p[1], p[2], p[3]), det(p[0], p[2], p[3]),
                         det(p[0], p[1], p[3]), det(p[0], p[1], p[2])};
#if defined TF_SOLUTION
    bool above = c[0] >= 0 && -c[1] >= 0 && c[2] >= 0 && -c[3] >= 0;
    bool below = c[0] <= 0 && -c[1] <= 0 && c[2] <= 0 && -c[3] <= 0;
    return above || below;
#elif defined TF_WRONG_1 // forgets that the signs alternate
    bool above = c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[3] >= 0;
    bool below = c[0] <= 0 && c[1] <= 0 && c[2] <= 0 && c[3] <= 0;
    return above || below;
#elif defined TF_WRONG_2 // leaves the surface out
    bool above = c[0] > 0 && -c[1] > 0 && c[2] > 0 && -c[3] > 0;
    bool below = c[0] < 0 && -c[1] < 0 && c[2] < 0 && -c[3] < 0;
    return above || below;
#elif defined TF_WRONG_3 // assumes that three faces are enough
    bool above = c[0] >= 0 && -c[1] >= 0 && c[2] >= 0;
    bool below = c[0] <= 0 && -c[1] <= 0 && c[2] <= 0;
    return above || below;
#elif defined TF_WRONG_4 // assumes one orientation of all tetrahedra
    return c[0] >= 0 && -c[1] >= 0 && c[2] >= 0 && -c[3] >= 0;
#else
    // Your turn.
    return c[0] == c[1] && c[2] == c[3];
#endif
}
