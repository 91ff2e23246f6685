/* Exercise 23.2.  A collapse that keeps the volume.
 *
 * The edge from s to d collapses into one vertex.  All triangles at s and d are
 * removed; around the hole is a ring of `count` vertices, counterclockwise as
 * seen from outside, which will be joined to the new vertex.  `before` is six
 * times the volume between the removed triangles and the origin: the sum of
 * their determinants.  Find the position of the new vertex that is nearest to
 * the middle of s and d and keeps the volume.  The vector area of the ring is
 * not zero.
 *
 * Section: Where the volume goes.
 *
 * Hint 1: What is six times the volume between the new triangles and the origin
 *     if the new vertex is at p?  It is linear in p.
 * Hint 2: What is missing if p is the middle?
 * Hint 3: The shortest shift is along the vector area.  Mind the factors: with
 *     twice the area and six times the volume, the 3 in the text becomes a 1.
 */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Twice the vector area of a ring.
static void add_up(int count, const double ring[][3], double area[3])
{
    for (int k = 0; k < 3; k++)
        area[k] = 0;
    for (int i = 0; i < count; i++) {
        const double *a = ring[i], *b = ring[(i + 1) % count];
        for (int k = 0; k < 3; k++)
            area[k] += a[(k + 1) % 3] * b[(k + 2) % 3] -
                       a[(k + 2) % 3] * b[(k + 1) % 3];
    }
}

void collapse_position(int count, const double ring[][3], const double s[3],
                       const double d[3], double before, double position[3])
{
    double area[3];
    add_up(count, ring, area);
    for (int k = 0; k < 3; k++)
        position[k] = (s[k] + d[k]) / 2;
#if defined TF_SOLUTION
    double shift = (before - dot(position, area)) / dot(area, area);
#elif defined TF_WRONG_1 // shifts to the wrong side
    double shift = (dot(position, area) - before) / dot(area, area);
#elif defined TF_WRONG_2 // takes the factor from the text
    double shift = 3 * (before - dot(position, area)) / dot(area, area);
#elif defined TF_WRONG_3 // forgets what the middle already has
    double shift = before / dot(area, area);
#else
    // Your turn: how far along the vector area?
    double shift = 0 * before * dot(position, area);
#endif
    for (int k = 0; k < 3; k++)
        position[k] += shift * area[k];
}
