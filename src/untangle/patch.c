//: Include what patches need
#include "untangle/patch.h"

#include <math.h>
#include <string.h>

//: Go through the elements of a surface
/// Triangles, edges of no triangle, and vertices of no edge: whatever is near
/// one of these is near an element.  Of each, `corners` and how to find them.
typedef struct element {
    int corners;
    const int *corner;
} element;

static int count_all(const tf_neighbors *near)
{
    return near->triangles + near->edges + near->vertices;
}

/// An element by its number; one without corners if it is a side of others.
/// A vertex is listed at `own`.
static element element_of(const tf_neighbors *near, int number, int *own)
{
    int edge = number - near->triangles, vertex = edge - near->edges;
    if (edge < 0)
        return (element){3, near->triangle + 3 * (ptrdiff_t)number};
    if (vertex < 0)
        return (element){tf_list_length(&near->sides, edge) > 0 ? 0 : 2,
                         near->edge + 2 * (ptrdiff_t)edge};
    *own = vertex;
    return (element){tf_list_length(&near->around, vertex) > 0 ? 0 : 1, own};
}

//: Enclose an element
static void unite(tf_cell_box *box, tf_vector place, bool first)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = first ? place.x[k] : fmin(box->low[k], place.x[k]);
        box->high[k] = first ? place.x[k] : fmax(box->high[k], place.x[k]);
    }
}

static tf_cell_box box_at(const tf_neighbors *near, const double x[],
                          element own)
{
    tf_cell_box box = {.low = {0, 0, 0}};
    for (int c = 0; c < own.corners; c++)
        unite(&box, tf_place(near, x, own.corner[c]), c == 0);
    return box;
}

//: Fill the cells near what moves
static bool moves(const tf_vector move[], element own)
{
    tf_vector none = {{0, 0, 0}};
    for (int c = 0; c < own.corners; c++)
        if (!tf_vector_equals(move[own.corner[c]], none))
            return true;
    return false;
}

/// The box of an element and of its end, with some room around.
static tf_cell_box box_on_the_way(const tf_near_patch_source *source,
                                  const double x[], const tf_vector move[],
                                  element own)
{
    tf_cell_box box = box_at(source->near, x, own);
    for (int c = 0; c < own.corners; c++) {
        tf_vector place = tf_place(source->near, x, own.corner[c]);
        unite(&box, tf_vector_sum(place, 1, move[own.corner[c]]), false);
    }
    for (int k = 0; k < 3; k++) {
        box.low[k] -= 2 * source->edge;
        box.high[k] += 2 * source->edge;
    }
    return box;
}

static bool fill_cells(tf_near_patch *patch, const tf_near_patch_source *source,
                       const double x[], const tf_vector move[])
{
    const tf_neighbors *near = source->near;
    int count = count_all(near), vertex = 0;
    if (!tf_cells_begin(&patch->cells, near, x, source->edge,
                        near->facets + 64))
        return false;
    for (int i = 0; i < count; i++) {
        element own = element_of(near, i, &vertex);
        if (!moves(move, own))
            continue;
        tf_cell_box box = box_on_the_way(source, x, move, own);
        tf_cells_add(&patch->cells, &box);
    }
    tf_cells_sum(&patch->cells);
    return true;
}

//: List the elements of a patch
/// The lists of a mesh, with the numbers of the whole surface at first.
typedef struct cut {
    int *place; ///< of each vertex of the whole surface: its number, or -1
    int *triangle, *edge;
    int triangles, edges, particles;
} cut;

static bool reserve(tf_near_patch *patch, const tf_neighbors *near, cut *own)
{
    size_t v = (size_t)near->vertices, t = (size_t)near->triangles;
    size_t e = (size_t)near->edges, coordinates = (size_t)near->axes * v;
    if (!tf_buffer_reserve(&patch->marks, 2 * v, sizeof(int)) ||
        !tf_buffer_reserve(&patch->elements, 3 * t + 2 * e + 1, sizeof(int)) ||
        !tf_buffer_reserve(&patch->places, 2 * coordinates + 1, sizeof(double)))
        return false;
    own->place = patch->marks.data;
    patch->vertex = own->place + v;
    own->triangle = patch->elements.data;
    own->edge = own->triangle + 3 * t;
    patch->start = patch->places.data;
    patch->end = patch->start + coordinates;
    return true;
}

static void add_element(cut *own, element next)
{
    int *to = next.corners == 3 ? own->triangle + 3 * (ptrdiff_t)own->triangles
                                : own->edge + 2 * (ptrdiff_t)own->edges;
    for (int c = 0; c < next.corners; c++)
        own->place[next.corner[c]] = 0;
    if (next.corners > 1)
        memcpy(to, next.corner, (size_t)next.corners * sizeof *to);
    own->triangles += next.corners == 3;
    own->edges += next.corners == 2;
    own->particles += next.corners == 1;
}

/// All that reach the cells.
static void list_elements(const tf_near_patch *patch, const tf_neighbors *near,
                          const double x[], cut *own)
{
    int count = count_all(near), vertex = 0;
    memset(own->place, -1, (size_t)near->vertices * sizeof *own->place);
    for (int i = 0; i < count; i++) {
        element next = element_of(near, i, &vertex);
        tf_cell_box box = box_at(near, x, next);
        if (next.corners > 0 && tf_cells_touch(&patch->cells, &box))
            add_element(own, next);
    }
}

//: Number the vertices of a patch
static void renumber(const cut *own, int count, int corner[])
{
    for (int i = 0; i < count; i++)
        corner[i] = own->place[corner[i]];
}

static void number_vertices(tf_near_patch *patch, const tf_neighbors *near,
                            const cut *own)
{
    patch->vertices = 0;
    for (int v = 0; v < near->vertices; v++)
        if (own->place[v] >= 0) {
            own->place[v] = patch->vertices;
            patch->vertex[patch->vertices++] = v;
        }
    renumber(own, 3 * own->triangles, own->triangle);
    renumber(own, 2 * own->edges, own->edge);
}

//: Find a patch
static bool has_filter(const tf_surface *surface)
{
    return surface->filter.wanted || surface->filter.group;
}

/// Whether a cut is worth its costs: at most half of the surface.
static bool is_small(const tf_neighbors *near, const cut *own)
{
    long all = (long)near->triangles + near->vertices;
    long some = (long)own->triangles + own->edges + own->particles;
    return own->triangles + own->edges > 0 && 2 * some <= all;
}

/// Makes the surface of a cut, in the memory of the last one.
static tf_status make_surface(tf_near_patch *patch,
                              const tf_near_patch_source *source,
                              const cut *own)
{
    tf_mesh mesh = {source->near->axes, patch->vertices, own->triangles,
                    own->triangle,      own->edges,      own->edge};
    tf_status status = TF_OK;
    if (!patch->surface)
        status = tf_surface_create(&mesh, &patch->surface, NULL);
    else if (!tf_surface_refill(patch->surface, &mesh))
        status = TF_OUT_OF_MEMORY;
    if (status == TF_OK)
        patch->surface->workers.watch = source->surface->workers.watch;
    return status;
}

tf_status tf_near_patch_find(tf_near_patch *patch,
                             const tf_near_patch_source *source,
                             const double x[], const tf_vector move[])
{
    cut own = {.triangles = 0};
    patch->is_used = false;
    if (has_filter(source->surface) || !(source->edge > 0))
        return TF_OK;
    if (!reserve(patch, source->near, &own) ||
        !fill_cells(patch, source, x, move))
        return TF_OUT_OF_MEMORY;
    list_elements(patch, source->near, x, &own);
    if (!is_small(source->near, &own))
        return TF_OK;
    number_vertices(patch, source->near, &own);
    tf_status status = make_surface(patch, source, &own);
    patch->is_used = status == TF_OK;
    return status;
}

void tf_near_patch_free(tf_near_patch *patch)
{
    tf_surface_free(patch->surface);
    tf_cells_free(&patch->cells);
    tf_buffer_free(&patch->marks);
    tf_buffer_free(&patch->elements);
    tf_buffer_free(&patch->places);
}

//: Translate between a patch and the whole surface
void tf_near_patch_gather(const tf_near_patch *patch, const tf_neighbors *near,
                          const double x[], double own[])
{
    for (int v = 0; v < patch->vertices; v++)
        tf_put(near, own, v, tf_place(near, x, patch->vertex[v]));
}

void tf_near_patch_name(const tf_near_patch *patch, int count, int vertex[])
{
    for (int i = 0; i < count; i++)
        if (vertex[i] >= 0)
            vertex[i] = patch->vertex[vertex[i]];
}

//: Check that nothing leaves a patch
static bool stays(const tf_neighbors *near, const double x[], const double to[],
                  element own)
{
    for (int c = 0; c < own.corners; c++)
        if (!tf_vector_equals(tf_place(near, x, own.corner[c]),
                              tf_place(near, to, own.corner[c])))
            return false;
    return true;
}

bool tf_near_patch_covers(const tf_near_patch *patch, const tf_neighbors *near,
                          const double x[], const double to[])
{
    int count = count_all(near), vertex = 0;
    for (int i = 0; i < count; i++) {
        element own = element_of(near, i, &vertex);
        if (stays(near, x, to, own))
            continue;
        tf_cell_box box = box_at(near, x, own);
        for (int c = 0; c < own.corners; c++)
            unite(&box, tf_place(near, to, own.corner[c]), false);
        if (!tf_cells_cover(&patch->cells, &box))
            return false;
    }
    return true;
}
