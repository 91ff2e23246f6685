// A nut before its remeshing, and after it with sharp edges and without.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/remeshed.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDES = 6,
    AROUND = 36, ///< corners of the hole
    VERTICES = 2 * (SIDES + AROUND),
    TRIANGLES = 4 * (SIDES + AROUND),
    PANELS = 4
};

static const double height = 0.8, radius = 0.5;

static void add(fig_some_mesh *mesh, int a, int b, int c)
{
    int *v = mesh->triangle + 3 * (ptrdiff_t)mesh->triangles++;
    v[0] = a;
    v[1] = b;
    v[2] = c;
}

/// A ring of corners at the bottom, and one at the top.
static void add_rings(fig_some_mesh *mesh, int corners, double r)
{
    for (int i = 0; i < 2 * corners; i++) {
        double angle = 2 * acos(-1) * (i % corners) / corners;
        double *x = mesh->x + 3 * (ptrdiff_t)mesh->vertices++;
        x[0] = r * cos(angle);
        x[1] = r * sin(angle);
        x[2] = i < corners ? 0 : height;
    }
}

/// The wall between two rings; it faces inward if `inside`.
static void add_wall(fig_some_mesh *mesh, int first, int corners, bool inside)
{
    for (int i = 0; i < corners; i++) {
        int a = first + i, b = first + (i + 1) % corners;
        int from = inside ? b : a, to = inside ? a : b;
        add(mesh, from, to, to + corners);
        add(mesh, from, to + corners, from + corners);
    }
}

/// A face between an outer ring and the hole, upward or downward: a fan of the
/// hole's edges at each corner.
static void add_face(fig_some_mesh *mesh, int outer, int inner, bool up)
{
    const int share = AROUND / SIDES;
    for (int i = 0; i < AROUND; i++) {
        int corner = outer + (i + share / 2) / share % SIDES;
        int a = inner + i, b = inner + (i + 1) % AROUND;
        add(mesh, corner, up ? b : a, up ? a : b);
    }
    for (int i = 0; i < SIDES; i++) {
        int a = outer + i, b = outer + (i + 1) % SIDES;
        int middle = inner + i * share + share / 2;
        add(mesh, up ? a : b, up ? b : a, middle);
    }
}

static fig_some_mesh make_nut(void)
{
    fig_some_mesh mesh = {.x = malloc(3 * VERTICES * sizeof(double)),
                          .triangle = malloc(3 * TRIANGLES * sizeof(int))};
    const int inner = 2 * SIDES;
    TF_REQUIRE(mesh.x && mesh.triangle);
    add_rings(&mesh, SIDES, 1);
    add_rings(&mesh, AROUND, radius);
    add_wall(&mesh, 0, SIDES, false);
    add_wall(&mesh, inner, AROUND, true);
    add_face(&mesh, SIDES, inner + AROUND, true);
    add_face(&mesh, 0, inner, false);
    return mesh;
}

static const struct {
    const char *key, *title;
    double edge, crease; ///< an edge of 0: it stays as it is
} versions[PANELS] = {
    {"before", "as it was", 0, 0},
    {"fine", "remeshed", 0.13, 0},
    {"lost", "from 61 degrees on", 0.13, 61},
    {"coarse", "coarse", 0.45, 0},
};

static void draw_version(fig_page *page, fig_box box, int i, FILE *numbers)
{
    fig_some_mesh nut = make_nut();
    tf_mesh mesh = fig_mesh_in_space(&nut);
    tf_adaptive_surface *surface;
    TF_REQUIRE(tf_adaptive_create(&mesh, nut.x, &surface, NULL) == TF_OK);
    tf_remesh_options how = {.size = sizeof how,
                             .edge = versions[i].edge,
                             .crease = versions[i].crease};
    if (how.edge > 0)
        TF_REQUIRE(tf_adaptive_remesh(surface, &how, NULL, NULL) == TF_OK);
    tf_mesh now = *tf_adaptive_mesh(surface);
    fig_some_mesh shown = {now.vertices, now.triangles,
                           (double *)tf_adaptive_positions(surface),
                           (int *)now.triangle};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 20, .elevation = 38});
    fig_panel_margin(panel, 5);
    fig_draw_triangles(fig_panel_scene(panel), &shown,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE});
    fig_page_caption(page, box, versions[i].title);
    char key[32];
    snprintf(key, sizeof key, "%s_triangles", versions[i].key);
    fig_number(numbers, key, shown.triangles);
    tf_adaptive_free(surface);
    fig_some_mesh_free(&nut);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / PANELS;
    for (int i = 0; i < PANELS; i++)
        draw_version(page,
                     (fig_box){width * i, 0, width, fig_page_height(page) - 16},
                     i, numbers);
}

const fig_figure fig_sharp_nut = {
    .name = "sharp-nut",
    .title = "A nut, remeshed with sharp edges and without",
    .width = FIG_PAGE_WIDTH,
    .height = 110,
    .draw = draw,
};
