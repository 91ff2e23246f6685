// A rolled-up sheet, remeshed with and without the exact tests.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/remeshed.h"

#include "renderer/plot.h"
#include "surface/check.h"

enum {
    STATES = 3,
    ROUNDS = 3
};

static const double edge = 0.2, radius = 0.3, gap = 0.013, turns = 3,
                    edge_before = 0.07;

/// The height at which the roll is cut for the picture.
static const double height = 0.4901;

/// The parts of the plane that are shown: of all, and of what is enlarged.
static const double reach = 0.35, window[2] = {0.17, 0.245}, half = 0.085;

/// Of the pictures, in points of the page.
static const double side = 116;

/// How many edges pass through triangles.
static double crossings_of(const fig_some_mesh *mesh)
{
    tf_mesh given = fig_mesh_in_space(mesh);
    tf_surface *surface = NULL;
    tf_crossings found;
    TF_REQUIRE(tf_surface_create(&given, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_check(surface, mesh->vertices, mesh->x, NULL, &found,
                                NULL) == TF_OK);
    double count = (double)found.count;
    tf_surface_free(surface);
    return count;
}

/// Where the plane at that height cuts an edge; false if it does not.
static bool cut_edge(const double *a, const double *b, tf_vector *at)
{
    if ((a[2] < height) == (b[2] < height))
        return false;
    double part = (height - a[2]) / (b[2] - a[2]);
    *at = (tf_vector){
        {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), 0}};
    return true;
}

static bool is_within(const double range[2], double x)
{
    return range[0] <= x && x <= range[1];
}

/// The two places where a triangle is cut; false if it is not.
static bool cut_triangle(const fig_some_mesh *mesh, int triangle,
                         tf_vector cut[2])
{
    const int *v = mesh->triangle + 3 * (ptrdiff_t)triangle;
    tf_vector at[3];
    int cuts = 0;
    for (int i = 0; i < 3; i++)
        cuts += cut_edge(mesh->x + 3 * (ptrdiff_t)v[i],
                         mesh->x + 3 * (ptrdiff_t)v[(i + 1) % 3], &at[cuts]);
    for (int i = 0; i < 2 && cuts >= 2; i++)
        cut[i] = at[i];
    return cuts >= 2;
}

/// The section, as far as it is in the box.
static void draw_section(fig_page *page, const fig_plot *plot,
                         const fig_some_mesh *mesh, fig_role role, double dot)
{
    for (int t = 0; t < mesh->triangles; t++) {
        tf_vector cut[2];
        if (!cut_triangle(mesh, t, cut))
            continue;
        fig_point line[2];
        for (int i = 0; i < 2; i++)
            line[i] = (fig_point){cut[i].x[0], cut[i].x[1]};
        fig_plot_curve(
            page, plot, 2, line,
            (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_THIN});
        for (int i = 0; i < 2; i++)
            if (is_within(plot->x, line[i].x) && is_within(plot->y, line[i].y))
                fig_plot_dot(page, plot, line[i].x, line[i].y, dot, role);
    }
}

static void draw_frame(fig_page *page, const fig_plot *plot)
{
    fig_point corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = (fig_point){window[0] + (i % 3 ? 1 : -1) * half,
                                window[1] + (i / 2 ? 1 : -1) * half};
    fig_plot_curve(page, plot, 4, corner,
                   (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                .width = FIG_WIDTH_THIN,
                                .closed = true});
    fig_plot_curve(page, plot, 2, (fig_point[]){corner[3], corner[0]},
                   (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                .width = FIG_WIDTH_THIN});
}

/// All of it and, below, a part enlarged.
static void draw_state(fig_page *page, int i, const fig_some_mesh *mesh,
                       const char *title)
{
    double pitch = fig_page_width(page) / STATES, x = pitch * i + 6;
    fig_role role = i == 2 ? FIG_ROLE_CONTACT : FIG_ROLE_TRIANGLE;
    fig_plot all = {
        .box = {x, 16, side, side}, .x = {-reach, reach}, .y = {-reach, reach}};
    fig_plot part = {.box = {x, 26 + side, side, side},
                     .x = {window[0] - half, window[0] + half},
                     .y = {window[1] - half, window[1] + half}};
    draw_section(page, &all, mesh, role, 1.7);
    draw_section(page, &part, mesh, role, 3);
    draw_frame(page, &all);
    draw_frame(page, &part);
    fig_page_text(page, pitch * (i + 0.5), 10, FIG_ALIGN_CENTER, title,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    static fig_remeshing safe, unsafe;
    fig_some_mesh roll = fig_roll_of_sheet(radius, gap, turns, edge_before);
    if (safe.stages == 0) {
        fig_remesh(&roll, edge, ROUNDS, false, &safe);
        fig_remesh(&roll, edge, ROUNDS, true, &unsafe);
    }
    const fig_some_mesh *tangled = &unsafe.stage[unsafe.stages - 1];
    const fig_some_mesh *clear = &safe.stage[safe.stages - 1];
    draw_state(page, 0, &roll, "before");
    draw_state(page, 1, clear, "remeshed");
    draw_state(page, 2, tangled, "without exact tests");
    const tf_remesh_report *report = &safe.report[ROUNDS - 1];
    double tried = fig_remesh_tried(report), done = 0;
    for (int i = 0; i < TF_OPERATIONS; i++)
        done += fig_remesh_done(report, (tf_operation)i);
    fig_number(numbers, "gap", gap / edge);
    fig_number(numbers, "edge_before", edge_before / edge);
    fig_number(numbers, "tried", tried);
    fig_number(numbers, "refused", tried - done);
    fig_number(numbers, "triangles_before", roll.triangles);
    fig_number(numbers, "triangles", clear->triangles);
    fig_number(numbers, "tangled_triangles", tangled->triangles);
    fig_number(numbers, "clear_crossings", crossings_of(clear));
    fig_number(numbers, "crossings", crossings_of(tangled));
    fig_some_mesh_free(&roll);
}

const fig_figure fig_remeshed_roll = {
    .name = "remeshed-roll",
    .title = "A roll, remeshed with and without exact tests",
    .width = FIG_PAGE_WIDTH,
    .height = 264,
    .draw = draw,
};
