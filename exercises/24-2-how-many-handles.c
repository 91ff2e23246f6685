/* Exercise 24.2.  How many handles does a surface have?
 *
 * A closed surface of one part is given as an adaptive surface lends it: three
 * vertices for each triangle, and gaps, triangles that are gone, whose first
 * vertex is -1.  Vertices may be gone as well: those of no triangle.  Return
 * how many handles the surface has: 0 for a ball, 1 for a ring, and so on.
 *
 * Section: Safe isn't enough.
 *
 * Hint 1: Vertices minus edges plus triangles is 2 for a ball, and each handle
 *     takes 2 away.
 * Hint 2: Each triangle has three edges, and each edge has two triangles.
 * Hint 3: Count only the vertices that some triangle has.
 */
#include <stdbool.h>

/// Whether a triangle that is there has a vertex.
static bool is_used(int triangles, const int triangle[][3], int vertex)
{
    for (int t = 0; t < triangles; t++)
        if (triangle[t][0] >= 0 &&
            (triangle[t][0] == vertex || triangle[t][1] == vertex ||
             triangle[t][2] == vertex))
            return true;
    return false;
}

int count_handles(int vertices, int triangles, const int triangle[][3])
{
    int used = 0, present = 0;
    for (int v = 0; v < vertices; v++)
        used += is_used(triangles, triangle, v);
    for (int t = 0; t < triangles; t++)
        present += triangle[t][0] >= 0;
#if defined TF_SOLUTION
    return 1 - (used - present / 2) / 2;
#elif defined TF_WRONG_1 // counts vertices that are gone
    return 1 - (vertices - present / 2) / 2;
#elif defined TF_WRONG_2 // counts gaps
    return 1 - (used - triangles / 2) / 2;
#elif defined TF_WRONG_3 // counts each edge for both of its triangles
    return 1 - (used - 3 * present + present) / 2;
#else
    // Your turn: what do the numbers of vertices and triangles say?
    return used - present;
#endif
}
