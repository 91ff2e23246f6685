//: Include what leaving defects alone needs
#include "surgery/frozen.h"

#include "base/fail.h"
#include "surgery/conditions.h"
#include "surgery/defects.h"
#include "surgery/orient.h"

#include <string.h>

//: Freeze vertices
/// Before that, no vertex is marked.  False if there is no memory.
static bool begin_freezing(tf_adaptive_surface *surface)
{
    size_t vertices = (size_t)surface->vertices;
    if (surface->marked > 0)
        return true;
    if (!tf_buffer_extend(&surface->frozen, vertices, sizeof(bool)))
        return false;
    memset(surface->frozen.data, false, vertices * sizeof(bool));
    surface->marked = surface->vertices;
    return true;
}

static void freeze(tf_adaptive_surface *surface, int count, const int vertex[])
{
    for (int i = 0; i < count; i++)
        ((bool *)surface->frozen.data)[vertex[i]] = true;
}

//: Freeze the triangles of an element
static bool has_vertices(const tf_adaptive_surface *surface, int triangle,
                         int count, const int vertex[])
{
    const int *own = tf_triangle(surface, triangle);
    int common = 0;
    for (int i = 0; i < count; i++)
        common +=
            own[0] == vertex[i] || own[1] == vertex[i] || own[2] == vertex[i];
    return common == count;
}

/// All vertices of the triangles that have a vertex, an edge or three corners.
static void freeze_around(tf_adaptive_surface *surface, int count,
                          const int vertex[])
{
    int c = tf_first_corner(surface, vertex[0]);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        if (has_vertices(surface, c / 3, count, vertex))
            freeze(surface, 3, tf_triangle(surface, c / 3));
}

//: Freeze what a defect is about
static void freeze_pair(tf_adaptive_surface *surface, const tf_error *defect)
{
    static const int first[] = {[TF_POINT_TRIANGLE_PAIR] = 1,
                                [TF_EDGE_EDGE_PAIR] = 2,
                                [TF_EDGE_TRIANGLE_PAIR] = 2};
    int count = first[defect->subject];
    int others = defect->subject == TF_EDGE_EDGE_PAIR ? 2 : 3;
    freeze_around(surface, count, defect->vertex);
    freeze_around(surface, others, defect->vertex + count);
}

static void freeze_defect(tf_adaptive_surface *surface, const tf_error *defect)
{
    if (defect->status == TF_EDGE_NOT_MANIFOLD)
        freeze(surface, 2, defect->vertex);
    else if (defect->status == TF_VERTEX_NOT_MANIFOLD)
        freeze(surface, 1, defect->vertex);
    else if (defect->status == TF_COLLINEAR)
        freeze(surface, 3, tf_triangle(surface, (int)defect->index));
    else
        freeze_pair(surface, defect);
}

//: List a defect
typedef struct defect_list {
    tf_defect_sink sink;
    tf_adaptive_surface *surface;
    tf_defects *all;
} defect_list;

static tf_status take(tf_defect_sink *sink, const tf_error *defect)
{
    defect_list *list = (defect_list *)sink;
    tf_adaptive_surface *surface = list->surface;
    tf_buffer *listed = &surface->lent.defect;
    if (!tf_buffer_extend(listed, list->all->count + 1, sizeof *defect) ||
        !begin_freezing(surface))
        return TF_OUT_OF_MEMORY;
    ((tf_error *)listed->data)[list->all->count++] = *defect;
    freeze_defect(surface, defect);
    return TF_OK;
}

//: Count what is frozen
static void count_frozen(const tf_adaptive_surface *surface, tf_defects *all)
{
    for (int v = 0; v < surface->marked; v++)
        all->vertices += tf_is_frozen(surface, v);
    for (int t = 0; t < surface->triangles; t++) {
        const int *v = tf_triangle(surface, t);
        all->triangles += tf_is_frozen_edge(surface, v[0], v[1]) &&
                          tf_is_frozen(surface, v[2]);
    }
}

//: Leave all defects alone
tf_status tf_leave_defects(tf_adaptive_surface *surface, const tf_mesh *mesh,
                           tf_error *error)
{
    tf_adaptive_lent *lent = &surface->lent;
    if (!tf_buffer_extend(&lent->defects, 1, sizeof(tf_defects)))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_defects *all = lent->defects.data;
    *all = (tf_defects){0};
    defect_list list = {{take}, surface, all};
    tf_status status =
        tf_fail(error, tf_orient_triangles(surface, &all->turned));
    if (status == TF_OK)
        status = tf_find_defects(surface, mesh, &list.sink, error);
    if (status == TF_OUT_OF_MEMORY)
        tf_fail(error, status);
    all->defect = lent->defect.data;
    count_frozen(surface, all);
    return status;
}

//: Refuse what is frozen
tf_status tf_check_freedom(const tf_adaptive_surface *surface, tf_error *error)
{
    if (surface->marked == 0)
        return tf_fail(error, TF_OK);
    const tf_error *first = surface->lent.defect.data;
    if (error)
        *error = *first;
    return first->status;
}
