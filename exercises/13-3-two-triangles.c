/* Exercise 13.3.  Do two triangles with common vertices intersect?
 *
 * Two triangles at rest are given by the indices of their vertices, of which
 * they may share some.  Find out whether they have more in common than the
 * convex hull of their common vertices: whether two of their elements without a
 * common vertex intersect.  Both triangles have an area.
 *
 * Section: Three kinds are enough.
 *
 * Hint 1: intersect() decides a single pair of elements, exactly.  For which
 *     pairs of elements of the two triangles must it be called?
 * Hint 2: An edge of either triangle can pass through the other one.
 * Hint 3: A vertex that lies on the other triangle is found with the edges that
 *     end there, if one of these has no vertex of that triangle.  If both have
 *     one, it is not: then the vertex itself must be tried.
 * Hint 4: Two edges that meet, when no end of either is on the other triangle,
 *     are found with the edges and triangles if the triangles share no vertex.
 *     When they are folded flat upon a common edge, only the two edges are.
 */
#include "arithmetic/exact.h"
#include "query/query.h"
#include "surface/crossing.h"

/// Whether two elements have a common vertex.
static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

/// Whether two elements without a common vertex intersect: an edge and a
/// triangle strictly inside both, a point and a triangle or two edges anywhere.
/// False if they have a common vertex.
static bool intersect(const double x[][3], int vertices, int count,
                      const int a[], int others, const int b[])
{
    if (share(count, a, others, b))
        return false;
    if (count == 2 && others == 3)
        return tf_edge_crosses_triangle(x[a[0]], x[a[1]], x[b[0]], x[b[1]],
                                        x[b[2]]);
    tf_motion rest = {3, vertices, x[0], x[0]};
    tf_verdict verdict = TF_APART;
    bool separated;
    tf_query_verdict(&tf_exact, 3, &rest, count, a, others, b, &verdict,
                     &separated);
    return verdict == TF_HIT;
}

/// The edges of a triangle.
static void find_edges(const int triangle[3], int edge[3][2])
{
    static const int end[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            edge[i][k] = triangle[end[i][k]];
}

bool have_more_in_common(const double x[][3], int vertices, const int first[3],
                         const int second[3])
{
    int edge[3][2], other[3][2];
    find_edges(first, edge);
    find_edges(second, other);
    bool found = false;
    for (int i = 0; i < 3; i++) {
        found |= intersect(x, vertices, 2, edge[i], 3, second);
#if !defined TF_WRONG_1 // only edges of the first triangle pass through
        found |= intersect(x, vertices, 2, other[i], 3, first);
#endif
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_3
        found |= intersect(x, vertices, 1, &first[i], 3, second);
        found |= intersect(x, vertices, 1, &second[i], 3, first);
#endif
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
        for (int j = 0; j < 3; j++)
            found |= intersect(x, vertices, 2, edge[i], 2, other[j]);
#endif
    }
    // Your turn: two kinds of pairs are missing.
    return found;
}
