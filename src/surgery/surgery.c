//: Include what surgery needs
#include "surgery/surgery.h"

#include "surgery/star.h"

#include <string.h>

//: Make room for a surgery
static bool reserve_lists(tf_surgery *surgery, size_t most)
{
    return tf_buffer_extend(&surgery->removed, most, sizeof(int)) &&
           tf_buffer_extend(&surgery->added, most, sizeof(tf_added_triangle)) &&
           tf_buffer_extend(&surgery->swept, most,
                            sizeof(tf_swept_tetrahedron)) &&
           tf_buffer_extend(&surgery->boundary, most, 2 * sizeof(int));
}

bool tf_surgery_begin(tf_adaptive_surface *surface, int most)
{
    tf_surgery *surgery = &surface->surgery;
    surgery->removals = surgery->additions = 0;
    surgery->sweeps = surgery->boundary_edges = 0;
    surgery->placed = surgery->earlier = 0;
    surgery->path[0] = surgery->path[1] = TF_NONE;
    return reserve_lists(surgery, (size_t)most) &&
           tf_adaptive_reserve(surface, surface->vertices, surface->triangles,
                               most);
}

void tf_surgery_free(tf_surgery *surgery)
{
    tf_buffer_free(&surgery->removed);
    tf_buffer_free(&surgery->added);
    tf_buffer_free(&surgery->swept);
    tf_buffer_free(&surgery->boundary);
}

//: Place a vertex
int tf_surgery_place(tf_adaptive_surface *surface, const double position[3])
{
    int vertex = surface->vertices + surface->surgery.placed++;
    memcpy((double *)surface->position.data + 3 * (ptrdiff_t)vertex, position,
           3 * sizeof *position);
    return vertex;
}

//: Exchange triangles
void tf_surgery_remove(tf_adaptive_surface *surface, int triangle)
{
    tf_surgery *surgery = &surface->surgery;
    ((int *)surgery->removed.data)[surgery->removals++] = triangle;
}

void tf_surgery_add(tf_adaptive_surface *surface, int a, int b, int c)
{
    tf_surgery *surgery = &surface->surgery;
    const int vertex[] = {a, b, c};
    ((tf_added_triangle *)surgery->added.data)[surgery->additions++] =
        (tf_added_triangle){tf_facet_of(surface, vertex),
                            tf_aabb_of(surface, 3, vertex)};
}

//: Sweep
void tf_surgery_sweep(tf_adaptive_surface *surface, int a, int b, int c, int d)
{
    tf_surgery *surgery = &surface->surgery;
    const int vertex[] = {a, b, c, d};
    const double *corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = tf_vertex_coordinates(surface, vertex[i]);
    ((tf_swept_tetrahedron *)surgery->swept.data)[surgery->sweeps++] =
        (tf_swept_tetrahedron){tf_tetrahedron_of(vertex, corner),
                               tf_aabb_of(surface, 4, vertex)};
}

void tf_surgery_move(tf_adaptive_surface *surface, int from, int to)
{
    surface->surgery.path[0] = from;
    surface->surgery.path[1] = to;
}

//: Keep the boundary
void tf_surgery_keep(tf_adaptive_surface *surface, int corner)
{
    tf_surgery *surgery = &surface->surgery;
    if (!tf_is_boundary_edge(surface, corner))
        return;
    int *edge = (int *)surgery->boundary.data +
                2 * (ptrdiff_t)surgery->boundary_edges++;
    edge[0] = tf_vertex_at(surface, corner);
    edge[1] = tf_vertex_at(surface, tf_corner_after(corner));
}

//: Do a surgery
void tf_surgery_commit(tf_adaptive_surface *surface)
{
    const tf_surgery *surgery = &surface->surgery;
    const int *removed = surgery->removed.data;
    const tf_added_triangle *added = surgery->added.data;
    for (int i = 0; i < surgery->removals; i++)
        tf_triangle_remove(surface, removed[i]);
    for (int i = 0; i < surgery->additions; i++)
        tf_triangle_add(surface, added[i].facet.vertex);
}

//: Accept what was placed
void tf_surgery_accept(tf_adaptive_surface *surface)
{
    for (int i = 0; i < surface->surgery.placed; i++)
        ((int *)surface->first.data)[surface->vertices++] = TF_NONE;
}
