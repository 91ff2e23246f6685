//: Include what mesh files need
#include "formats/mesh_file.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

//: Describe what is wrong with a mesh file
bool tf_mesh_file_fault(const tf_mesh_file *file, long place,
                        const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(file->fault, file->name, place, format, arguments);
    va_end(arguments);
    file->fault->counts_bytes = file->counts_bytes;
    return false;
}

//: Make room in a list
/// Room for `more` items of `size` bytes; the list, moved, or NULL.
static void *extend(void *item, size_t count, size_t *room, size_t more,
                    size_t size)
{
    if (count + more <= *room)
        return item;
    size_t wanted = 2 * (count + more);
    void *moved =
        wanted > SIZE_MAX / size ? NULL : realloc(item, wanted * size);
    if (moved)
        *room = wanted;
    return moved;
}

/// Appends items to a list; returns the list, moved, or NULL.
static void *append(void *list, size_t *count, size_t *room, const void *item,
                    size_t more, size_t size)
{
    char *moved = extend(list, *count, room, more, size);
    if (moved)
        memcpy(moved + *count * size, item, more * size);
    *count += moved ? more : 0;
    return moved;
}

static bool add_ints(tf_ints *list, size_t count, const int item[])
{
    int *moved = append(list->item, &list->count, &list->room, item, count,
                        sizeof *item);
    list->item = moved ? moved : list->item;
    return moved;
}

static bool add_doubles(tf_doubles *list, size_t count, const double item[])
{
    double *moved = append(list->item, &list->count, &list->room, item, count,
                           sizeof *item);
    list->item = moved ? moved : list->item;
    return moved;
}

//: Add to a mesh
bool tf_mesh_file_fault_in_memory(const tf_mesh_file *file)
{
    return tf_mesh_file_fault(
        file, -1,
        "not enough memory; divide the mesh, or use a machine with more");
}

/// Adds the place of an item, unless there are too many: a surface counts the
/// edges of all triangles by an int.
static bool add_place(tf_mesh_file *file, tf_ints *places, long place)
{
    enum {
        MOST = INT_MAX / 4
    };
    int kept = place > INT_MAX ? -1 : (int)place;
    if (places->count == MOST)
        return tf_mesh_file_fault(
            file, place,
            "more than %d vertices, triangles or edges; divide the mesh", MOST);
    return add_ints(places, 1, &kept) || tf_mesh_file_fault_in_memory(file);
}

bool tf_mesh_file_add_vertex(tf_mesh_file *file, const double x[3], long place)
{
    return add_place(file, &file->vertex_place, place) &&
           (add_doubles(&file->position, 3, x) ||
            tf_mesh_file_fault_in_memory(file));
}

bool tf_mesh_file_add_row(tf_mesh_file *file, const double value[])
{
    return !file->columns || tf_columns_add(file->columns, value) ||
           tf_mesh_file_fault_in_memory(file);
}

bool tf_mesh_file_add_point(tf_mesh_file *file, int vertex, const char *start,
                            const char *const at[3])
{
    tf_source_point point = {.vertex = vertex};
    for (int k = 0; k < 3; k++)
        point.at[k] = (size_t)(at[k] - start);
    return !file->source || tf_source_add(file->source, &point) ||
           tf_mesh_file_fault_in_memory(file);
}

bool tf_mesh_file_add_triangle(tf_mesh_file *file, const int vertex[3],
                               long place)
{
    return add_place(file, &file->triangle_place, place) &&
           (add_ints(&file->triangle, 3, vertex) ||
            tf_mesh_file_fault_in_memory(file));
}

bool tf_mesh_file_add_edge(tf_mesh_file *file, const int vertex[2], long place)
{
    return add_place(file, &file->edge_place, place) &&
           (add_ints(&file->edge, 2, vertex) ||
            tf_mesh_file_fault_in_memory(file));
}

//: Count what a file holds
int tf_mesh_file_vertices(const tf_mesh_file *file)
{
    return (int)file->vertex_place.count;
}

int tf_mesh_file_triangles(const tf_mesh_file *file)
{
    return (int)file->triangle_place.count;
}

int tf_mesh_file_edges(const tf_mesh_file *file)
{
    return (int)file->edge_place.count;
}

bool tf_mesh_file_is_flat(const tf_mesh_file *file)
{
    bool flat = tf_mesh_file_triangles(file) == 0;
    for (size_t i = 2; i < file->position.count && flat; i += 3)
        flat = file->position.item[i] == 0;
    return flat;
}

//: Lend the elements of a file
tf_mesh tf_mesh_file_elements(const tf_mesh_file *file, int axes)
{
    return (tf_mesh){.axes = axes,
                     .vertices = tf_mesh_file_vertices(file),
                     .triangles = tf_mesh_file_triangles(file),
                     .triangle = file->triangle.item,
                     .edges = tf_mesh_file_edges(file),
                     .edge = file->edge.item};
}

//: Free a mesh file
void tf_mesh_file_free(tf_mesh_file *file)
{
    free(file->position.item);
    free(file->triangle.item);
    free(file->edge.item);
    free(file->vertex_place.item);
    free(file->triangle_place.item);
    free(file->edge_place.item);
    *file = (tf_mesh_file){0};
}
