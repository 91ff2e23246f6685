// Two beads and a knot on a wire, round by round; and the rounds that more
// beads take, with and without memory.
#include "kit/figures.h"

#include "kit/wire.h"
#include "renderer/plot.h"
#include "response/gauss_seidel.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SHOWN = 5,    ///< rounds without memory
    MOST = 16,    ///< beads of the plot
    ENOUGH = 5000 ///< sweeps, so that none of the solutions is cut short
};

static const double gap = 0x1p-10;

static const double left = 14, apart = 52, step = 17, reach = 40;

// Rounds -----------------------------------------------------------------

static void draw_wire(fig_page *page, double y)
{
    fig_point wire[] = {{left, y}, {left + 2 * apart + 14, y}};
    fig_page_line(page, 2, wire,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_THIN});
    fig_page_fill_box(page, (fig_box){left + 2 * apart + 6, y - 4.5, 6, 9},
                      (fig_paint){.role = FIG_ROLE_INK});
}

static void draw_bead(fig_page *page, double x, double y, double displacement)
{
    fig_point arrow[] = {{x, y}, {x + 4 + reach * displacement, y}};
    if (displacement > 0)
        fig_page_line(page, 2, arrow,
                      (fig_stroke){.paint = {.role = FIG_ROLE_EDGE},
                                   .width = 1.8,
                                   .arrow = true});
    fig_page_dot(page, x, y, 8, (fig_paint){.role = FIG_ROLE_POINT});
}

/// The beads before a round, and where they meet in it.
static void draw_round(fig_page *page, const fig_wire *course, int round,
                       double y)
{
    draw_wire(page, y);
    for (int i = 0; i < 2; i++)
        draw_bead(page, left + 6 + i * apart, y, course->seen[round][i]);
    char text[48];
    double d[2]; // the sweeps leave a billionth, which is not worth showing
    for (int i = 0; i < 2; i++)
        d[i] = course->seen[round][i] < 1e-4 ? 0 : course->seen[round][i];
    snprintf(text, sizeof text, "%.2g, %.2g", d[0], d[1]);
    fig_page_text(page, left + 2 * apart + 24, y + 3, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_rounds(fig_page *page)
{
    fig_wire alone = fig_wire_alone(2, gap);
    fig_wire kept = fig_wire_kept(2, gap, ENOUGH);
    double y = 14;
    fig_page_text(page, left, y, FIG_ALIGN_LEFT, "*one contact at a time*",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int i = 0; i < SHOWN; i++)
        draw_round(page, &alone, i, y + step * (i + 1));
    y += step * (SHOWN + 1);
    fig_page_text(page, left + 6 + apart, y, FIG_ALIGN_CENTER, "⋮", FIG_LETTERS,
                  FIG_ROLE_INK);
    y += step + 8;
    fig_page_text(page, left, y, FIG_ALIGN_LEFT, "*constraints that are kept*",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int i = 0; i <= kept.rounds; i++)
        draw_round(page, &kept, i, y + step * (i + 1));
}

// Numbers of rounds ------------------------------------------------------

static void draw_plot(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {236, 26, 138, 158},
                     .x = {2, MOST},
                     .y = {1, 1000},
                     .log_y = true,
                     .name_x = "beads",
                     .name_y = "rounds"};
    fig_plot_frame(page, &plot);
    fig_point alone[MOST], kept[MOST];
    int count = 0;
    for (int beads = 2; beads <= MOST; beads++, count++) {
        alone[count] = (fig_point){beads, fig_wire_alone(beads, gap).rounds};
        kept[count] =
            (fig_point){beads, fig_wire_kept(beads, gap, ENOUGH).rounds};
        char key[32];
        snprintf(key, sizeof key, "alone_%d", beads);
        fig_number(numbers, key, alone[count].y);
        snprintf(key, sizeof key, "kept_%d", beads);
        fig_number(numbers, key, kept[count].y);
    }
    const fig_stroke thin = {.paint = {.role = FIG_ROLE_POINT}};
    fig_plot_curve(page, &plot, count, alone, thin);
    fig_plot_curve(page, &plot, count, kept,
                   (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    for (int i = 0; i < count; i++) {
        fig_plot_dot(page, &plot, alone[i].x, alone[i].y, 4, FIG_ROLE_POINT);
        fig_plot_dot(page, &plot, kept[i].x, kept[i].y, 4, FIG_ROLE_EDGE);
    }
    fig_plot_key(page, 200, 12, "one at a time", FIG_ROLE_POINT);
    fig_plot_key(page, 288, 12, "constraints kept", FIG_ROLE_EDGE);
}

// What the library leaves ------------------------------------------------

/// The displacement of the first of two beads after the library has solved the
/// row between them and then that row and the knot's.
static double left_by_library(void)
{
    const double inverse_mass[] = {1, 1, 0};
    double displacement[6];
    tf_constraint row[] = {
        {.vertex = {1, 0, -1, -1}, .coefficient = {1, -1}, .normal = {1}},
        {.vertex = {2, 1, -1, -1}, .coefficient = {1, -1}, .normal = {1}}};
    tf_zone zone = {.axes = 2,
                    .vertices = 3,
                    .constraint = row,
                    .inverse_mass = inverse_mass,
                    .displacement = displacement,
                    .sweeps = 30};
    zone.workspace =
        malloc(tf_gauss_seidel.workspace(2, 3, 2) * sizeof(double));
    if (!zone.workspace)
        return 0;
    for (zone.constraints = 1; zone.constraints <= 2; zone.constraints++) {
        zone.solved = zone.constraints - 1;
        memset(displacement, 0, sizeof displacement);
        displacement[0] = 1;
        tf_gauss_seidel.solve(&zone);
    }
    free(zone.workspace);
    return displacement[0];
}

static void draw(fig_page *page, FILE *numbers)
{
    draw_rounds(page);
    draw_plot(page, numbers);
    fig_number(numbers, "library_part", 1 / left_by_library());
}

const fig_figure fig_kept_rows = {
    .name = "kept-rows",
    .title = "Beads on a wire: contacts one at a time, and constraints kept",
    .width = FIG_PAGE_WIDTH,
    .height = 218,
    .draw = draw,
};
