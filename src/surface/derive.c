//: Check the vertices of an element
#include "surface/derive.h"

#include "base/require.h"

#include <limits.h>
#include <stddef.h>

static tf_status check_corners(int corners, const int corner[], int vertices,
                               tf_flaw *flaw)
{
    for (int i = 0; i < corners; i++) {
        bool bad = corner[i] < 0 || corner[i] >= vertices;
        for (int j = 0; j < i; j++)
            bad |= corner[j] == corner[i];
        flaw->vertex = corner[i];
        if (bad)
            return TF_BAD_INDEX;
    }
    return TF_OK;
}

static tf_status check_elements(tf_element element, int count, int corners,
                                const int *corner, int vertices, tf_flaw *flaw)
{
    for (int i = 0; i < count; i++) {
        *flaw = (tf_flaw){.element = element, .index = i};
        tf_status status = check_corners(
            corners, corner + (size_t)i * (size_t)corners, vertices, flaw);
        if (status != TF_OK)
            return status;
    }
    *flaw = (tf_flaw){.element = TF_NO_ELEMENT};
    return TF_OK;
}

//: Check a mesh
tf_status tf_mesh_check(const tf_mesh *mesh, tf_flaw *flaw)
{
    TF_REQUIRE(mesh->axes == 3 || (mesh->axes == 2 && mesh->triangles == 0));
    TF_REQUIRE(mesh->vertices >= 0 && mesh->triangles >= 0 && mesh->edges >= 0);
    TF_REQUIRE(mesh->triangle || mesh->triangles == 0);
    TF_REQUIRE(mesh->edge || mesh->edges == 0);
    *flaw = (tf_flaw){.element = TF_NO_ELEMENT};
    if (mesh->triangles == 0 && mesh->edges == 0)
        return TF_NO_ELEMENTS;
    // Every index, also that of an edge, must be an int.
    if (mesh->triangles > (INT_MAX - mesh->edges) / 3)
        return TF_OUT_OF_MEMORY;
    tf_status status = check_elements(TF_TRIANGLE, mesh->triangles, 3,
                                      mesh->triangle, mesh->vertices, flaw);
    return status == TF_OK ? check_elements(TF_EDGE, mesh->edges, 2, mesh->edge,
                                            mesh->vertices, flaw)
                           : status;
}

//: List the triangles
static void copy_element(int corners, const int from[], int to[])
{
    for (int c = 0; c < corners; c++)
        to[c] = from[c];
    tf_element_sort(corners, to);
}

bool tf_mesh_triangles(const tf_mesh *mesh, tf_elements *list,
                       tf_sort_workspace *workspace)
{
    list->corners = 3;
    if (!tf_buffer_reserve(&list->storage, (size_t)mesh->triangles + 1,
                           3 * sizeof(int)))
        return false;
    int *corner = list->storage.data;
    for (int i = 0; i < mesh->triangles; i++)
        copy_element(3, mesh->triangle + 3 * (size_t)i, corner + 3 * (size_t)i);
    return tf_elements_sort(list, mesh->triangles, mesh->vertices, workspace);
}

//: Derive the edges
/// Writes the edges of a triangle, each with its lower vertex first.
static void copy_edges(const int triangle[3], int edge[6])
{
    static const int end[] = {0, 1, 0, 2, 1, 2};
    for (int i = 0; i < 6; i++)
        edge[i] = triangle[end[i]];
}

bool tf_mesh_edges(const tf_mesh *mesh, const tf_elements *triangles,
                   tf_elements *list, tf_sort_workspace *workspace)
{
    list->corners = 2;
    int count = 3 * triangles->count + mesh->edges;
    if (!tf_buffer_reserve(&list->storage, (size_t)count + 1, 2 * sizeof(int)))
        return false;
    int *edge = list->storage.data;
    for (int i = 0; i < triangles->count; i++, edge += 6)
        copy_edges(triangles->corner + 3 * (size_t)i, edge);
    for (int i = 0; i < mesh->edges; i++, edge += 2)
        copy_element(2, mesh->edge + 2 * (size_t)i, edge);
    return tf_elements_sort(list, count, mesh->vertices, workspace);
}
