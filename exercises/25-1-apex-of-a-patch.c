/* Exercise 25.1.  The apex of a patch for a given volume.
 *
 * A patch of `count` triangles, counterclockwise as seen from outside, is to be
 * replaced by the triangles between its outline and an apex.  Find the position
 * nearest to `wanted` where the apex can be put so that the surface encloses
 * more by `gain` than before.  The sum of the normals of the patch is not zero.
 *
 * Section: The level of a patch.
 *
 * Hint 1: The normal of a triangle abc is (b - a) x (c - a), as long as twice
 *     the area.  What is lost if the apex is where it is wanted?
 * Hint 2: Add up n . (x - wanted), where x is any corner.  Is it the volume?
 * Hint 3: Six times the volume.  The shortest way to gain is along the sum of
 *     the normals, N: by s N the sum grows by s N . N.
 */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void subtract(const double a[3], const double b[3], double way[3])
{
    for (int k = 0; k < 3; k++)
        way[k] = a[k] - b[k];
}

/// The cross product of two sides of a triangle.
static void find_normal(const double corner[3][3], double normal[3])
{
    double one[3], other[3];
    subtract(corner[1], corner[0], one);
    subtract(corner[2], corner[0], other);
    for (int k = 0; k < 3; k++)
        normal[k] = one[(k + 1) % 3] * other[(k + 2) % 3] -
                    one[(k + 2) % 3] * other[(k + 1) % 3];
}

void put_apex(int count, const double triangle[][3][3], const double wanted[3],
              double gain, double position[3])
{
    double sum[3] = {0}, below = 0;
    for (int t = 0; t < count; t++) {
        double normal[3], way[3];
        find_normal(triangle[t], normal);
        subtract(triangle[t][0], wanted, way);
        for (int k = 0; k < 3; k++)
            sum[k] += normal[k];
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
        below += dot(normal, way);
#elif defined TF_WRONG_3 // takes the corners from the origin
        below += dot(normal, triangle[t][0]) + 0 * dot(normal, way);
#else
        // Your turn, part one: what does this triangle add?
        below += 0 * dot(normal, way);
#endif
    }
#if defined TF_SOLUTION || defined TF_WRONG_3
    double rise = (below + 6 * gain) / dot(sum, sum);
#elif defined TF_WRONG_1 // takes six times the volume for the volume
    double rise = (below + gain) / dot(sum, sum);
#elif defined TF_WRONG_2 // goes in instead of out
    double rise = (below - 6 * gain) / dot(sum, sum);
#else
    // Your turn, part two: how far along the sum of the normals?
    double rise = 0 * (below + gain);
#endif
    for (int k = 0; k < 3; k++)
        position[k] = wanted[k] + rise * sum[k];
}
