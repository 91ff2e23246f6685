/* Exercise 25.3.  The volume between a triangle and a quadratic patch.
 *
 * The corners of a triangle have moved, and so have three points that were in
 * the middle of its sides: middle[i] is that of the side from corner[i] to
 * corner[(i + 1) % 3].  A quadratic patch passes through all six.  Find the
 * volume between the triangle and the patch, to first order: positive if the
 * patch is in front of the triangle, from where its corners go counterclockwise.
 *
 * Section: What chords lose.
 *
 * Hint 1: What counts is by how much a point has left the middle of its side,
 *     as the side is now.
 * Hint 2: The quadratic function that is 1 at one of these points and 0 at the
 *     other five has the mean 1/3.
 * Hint 3: The cross product of two sides is twice the area times the unit
 *     normal.
 */
#include <math.h>

static void find_normal(const double corner[][3], double normal[3])
{
    double one[3], other[3];
    for (int k = 0; k < 3; k++) {
        one[k] = corner[1][k] - corner[0][k];
        other[k] = corner[2][k] - corner[0][k];
    }
    for (int k = 0; k < 3; k++)
        normal[k] = one[(k + 1) % 3] * other[(k + 2) % 3] -
                    one[(k + 2) % 3] * other[(k + 1) % 3];
}

double volume_under(const double corner[][3], const double middle[][3])
{
    double normal[3], sum = 0;
    find_normal(corner, normal);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
#if defined TF_WRONG_1 // measures from the origin
            double rise = middle[i][k];
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
            double rise =
                middle[i][k] - (corner[i][k] + corner[(i + 1) % 3][k]) / 2;
#else
            // Your turn, part one: how far has the point left its side?
            double rise = 0 * middle[i][k];
#endif
            sum += rise * normal[k];
        }
#if defined TF_WRONG_3 // takes twice the area for the area
    return sum / 3;
#elif defined TF_WRONG_2 // takes a normal of length 1
    return sum / 6 /
           sqrt(normal[0] * normal[0] + normal[1] * normal[1] +
                normal[2] * normal[2]);
#elif defined TF_SOLUTION || defined TF_WRONG_1
    return sum / 6;
#else
    // Your turn, part two: which part of it?
    return 0 * sum;
#endif
}
