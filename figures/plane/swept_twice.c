// What an edge sweeps when one end goes up and the other down: the staircase
// passes twice over a triangle that linear motion avoids.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "intersect/cascade.h"
#include "renderer/plot.h"

enum {
    ENDS = 2
};

/// How far the ends move, and how long the edge is.
static const double down = 1, up = 1.5, length = 6;

static const double dot = 0.55; ///< the coordinate of e1 of a painted dot

static void make_edge(tf_worldline edge[ENDS])
{
    edge[0] = tf_worldline_between(2, (double[]){0, 0}, (double[]){0, -down});
    edge[1] =
        tf_worldline_between(2, (double[]){length, 0}, (double[]){length, up});
}

/// The coordinate of the dot that ends where it began.
static double fixed_dot(void)
{
    return down / (up + down);
}

// Counting ---------------------------------------------------------------

/// How many triangles of the sweep a point at rest is in.
static int count_passes(const tf_worldline edge[ENDS], double x, double y)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){x, y}, (double[]){x, y});
    tf_simplex path[1], sweep[ENDS];
    tf_sweep(1, &point, path);
    tf_sweep(ENDS, edge, sweep);
    int passes = 0;
    for (int i = 0; i < ENDS; i++) {
        tf_pair pair = tf_pair_of(&path[0], &sweep[i], 2);
        passes +=
            tf_intersect(&tf_exact, &pair, TF_ONLY_VERDICT).verdict == TF_HIT;
    }
    return passes;
}

/// What is swept in units of half the edge's length, and how often: in the
/// triangle between, and beyond the dot that ends where it began.
static void print_numbers(FILE *numbers, const tf_worldline edge[ENDS])
{
    double fixed = fixed_dot() * length;
    fig_number(numbers, "twice", up * fixed_dot());
    fig_number(numbers, "all", down + up - up * fixed_dot());
    fig_number(numbers, "passes_between",
               count_passes(edge, (fixed + length) / 3, up / 3));
    fig_number(numbers, "passes_beyond",
               count_passes(edge, (fixed + 2 * length) / 3, up / 6));
}

// Drawing ----------------------------------------------------------------

static void fill(fig_page *page, const fig_plot *plot, fig_role role,
                 const fig_point corner[3])
{
    fig_point at[3];
    for (int i = 0; i < 3; i++)
        at[i] = fig_plot_place(plot, corner[i].x, corner[i].y);
    fig_page_fill(page, 3, at, (fig_paint){.role = role, .opacity = 0.28});
}

/// The edge at a time, with its ends and their names.
static void draw_edge(fig_page *page, const fig_plot *plot,
                      const tf_worldline edge[ENDS], int t, fig_role role)
{
    static const char *const name[ENDS][2] = {{"$e_0$", "$e_0'$"},
                                              {"$e_1$", "$e_1'$"}};
    fig_point end[ENDS];
    for (int i = 0; i < ENDS; i++)
        end[i] = (fig_point){edge[i].at[t].x[0], edge[i].at[t].x[1]};
    fig_plot_curve(page, plot, ENDS, end,
                   (fig_stroke){.paint.role = role, .width = 1.6});
    for (int i = 0; i < ENDS; i++) {
        fig_point at = fig_plot_dot(page, plot, end[i].x, end[i].y, 5, role);
        fig_page_label(page, at.x, at.y,
                       (fig_label){.text = name[i][t],
                                   .role = role,
                                   .size = FIG_LETTERS_SMALL,
                                   .side = i == 0 ? FIG_SIDE_W : FIG_SIDE_E});
    }
}

/// The way of the painted dot, `count` places with arrows in between, each a
/// little to the right of the one before.
static void draw_way(fig_page *page, const fig_plot *plot, int count,
                     const double y[])
{
    double x = dot * length;
    for (int i = 1; i < count; i++, x += 0.16)
        fig_page_line(page, 2,
                      (fig_point[]){fig_plot_place(plot, x, y[i - 1]),
                                    fig_plot_place(plot, x, y[i])},
                      (fig_stroke){.width = FIG_WIDTH_THIN, .arrow = true});
    fig_plot_dot(page, plot, dot * length, y[0], 4, FIG_ROLE_INK);
}

static void draw_staircase(fig_page *page, const fig_plot *plot,
                           const tf_worldline edge[ENDS])
{
    tf_simplex sweep[ENDS];
    tf_sweep(ENDS, edge, sweep);
    for (int i = 0; i < ENDS; i++) {
        fig_point corner[3];
        for (int j = 0; j < 3; j++) {
            const double *x = sweep[i].event[j]->x;
            corner[j] = (fig_point){x[0], x[1]};
        }
        fill(page, plot, FIG_ROLE_EDGE, corner);
    }
    fig_plot_curve(page, plot, 2, (fig_point[]){{0, 0}, {length, up}},
                   (fig_stroke){.paint.role = FIG_ROLE_EDGE,
                                .width = FIG_WIDTH_THIN,
                                .dash = 3});
    fig_point at = fig_plot_place(plot, 2.35, 0.2);
    fig_page_text(page, at.x, at.y, FIG_ALIGN_CENTER, "twice",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_linear(fig_page *page, const fig_plot *plot)
{
    double fixed = fixed_dot() * length;
    fill(page, plot, FIG_ROLE_OTHER_EDGE,
         (fig_point[]){{0, 0}, {0, -down}, {fixed, 0}});
    fill(page, plot, FIG_ROLE_OTHER_EDGE,
         (fig_point[]){{length, 0}, {length, up}, {fixed, 0}});
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const title[2] = {"*staircase motion*",
                                         "*linear motion*"};
    static const fig_role role[2] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
    const double end = dot * up - (1 - dot) * down;
    const double way[2][3] = {{0, dot * up, end}, {0, end}};
    tf_worldline edge[ENDS];
    make_edge(edge);
    print_numbers(numbers, edge);
    double width = (fig_page_width(page) - 24) / 2;
    for (int i = 0; i < 2; i++) {
        fig_box box = {i * (width + 24), 6, width, width * 3.1 / 7.4};
        fig_plot plot = {.box = box, .x = {-0.7, 6.7}, .y = {-1.3, 1.8}};
        if (i == 0)
            draw_staircase(page, &plot, edge);
        else
            draw_linear(page, &plot);
        for (int t = 0; t < 2; t++)
            draw_edge(page, &plot, edge, t, role[i]);
        draw_way(page, &plot, i == 0 ? 3 : 2, way[i]);
        fig_page_caption(page, box, title[i]);
    }
}

const fig_figure fig_swept_twice = {
    .name = "swept-twice",
    .title = "What an edge sweeps as its ends go up and down",
    .width = FIG_PAGE_WIDTH,
    .height = 108,
    .draw = draw,
};
