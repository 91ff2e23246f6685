//: Include what carrying faces over needs
#include "scenes/carried_faces.h"

#include "remesh/origins.h"

#include <stdlib.h>
#include <string.h>

//: Divide what faces have among triangles
/// The row of a vertex of a face, or -1.
static int texture_at(const tf_face *face, const int texture[], int vertex)
{
    int i = 0;
    while (face->corner[i] != vertex)
        i++;
    return texture[i];
}

static void divide_face(tf_carried_faces *carried, const tf_mesh_file *file,
                        const tf_face *face, int number, size_t corner)
{
    const int *texture = carried->from.corner.item;
    int end = face->triangle + face->corners - 2;
    for (int t = face->triangle; t < end; t++)
        carried->face[t] = number;
    for (int c = 3 * face->triangle; c < 3 * end; c++)
        carried->texture[c] =
            texture ? texture_at(face, texture + corner, file->triangle.item[c])
                    : -1;
}

static bool divide_faces(tf_carried_faces *carried, const tf_mesh_file *file)
{
    size_t triangles = (size_t)tf_mesh_file_triangles(file), corner = 0;
    int count = 0;
    carried->face = calloc(triangles + 1, sizeof *carried->face);
    carried->texture = calloc(3 * triangles + 1, sizeof *carried->texture);
    if (!carried->face || !carried->texture)
        return tf_mesh_file_fault_in_memory(file);
    for (tf_face face = {0}; tf_mesh_file_next_face(file, &face);) {
        divide_face(carried, file, &face, count++, corner);
        corner += (size_t)face.corners;
    }
    return true;
}

//: Find borders
static bool differ(const tf_carried_faces *carried, int corner, int other)
{
    int a = carried->texture[corner], b = carried->texture[other];
    if (a < 0 || b < 0)
        return a != b;
    const double *x = tf_columns_row(&carried->from.texture, a);
    const double *y = tf_columns_row(&carried->from.texture, b);
    return x[0] != y[0] || x[1] != y[1] || x[2] != y[2];
}

static int corner_after(int corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Of an edge, given by the corners where it begins in its two triangles.
static bool is_border(const tf_carried_faces *carried, int corner, int across)
{
    return !tf_face_attributes_agree(&carried->from, carried->face[corner / 3],
                                     carried->face[across / 3]) ||
           differ(carried, corner, corner_after(across)) ||
           differ(carried, corner_after(corner), across);
}

/// Links corners at which edges begin by the lesser ends of these.  All are -1
/// at first.
typedef struct edge_links {
    const int *vertex; ///< of each corner
    int *first;        ///< of each vertex: a corner
    int *next;         ///< of each corner: another one
} edge_links;

/// The corner where the same edge begins in the triangle that was linked before,
/// or -1; and links this one.
static int link_edge(const edge_links *links, int corner)
{
    int from = links->vertex[corner], to = links->vertex[corner_after(corner)];
    int *first = &links->first[from < to ? from : to], across = *first;
    while (across >= 0 && !(links->vertex[across] == to &&
                            links->vertex[corner_after(across)] == from))
        across = links->next[across];
    links->next[corner] = *first;
    *first = corner;
    return across;
}

/// False: there is no memory.
static bool add_borders(const tf_carried_faces *carried,
                        const edge_links *links, int corners,
                        tf_kept_edges *kept)
{
    for (int c = 0; c < corners; c++) {
        int across = link_edge(links, c);
        if (across >= 0 && is_border(carried, c, across) &&
            !tf_kept_edges_add(kept, links->vertex[across], links->vertex[c]))
            return false;
    }
    return true;
}

static bool find_borders(const tf_carried_faces *carried,
                         const tf_mesh_file *file, tf_kept_edges *kept)
{
    int corners = 3 * tf_mesh_file_triangles(file);
    size_t first = sizeof(int) * (size_t)tf_mesh_file_vertices(file);
    size_t next = sizeof(int) * (size_t)corners;
    edge_links links = {file->triangle.item, malloc(first + 1),
                        malloc(next + 1)};
    bool good = links.first && links.next;
    if (good) {
        memset(links.first, -1, first);
        memset(links.next, -1, next);
        good = add_borders(carried, &links, corners, kept);
    }
    free(links.first);
    free(links.next);
    return good || tf_mesh_file_fault_in_memory(file);
}

bool tf_carried_faces_begin(tf_carried_faces *carried, const tf_mesh_file *file,
                            tf_kept_edges *kept)
{
    return carried->from.row.rows == 0 ||
           (divide_faces(carried, file) && find_borders(carried, file, kept));
}

//: Mix texture coordinates
/// Those of a vertex are linked, so that equal ones are written once.
typedef struct mixture {
    tf_carried_faces *carried;
    const tf_origin *origin; ///< of each corner
    tf_ints first;           ///< of each vertex: a row, or -1
    tf_ints next;            ///< of each row: another one of its vertex, or -1
} mixture;

/// Whether the corners that an origin is made of have texture coordinates;
/// `row`: theirs.
static bool find_rows(const mixture *mixed, const tf_origin *origin, int row[3])
{
    memcpy(row, mixed->carried->texture + 3 * (size_t)origin->triangle,
           3 * sizeof *row);
    for (int i = 0; i < 3; i++)
        if (origin->barycentric[i] > 0 && row[i] < 0)
            return false;
    return true;
}

/// The row of a vertex that is the same as the last one.
static int find_same(const mixture *mixed, int vertex)
{
    const tf_columns *all = &mixed->carried->made.texture;
    const double *last = tf_columns_row(all, (int)all->rows - 1);
    int row = mixed->first.item[vertex];
    while (row >= 0 &&
           memcmp(tf_columns_row(all, row), last, 3 * sizeof *last) != 0)
        row = mixed->next.item[row];
    return row;
}

/// False: there is no memory.
static bool mix_corner(mixture *mixed, int corner, int vertex)
{
    tf_face_attributes *made = &mixed->carried->made;
    const tf_origin *origin = &mixed->origin[corner];
    int from[3], row = -1;
    if (!find_rows(mixed, origin, from))
        return tf_ints_add(&made->corner, 1, &row);
    if (!tf_columns_mix(&made->texture, &mixed->carried->from.texture, from,
                        origin->barycentric))
        return false;
    row = find_same(mixed, vertex);
    if (row >= 0) {
        made->texture.rows--;
    } else {
        row = (int)made->texture.rows - 1;
        if (!tf_ints_add(&mixed->next, 1, &mixed->first.item[vertex]))
            return false;
        mixed->first.item[vertex] = row;
    }
    return tf_ints_add(&made->corner, 1, &row);
}

//: Order triangles by their headings
static int heading_of(const tf_carried_faces *carried, const tf_origin origin[],
                      int triangle)
{
    int face = carried->face[origin[3 * (size_t)triangle].triangle];
    return carried->from.heading.count > 0
               ? (int)*tf_columns_row(&carried->from.row, face)
               : 0;
}

/// Lists all triangles in `order`; `begin` has a zero for each heading and one
/// more.
static void order_triangles(const tf_carried_faces *carried,
                            const tf_origin origin[], int triangles,
                            int begin[], int order[])
{
    for (int t = 0; t < triangles; t++)
        begin[heading_of(carried, origin, t) + 1]++;
    for (size_t h = 0; h < carried->from.heading.count / TF_HEADING_LINES; h++)
        begin[h + 1] += begin[h];
    for (int t = 0; t < triangles; t++)
        order[begin[heading_of(carried, origin, t)]++] = t;
}

//: Carry faces over
static bool carry_triangle(mixture *mixed, const tf_mesh *mesh, int triangle)
{
    tf_carried_faces *carried = mixed->carried;
    size_t done = carried->made.row.rows;
    int face = carried->face[mixed->origin[3 * (size_t)triangle].triangle];
    bool good = tf_columns_add(&carried->made.row,
                               tf_columns_row(&carried->from.row, face));
    for (int i = 0; i < 3 && good; i++) {
        int corner = 3 * triangle + i, vertex = mesh->triangle[corner];
        carried->triangle[3 * done + (size_t)i] = vertex;
        good = carried->from.corner.count == 0 ||
               mix_corner(mixed, corner, vertex);
    }
    return good;
}

static bool carry_all(mixture *mixed, const tf_mesh *mesh, int begin[],
                      int order[])
{
    const int none = -1;
    for (int v = 0; v < mesh->vertices; v++)
        if (!tf_ints_add(&mixed->first, 1, &none))
            return false;
    order_triangles(mixed->carried, mixed->origin, mesh->triangles, begin,
                    order);
    for (int i = 0; i < mesh->triangles; i++)
        if (!carry_triangle(mixed, mesh, order[i]))
            return false;
    return true;
}

/// The same columns and lines.
static void begin_made(tf_carried_faces *carried)
{
    const tf_face_attributes *from = &carried->from;
    tf_face_attributes *made = &carried->made;
    made->text = from->text;
    made->library = from->library;
    made->heading = from->heading;
    made->texture_axes = from->texture_axes;
    made->row.count = from->row.count;
    memcpy(made->row.column, from->row.column, sizeof from->row.column);
    made->texture.count = from->texture.count;
    memcpy(made->texture.column, from->texture.column,
           sizeof from->texture.column);
}

bool tf_carried_faces_make(tf_carried_faces *carried, const tf_mesh_file *file,
                           const tf_adaptive_surface *surface)
{
    if (carried->from.row.rows == 0)
        return true;
    const tf_mesh *mesh = tf_adaptive_mesh(surface);
    size_t triangles = (size_t)mesh->triangles;
    mixture mixed = {.carried = carried,
                     .origin = tf_adaptive_corner_origins(surface)};
    begin_made(carried);
    carried->triangle = calloc(3 * triangles + 1, sizeof *carried->triangle);
    int *begin = calloc(carried->from.heading.count + 2, sizeof *begin);
    int *order = calloc(triangles + 1, sizeof *order);
    bool good = carried->triangle && begin && order &&
                carry_all(&mixed, mesh, begin, order);
    free(begin);
    free(order);
    free(mixed.first.item);
    free(mixed.next.item);
    return good || tf_mesh_file_fault_in_memory(file);
}

void tf_carried_faces_free(tf_carried_faces *carried)
{
    carried->made.library = carried->made.heading = (tf_excerpts){0};
    tf_face_attributes_free(&carried->made);
    tf_face_attributes_free(&carried->from);
    free(carried->face);
    free(carried->texture);
    free(carried->triangle);
    *carried = (tf_carried_faces){0};
}
