/* Exercise 21.3.  Which way makes a crossing curve shorter?
 *
 * An edge with the direction `along` pierces a triangle with the normal `normal`
 * at a point p.  There the curve of the crossing passes from one of the edge's
 * triangles to another, or ends, if it is a border.  In each of them it goes
 * straight from p to a point that is at rest: `segment` has the vectors from p
 * to these one or two points.  The pierced triangle is at rest, too.
 *
 * Let the edge be moved by a small displacement d, without turning.  Then the
 * curve gets shorter by g . d, if we neglect squares of d.  Find g, the direction
 * that shortens the curve most.  Neither `along` nor `normal` need have the
 * length 1; their dot product is not zero.
 *
 * Section: The contour gradient.
 *
 * Hint 1: If p moves by w, a segment s gets shorter by s . w / |s|.
 * Hint 2: p moves within the plane of the triangle: by d, and by as much along
 *     the edge as it takes to be in the plane.
 * Hint 3: w = d - (normal . d) / (normal . along) along.  Write s . w as the dot
 *     product of something with d.
 */
#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Adds up what the point would gain by moving into each of the triangles.
static void add_pulls(int segments, const double segment[][3], double pull[3])
{
    for (int k = 0; k < 3; k++)
        pull[k] = 0;
    for (int i = 0; i < segments; i++)
        for (int k = 0; k < 3; k++)
#if defined TF_WRONG_1 // lets long segments pull harder
            pull[k] += segment[i][k];
#elif defined TF_WRONG_2 // moves away from the other end
            pull[k] -= segment[i][k] / sqrt(dot(segment[i], segment[i]));
#elif defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
            pull[k] += segment[i][k] / sqrt(dot(segment[i], segment[i]));
#else
            // Your turn, part one: for now nothing pulls.
            pull[k] += 0;
#endif
}

void find_gradient(const double along[3], const double normal[3], int segments,
                   const double segment[][3], double gradient[3])
{
    double pull[3];
    add_pulls(segments, segment, pull);
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    double part = dot(pull, along) / dot(normal, along);
#elif defined TF_WRONG_3 // forgets that the point slides along the edge
    double part = 0;
#elif defined TF_WRONG_4 // lets the point slide along the normal
    double part = dot(pull, normal) / dot(normal, normal);
#else
    // Your turn, part two: which multiple of the normal is it?
    double part = dot(pull, normal) / dot(normal, normal);
#endif
    for (int k = 0; k < 3; k++)
        gradient[k] = pull[k] - part * normal[k];
}
