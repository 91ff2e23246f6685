/* Exercise 21.2.  Does a crossing curve close?
 *
 * Two triangles that cross have a segment in common.  Each of its ends is a
 * crossing: an edge of either triangle pierces the other one.  Where the two
 * have a vertex in common, the segment has an end there instead, which is no
 * crossing.  Together the segments are curves.  Given are all crossings, each by
 * the edge's two vertices and the triangle's three.  Return how many curves are
 * closed, and set `open` to how many are not.
 *
 * No edge has more than two triangles.  Nothing touches without crossing.
 * There are at most 256 crossings.
 *
 * Section: Curves.
 *
 * Hint 1: Two crossings are neighbors on a curve if they are the two ends of the
 *     segment that a pair of triangles has in common.
 * Hint 2: The two edges may belong to the same triangle of the pair, or one to
 *     each.
 * Hint 3: How many neighbors does a crossing of a closed curve have?
 */
#include <stdbool.h>

enum {
    MOST_CROSSINGS = 256
};

/// Whether all of `count` vertices are among those of a triangle.
static bool has(const int triangle[3], int count, const int vertex[])
{
    for (int i = 0; i < count; i++)
        if (vertex[i] != triangle[0] && vertex[i] != triangle[1] &&
            vertex[i] != triangle[2])
            return false;
    return true;
}

/// Whether two edges are of one triangle.
static bool share_triangle(int triangles, const int triangle[][3],
                           const int edge[2], const int other[2])
{
    for (int t = 0; t < triangles; t++)
        if (has(triangle[t], 2, edge) && has(triangle[t], 2, other))
            return true;
    return false;
}

/// Whether two different crossings, an edge and a triangle each, are the ends of
/// what one pair of triangles has in common.
static bool are_neighbors(int triangles, const int triangle[][3],
                          const int a[5], const int b[5])
{
#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    if (has(a + 2, 2, b) && has(b + 2, 2, a))
        return true;
    return has(a + 2, 3, b + 2) && share_triangle(triangles, triangle, a, b);
#elif defined TF_WRONG_1 // both edges are of one triangle
    return has(a + 2, 3, b + 2) && share_triangle(triangles, triangle, a, b);
#elif defined TF_WRONG_4 // forgets that the edges must be of one triangle
    if (has(a + 2, 2, b) && has(b + 2, 2, a))
        return true;
    return has(a + 2, 3, b + 2) && share_triangle(triangles, triangle, a, a);
#else
    // Your turn, part one: for now only where each pierces the other.
    return share_triangle(triangles, triangle, a, a) && has(a + 2, 2, b) &&
           has(b + 2, 2, a);
#endif
}

/// Whether a curve ends at a crossing.
static bool ends_at(int triangles, const int triangle[][3], int crossings,
                    const int crossing[][5], int i)
{
#if defined TF_WRONG_2 // looks only for borders
    int found = 0;
    for (int t = 0; t < triangles; t++)
        found += has(triangle[t], 2, crossing[i]);
    return found < 2 || i >= crossings;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_4
    int neighbors = 0;
    for (int j = 0; j < crossings; j++)
        neighbors += j != i && are_neighbors(triangles, triangle, crossing[i],
                                             crossing[j]);
    return neighbors < 2;
#elif defined TF_WRONG_3 // counts only crossings without any neighbor
    for (int j = 0; j < crossings; j++)
        if (j != i &&
            are_neighbors(triangles, triangle, crossing[i], crossing[j]))
            return false;
    return true;
#else
    // Your turn, part two: for now no curve ends.
    return i >= crossings && triangle[triangles - 1][0] == crossing[i][0];
#endif
}

int count_closed(int triangles, const int triangle[][3], int crossings,
                 const int crossing[][5], int *open)
{
    int curve[MOST_CROSSINGS], curves = 0;
    bool ends[MOST_CROSSINGS] = {false};
    for (int i = 0; i < crossings; i++)
        curve[i] = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < crossings; i++)
            for (int j = 0; j < crossings; j++)
                if (curve[j] < curve[i] &&
                    are_neighbors(triangles, triangle, crossing[i],
                                  crossing[j])) {
                    curve[i] = curve[j];
                    changed = true;
                }
    }
    for (int i = 0; i < crossings; i++)
        ends[curve[i]] |= ends_at(triangles, triangle, crossings, crossing, i);
    *open = 0;
    for (int i = 0; i < crossings; i++) {
        curves += curve[i] == i;
        *open += curve[i] == i && ends[i];
    }
    return curves - *open;
}
