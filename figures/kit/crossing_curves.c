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

static void find_pieces(fig_crossing_curves *curves, const tf_surface *surface,
                        int vertices, const double x[],
                        const tf_crossings *found)
{
    const tf_motion rest = {3, vertices, x, x};
    fig_shape shape;
    tf_vector *at = allocate((size_t)vertices, sizeof *at);
    for (int v = 0; v < vertices; v++)
        at[v] = place(x, v);
    TF_REQUIRE(fig_shape_make(&shape, surface, 3, &rest, FIG_UP_Z) &&
               fig_curve_pieces_find(&curves->pieces, &shape, at, found));
    fig_shape_free(&shape);
    free(at);
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
    find_pieces(&curves, surface, mesh->vertices, x, &found);
    find_regions(&curves, surface, mesh->vertices, x);
    tf_surface_free(surface);
    return curves;
}

void fig_crossing_curves_free(fig_crossing_curves *curves)
{
    fig_curve_pieces_free(&curves->pieces);
    free(curves->part);
    free(curves->wrong);
    *curves = (fig_crossing_curves){0};
}

// Drawing --------------------------------------------------------------------

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
