//: Include what welding a mesh needs
#include "scenes/weld.h"

#include "scenes/coincident.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

//: Hold what is being welded
typedef struct weld {
    const tf_mesh_file *file;
    tf_mesh_file *welded;
    int *first;   ///< the vertex that each coincides with
    int *number;  ///< of each vertex: its new one; -1: none; lent by the caller
    bool *used;   ///< whether a vertex has elements in the file
    bool *wanted; ///< whether it has some then
    int *corner;  ///< room for those of a face
    size_t *seen; ///< of each vertex, the last round in which it was seen
    size_t round; ///< how many polygons were looked at
    tf_weld_report *report;
} weld;

static bool begin_weld(weld *w)
{
    size_t vertices = (size_t)tf_mesh_file_vertices(w->file) + 1;
    w->first = malloc(vertices * sizeof *w->first);
    w->used = calloc(vertices, sizeof *w->used);
    w->wanted = calloc(vertices, sizeof *w->wanted);
    w->corner = malloc((w->file->corner.count + 3) * sizeof *w->corner);
    w->seen = calloc(vertices, sizeof *w->seen);
    return (w->first && w->used && w->wanted && w->corner && w->seen) ||
           tf_mesh_file_fault_in_memory(w->file);
}

static void end_weld(weld *w)
{
    free(w->first);
    free(w->used);
    free(w->wanted);
    free(w->corner);
    free(w->seen);
}

//: Find out what is left of a polygon
/// Lists the corners that are left of a face, without those that are the same as
/// the one before.
static int list_corners(const weld *w, const tf_face *face)
{
    int count = 0;
    for (int i = 0; i < face->corners; i++) {
        int corner = w->first[face->corner[i]];
        if (count == 0 || w->corner[count - 1] != corner)
            w->corner[count++] = corner;
    }
    while (count > 1 && w->corner[count - 1] == w->corner[0])
        count--;
    return count;
}

static bool is_simple(weld *w, int count)
{
    bool simple = true;
    w->round++;
    for (int i = 0; i < count && simple; i++) {
        simple = w->seen[w->corner[i]] != w->round;
        w->seen[w->corner[i]] = w->round;
    }
    return simple;
}

/// Lists the corners of a face that stays a polygon, and counts them: no two of
/// them are joined, or only neighbors.  0: it does not.
static int count_polygon(weld *w, const tf_face *face)
{
    int count = face->corners > 3 ? list_corners(w, face) : 0;
    return count > 3 && is_simple(w, count) ? count : 0;
}

//: Find out which vertices are left
static bool is_collapsed(const weld *w, const int corner[3])
{
    int a = w->first[corner[0]], b = w->first[corner[1]],
        c = w->first[corner[2]];
    return a == b || b == c || c == a;
}

static void mark(weld *w, int corners, const int corner[], bool stays)
{
    for (int i = 0; i < corners; i++) {
        w->used[w->first[corner[i]]] = true;
        w->wanted[w->first[corner[i]]] |= stays;
    }
}

static void mark_triangles(weld *w, const tf_face *face)
{
    for (int t = face->triangle; t < face->triangle + face->corners - 2; t++) {
        const int *corner = w->file->triangle.item + 3 * (size_t)t;
        bool collapsed = is_collapsed(w, corner);
        mark(w, 3, corner, !collapsed);
        w->report->collapsed += collapsed;
    }
}

static void mark_face(weld *w, const tf_face *face)
{
    int count = count_polygon(w, face);
    if (count == 0) {
        mark_triangles(w, face);
        return;
    }
    mark(w, face->corners, face->corner, true);
    w->report->collapsed += face->corners - count;
}

static void mark_elements(weld *w)
{
    const tf_mesh_file *file = w->file;
    for (tf_face face = {0}; tf_mesh_file_next_face(file, &face);)
        mark_face(w, &face);
    for (size_t i = 0; i < file->edge.count; i += 2) {
        const int *end = file->edge.item + i;
        bool collapsed = w->first[end[0]] == w->first[end[1]];
        mark(w, 2, end, !collapsed);
        w->report->collapsed_edges += collapsed;
    }
}

//: Add the vertices that are left
static void measure_vertex(weld *w, int vertex)
{
    const double *x = w->file->position.item;
    int first = w->first[vertex];
    w->report->joined++;
    w->report->farthest =
        fmax(w->report->farthest, tf_distance_between(x + 3 * (size_t)first,
                                                      x + 3 * (size_t)vertex));
}

static bool add_vertex(weld *w, int vertex, const tf_columns *columns)
{
    w->number[vertex] = tf_mesh_file_vertices(w->welded);
    return tf_mesh_file_add_vertex(w->welded,
                                   w->file->position.item + 3 * (size_t)vertex,
                                   w->file->vertex_place.item[vertex]) &&
           (!columns ||
            tf_mesh_file_add_row(w->welded, tf_columns_row(columns, vertex)));
}

static bool add_vertices(weld *w, const tf_columns *columns)
{
    bool good = true;
    for (int v = 0; v < tf_mesh_file_vertices(w->file) && good; v++) {
        w->number[v] = w->first[v] == v ? -1 : w->number[w->first[v]];
        if (w->first[v] != v)
            measure_vertex(w, v);
        else if (w->wanted[v] || !w->used[v])
            good = add_vertex(w, v, columns);
    }
    return good;
}

//: Add the faces that are left
static int number_of(const weld *w, int vertex)
{
    return w->number[vertex];
}

static bool add_triangles(weld *w, const tf_face *face)
{
    bool good = true;
    for (int t = face->triangle; t < face->triangle + face->corners - 2 && good;
         t++) {
        const int *corner = w->file->triangle.item + 3 * (size_t)t;
        if (!is_collapsed(w, corner))
            good = tf_mesh_file_add_triangle(w->welded,
                                             (int[]){number_of(w, corner[0]),
                                                     number_of(w, corner[1]),
                                                     number_of(w, corner[2])},
                                             w->file->triangle_place.item[t]);
    }
    return good;
}

static bool add_face(weld *w, const tf_face *face)
{
    int count = count_polygon(w, face);
    for (int i = 0; i < count; i++)
        w->corner[i] = number_of(w, w->corner[i]);
    return count > 0 ? tf_mesh_file_add_face(
                           w->welded, w->corner, count,
                           w->file->triangle_place.item[face->triangle])
                     : add_triangles(w, face);
}

static bool add_elements(weld *w)
{
    tf_face face = {0};
    bool good = true;
    while (good && tf_mesh_file_next_face(w->file, &face))
        good = add_face(w, &face);
    for (int e = 0; e < tf_mesh_file_edges(w->file) && good; e++) {
        const int *end = w->file->edge.item + 2 * (size_t)e;
        if (w->first[end[0]] != w->first[end[1]])
            good = tf_mesh_file_add_edge(
                w->welded, (int[]){number_of(w, end[0]), number_of(w, end[1])},
                w->file->edge_place.item[e]);
    }
    return good && tf_mesh_file_divide(w->welded);
}

//: Weld a mesh
static bool make_welded(weld *w, double within, const tf_columns *columns)
{
    const tf_mesh_file *file = w->file;
    if (!begin_weld(w))
        return false;
    if (!tf_find_coincident(tf_mesh_file_vertices(file), file->position.item,
                            within, w->first))
        return tf_mesh_file_fault_in_memory(file);
    mark_elements(w);
    return add_vertices(w, columns) && add_elements(w);
}

bool tf_weld(const tf_mesh_file *file, double within, const tf_columns *columns,
             int number[], tf_mesh_file *welded, tf_columns *carried,
             tf_weld_report *report)
{
    *report = (tf_weld_report){.vertices_before = tf_mesh_file_vertices(file),
                               .triangles_before = tf_mesh_file_triangles(file),
                               .edges_before = tf_mesh_file_edges(file)};
    *welded = (tf_mesh_file){.name = file->name,
                             .fault = file->fault,
                             .format = file->format,
                             .first_index = file->first_index,
                             .columns = columns ? carried : NULL};
    if (columns) {
        carried->count = columns->count;
        memcpy(carried->column, columns->column, sizeof columns->column);
    }
    weld w = {
        .file = file, .welded = welded, .number = number, .report = report};
    bool good = make_welded(&w, within, columns);
    end_weld(&w);
    report->vertices = tf_mesh_file_vertices(welded);
    report->triangles = tf_mesh_file_triangles(welded);
    report->edges = tf_mesh_file_edges(welded);
    return good;
}
