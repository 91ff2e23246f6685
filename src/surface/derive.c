//: Check the vertices of an element
#include "surface/derive.h"

#include "base/fail.h"

#include <limits.h>
#include <stddef.h>

/// Finds the first corner that is no vertex, or that is there twice; returns how
/// many are good.
static int good_corners(int corners, const int corner[], int vertices)
{
    for (int i = 0; i < corners; i++) {
        bool bad = corner[i] < 0 || corner[i] >= vertices;
        for (int j = 0; j < i; j++)
            bad |= corner[j] == corner[i];
        if (bad)
            return i;
    }
    return corners;
}

static tf_status check_elements(tf_subject element, int count, int corners,
                                const int *corner, int vertices,
                                tf_error *error)
{
    for (int i = 0; i < count; i++, corner += corners) {
        int good = good_corners(corners, corner, vertices);
        if (good < corners)
            return tf_fail_index(error, element, (size_t)i, corner[good],
                                 vertices);
    }
    return TF_OK;
}

//: Check the counts of a mesh
/// Every index must be an int, also that of an edge or of a coordinate.
static bool are_countable(const tf_mesh *mesh)
{
    return mesh->vertices <= INT_MAX / mesh->axes &&
           mesh->edges <= INT_MAX / 2 &&
           mesh->triangles <= (INT_MAX - mesh->edges) / 3;
}

static bool are_counted(const tf_mesh *mesh)
{
    return mesh->vertices >= 0 && mesh->triangles >= 0 && mesh->edges >= 0 &&
           (mesh->triangle || mesh->triangles == 0) &&
           (mesh->edge || mesh->edges == 0) && are_countable(mesh);
}

//: Check a mesh
tf_status tf_mesh_check(const tf_mesh *mesh, tf_error *error)
{
    if (mesh->axes != 3 && (mesh->axes != 2 || mesh->triangles != 0))
        return tf_fail(error, TF_BAD_AXES);
    if (!are_counted(mesh))
        return tf_fail(error, TF_BAD_COUNT);
    if (mesh->triangles == 0 && mesh->edges == 0)
        return tf_fail(error, TF_NO_ELEMENTS);
    tf_status status = check_elements(TF_TRIANGLE, mesh->triangles, 3,
                                      mesh->triangle, mesh->vertices, error);
    if (status == TF_OK)
        status = check_elements(TF_EDGE, mesh->edges, 2, mesh->edge,
                                mesh->vertices, error);
    return status;
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
