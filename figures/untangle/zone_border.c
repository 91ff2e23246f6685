// The zone of two sheets that cross, and what is kept at its border, drawn
// apart.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/tangle_picture.h"
#include "untangle/tangled_zones.h"

#include <stdlib.h>
#include <string.h>

enum {
    RINGS = 1
};

static const double lift = 1.5; // of the second sheet

/// A surface with one zone.
typedef struct zoned {
    const fig_tangle *tangle;
    fig_crossing_curves curves;
    tf_surface *surface;
    int edges, triangles;
    const int *edge, *triangle; ///< of the surface
    int *zone;                  ///< of each triangle
    int zones, core; ///< how many zones; how many triangles without the ring
} zoned;

static void find_zones(zoned *all, int rings)
{
    const fig_some_mesh *mesh = &all->tangle->mesh;
    TF_REQUIRE(tf_surface_zones(all->surface, mesh->vertices, mesh->x, rings,
                                NULL, all->zone, &all->zones, NULL,
                                NULL) == TF_OK);
}

static int triangles_in_zones(const zoned *all)
{
    int count = 0;
    for (int i = 0; i < all->triangles; i++)
        count += all->zone[i] >= 0;
    return count;
}

static zoned zoned_make(const fig_tangle *tangle)
{
    const fig_some_mesh *mesh = &tangle->mesh;
    zoned all = {.tangle = tangle,
                 .curves = fig_crossing_curves_find(mesh, mesh->x)};
    tf_mesh own = fig_mesh_in_space(mesh);
    TF_REQUIRE(tf_surface_create(&own, &all.surface, NULL) == TF_OK);
    all.edge = tf_surface_edges(all.surface, &all.edges);
    all.triangle = tf_surface_triangles(all.surface, &all.triangles);
    all.zone = calloc((size_t)all.triangles, sizeof *all.zone);
    TF_REQUIRE(all.zone);
    find_zones(&all, 0);
    all.core = triangles_in_zones(&all);
    find_zones(&all, RINGS);
    return all;
}

static void zoned_free(zoned *all)
{
    fig_crossing_curves_free(&all->curves);
    tf_surface_free(all->surface);
    free(all->zone);
}

// What the zone holds ---------------------------------------------------------

static bool has(int corners, const int corner[], int vertex)
{
    for (int i = 0; i < corners; i++)
        if (corner[i] == vertex)
            return true;
    return false;
}

static bool has_all(const zoned *all, int triangle, int corners, const int v[])
{
    for (int i = 0; i < corners; i++)
        if (!has(3, all->triangle + 3 * (ptrdiff_t)triangle, v[i]))
            return false;
    return true;
}

/// How many triangles at an element are in the zone, and how many are not.
typedef struct sides {
    int in, out;
} sides;

static sides sides_of(const zoned *all, int corners, const int v[])
{
    sides count = {0, 0};
    for (int i = 0; i < all->triangles; i++)
        if (has_all(all, i, corners, v))
            *(all->zone[i] >= 0 ? &count.in : &count.out) += 1;
    return count;
}

static bool share_vertex(int corners, const int v[], int others, const int w[])
{
    for (int i = 0; i < corners; i++)
        if (has(others, w, v[i]))
            return true;
    return false;
}

/// Elements of so many corners, of which some triangles are in the zone.
typedef struct touched {
    int count, *place;
    sides *side;
} touched;

static touched touched_of(const zoned *all, int count, int corners,
                          const int *corner)
{
    touched found = {.place = malloc(sizeof(int) * (size_t)count),
                     .side = malloc(sizeof(sides) * (size_t)count)};
    TF_REQUIRE(found.place && found.side);
    for (int i = 0; i < count; i++) {
        sides own = corners > 1 ? sides_of(all, corners,
                                           corner + corners * (ptrdiff_t)i)
                                : sides_of(all, 1, &i);
        if (own.in == 0)
            continue;
        found.place[found.count] = i;
        found.side[found.count++] = own;
    }
    return found;
}

static void touched_free(touched *found)
{
    free(found->place);
    free(found->side);
}

static int kept_vertices(const zoned *all)
{
    touched points = touched_of(all, all->tangle->mesh.vertices, 1, NULL);
    int kept = 0;
    for (int i = 0; i < points.count; i++)
        for (int t = 0; t < all->triangles && points.side[i].out > 0; t++)
            kept += all->zone[t] >= 0 && !has_all(all, t, 1, &points.place[i]);
    touched_free(&points);
    return kept;
}

static int kept_edges(const zoned *all)
{
    touched edges = touched_of(all, all->edges, 2, all->edge);
    int kept = 0;
    for (int i = 0; i < edges.count; i++)
        for (int j = i + 1; j < edges.count; j++) {
            const int *a = all->edge + 2 * (ptrdiff_t)edges.place[i];
            const int *b = all->edge + 2 * (ptrdiff_t)edges.place[j];
            bool border = edges.side[i].out > 0 || edges.side[j].out > 0;
            kept += border && !share_vertex(2, a, 2, b);
        }
    touched_free(&edges);
    return kept;
}

// The picture -----------------------------------------------------------------

static bool is_in_zone(const zoned *all, const int v[3])
{
    for (int i = 0; i < all->triangles; i++)
        if (has_all(all, i, 3, v))
            return all->zone[i] >= 0;
    return false;
}

static bool paint_zone(const void *context, int triangle, fig_paint *paint)
{
    const zoned *all = context;
    const int *v = all->tangle->mesh.triangle + 3 * (ptrdiff_t)triangle;
    *paint = (fig_paint){.role = is_in_zone(all, v)
                                     ? FIG_ROLE_POINT
                                     : fig_part_role(&all->curves, v[0])};
    return true;
}

static tf_vector place_of(const zoned *all, int vertex)
{
    tf_vector at = fig_vector_of(all->tangle->mesh.x + 3 * (ptrdiff_t)vertex);
    at.x[2] += all->curves.part[vertex] == 0 ? 0 : lift;
    return at;
}

/// Edges with one triangle in the zone and another one that is in none.
static void draw_border(fig_scene *scene, const zoned *all)
{
    for (int i = 0; i < all->edges; i++) {
        const int *edge = all->edge + 2 * (ptrdiff_t)i;
        sides own = sides_of(all, 2, edge);
        if (own.in > 0 && own.out > 0)
            fig_scene_tube(scene, place_of(all, edge[0]),
                           place_of(all, edge[1]), 2.2,
                           (fig_paint){.role = FIG_ROLE_INK});
    }
}

static void draw_apart(fig_page *page, fig_box box, const zoned *all)
{
    const fig_some_mesh *mesh = &all->tangle->mesh;
    double *x = malloc(3 * (size_t)mesh->vertices * sizeof *x);
    fig_panel *panel = fig_page_panel(page, box);
    fig_scene *scene = fig_panel_scene(panel);
    fig_panel_look(panel, all->tangle->camera);
    fig_panel_margin(panel, 5);
    TF_REQUIRE(x);
    for (int v = 0; v < mesh->vertices; v++) {
        tf_vector at = place_of(all, v);
        memcpy(x + 3 * (ptrdiff_t)v, at.x, sizeof at.x);
    }
    fig_draw_smooth_mesh(scene, mesh, x, 0.4, paint_zone, all);
    draw_border(scene, all);
    free(x);
}

static void print_numbers(FILE *numbers, const zoned *all)
{
    fig_number(numbers, "zones", all->zones);
    fig_number(numbers, "core", all->core);
    fig_number(numbers, "zone", triangles_in_zones(all));
    fig_number(numbers, "triangles", all->triangles);
    fig_number(numbers, "border", kept_vertices(all) + kept_edges(all));
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / 2, height = fig_page_height(page) - 4;
    fig_tangle tangle = fig_tangle_make("half way in");
    zoned all = zoned_make(&tangle);
    fig_tangle_draw(page, (fig_box){0, 0, width, height}, &tangle,
                    tangle.mesh.x);
    draw_apart(page, (fig_box){width, 0, width, height}, &all);
    print_numbers(numbers, &all);
    zoned_free(&all);
    fig_tangle_free(&tangle);
}

const fig_figure fig_zone_border = {
    .name = "zone-border",
    .title = "The zone of two sheets that cross, and its border",
    .width = FIG_PAGE_WIDTH,
    .height = 170,
    .draw = draw,
};
