#include "kit/crossing_curves.h"

#include "base/require.h"
#include "untangle/regions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *allocate(size_t count, size_t size)
{
    void *made = calloc(count + 1, size);
    TF_REQUIRE(made);
    return made;
}

static tf_vector place(const double x[], int vertex)
{
    return fig_vector_of(x + 3 * (ptrdiff_t)vertex);
}

// The curves -----------------------------------------------------------------

/// A point where an edge of the one triangle passes through the other.
typedef struct passage {
    int triangle[2];
    tf_vector at;
} passage;

static bool has_vertex(const fig_some_mesh *mesh, int triangle, int vertex)
{
    const int *v = mesh->triangle + 3 * (ptrdiff_t)triangle;
    return v[0] == vertex || v[1] == vertex || v[2] == vertex;
}

static tf_vector find_passage(const double x[], const int v[5])
{
    tf_vector c = place(x, v[2]);
    tf_vector normal = fig_cross(fig_difference(place(x, v[3]), c),
                                 fig_difference(place(x, v[4]), c));
    double a = tf_vector_dot(normal, fig_difference(place(x, v[0]), c));
    double b = tf_vector_dot(normal, fig_difference(place(x, v[1]), c));
    return fig_lerp(place(x, v[0]), place(x, v[1]), a / (a - b));
}

static int compare_passages(const void *a, const void *b)
{
    const passage *p = a, *q = b;
    for (int i = 0; i < 2; i++)
        if (p->triangle[i] != q->triangle[i])
            return p->triangle[i] < q->triangle[i] ? -1 : 1;
    return 0;
}

/// Add a passage for each triangle at the edge.
static int add_passages(const fig_some_mesh *mesh, const double x[],
                        const int v[5], passage *to)
{
    int count = 0, through = 0;
    while (!has_vertex(mesh, through, v[2]) ||
           !has_vertex(mesh, through, v[3]) || !has_vertex(mesh, through, v[4]))
        through++;
    for (int t = 0; t < mesh->triangles && count < 2; t++)
        if (has_vertex(mesh, t, v[0]) && has_vertex(mesh, t, v[1]))
            to[count++] = (passage){
                {t < through ? t : through, t < through ? through : t},
                find_passage(x, v)};
    return count;
}

/// The vertex that two triangles share, if they share one; -1: they do not.
static int shared_vertex(const fig_some_mesh *mesh, const int triangle[2])
{
    const int *v = mesh->triangle + 3 * (ptrdiff_t)triangle[0];
    for (int i = 0; i < 3; i++)
        if (has_vertex(mesh, triangle[1], v[i]))
            return v[i];
    return -1;
}

/// Two passages of the same two triangles are the ends of a piece; a single one
/// goes on to the vertex that they share.
static void join_passages(fig_crossing_curves *curves,
                          const fig_some_mesh *mesh, const double x[],
                          int count, const passage passages[])
{
    for (int i = 0; i < count; i++) {
        const passage *p = &passages[i];
        fig_curve_piece *piece = &curves->piece[curves->pieces];
        int shared = shared_vertex(mesh, p->triangle);
        memcpy(piece->triangle, p->triangle, sizeof p->triangle);
        piece->at[0] = p->at;
        if (i + 1 < count && compare_passages(p, p + 1) == 0)
            piece->at[1] = passages[++i].at;
        else if (shared >= 0)
            piece->at[1] = place(x, shared);
        else
            continue;
        curves->pieces++;
    }
    for (int i = 0; i < curves->pieces; i++)
        for (int k = 0; k < 2; k++)
            curves->crosses[curves->piece[i].triangle[k]] = true;
}

static void find_pieces(fig_crossing_curves *curves, const fig_some_mesh *mesh,
                        const double x[], const tf_crossings *found)
{
    passage *all = allocate(2 * found->count, sizeof *all);
    int count = 0;
    for (size_t i = 0; i < found->count; i++)
        if (found->crossing[i].kind == TF_EDGE_THROUGH_TRIANGLE)
            count +=
                add_passages(mesh, x, found->crossing[i].vertex, all + count);
    qsort(all, (size_t)count, sizeof *all, compare_passages);
    curves->piece = allocate((size_t)count, sizeof *curves->piece);
    join_passages(curves, mesh, x, count, all);
    free(all);
}

// What they cut --------------------------------------------------------------

/// What the library takes for wrong.
static void find_regions(fig_crossing_curves *curves, tf_surface *surface,
                         int vertices, const double x[])
{
    tf_tangle tangle = {.surface = surface,
                        .fixed = allocate((size_t)vertices, sizeof(bool)),
                        .in = x};
    tf_curves found = {0};
    tf_regions regions = {0};
    TF_REQUIRE(tf_tangle_begin(&tangle) &&
               tf_tangle_check(&tangle, x) == TF_OK &&
               tf_curves_find(&found, &tangle, x));
    int *preferred = allocate((size_t)tangle.near.parts, sizeof *preferred);
    for (int i = 0; i < tangle.near.parts; i++)
        preferred[i] = -1;
    TF_REQUIRE(tf_regions_find(&regions, &tangle, &found, preferred));
    curves->parts = tangle.near.parts;
    curves->regions = regions.count;
    for (int v = 0; v < vertices; v++) {
        curves->part[v] = tangle.near.part[v];
        curves->wrong[v] =
            tf_is_wrong(&regions, &tangle.near, regions.region[v]);
        curves->wrongs += curves->wrong[v];
    }
    tf_regions_free(&regions);
    tf_curves_free(&found);
    tf_tangle_end(&tangle);
    free(preferred);
    free((void *)tangle.fixed);
}

fig_crossing_curves fig_crossing_curves_find(const fig_some_mesh *mesh,
                                             const double x[])
{
    fig_crossing_curves curves = {0};
    tf_mesh given = fig_mesh_in_space(mesh);
    tf_surface *surface = NULL;
    tf_crossings found;
    TF_REQUIRE(tf_surface_create(&given, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_check(surface, mesh->vertices, x, NULL, &found,
                                NULL) == TF_OK);
    size_t vertices = (size_t)mesh->vertices;
    curves.crossings = found.count;
    curves.part = allocate(vertices, sizeof(int));
    curves.wrong = allocate(vertices, sizeof(bool));
    curves.crosses = allocate((size_t)mesh->triangles, sizeof(bool));
    find_pieces(&curves, mesh, x, &found);
    find_regions(&curves, surface, mesh->vertices, x);
    tf_surface_free(surface);
    return curves;
}

void fig_crossing_curves_free(fig_crossing_curves *curves)
{
    free(curves->piece);
    free(curves->crosses);
    free(curves->part);
    free(curves->wrong);
    *curves = (fig_crossing_curves){0};
}

// Drawing --------------------------------------------------------------------

void fig_crossing_curves_draw(fig_scene *scene,
                              const fig_crossing_curves *curves, double width)
{
    for (int i = 0; i < curves->pieces; i++)
        fig_scene_tube(scene, curves->piece[i].at[0], curves->piece[i].at[1],
                       width, (fig_paint){.role = FIG_ROLE_CONTACT});
}

/// The normals of the vertices, those of their triangles added up.
static tf_vector *find_normals(const fig_some_mesh *mesh, const double x[])
{
    tf_vector *normal = allocate((size_t)mesh->vertices, sizeof *normal);
    for (int t = 0; t < mesh->triangles; t++) {
        const int *v = mesh->triangle + 3 * (ptrdiff_t)t;
        tf_vector a = place(x, v[0]);
        tf_vector n = fig_cross(fig_difference(place(x, v[1]), a),
                                fig_difference(place(x, v[2]), a));
        for (int i = 0; i < 3; i++)
            normal[v[i]] = fig_sum(normal[v[i]], n);
    }
    return normal;
}

static void draw_lines(fig_scene *scene, const tf_vector at[3], double lines,
                       fig_paint paint)
{
    paint.shade += 0.3;
    for (int i = 0; i < 3; i++)
        fig_scene_tube(scene, at[i], at[(i + 1) % 3], lines, paint);
}

static void draw_facet(fig_scene *scene, const tf_vector at[3],
                       const tf_vector normal[3], fig_paint paint)
{
    fig_facet *facet = fig_scene_facets(scene, 1);
    if (!facet)
        return;
    facet->role = paint.role;
    facet->shade = (float)paint.shade;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) {
            facet->at[c][k] = (float)at[c].x[k];
            facet->normal[c][k] = (float)normal[c].x[k];
        }
}

void fig_draw_smooth_mesh(fig_scene *scene, const fig_some_mesh *mesh,
                          const double x[], double lines,
                          fig_triangle_paint *paint, const void *context)
{
    tf_vector *normals = find_normals(mesh, x);
    for (int t = 0; t < mesh->triangles; t++) {
        const int *v = mesh->triangle + 3 * (ptrdiff_t)t;
        fig_paint paints = {0};
        if (!paint(context, t, &paints))
            continue;
        tf_vector at[3], normal[3];
        for (int i = 0; i < 3; i++) {
            at[i] = place(x, v[i]);
            normal[i] = fig_normalized(normals[v[i]]);
            fig_scene_reach(scene, at[i]);
        }
        if (paints.opacity > 0)
            fig_scene_triangle(scene, at, 0, paints);
        else
            draw_facet(scene, at, normal, paints);
        if (lines > 0)
            draw_lines(scene, at, lines, paints);
    }
    free(normals);
}
