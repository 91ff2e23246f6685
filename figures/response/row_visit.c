// One visit of a constraint: what it does to the displacements of two bodies, without
// and with restitution, and with friction.
#include "kit/figures.h"

#include "renderer/plot.h"
#include "response/impulse.h"

#include <math.h>

enum {
    ARC = 97 ///< points of an ellipse
};

static const double plank_mass = 2; ///< as the middle of two vertices has it
static const double bound = 0;
static const double frictions[2] = {0.5, 1.5};
static const double sliding = 1.2, approach = 1;

/// The fly, vertex 0, and the plank, vertex 1, move up and down.
typedef struct bodies {
    double fly, plank;
} bodies;

static const bodies proposed = {0, 1};

static bodies visited(double restitution)
{
    const double inverse_mass[2] = {1, 1 / plank_mass};
    double move[4] = {0, proposed.fly, 0, proposed.plank};
    double gap_change = proposed.fly - proposed.plank;
    tf_constraint row = {.vertex = {0, 1, -1, -1},
                         .coefficient = {1, -1},
                         .normal = {0, 1},
                         .bound = fmax(bound, -restitution * gap_change)};
    tf_constraint_visit(&row, 0, &(tf_bodies){2, inverse_mass, move});
    return (bodies){move[1], move[3]};
}

/// How a body of mass 1 slides on the fixed ground after a visit.
static double slides(double friction)
{
    const double inverse_mass[2] = {1, 0};
    double move[4] = {sliding, -approach, 0, 0};
    tf_constraint row = {
        .vertex = {0, 1, -1, -1}, .coefficient = {1, -1}, .normal = {0, 1}};
    tf_constraint_visit(&row, friction, &(tf_bodies){2, inverse_mass, move});
    return move[0];
}

static double energy(bodies b)
{
    return (b.fly * b.fly + plank_mass * b.plank * b.plank) / 2;
}

// Drawing ----------------------------------------------------------------

static void draw_dot(fig_page *page, const fig_plot *plot, double x, double y,
                     const char *name, fig_role role, fig_side side)
{
    fig_point at = fig_plot_dot(page, plot, x, y, 6, role);
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = name,
                               .role = role,
                               .size = FIG_LETTERS_SMALL,
                               .side = side,
                               .gap = 5});
}

static void draw_arrow(fig_page *page, const fig_plot *plot, fig_point from,
                       fig_point to, fig_role role)
{
    fig_point at[2] = {fig_plot_place(plot, from.x, from.y),
                       fig_plot_place(plot, to.x, to.y)};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint = {.role = role}, .arrow = true});
}

/// All pairs of displacements that have the same energy.
static void draw_energy(fig_page *page, const fig_plot *plot, double energy)
{
    fig_point at[ARC];
    for (int i = 0; i < ARC; i++) {
        double angle = 2 * acos(-1) * i / (ARC - 1);
        at[i] = (fig_point){sqrt(2 * energy / plank_mass) * cos(angle),
                            sqrt(2 * energy) * sin(angle)};
    }
    fig_plot_curve(page, plot, ARC, at,
                   (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                .width = FIG_WIDTH_THIN,
                                .dash = 2.5,
                                .under_labels = true});
}

static void fill(fig_page *page, const fig_plot *plot, int count,
                 const fig_point corner[], fig_role role)
{
    fig_point at[4];
    for (int i = 0; i < count; i++)
        at[i] = fig_plot_place(plot, corner[i].x, corner[i].y);
    fig_page_fill(page, count, at, (fig_paint){.role = role, .opacity = 0.15});
}

static void draw_bodies(fig_page *page, fig_box box)
{
    fig_plot plot = {.box = box,
                     .x = {-0.2, 1.6},
                     .y = {-0.25, 1.55},
                     .name_x = "displacement of the plank",
                     .name_y = "displacement of the fly",
                     .ticks_x = 4,
                     .ticks_y = 4};
    fill(page, &plot, 3,
         (fig_point[]){{-0.2, -0.2}, {-0.2, 1.55}, {1.55, 1.55}},
         FIG_ROLE_POSITIVE);
    fig_plot_frame(page, &plot);
    bodies still = visited(0), bounced = visited(1);
    draw_energy(page, &plot, energy(proposed));
    draw_energy(page, &plot, energy(still));
    draw_arrow(page, &plot, (fig_point){proposed.plank, proposed.fly},
               (fig_point){still.plank, still.fly}, FIG_ROLE_INK);
    draw_arrow(page, &plot, (fig_point){still.plank, still.fly},
               (fig_point){bounced.plank, bounced.fly}, FIG_ROLE_NEUTRAL);
    draw_dot(page, &plot, proposed.plank, proposed.fly, "proposed",
             FIG_ROLE_CONTACT, FIG_SIDE_E);
    draw_dot(page, &plot, still.plank, still.fly, "pushed", FIG_ROLE_INK,
             FIG_SIDE_W);
    draw_dot(page, &plot, bounced.plank, bounced.fly, "bounced", FIG_ROLE_INK,
             FIG_SIDE_NE);
}

static void draw_friction(fig_page *page, fig_box box)
{
    fig_plot plot = {.box = box,
                     .x = {-0.4, 2},
                     .y = {-1.25, 0.55},
                     .name_x = "sliding",
                     .name_y = "gap change",
                     .ticks_x = 4,
                     .ticks_y = 4};
    double reach = frictions[0] * approach;
    fill(page, &plot, 3,
         (fig_point[]){
             {sliding, -approach}, {sliding - reach, 0}, {sliding + reach, 0}},
         FIG_ROLE_POSITIVE);
    fig_plot_frame(page, &plot);
    fig_plot_level(page, &plot, 0);
    double slow = slides(frictions[0]), stopped = slides(frictions[1]);
    fig_point from = {sliding, -approach};
    draw_arrow(page, &plot, from, (fig_point){sliding, 0}, FIG_ROLE_NEUTRAL);
    draw_arrow(page, &plot, from, (fig_point){slow, 0}, FIG_ROLE_INK);
    draw_arrow(page, &plot, from, (fig_point){stopped, 0}, FIG_ROLE_INK);
    draw_dot(page, &plot, from.x, from.y, "proposed", FIG_ROLE_CONTACT,
             FIG_SIDE_E);
    draw_dot(page, &plot, sliding, 0, "$μ = 0$", FIG_ROLE_INK, FIG_SIDE_NE);
    draw_dot(page, &plot, slow, 0, "$μ = 0.5$", FIG_ROLE_INK, FIG_SIDE_N);
    draw_dot(page, &plot, stopped, 0, "$μ = 1.5$", FIG_ROLE_INK, FIG_SIDE_NW);
}

static void print_numbers(FILE *numbers)
{
    bodies still = visited(0), bounced = visited(1);
    fig_number(numbers, "fly_still", still.fly);
    fig_number(numbers, "plank_still", still.plank);
    fig_number(numbers, "fly_bounced", bounced.fly);
    fig_number(numbers, "plank_bounced", bounced.plank);
    fig_number(numbers, "energy_proposed", energy(proposed));
    fig_number(numbers, "energy_still", energy(still));
    fig_number(numbers, "energy_bounced", energy(bounced));
    fig_number(numbers, "sliding", sliding);
    fig_number(numbers, "sliding_0.5", slides(frictions[0]));
    fig_number(numbers, "sliding_1.5", slides(frictions[1]));
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page), height = fig_page_height(page);
    double size = height - 42, left = 40;
    draw_bodies(page, (fig_box){left, 8, size, size});
    double right = left + size + 50;
    draw_friction(page, (fig_box){right, 8, width - right - 6, size});
    print_numbers(numbers);
}

const fig_figure fig_row_visit = {
    .name = "row-visit",
    .title = "What one visit of a constraint does to displacements",
    .width = FIG_PAGE_WIDTH,
    .height = 182,
    .draw = draw,
};
