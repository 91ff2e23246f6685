// A bumpy ball, remeshed within two distances.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/remeshed.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdlib.h>

enum {
    RINGS = 48,
    AROUND = 96,
    VERTICES = 2 + (RINGS - 1) * AROUND,
    TRIANGLES = 2 * AROUND * (RINGS - 1),
    BUMPS = 5,
    PANELS = 3
};

static const double bumps[BUMPS][3] = {{0.8, -0.5, 0.3},
                                       {0.9, 0.3, -0.2},
                                       {0.5, -0.2, 0.8},
                                       {0.4, -0.8, -0.4},
                                       {0.3, 0.8, 0.5}};

/// The radius in a direction.
static double radius_at(const double direction[3])
{
    double radius = 1;
    for (int b = 0; b < BUMPS; b++) {
        const double *at = bumps[b];
        double length = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
        double square = 0;
        for (int k = 0; k < 3; k++)
            square += pow(direction[k] - at[k] / length, 2);
        radius += 0.13 * exp(-square / 0.02);
    }
    return radius;
}

static void add_vertex(fig_some_mesh *ball, double polar, double around)
{
    double *x = ball->x + 3 * (ptrdiff_t)ball->vertices++;
    x[0] = sin(polar) * cos(around);
    x[1] = sin(polar) * sin(around);
    x[2] = cos(polar);
    double radius = radius_at(x);
    for (int k = 0; k < 3; k++)
        x[k] *= radius;
}

static void add(fig_some_mesh *ball, int a, int b, int c)
{
    int *v = ball->triangle + 3 * (ptrdiff_t)ball->triangles++;
    v[0] = a;
    v[1] = b;
    v[2] = c;
}

/// The vertex i of a ring, from 1; the poles are the first vertex and the last.
static int vertex_of(int ring, int i)
{
    return 1 + (ring - 1) * AROUND + i % AROUND;
}

static fig_some_mesh make_ball(void)
{
    fig_some_mesh ball = {.x = malloc(3 * VERTICES * sizeof(double)),
                          .triangle = malloc(3 * TRIANGLES * sizeof(int))};
    const double pi = acos(-1);
    TF_REQUIRE(ball.x && ball.triangle);
    add_vertex(&ball, 0, 0);
    for (int ring = 1; ring < RINGS; ring++)
        for (int i = 0; i < AROUND; i++)
            add_vertex(&ball, pi * ring / RINGS, 2 * pi * i / AROUND);
    add_vertex(&ball, pi, 0);
    for (int i = 0; i < AROUND; i++) {
        add(&ball, 0, vertex_of(1, i), vertex_of(1, i + 1));
        for (int r = 1; r + 1 < RINGS; r++) {
            add(&ball, vertex_of(r, i), vertex_of(r + 1, i),
                vertex_of(r + 1, i + 1));
            add(&ball, vertex_of(r, i), vertex_of(r + 1, i + 1),
                vertex_of(r, i + 1));
        }
        add(&ball, vertex_of(RINGS - 1, i), VERTICES - 1,
            vertex_of(RINGS - 1, i + 1));
    }
    return ball;
}

static const struct {
    const char *key;
    double error; ///< in percent of the diameter; 0: it stays as it is
} versions[PANELS] = {{"triangles", 0}, {"fine", 0.2}, {"coarse", 1}};

static void draw_version(fig_page *page, fig_box box, int i, FILE *numbers)
{
    fig_some_mesh ball = make_ball();
    tf_mesh mesh = fig_mesh_in_space(&ball);
    tf_adaptive_surface *surface;
    TF_REQUIRE(tf_adaptive_create(&mesh, ball.x, &surface, NULL) == TF_OK);
    tf_remesh_options how = {.size = sizeof how,
                             .error = 2 * versions[i].error / 100};
    if (how.error > 0)
        TF_REQUIRE(tf_adaptive_remesh(surface, &how, NULL, NULL) == TF_OK);
    tf_mesh now = *tf_adaptive_mesh(surface);
    fig_some_mesh shown = {now.vertices, now.triangles,
                           (double *)tf_adaptive_positions(surface),
                           (int *)now.triangle};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 70, .elevation = 15});
    fig_panel_margin(panel, 5);
    fig_draw_triangles(fig_panel_scene(panel), &shown,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE});
    char count[FIG_GROUPED], text[FIG_GROUPED + 16];
    fig_plot_grouped(shown.triangles, count);
    snprintf(text, sizeof text, "%s triangles", count);
    fig_page_caption(page, box, text);
    fig_number(numbers, versions[i].key, shown.triangles);
    tf_adaptive_free(surface);
    fig_some_mesh_free(&ball);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / PANELS;
    for (int i = 0; i < PANELS; i++)
        draw_version(page,
                     (fig_box){width * i, 0, width, fig_page_height(page) - 16},
                     i, numbers);
    fig_number(numbers, "fine_error", versions[1].error);
    fig_number(numbers, "coarse_error", versions[2].error);
}

const fig_figure fig_error_bumps = {
    .name = "error-bumps",
    .title = "A bumpy ball, remeshed within two distances",
    .width = FIG_PAGE_WIDTH,
    .height = 150,
    .draw = draw,
};
