/* Exercise 21.1.  Which vertices are on the wrong side?
 *
 * A surface crosses itself.  Given are its edges, each by its two vertices, and
 * for each edge how many triangles it pierces.  An edge with an odd number is
 * cut.  Vertices that edges connect are in the same part of the surface;
 * vertices that are connected by edges that are not cut are in the same region.
 * In each part the region with the most vertices is right, and the others are
 * wrong.  Where several have the most, the one with the lowest vertex is right.
 * Set wrong[v] to whether vertex v is in a wrong region, and return how many
 * vertices are.  There are at most 64 vertices.
 *
 * Section: Regions.
 *
 * Hint 1: An edge that goes in and comes out again has both ends on one side.
 * Hint 2: The largest region of one part says nothing about other parts.
 * Hint 3: A region is named after its lowest vertex, so going through the
 *     vertices upward, you meet the regions in the order that decides between
 *     equal ones.
 */
#include <stdbool.h>

enum {
    MOST_VERTICES = 64
};

/// Whether an edge is cut that pierces that many triangles.
static bool is_cut(int pierced)
{
#if defined TF_WRONG_1 // cuts all edges that pierce anything
    return pierced > 0;
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    return pierced % 2 == 1;
#else
    // Your turn, part one: for now no edge is cut.
    return pierced < 0;
#endif
}

/// Labels what edges connect by its lowest vertex; of no pierced edge, if NULL.
static void flood(int vertices, int edges, const int edge[][2],
                  const int pierced[], int label[])
{
    for (int v = 0; v < vertices; v++)
        label[v] = v;
    for (bool changed = true; changed;) {
        changed = false;
        for (int e = 0; e < edges; e++) {
            int *a = &label[edge[e][0]], *b = &label[edge[e][1]];
            if ((pierced && is_cut(pierced[e])) || *a == *b)
                continue;
            *a = *b = *a < *b ? *a : *b;
            changed = true;
        }
    }
}

/// The label of the right region of a part.
static int right_region(int vertices, const int part[], const int region[],
                        int of_part)
{
    int size[MOST_VERTICES] = {0};
    for (int v = 0; v < vertices; v++)
        size[region[v]]++;
    int right = region[of_part];
#if defined TF_SOLUTION || defined TF_WRONG_1
    for (int v = 0; v < vertices; v++)
        if (part[v] == of_part && size[region[v]] > size[right])
            right = region[v];
#elif defined TF_WRONG_2 // knows only the largest region of the whole surface
    for (int v = 0; v < vertices; v++)
        if (size[region[v]] > size[right])
            right = region[v];
#elif defined TF_WRONG_3 // takes the last of equally large ones
    for (int v = 0; v < vertices; v++)
        if (part[v] == of_part && size[region[v]] >= size[right])
            right = region[v];
#else
    // Your turn, part two: for now that of the part's lowest vertex is right.
#endif
    return right;
}

int mark_wrong(int vertices, int edges, const int edge[][2],
               const int pierced[], bool wrong[])
{
    int part[MOST_VERTICES], region[MOST_VERTICES], count = 0;
    flood(vertices, edges, edge, 0, part);
    flood(vertices, edges, edge, pierced, region);
    for (int v = 0; v < vertices; v++) {
        wrong[v] = region[v] != right_region(vertices, part, region, part[v]);
        count += wrong[v];
    }
    return count;
}
