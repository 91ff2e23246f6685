/* Exercise 13.1.  Is a surface closed?
 *
 * A surface is closed if every edge is run through as often in one direction as
 * in the other, when the corners of each triangle are passed in the order in
 * which they are listed.  Only a closed surface has an inside, in which
 * vertices are kept.  Find out whether the triangles of a mesh are closed.
 *
 * Section: Every edge once.
 *
 * Hint 1: The triangle 5, 2, 7 runs through its edges from 5 to 2, from 2 to 7
 *     and from 7 back to 5.
 * Hint 2: For one directed edge, count how many triangles run from its first
 *     vertex to its second.  Then count those that run back.
 * Hint 3: The counts must be equal for the directed edges of all triangles.
 *     That takes time that is quadratic in their number, which will do here.
 *     With the edges sorted, as the library sorts them, it would be linear.
 */
#include "surface/mesh.h"

#include <stdbool.h>

/// How many triangles run from one vertex to another.
static int count_runs(const tf_mesh *mesh, int from, int to)
{
    int count = 0;
    for (int i = 0; i < mesh->triangles; i++) {
        const int *corner = mesh->triangle + 3 * i;
        for (int c = 0; c < 3; c++)
#if defined TF_WRONG_1 // does not return to the first corner
            count += c < 2 && corner[c] == from && corner[c + 1] == to;
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
            count += corner[c] == from && corner[(c + 1) % 3] == to;
#else
            // Your turn: does this edge of the triangle run from `from` to
            // `to`?
            count += corner[c] == from;
#endif
    }
    return count;
}

bool is_closed(const tf_mesh *mesh)
{
    for (int i = 0; i < mesh->triangles; i++) {
        const int *corner = mesh->triangle + 3 * i;
        for (int c = 0; c < 3; c++) {
            int a = corner[c], b = corner[(c + 1) % 3];
#if defined TF_WRONG_2 // two triangles at an edge, whatever their directions
            if (count_runs(mesh, a, b) + count_runs(mesh, b, a) != 2)
                return false;
#elif defined TF_WRONG_3 // some triangle on the other side, however many here
            if (count_runs(mesh, b, a) == 0)
                return false;
#elif defined TF_SOLUTION || defined TF_WRONG_1
            if (count_runs(mesh, a, b) != count_runs(mesh, b, a))
                return false;
#else
            // Your turn: compare the runs from a to b with those back.
            if (count_runs(mesh, a, b) == 0)
                return false;
#endif
        }
    }
    return true;
}
