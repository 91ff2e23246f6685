/* Exercise 23.1.  Sideways: smoothing that keeps the volume.
 *
 * A vertex is at `from`, in the middle of a star of `count` triangles, whose
 * ring of neighbors is given in order, counterclockwise as seen from outside.
 * Smoothing would like to move the vertex to `wanted`.  Find the position
 * nearest to that to which the vertex can go so that the volume that the surface
 * encloses does not change.  If the vector area of the ring is zero, any
 * position will do.
 *
 * Section: Where the volume goes.
 *
 * Hint 1: The vector area depends only on the ring.  Add up the cross products
 *     of neighbors that follow each other, and do not forget the last and the
 *     first one.
 * Hint 2: Which part of the way from `from` to `wanted` changes the volume?
 * Hint 3: The component of w along A is (w . A) / (A . A) times A.  The length
 *     of A cancels, so half of A, or twice of it, will do as well.
 */
#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Twice the vector area of a ring.
static void add_up(int count, const double ring[][3], double area[3])
{
    for (int k = 0; k < 3; k++)
        area[k] = 0;
#if defined TF_WRONG_1 // leaves the ring open
    count--;
    for (int i = 0; i < count; i++) {
        const double *a = ring[i], *b = ring[i + 1];
#else
    for (int i = 0; i < count; i++) {
        const double *a = ring[i], *b = ring[(i + 1) % count];
#endif
        for (int k = 0; k < 3; k++)
            area[k] += a[(k + 1) % 3] * b[(k + 2) % 3] -
                       a[(k + 2) % 3] * b[(k + 1) % 3];
    }
}

void move_sideways(int count, const double ring[][3], const double from[3],
                   const double wanted[3], double position[3])
{
    double area[3];
    add_up(count, ring, area);
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    double way[3];
    for (int k = 0; k < 3; k++)
#if defined TF_WRONG_2 // takes the component of the position, not of the way
        way[k] = wanted[k] + 0 * from[k];
#else
        way[k] = wanted[k] - from[k];
#endif
    double square = dot(area, area);
    double part = square > 0 ? dot(way, area) / square : 0;
    for (int k = 0; k < 3; k++)
        position[k] = wanted[k] - part * area[k];
#elif defined TF_WRONG_3 // keeps only what it should take away
    double part = dot(wanted, area) - dot(from, area);
    for (int k = 0; k < 3; k++)
        position[k] = from[k] + part / fmax(dot(area, area), 1e-300) * area[k];
#else
    // Your turn: this changes the volume.
    for (int k = 0; k < 3; k++)
        position[k] = wanted[k] + 0 * from[k] * dot(area, area);
#endif
}
