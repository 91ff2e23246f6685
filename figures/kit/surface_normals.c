#include "kit/surface_normals.h"

#include <stdlib.h>
#include <string.h>

/// The cosine of the angle from which on an edge is a crease.
static const double crease_cosine = 0.8;

enum {
    FAN = 32 ///< triangles around a vertex, of which the normals are joined
};

/// The triangles around each vertex.
typedef struct fans {
    const fig_shape *shape;
    fig_normals *normals;
    int *first; ///< of each vertex: where its triangles begin in `triangle`
    int *triangle;
} fans;

static tf_vector normal_of(const fig_normals *normals, int triangle)
{
    const float *n = normals->triangle[triangle];
    return (tf_vector){{n[0], n[1], n[2]}};
}

static void find_triangle_normals(fig_normals *normals, const fig_shape *shape,
                                  double t)
{
    for (int i = 0; i < shape->triangles; i++) {
        tf_vector p[FIG_BENT_PIECES][3];
        fig_shape_pieces(shape, i, FIG_STRAIGHT, t, p);
        tf_vector n = fig_cross(fig_difference(p[0][1], p[0][0]),
                                fig_difference(p[0][2], p[0][0]));
        for (int k = 0; k < 3; k++)
            normals->triangle[i][k] = (float)n.x[k];
    }
}

// Creases ----------------------------------------------------------------

static bool is_crease(const fig_normals *normals, const fig_shape *shape,
                      int edge, const bool soft[])
{
    if (shape->degree[edge] != 2)
        return true;
    if (soft && soft[shape->part[shape->edge[2 * (size_t)edge]]])
        return false;
    tf_vector a = normal_of(normals, shape->beside[edge][0]);
    tf_vector b = normal_of(normals, shape->beside[edge][1]);
    return fig_shape_sense(shape, edge) * tf_vector_dot(a, b) <
           crease_cosine * fig_length(a) * fig_length(b);
}

// Fans -------------------------------------------------------------------

static bool find_fans(fans *f)
{
    size_t corners = 3 * (size_t)f->shape->triangles;
    size_t vertices = (size_t)f->shape->vertices;
    f->first = calloc(vertices + 2, sizeof(int));
    f->triangle = malloc((corners + 1) * sizeof(int));
    if (!f->first || !f->triangle)
        return false;
    // Count, then turn counts into places, one vertex behind: filling in moves
    // each to where the next begins.
    for (size_t c = 0; c < corners; c++)
        f->first[f->shape->triangle[c] + 2]++;
    for (size_t v = 2; v < vertices + 2; v++)
        f->first[v] += f->first[v - 1];
    for (size_t c = 0; c < corners; c++)
        f->triangle[f->first[f->shape->triangle[c] + 1]++] = (int)(c / 3);
    return true;
}

/// A part of a fan without creases: triangles, and for each 1 or -1, by which
/// its normal is to the same side as the others'.
typedef struct leaf {
    int count;
    int triangle[FAN];
    double sense[FAN];
} leaf;

static bool has(const leaf *l, int triangle)
{
    for (int i = 0; i < l->count; i++)
        if (l->triangle[i] == triangle)
            return true;
    return false;
}

/// Add the neighbor of the i-th triangle beyond one of its sides.
static void add_neighbor(const fans *f, leaf *l, int i, int edge)
{
    if (f->normals->crease[edge])
        return;
    const int *beside = f->shape->beside[edge];
    int other = beside[beside[0] == l->triangle[i]];
    if (has(l, other) || l->count == FAN)
        return;
    l->triangle[l->count] = other;
    l->sense[l->count++] = l->sense[i] * fig_shape_sense(f->shape, edge);
}

/// The triangles around a vertex that are joined to the first one there.
static leaf find_leaf(const fans *f, int vertex, int first)
{
    leaf l = {1, {first}, {1}};
    for (int i = 0; i < l.count; i++)
        for (int c = 0; c < 3; c++) {
            int edge = f->shape->side[3 * (size_t)l.triangle[i] + (size_t)c];
            const int *end = f->shape->edge + 2 * (size_t)edge;
            if (end[0] == vertex || end[1] == vertex)
                add_neighbor(f, &l, i, edge);
        }
    return l;
}

static float *corner_of(const fans *f, int triangle, int vertex)
{
    const int *v = f->shape->triangle + 3 * (size_t)triangle;
    size_t c = vertex == v[0] ? 0 : vertex == v[1] ? 1 : 2;
    return f->normals->corner[3 * (size_t)triangle + c];
}

static void set_corner(const fans *f, int triangle, int vertex, double sense,
                       tf_vector normal)
{
    float *corner = corner_of(f, triangle, vertex);
    for (int k = 0; k < 3; k++)
        corner[k] = (float)(sense * normal.x[k]);
}

/// Give the triangles of a leaf their mean normal; one of no area keeps zero.
static void light_leaf(const fans *f, const leaf *l, int vertex)
{
    tf_vector sum = {{0}};
    for (int i = 0; i < l->count; i++)
        sum = fig_combination(sum, l->sense[i],
                              normal_of(f->normals, l->triangle[i]));
    for (int i = 0; i < l->count; i++)
        set_corner(f, l->triangle[i], vertex, l->sense[i], fig_normalized(sum));
}

static bool is_set(const float corner[3])
{
    return corner[0] != 0 || corner[1] != 0 || corner[2] != 0;
}

static void light_fan(const fans *f, int vertex)
{
    int begin = f->first[vertex], end = f->first[vertex + 1];
    for (int i = begin; i < end; i++) {
        int triangle = f->triangle[i];
        if (is_set(corner_of(f, triangle, vertex)))
            continue;
        if (end - begin <= FAN) {
            leaf l = find_leaf(f, vertex, triangle);
            light_leaf(f, &l, vertex);
        } else {
            tf_vector own = normal_of(f->normals, triangle);
            set_corner(f, triangle, vertex, 1, fig_normalized(own));
        }
    }
}

// Normals ----------------------------------------------------------------

static bool light(fig_normals *normals, const fig_shape *shape)
{
    fans f = {.shape = shape, .normals = normals};
    bool good = find_fans(&f);
    for (int v = 0; v < shape->vertices && good; v++)
        light_fan(&f, v);
    free(f.first);
    free(f.triangle);
    return good;
}

bool fig_normals_find(fig_normals *normals, const fig_shape *shape, double t,
                      const bool soft[])
{
    size_t triangles = (size_t)shape->triangles;
    *normals = (fig_normals){
        .triangle = malloc((triangles + 1) * sizeof *normals->triangle),
        .corner = calloc(3 * triangles + 1, sizeof *normals->corner),
        .crease = malloc((size_t)shape->edges + 1)};
    if (!normals->triangle || !normals->corner || !normals->crease)
        return false;
    find_triangle_normals(normals, shape, t);
    for (int i = 0; i < shape->edges; i++)
        normals->crease[i] = is_crease(normals, shape, i, soft);
    return light(normals, shape);
}

void fig_normals_free(fig_normals *normals)
{
    free(normals->triangle);
    free(normals->corner);
    free(normals->crease);
}
