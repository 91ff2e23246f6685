/* Exercise 6.2.  In a tetrahedron.
 *
 * In the frame of the point the question is whether the origin of space is in a
 * tetrahedron.  Its corners have small integer coordinates, and it has a
 * volume.  Touching counts.  The determinant of three corners, seen from the
 * origin, is given to you.
 *
 * Section: Ten determinants.
 *
 * Hint 1: The barycentric coordinate of corner i is, up to one common factor,
 *     (-1)^i times the determinant of the other three.
 * Hint 2: The origin is inside if these four do not have different signs:
 *     none positive beside a negative one.
 * Hint 3: So det(1, 2, 3), -det(0, 2, 3), det(0, 1, 3) and -det(0, 1, 2) must
 *     be all >= 0 or all <= 0.
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
#elif defined TF_WRONG_2 // touching does not count
    bool above = c[0] > 0 && -c[1] > 0 && c[2] > 0 && -c[3] > 0;
    bool below = c[0] < 0 && -c[1] < 0 && c[2] < 0 && -c[3] < 0;
    return above || below;
#elif defined TF_WRONG_3 // believes that three faces are enough
    bool above = c[0] >= 0 && -c[1] >= 0 && c[2] >= 0;
    bool below = c[0] <= 0 && -c[1] <= 0 && c[2] <= 0;
    return above || below;
#elif defined TF_WRONG_4 // believes that all tetrahedra are turned one way
    return c[0] >= 0 && -c[1] >= 0 && c[2] >= 0 && -c[3] >= 0;
#else
    // Your turn.
    return c[0] == c[1] && c[2] == c[3];
#endif
}
