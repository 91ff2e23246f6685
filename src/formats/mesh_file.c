//: Include what mesh files need
#include "formats/mesh_file.h"

#include "formats/polygon.h"

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

bool tf_ints_add(tf_ints *list, size_t count, const int item[])
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
    return tf_ints_add(places, 1, &kept) || tf_mesh_file_fault_in_memory(file);
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
    if (!file->source)
        return true;
    for (int k = 0; k < 3; k++)
        point.at[k] = (size_t)(at[k] - start);
    return tf_source_add(file->source, &point) ||
           tf_mesh_file_fault_in_memory(file);
}

bool tf_mesh_file_add_part(tf_mesh_file *file, tf_part_kind kind, int vertex,
                           const char *start, const char *at, const char *end)
{
    const tf_source_part part = {(size_t)(at - start), (size_t)(end - at), kind,
                                 vertex};
    return !file->source || !file->source->keeps_parts ||
           tf_source_add_part(file->source, &part) ||
           tf_mesh_file_fault_in_memory(file);
}

size_t tf_mesh_file_parts(const tf_mesh_file *file)
{
    return file->source ? file->source->parts : 0;
}

void tf_mesh_file_end_part(const tf_mesh_file *file, size_t part,
                           const char *start, const char *end)
{
    tf_source *source = file->source;
    if (source && part < source->parts)
        source->part[part].length =
            (size_t)(end - start) - source->part[part].at;
}

void tf_mesh_file_drop_parts(tf_mesh_file *file)
{
    if (file->source)
        file->source->keeps_parts = false;
}

bool tf_mesh_file_add_triangle(tf_mesh_file *file, const int vertex[3],
                               long place)
{
    return add_place(file, &file->triangle_place, place) &&
           (tf_ints_add(&file->triangle, 3, vertex) ||
            tf_mesh_file_fault_in_memory(file));
}

//: Add a face
bool tf_mesh_file_check_corners(const tf_mesh_file *file, int corners,
                                long place)
{
    return corners >= 3 ||
           tf_mesh_file_fault(
               file, place,
               "a face with %d corners; each must have three or more", corners);
}

static bool add_polygon(tf_mesh_file *file, const int corner[], int corners)
{
    int first[] = {tf_mesh_file_triangles(file), (int)file->corner.count};
    return (tf_ints_add(&file->polygon, 2, first) &&
            tf_ints_add(&file->corner, (size_t)corners, corner)) ||
           tf_mesh_file_fault_in_memory(file);
}

/// Until polygons are divided, they are fans.
bool tf_mesh_file_add_face(tf_mesh_file *file, const int corner[], int corners,
                           long place)
{
    if (corners > 3 && !add_polygon(file, corner, corners))
        return false;
    for (int i = 1; i < corners - 1; i++)
        if (!tf_mesh_file_add_triangle(
                file, (int[]){corner[0], corner[i], corner[i + 1]}, place))
            return false;
    return true;
}

//: Add an edge
bool tf_mesh_file_add_edge(tf_mesh_file *file, const int vertex[2], long place)
{
    return add_place(file, &file->edge_place, place) &&
           (tf_ints_add(&file->edge, 2, vertex) ||
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

int tf_mesh_file_polygons(const tf_mesh_file *file)
{
    return (int)(file->polygon.count / 2);
}

bool tf_mesh_file_is_flat(const tf_mesh_file *file)
{
    bool flat = tf_mesh_file_triangles(file) == 0;
    for (size_t i = 2; i < file->position.count && flat; i += 3)
        flat = file->position.item[i] == 0;
    return flat;
}

//: Go through the faces
static void take_polygon(const tf_mesh_file *file, tf_face *face)
{
    const int *first = file->polygon.item + (ptrdiff_t)2 * face->polygon;
    bool is_last = face->polygon == tf_mesh_file_polygons(file) - 1;
    face->corner = file->corner.item + first[1];
    face->corners = (is_last ? (int)file->corner.count : first[3]) - first[1];
}

bool tf_mesh_file_next_face(const tf_mesh_file *file, tf_face *face)
{
    if (face->corner) {
        face->triangle += face->corners - 2;
        face->polygon += face->corners > 3;
    }
    if (face->triangle >= tf_mesh_file_triangles(file))
        return false;
    face->corner = file->triangle.item + (ptrdiff_t)3 * face->triangle;
    face->corners = 3;
    if (face->polygon < tf_mesh_file_polygons(file) &&
        file->polygon.item[(ptrdiff_t)2 * face->polygon] == face->triangle)
        take_polygon(file, face);
    return true;
}

//: Check the corners of a polygon
static bool check_corners(const tf_mesh_file *file, const tf_face *face)
{
    int vertices = tf_mesh_file_vertices(file), first = file->first_index;
    for (int i = 0; i < face->corners; i++)
        if (face->corner[i] >= vertices)
            return tf_mesh_file_fault(
                file, file->triangle_place.item[face->triangle],
                "there is no vertex %lld; they are numbered from %d to %d",
                (long long)face->corner[i] + first, first,
                vertices - 1 + first);
    return true;
}

//: Check a polygon with a corner twice
/// The first vertex that was a corner before, or -1.  `last`: of each vertex,
/// the last polygon that it is a corner of, from 1.
static int find_twin(const tf_face *face, int last[])
{
    int twin = -1;
    for (int i = 0; i < face->corners && twin < 0; i++) {
        int vertex = face->corner[i];
        if (last[vertex] == face->polygon + 1)
            twin = vertex;
        last[vertex] = face->polygon + 1;
    }
    return twin;
}

static bool sides_differ(const tf_face *face)
{
    const int *corner = face->corner;
    int n = face->corners;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            if (corner[i] == corner[j] &&
                corner[(i + 1) % n] == corner[(j + 1) % n])
                return false;
    return true;
}

/// Whether it was divided well although that vertex, if any, is a corner twice.
static bool check_twin(const tf_mesh_file *file, const tf_face *face, int twin,
                       const tf_polygon *polygon)
{
    return twin < 0 || (polygon->is_good && sides_differ(face)) ||
           tf_mesh_file_fault(file, file->triangle_place.item[face->triangle],
                              "vertex %d is a corner twice; divide the "
                              "face, or delete it, here and in all "
                              "files",
                              twin + file->first_index);
}

//: Divide polygons
static bool divide_polygons(tf_mesh_file *file, tf_polygon *polygon, int last[])
{
    tf_face face = {0};
    while (tf_mesh_file_next_face(file, &face)) {
        if (face.corners == 3)
            continue;
        if (!check_corners(file, &face))
            return false;
        if (!tf_polygon_divide(
                polygon, file->position.item, face.corners, face.corner,
                file->triangle.item + (ptrdiff_t)3 * face.triangle))
            return tf_mesh_file_fault_in_memory(file);
        if (!check_twin(file, &face, find_twin(&face, last), polygon))
            return false;
    }
    return true;
}

bool tf_mesh_file_divide(tf_mesh_file *file)
{
    if (tf_mesh_file_polygons(file) == 0)
        return true;
    tf_polygon polygon = {0};
    int *last = calloc((size_t)tf_mesh_file_vertices(file) + 1, sizeof *last);
    bool good = last ? divide_polygons(file, &polygon, last)
                     : tf_mesh_file_fault_in_memory(file);
    free(last);
    tf_polygon_free(&polygon);
    return good;
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
    free(file->polygon.item);
    free(file->corner.item);
    free(file->vertex_place.item);
    free(file->triangle_place.item);
    free(file->edge_place.item);
    *file = (tf_mesh_file){0};
}
