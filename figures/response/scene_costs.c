// What a step of each scene costs, and how that grows with the triangles.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <stdio.h>

enum {
    SCENES = 7,
    SIZES = 5
};

static const char *const scenes[SCENES] = {
    "sphere", "stack", "twist", "knot", "curtain", "flag", "plane-chain"};

static const int sizes[SIZES] = {22, 39, 69, 123, 181};

static const char *const part[] = {"dynamics", "response"};

static const fig_role role[] = {FIG_ROLE_EDGE, FIG_ROLE_CONTACT};

/// Processor time, of the response what is left of a step.
static double cost_of(const char *scene, int i)
{
    double dynamics = fig_measured("simulation %s coupled dynamics", scene);
    double step = fig_measured("simulation %s coupled step", scene);
    return i == 0 ? dynamics : step - dynamics;
}

static void draw_scenes(fig_page *page)
{
    double most = 0;
    for (int s = 0; s < SCENES; s++) {
        double sum = cost_of(scenes[s], 0) + cost_of(scenes[s], 1);
        most = sum > most ? sum : most;
    }
    for (int s = 0; s < SCENES; s++) {
        double x = 62, y = 22 + 20.0 * s;
        fig_page_text(page, x - 5, y + 9, FIG_ALIGN_RIGHT, scenes[s],
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        for (int i = 0; i < 2; i++) {
            double length = 92 * cost_of(scenes[s], i) / most;
            fig_page_fill_box(page, (fig_box){x, y, length, 12},
                              (fig_paint){.role = role[i]});
            x += length;
        }
        char text[32];
        snprintf(text, sizeof text, "%.0f",
                 cost_of(scenes[s], 0) + cost_of(scenes[s], 1));
        fig_page_text(page, x + 4, y + 9, FIG_ALIGN_LEFT, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
    fig_page_text(page, 62, 14, FIG_ALIGN_LEFT, "milliseconds a step",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_growth(fig_page *page)
{
    fig_plot plot = {.box = {232, 22, 144, 120},
                     .x = {700, 150000},
                     .y = {0.3, 30000},
                     .log_x = true,
                     .log_y = true,
                     .name_x = "triangles",
                     .name_y = "milliseconds a step"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < 2; i++) {
        fig_point at[SIZES];
        for (int k = 0; k < SIZES; k++)
            at[k] = (fig_point){
                fig_measured("simulation growth %d triangles", sizes[k]),
                fig_measured("simulation growth %d %s", sizes[k], part[i])};
        fig_plot_curve(page, &plot, SIZES, at,
                       (fig_stroke){.paint = {.role = role[i]}});
        for (int k = 0; k < SIZES; k++)
            fig_plot_dot(page, &plot, at[k].x, at[k].y, 4, role[i]);
        fig_plot_key(page, 240, 30 + 12.0 * i, part[i], role[i]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    draw_scenes(page);
    draw_growth(page);
    for (int s = 0; s < SCENES; s++)
        for (int i = 0; i < 2; i++) {
            char key[64];
            snprintf(key, sizeof key, "%s_%s", part[i], scenes[s]);
            fig_number(numbers, key, cost_of(scenes[s], i));
        }
}

const fig_figure fig_scene_costs = {
    .name = "scene-costs",
    .title = "What a step of each scene costs, and how that grows",
    .width = FIG_PAGE_WIDTH,
    .height = 178,
    .draw = draw,
};
