// The zone of a bump through a flat sheet: the sheet seen from above, and both in
// a section.
#include "base/require.h"
#include "kit/crossing_curves.h"
#include "kit/figures.h"
#include "kit/tangles.h"
#include "renderer/plot.h"
#include "untangle/zones.h"

#include <stdlib.h>

enum {
    RINGS = 1
};

/// Of the section, where no vertex is, and what is shown of both.
static const double cut_at = 0.0123, half = 0.72;

typedef struct zoned {
    fig_tangle tangle;
    fig_crossing_curves curves;
    int *zone; ///< of each triangle
    int zones;
} zoned;

static zoned find_zones(void)
{
    zoned z = {.tangle = fig_tangle_make("bump")};
    const fig_some_mesh *mesh = &z.tangle.mesh;
    tf_mesh given = fig_mesh_in_space(mesh);
    tf_surface *surface;
    z.curves = fig_crossing_curves_find(mesh, mesh->x);
    z.zone = malloc((size_t)mesh->triangles * sizeof *z.zone);
    TF_REQUIRE(z.zone);
    TF_REQUIRE(tf_surface_create(&given, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_zones(surface, mesh->vertices, mesh->x, RINGS,
                                z.zone, &z.zones, NULL) == TF_OK);
    tf_surface_free(surface);
    return z;
}

static void free_zones(zoned *z)
{
    fig_crossing_curves_free(&z->curves);
    fig_tangle_free(&z->tangle);
    free(z->zone);
}

static const int *corners_of(const zoned *z, int triangle)
{
    return z->tangle.mesh.triangle + 3 * (ptrdiff_t)triangle;
}

static bool is_of_sheet(const zoned *z, int triangle)
{
    return z->curves.part[corners_of(z, triangle)[0]] == 0;
}

static fig_paint paint_of(const zoned *z, int triangle)
{
    bool sheet = is_of_sheet(z, triangle);
    return (fig_paint){.role = z->zone[triangle] < 0
                                   ? FIG_ROLE_NEUTRAL
                               : sheet ? FIG_ROLE_TRIANGLE
                                       : FIG_ROLE_EDGE,
                       .shade = z->curves.crosses[triangle] ? 0 : -0.35};
}

// From above -------------------------------------------------------------------

static fig_point above(const zoned *z, const fig_plot *plot, int vertex)
{
    const double *x = z->tangle.mesh.x + 3 * (ptrdiff_t)vertex;
    return fig_plot_place(plot, x[0], x[1]);
}

/// The triangle at the other side of an edge of the mesh; -1: there is none.
static int beyond(const zoned *z, int triangle, int a, int b)
{
    for (int t = 0; t < z->tangle.mesh.triangles; t++) {
        const int *v = corners_of(z, t);
        int shared = 0;
        for (int i = 0; i < 3; i++)
            shared += v[i] == a || v[i] == b;
        if (t != triangle && shared == 2)
            return t;
    }
    return -1;
}

static bool is_shown(const zoned *z, int triangle)
{
    for (int i = 0; i < 3; i++) {
        const double *x = z->tangle.mesh.x +
                          3 * (ptrdiff_t)corners_of(z, triangle)[i];
        if (fabs(x[0]) > half || fabs(x[1]) > half)
            return false;
    }
    return is_of_sheet(z, triangle);
}

static void draw_triangle(fig_page *page, const fig_plot *plot, const zoned *z,
                          int triangle)
{
    fig_point at[3];
    for (int i = 0; i < 3; i++)
        at[i] = above(z, plot, corners_of(z, triangle)[i]);
    fig_paint paint = paint_of(z, triangle);
    paint.opacity = z->zone[triangle] < 0 ? 0.15 : 0.75;
    fig_page_fill(page, 3, at, paint);
    fig_page_line(page, 3, at,
                  (fig_stroke){.paint = {.role = FIG_ROLE_PAPER},
                               .width = FIG_WIDTH_THIN,
                               .closed = true});
}

/// Edges of the zone that have a triangle outside it; how many.
static int draw_border(fig_page *page, const fig_plot *plot, const zoned *z,
                       int triangle)
{
    int count = 0;
    const int *v = corners_of(z, triangle);
    for (int i = 0; i < 3 && z->zone[triangle] >= 0; i++) {
        int other = beyond(z, triangle, v[i], v[(i + 1) % 3]);
        if (other >= 0 && z->zone[other] == z->zone[triangle])
            continue;
        fig_page_line(page, 2,
                      (fig_point[]){above(z, plot, v[i]),
                                    above(z, plot, v[(i + 1) % 3])},
                      (fig_stroke){.width = 1.6});
        count++;
    }
    return count;
}

static int draw_above(fig_page *page, const zoned *z, fig_box box)
{
    fig_plot plot = {.box = box, .x = {-half, half}, .y = {-half, half}};
    int border = 0;
    for (int t = 0; t < z->tangle.mesh.triangles; t++)
        if (is_shown(z, t))
            draw_triangle(page, &plot, z, t);
    for (int t = 0; t < z->tangle.mesh.triangles; t++)
        if (is_shown(z, t))
            border += draw_border(page, &plot, z, t);
    for (int i = 0; i < z->curves.pieces; i++) {
        fig_point at[2];
        for (int k = 0; k < 2; k++)
            at[k] = fig_plot_place(&plot, z->curves.piece[i].at[k].x[0],
                                   z->curves.piece[i].at[k].x[1]);
        fig_page_line(page, 2, at,
                      (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT},
                                   .width = 1.6});
    }
    return border;
}

// In a section -----------------------------------------------------------------

static void draw_cut(fig_page *page, const fig_plot *plot, const zoned *z,
                     int triangle)
{
    fig_point cut[2];
    int cuts = 0;
    const int *v = corners_of(z, triangle);
    for (int i = 0; i < 3; i++) {
        const double *a = z->tangle.mesh.x + 3 * (ptrdiff_t)v[i],
                     *b = z->tangle.mesh.x + 3 * (ptrdiff_t)v[(i + 1) % 3];
        if ((a[1] < cut_at) == (b[1] < cut_at))
            continue;
        double part = (cut_at - a[1]) / (b[1] - a[1]);
        cut[cuts++] = (fig_point){a[0] + part * (b[0] - a[0]),
                                  a[2] + part * (b[2] - a[2])};
    }
    if (cuts < 2)
        return;
    fig_plot_curve(page, plot, 2, cut,
                   (fig_stroke){.paint = paint_of(z, triangle),
                                .width = z->zone[triangle] < 0 ? 1.1 : 2.4});
}

static void draw(fig_page *page, FILE *numbers)
{
    zoned z = find_zones();
    int of_zone = 0, crossing = 0;
    fig_box left = {6, 16, 150, 150};
    fig_plot plot = {.box = {186, 54, 190, 95},
                     .x = {-half, half},
                     .y = {-0.36, 0.36}};
    int border = draw_above(page, &z, left);
    for (int t = 0; t < z.tangle.mesh.triangles; t++) {
        draw_cut(page, &plot, &z, t);
        of_zone += z.zone[t] >= 0;
        crossing += z.curves.crosses[t];
    }
    fig_page_title(page, left, "the sheet from above");
    fig_page_title(page, (fig_box){186, 16, 190, 100}, "a section");
    fig_number(numbers, "triangles", z.tangle.mesh.triangles);
    fig_number(numbers, "crossings", (double)z.curves.crossings);
    fig_number(numbers, "crossing", crossing);
    fig_number(numbers, "zone", of_zone);
    fig_number(numbers, "zones", z.zones);
    fig_number(numbers, "border", border);
    free_zones(&z);
}

const fig_figure fig_zone_border = {
    .name = "zone-border",
    .title = "The zone of a bump through a sheet",
    .width = FIG_PAGE_WIDTH,
    .height = 172,
    .draw = draw,
};
