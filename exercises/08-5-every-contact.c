/* Exercise 8.5.  Project: every contact of a mesh.
 *
 * Find every contact of a step of a mesh with about 200 triangles in space:
 * every vertex that meets a triangle of which it is no corner, and every two
 * edges that meet and have no common vertex.  Write them to `found`, each once
 * and in any order, and return how many there are; there is room for all.  A
 * row's `kind` is 1 for a vertex and a triangle, and `vertex` has the vertex
 * and then the corners; it is 2 for two edges, and `vertex` has the ends of
 * one and then those of the other.  Those of an element may be in any order, in
 * queries too, which sort them.
 *
 * You need no more than this part of the book.  The checks compare your list
 * with one that was found with exact signs; some contacts are mere touches.
 * Once they pass, try finer meshes of your own and see how the time grows.  Which pairs
 * could you rule out without a query?  Part IV goes on from there.
 *
 * Section: The theorem.
 *
 * Hint 1: Begin with the edges.  An edge of two triangles is one edge; keep
 *     only one of the two, with its ends in ascending order.
 * Hint 2: Then there are two pairs of loops.  A triangle's vertices are no
 *     partners for it; for two edges, look at each pair once.
 * Hint 3: tf_point_triangle and tf_edge_edge take the arithmetic that you are
 *     given.  TF_HIT is a contact; the arithmetic leaves nothing undecided.
 */
#include "query/edge_edge.h"
#include "query/point_triangle.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct row {
    int kind; // 1 vertex and a triangle, or 2 ends of an edge and an edge
    int vertex[4];
} row;

/// The corners of a triangle in ascending order: equal edges become the same.
static void sort_three(const int triangle[3], int sorted[3])
{
    memcpy(sorted, triangle, 3 * sizeof *sorted);
    for (int i = 0; i < 3; i++)
        for (int j = i + 1; j < 3; j++)
            if (sorted[j] < sorted[i]) {
                int larger = sorted[i];
                sorted[i] = sorted[j];
                sorted[j] = larger;
            }
}

static bool has(int count, const int vertex[], int one)
{
    for (int i = 0; i < count; i++)
        if (vertex[i] == one)
            return true;
    return false;
}

#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
/// All edges, each once; returns how many.
static int list_edges(int triangles, const int triangle[][3], int edge[][2])
{
    int count = 0;
    for (int t = 0; t < triangles; t++) {
        int v[3];
        sort_three(triangle[t], v);
        for (int i = 0; i < 3; i++) {
            int low = v[i == 2], high = v[i == 0 ? 1 : 2];
            bool old = false;
            for (int e = 0; e < count; e++)
                old |= edge[e][0] == low && edge[e][1] == high;
#if defined TF_WRONG_1 // lists an edge once for each triangle
            old = false;
#endif
            edge[count][0] = low;
            edge[count][1] = high;
            count += !old;
        }
    }
    return count;
}

static int find_edges(const tf_arithmetic *arithmetic, const tf_motion *step,
                      int edges, const int edge[][2], row found[])
{
    int count = 0;
    for (int e = 0; e < edges; e++)
        for (int f = 0; f < e; f++) {
            tf_contact contact;
            const int *a = edge[f], *b = edge[e];
            if (has(2, b, a[0]) || has(2, b, a[1]))
                continue;
            tf_status status = tf_edge_edge(arithmetic, step, a, b, &contact);
            if (status != TF_OK || contact.verdict != TF_HIT)
                continue;
#if defined TF_WRONG_2 // leaves out what only touches
            if (contact.classification != TF_GENERIC)
                continue;
#endif
            found[count++] = (row){2, {a[0], a[1], b[0], b[1]}};
        }
    return count;
}

static int find_points(const tf_arithmetic *arithmetic, const tf_motion *step,
                       const int c[3], row found[])
{
    int count = 0;
    for (int v = 0; v < step->vertices; v++) {
        tf_contact contact;
        if (!has(3, c, v) &&
            tf_point_triangle(arithmetic, step, v, c, &contact) == TF_OK &&
            contact.verdict == TF_HIT)
            found[count++] = (row){1, {v, c[0], c[1], c[2]}};
    }
    return count;
}
#endif

int every_contact(const tf_arithmetic *arithmetic, const tf_motion *step,
                  int triangles, const int triangle[][3], row found[])
{
    int count = 0;
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    for (int t = 0; t < triangles; t++) {
        int corner[3];
        sort_three(triangle[t], corner);
        count += find_points(arithmetic, step, corner, found + count);
    }
    int(*edge)[2] = malloc((size_t)triangles * 3 * sizeof *edge);
    if (edge)
        count +=
            find_edges(arithmetic, step, list_edges(triangles, triangle, edge),
                       (const int(*)[2])edge, found + count);
    free(edge);
#elif defined TF_WRONG_3 // looks at the first corner of each triangle alone
    for (int s = 0; s < triangles; s++)
        for (int t = 0; t < triangles; t++) {
            int c[3], v = triangle[s][0];
            tf_contact contact;
            sort_three(triangle[t], c);
            if (!has(3, c, v) &&
                tf_point_triangle(arithmetic, step, v, c, &contact) == TF_OK &&
                contact.verdict == TF_HIT)
                found[count++] = (row){1, {v, c[0], c[1], c[2]}};
        }
#else
    // Your turn: so far only the first vertex meets the first triangle.
    int c[3];
    tf_contact contact;
    sort_three(triangle[0], c);
    if (triangles > 1 && !has(3, c, 0) &&
        tf_point_triangle(arithmetic, step, 0, c, &contact) == TF_OK &&
        contact.verdict == TF_HIT)
        found[count++] = (row){1, {0, c[0], c[1], c[2]}};
#endif
    return count;
}
