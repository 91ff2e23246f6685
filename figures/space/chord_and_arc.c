// A bar that turns, and the same bar with ends that move in straight lines: how
// far the arc is from its chord, and how much shorter the bar gets.
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>

enum {
    GHOSTS = 5,
    CURVE = 65
};

static const double degree = 3.14159265358979323846 / 180;
static const double shown_turn = 90; ///< degrees, of the bar that is drawn
static const double turns[] = {1, 10, 30, 90};

/// The distance of the middle of the chord from the arc, in radii.
static double sagitta(double turn)
{
    return 1 - cos(turn * degree / 2);
}

/// What the staircase may add for the bar, a quarter of the change of the edge.
static double bend(double turn)
{
    return sin(turn * degree / 2) / 2;
}

static void draw_line(fig_page *page, const fig_plot *plot, int count,
                      const fig_point world[], fig_stroke stroke)
{
    fig_point at[CURVE];
    for (int i = 0; i < count; i++)
        at[i] = fig_plot_place(plot, world[i].x, world[i].y);
    fig_page_line(page, count, at, stroke);
}

/// The tip of the bar as it turns, and as it moves in a straight line.
static fig_point turned(double t)
{
    double angle = t * shown_turn * degree;
    return (fig_point){cos(angle), sin(angle)};
}

static fig_point straight(double t)
{
    fig_point from = turned(0), to = turned(1);
    return (fig_point){(1 - t) * from.x + t * to.x,
                       (1 - t) * from.y + t * to.y};
}

static void draw_paths(fig_page *page, const fig_plot *plot)
{
    fig_point arc[CURVE];
    for (int i = 0; i < CURVE; i++)
        arc[i] = turned((double)i / (CURVE - 1));
    draw_line(page, plot, CURVE, arc,
              (fig_stroke){.paint.role = FIG_ROLE_EDGE});
    draw_line(page, plot, 2, (fig_point[]){straight(0), straight(1)},
              (fig_stroke){.paint.role = FIG_ROLE_OTHER_EDGE});
    draw_line(page, plot, 2, (fig_point[]){straight(0.5), turned(0.5)},
              (fig_stroke){.paint.role = FIG_ROLE_CONTACT,
                           .width = 1.6,
                           .arrow = true,
                           .both = true});
}

static void draw_bars(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < GHOSTS; i++) {
        double t = (double)i / (GHOSTS - 1);
        bool ends = i == 0 || i == GHOSTS - 1;
        fig_point turning[2] = {{0, 0}, turned(t)};
        fig_point moving[2] = {{0, 0}, straight(t)};
        draw_line(page, plot, 2, turning,
                  (fig_stroke){.paint = {.role = FIG_ROLE_EDGE,
                                         .opacity = ends ? 0 : 0.35},
                               .width = ends ? FIG_WIDTH_TUBE : 1.2});
        if (!ends)
            draw_line(
                page, plot, 2, moving,
                (fig_stroke){.paint.role = FIG_ROLE_OTHER_EDGE, .width = 1.2});
    }
}

static void draw_bar(fig_page *page, fig_box box)
{
    double reach = 1.14;
    fig_plot plot = {
        .box = box,
        .x = {-0.06, reach},
        .y = {-0.06, (reach + 0.06) * box.height / box.width - 0.06}};
    draw_bars(page, &plot);
    draw_paths(page, &plot);
    fig_point middle = fig_plot_place(&plot, turned(0.5).x, turned(0.5).y);
    fig_page_text(page, middle.x + 5, middle.y - 4, FIG_ALIGN_LEFT, "sagitta",
                  FIG_LETTERS_SMALL, FIG_ROLE_CONTACT);
    fig_plot_dot(page, &plot, 0, 0, FIG_WIDTH_BALL, FIG_ROLE_EDGE);
}

static void draw_errors(fig_page *page, const fig_plot *plot)
{
    fig_point linear[CURVE], staircase[CURVE];
    for (int i = 0; i < CURVE; i++) {
        double part = (double)i / (CURVE - 1);
        double turn = plot->x[0] * pow(plot->x[1] / plot->x[0], part);
        linear[i] = (fig_point){turn, sagitta(turn)};
        staircase[i] = (fig_point){turn, sagitta(turn) + bend(turn)};
    }
    fig_plot_curve(page, plot, CURVE, linear,
                   (fig_stroke){.paint.role = FIG_ROLE_OTHER_EDGE});
    fig_plot_curve(page, plot, CURVE, staircase,
                   (fig_stroke){.paint.role = FIG_ROLE_TRIANGLE});
    fig_page_label(page, fig_plot_place(plot, 12, sagitta(12)).x,
                   fig_plot_place(plot, 12, sagitta(12)).y,
                   (fig_label){.text = "straight paths",
                               .role = FIG_ROLE_OTHER_EDGE,
                               .size = FIG_LETTERS_SMALL,
                               .side = FIG_SIDE_SE});
    fig_page_label(page, fig_plot_place(plot, 3, bend(3)).x,
                   fig_plot_place(plot, 3, bend(3)).y,
                   (fig_label){.text = "staircase, at most",
                               .role = FIG_ROLE_TRIANGLE,
                               .size = FIG_LETTERS_SMALL,
                               .side = FIG_SIDE_NW});
}

static void draw(fig_page *page, FILE *numbers)
{
    draw_bar(page, (fig_box){4, 6, 152, 152});
    fig_plot plot = {.box = {212, 8, 164, 134},
                     .x = {1, 100},
                     .y = {1e-5, 1},
                     .log_x = true,
                     .log_y = true,
                     .name_x = "turn in degrees",
                     .name_y = "error, in lengths of the bar"};
    fig_plot_frame(page, &plot);
    draw_errors(page, &plot);
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        char key[32];
        snprintf(key, sizeof key, "sagitta_%g", turns[i]);
        fig_number(numbers, key, sagitta(turns[i]));
        snprintf(key, sizeof key, "sagitta_percent_%g", turns[i]);
        fig_number(numbers, key, 100 * sagitta(turns[i]));
        snprintf(key, sizeof key, "staircase_%g", turns[i]);
        fig_number(numbers, key, sagitta(turns[i]) + bend(turns[i]));
    }
}

const fig_figure fig_chord_and_arc = {
    .name = "chord-and-arc",
    .title = "A bar that turns, and one whose ends move straight",
    .width = FIG_PAGE_WIDTH,
    .height = 178,
    .draw = draw,
};
