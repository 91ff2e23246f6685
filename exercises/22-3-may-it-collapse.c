/* Exercise 22.3.  May an edge collapse?
 *
 * A closed surface is given by its triangles alone: each edge has two of them,
 * which pass it in opposite directions, and the triangles at each vertex form
 * one ring.  Its edge from a to b shall collapse, so that a and b become one
 * vertex and the two triangles on the edge vanish.  Return whether what is left
 * is again such a surface, and no two of its triangles have the same vertices.
 *
 * Section: Collapsing an edge.
 *
 * Hint 1: Which vertices are joined to both a and b?
 * Hint 2: Let c be joined to both.  Then ac and bc become one edge, and it has
 *     their four triangles, unless two of those vanish.
 * Hint 3: A vertex opposite to the edge loses a triangle.  How many must it
 *     have?
 */
#include <stdbool.h>

static bool has(const int triangle[3], int vertex)
{
    return triangle[0] == vertex || triangle[1] == vertex ||
           triangle[2] == vertex;
}

/// How many triangles have both vertices; they may be the same.
static int count_at(int triangles, const int triangle[][3], int a, int b)
{
    int count = 0;
    for (int t = 0; t < triangles; t++)
        count += has(triangle[t], a) && has(triangle[t], b);
    return count;
}

static bool is_opposite(int triangles, const int triangle[][3], int a, int b,
                        int vertex)
{
    for (int t = 0; t < triangles; t++)
        if (has(triangle[t], a) && has(triangle[t], b) &&
            has(triangle[t], vertex))
            return true;
    return false;
}

bool may_collapse(int vertices, int triangles, const int triangle[][3], int a,
                  int b)
{
    int common = 0;
    for (int v = 0; v < vertices; v++) {
        if (v == a || v == b || count_at(triangles, triangle, v, a) == 0 ||
            count_at(triangles, triangle, v, b) == 0)
            continue;
#if defined TF_SOLUTION
        common++;
        if (is_opposite(triangles, triangle, a, b, v) &&
            count_at(triangles, triangle, v, v) < 4)
            return false;
#elif defined TF_WRONG_1 // lets two triangles remain on the same vertices
        common++;
        if (is_opposite(triangles, triangle, a, b, v) &&
            count_at(triangles, triangle, v, v) < 3)
            return false;
#elif defined TF_WRONG_2 // forgets neighbors that are not opposite
        if (is_opposite(triangles, triangle, a, b, v) &&
            count_at(triangles, triangle, v, v) < 4)
            return false;
        common += is_opposite(triangles, triangle, a, b, v);
#elif defined TF_WRONG_3 // wants three triangles to remain and one more
        common++;
        if (is_opposite(triangles, triangle, a, b, v) &&
            count_at(triangles, triangle, v, v) < 5)
            return false;
#else
        // Your turn: which of the common neighbors are allowed?
        common += is_opposite(triangles, triangle, a, b, v);
#endif
    }
    return common == 2;
}
