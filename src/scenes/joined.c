//: Include what joining meshes needs
#include "scenes/joined.h"

#include "scenes/flaws.h"

#include <limits.h>
#include <stdlib.h>

//: Check the indices of a mesh
/// Once the mesh is joined, an index too large would be one of the next mesh.
static bool check_indices(const tf_mesh_file *file, const tf_ints *list,
                          int corners, tf_subject subject)
{
    int vertices = tf_mesh_file_vertices(file);
    for (size_t i = 0; i < list->count; i++)
        if (list->item[i] < 0 || list->item[i] >= vertices)
            return tf_error_fault(
                file, &(tf_error){.status = TF_BAD_INDEX,
                                  .subject = subject,
                                  .index = i / (size_t)corners,
                                  .vertex = {list->item[i], -1, -1, -1, -1},
                                  .vertices = vertices,
                                  .time = -1});
    return true;
}

static bool check_mesh(const tf_mesh_file *file)
{
    return check_indices(file, &file->triangle, 3, TF_TRIANGLE) &&
           check_indices(file, &file->edge, 2, TF_EDGE);
}

//: Count what meshes have together
enum {
    MOST_JOINED = INT_MAX / 4 // as in a file
};

static bool count_to(int first[], int mesh, int own)
{
    first[mesh + 1] = own <= MOST_JOINED - first[mesh] ? first[mesh] + own : -1;
    return first[mesh + 1] >= 0;
}

static bool count_elements(tf_joined *joined, const tf_mesh_file *const file[])
{
    for (int m = 0; m < joined->meshes; m++)
        if (!count_to(joined->first_vertex, m,
                      tf_mesh_file_vertices(file[m])) ||
            !count_to(joined->first_triangle, m,
                      tf_mesh_file_triangles(file[m])) ||
            !count_to(joined->first_edge, m, tf_mesh_file_edges(file[m])))
            return tf_mesh_file_fault(
                file[m], -1,
                "with the meshes before it, more than %d vertices, triangles "
                "or edges; divide the scene",
                MOST_JOINED);
    return true;
}

//: Join meshes
bool tf_joined_make(tf_joined *joined, int meshes,
                    const tf_mesh_file *const file[])
{
    size_t room = (size_t)meshes + 1;
    *joined = (tf_joined){
        .meshes = meshes,
        .first_vertex = calloc(room, sizeof *joined->first_vertex),
        .first_triangle = calloc(room, sizeof *joined->first_triangle),
        .first_edge = calloc(room, sizeof *joined->first_edge),
    };
    if (!joined->first_vertex || !joined->first_triangle || !joined->first_edge)
        return tf_mesh_file_fault_in_memory(file[0]);
    bool good = true;
    for (int m = 0; m < meshes && good; m++)
        good = check_mesh(file[m]);
    return good && count_elements(joined, file);
}

void tf_joined_free(tf_joined *joined)
{
    free(joined->first_vertex);
    free(joined->first_triangle);
    free(joined->first_edge);
    *joined = (tf_joined){0};
}

int tf_joined_vertices(const tf_joined *joined)
{
    return joined->first_vertex[joined->meshes];
}

//: Tell joined meshes apart
/// The last mesh whose first item is not behind this one, which is not empty.
static int mesh_of(const tf_joined *joined, const int first[], int item)
{
    int from = 0, to = joined->meshes;
    while (to - from > 1) {
        int middle = from + (to - from) / 2;
        if (first[middle] <= item)
            from = middle;
        else
            to = middle;
    }
    return from;
}

int tf_joined_mesh(const tf_joined *joined, int vertex)
{
    return mesh_of(joined, joined->first_vertex, vertex);
}

void tf_joined_localize(const tf_joined *joined, int count, int vertex[],
                        int first, int mesh[2])
{
    mesh[0] = tf_joined_mesh(joined, vertex[0]);
    mesh[1] = first < count && vertex[first] >= 0
                  ? tf_joined_mesh(joined, vertex[first])
                  : mesh[0];
    for (int i = 0; i < count; i++)
        if (vertex[i] >= 0)
            vertex[i] -= joined->first_vertex[mesh[i >= first]];
}

//: Tell to which mesh an error belongs
/// How many vertices the first element of a pair has; 0: it is about no pair.
static int first_element(tf_subject subject)
{
    static const int vertices[] = {[TF_POINT_EDGE_PAIR] = 1,
                                   [TF_POINT_TRIANGLE_PAIR] = 1,
                                   [TF_EDGE_EDGE_PAIR] = 2,
                                   [TF_EDGE_TRIANGLE_PAIR] = 2};
    return subject >= TF_POINT_EDGE_PAIR && subject <= TF_EDGE_TRIANGLE_PAIR
               ? vertices[subject]
               : 0;
}

/// Those of which the error has the index of one; NULL: it has none.
static const int *firsts_of(const tf_joined *joined, tf_subject subject)
{
    return subject == TF_VERTEX     ? joined->first_vertex
           : subject == TF_EDGE     ? joined->first_edge
           : subject == TF_TRIANGLE ? joined->first_triangle
                                    : NULL;
}

void tf_joined_localize_error(const tf_joined *joined, tf_error *error,
                              int mesh[2])
{
    const int *first = firsts_of(joined, error->subject);
    mesh[0] = mesh[1] = 0;
    if (first_element(error->subject) > 0)
        tf_joined_localize(joined, 5, error->vertex,
                           first_element(error->subject), mesh);
    if (!first)
        return;
    mesh[0] = mesh[1] = mesh_of(joined, first, (int)error->index);
    error->index -= (size_t)first[mesh[0]];
    for (int i = 0; i < 5; i++)
        if (error->vertex[i] >= 0)
            error->vertex[i] -= joined->first_vertex[mesh[0]];
    error->vertices =
        joined->first_vertex[mesh[0] + 1] - joined->first_vertex[mesh[0]];
}

//: List the elements of joined meshes
static int *list_joined(const tf_ints *list, int to[], int first_vertex)
{
    for (size_t i = 0; i < list->count; i++)
        *to++ = list->item[i] + first_vertex;
    return to;
}

bool tf_joined_elements(const tf_joined *joined,
                        const tf_mesh_file *const file[], int **triangle,
                        int **edge)
{
    size_t triangles = (size_t)joined->first_triangle[joined->meshes];
    size_t edges = (size_t)joined->first_edge[joined->meshes];
    int *t = *triangle = malloc((3 * triangles + 1) * sizeof *t);
    int *e = *edge = malloc((2 * edges + 1) * sizeof *e);
    for (int m = 0; m < joined->meshes && t && e; m++) {
        t = list_joined(&file[m]->triangle, t, joined->first_vertex[m]);
        e = list_joined(&file[m]->edge, e, joined->first_vertex[m]);
    }
    return t && e;
}
