// Two walls close upon a chain step by step, jam, and open again: how far they
// should be apart, and how far they are.
#include "base/require.h"
#include "kit/figures.h"

#include "renderer/plot.h"
#include "response/resolve.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    CHAIN = 13,
    WALL = 2,
    VERTICES = CHAIN + 2 * WALL,
    EDGES = CHAIN - 1 + 2,
    NUMBERS = 2 * VERTICES,
    STEPS = 80,
    TURNING = 45, ///< the step from which on the walls should open
    SWEEPS = 20
};

/// How far each wall should go in a step, where it is at first, and how far up
/// the walls reach.
static const double speed = 0.03, wall_at = 0.9, wall_top = 2.1;

/// Half of the chain's width and height at the start.
static const double chain_width = 0.55, chain_height = 1.2;

typedef struct scene {
    tf_mesh mesh;
    int edge[2 * EDGES];
    double length[CHAIN - 1]; ///< of the chain's edges
    double inverse_mass[VERTICES];
    double x[NUMBERS];
} scene;

/// What happened in each step.
typedef struct course {
    double asked[STEPS + 1], gap[STEPS + 1]; ///< from wall to wall
    int held[STEPS + 1];
    int first_jam, jammed; ///< steps
    double jam[NUMBERS];   ///< positions in the jam
} course;

// The scene -------------------------------------------------------------------

static void place(scene *s)
{
    for (int v = 0; v < CHAIN; v++) {
        s->x[(ptrdiff_t)2 * v] = v % 2 == 0 ? -chain_width : chain_width;
        s->x[2 * v + 1] = chain_height * (2.0 * v / (CHAIN - 1) - 1);
        s->inverse_mass[v] = 1;
    }
    for (int v = CHAIN; v < VERTICES; v++) {
        s->x[(ptrdiff_t)2 * v] = v < CHAIN + WALL ? -wall_at : wall_at;
        s->x[2 * v + 1] = (v - CHAIN) % WALL == 0 ? -wall_top : wall_top;
    }
}

static void make_scene(scene *s)
{
    memset(s, 0, sizeof *s);
    place(s);
    for (int e = 0; e < EDGES; e++) {
        int first = e < CHAIN - 1 ? e : CHAIN + WALL * (e - CHAIN + 1);
        s->edge[2 * (ptrdiff_t)e] = first;
        s->edge[2 * e + 1] = first + 1;
    }
    for (int e = 0; e < CHAIN - 1; e++)
        s->length[e] = hypot(s->x[2 * e + 2] - s->x[(ptrdiff_t)2 * e],
                             s->x[2 * e + 3] - s->x[2 * e + 1]);
    s->mesh = (tf_mesh){
        .axes = 2, .vertices = VERTICES, .edges = EDGES, .edge = s->edge};
}

/// Moves the ends of each edge of the chain toward its length, in turns.
static void relax(const scene *s, double end[])
{
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (int e = 0; e < CHAIN - 1; e++) {
            double *a = end + 2 * (ptrdiff_t)e, *b = a + 2;
            double d[2] = {b[0] - a[0], b[1] - a[1]};
            double length = hypot(d[0], d[1]);
            for (int k = 0; k < 2; k++) {
                double part = (s->length[e] / length - 1) / 2 * d[k];
                a[k] -= part;
                b[k] += part;
            }
        }
}

/// How far apart the walls should be after a step.
static double asked_after(int step)
{
    int closing = step < TURNING ? step : 2 * TURNING - step;
    return 2 * (wall_at - speed * closing);
}

static void propose(const scene *s, int step, double end[])
{
    memcpy(end, s->x, sizeof s->x);
    relax(s, end);
    for (int v = CHAIN; v < VERTICES; v++)
        end[(ptrdiff_t)2 * v] =
            (v < CHAIN + WALL ? -0.5 : 0.5) * asked_after(step);
}

static void note(course *c, const scene *s, int step, int held)
{
    c->asked[step] = asked_after(step);
    c->gap[step] =
        s->x[(ptrdiff_t)2 * (CHAIN + WALL)] - s->x[(ptrdiff_t)2 * CHAIN];
    c->held[step] = held;
    c->jammed += held > 0;
    if (held > 0 && c->first_jam == 0) {
        c->first_jam = step;
        memcpy(c->jam, s->x, sizeof c->jam);
    }
}

static void simulate(scene *s, course *c)
{
    tf_surface *surface;
    tf_resolver *resolver;
    TF_REQUIRE(tf_surface_create(&s->mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    memset(c, 0, sizeof *c);
    note(c, s, 0, 0);
    for (int step = 1; step <= STEPS; step++) {
        double end[NUMBERS];
        const tf_response_report *report;
        propose(s, step, end);
        TF_REQUIRE(tf_step_resolve(resolver, VERTICES, s->x, end,
                                   s->inverse_mass, NULL, &report,
                                   NULL) == TF_OK);
        memcpy(s->x, end, sizeof end);
        note(c, s, step, report->held);
    }
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

// Drawing ---------------------------------------------------------------------

static void draw_state(fig_page *page, int i, const scene *s, const double x[],
                       const char *title)
{
    fig_plot plot = {.box = {4 + 76.0 * i, 18, 70, 150},
                     .x = {-1.05, 1.05},
                     .y = {-2.25, 2.25}};
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_page_title(page, plot.box, title);
    for (int e = 0; e < EDGES; e++) {
        const double *a = x + 2 * (ptrdiff_t)s->edge[(ptrdiff_t)2 * e];
        const double *b = x + 2 * (ptrdiff_t)s->edge[2 * e + 1];
        bool is_wall = e >= CHAIN - 1;
        fig_plot_curve(page, &plot, 2,
                       (fig_point[]){{a[0], a[1]}, {b[0], b[1]}},
                       (fig_stroke){.paint = {.role = is_wall ? FIG_ROLE_EDGE
                                                              : FIG_ROLE_POINT},
                                    .width = is_wall ? 2 : 1});
    }
}

static void draw_course(fig_page *page, const course *c)
{
    fig_plot plot = {.box = {200, 18, 172, 138},
                     .x = {0, STEPS},
                     .y = {-1.05, 1.95},
                     .ticks_x = 4,
                     .name_x = "step",
                     .name_y = "from wall to wall"};
    fig_point asked[STEPS + 1], gap[STEPS + 1];
    for (int i = 0; i <= STEPS; i++) {
        asked[i] = (fig_point){i, c->asked[i]};
        gap[i] = (fig_point){i, c->gap[i]};
    }
    fig_plot_frame(page, &plot);
    fig_plot_level(page, &plot, 0);
    fig_plot_curve(page, &plot, STEPS + 1, asked,
                   (fig_stroke){.width = FIG_WIDTH_THIN, .dash = 3});
    fig_plot_curve(
        page, &plot, STEPS + 1, gap,
        (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .width = 1.8});
    for (int i = 0; i <= STEPS; i++)
        if (c->held[i] > 0)
            fig_plot_dot(page, &plot, i, c->gap[i], 3, FIG_ROLE_CONTACT);
    fig_plot_key(page, plot.box.x + 62, 30, "where they are", FIG_ROLE_EDGE);
    fig_plot_key(page, plot.box.x + 62, 44, "held back", FIG_ROLE_CONTACT);
}

static void draw(fig_page *page, FILE *numbers)
{
    scene s;
    course c;
    double start[NUMBERS];
    make_scene(&s);
    memcpy(start, s.x, sizeof start);
    simulate(&s, &c);
    double jump = 0, most = 0, least = INFINITY; // of gaps after the first jam
    for (int i = 1; i <= STEPS; i++) {
        jump = fmax(jump, fabs(c.gap[i] - c.gap[i - 1]));
        if (c.held[i] > 0 && i > c.first_jam) {
            most = fmax(most, c.gap[i]);
            least = fmin(least, c.gap[i]);
        }
    }
    draw_state(page, 0, &s, start, "start");
    draw_state(page, 1, &s, c.jam, "jam");
    draw_course(page, &c);
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "meeting", rint(wall_at / speed));
    fig_number(numbers, "first_jam", c.first_jam);
    fig_number(numbers, "jammed", c.jammed);
    fig_number(numbers, "asked", c.asked[c.first_jam]);
    fig_number(numbers, "jam_gap", c.gap[c.first_jam]);
    fig_number(numbers, "largest_gap", most);
    fig_number(numbers, "smallest_gap", least);
    fig_number(numbers, "speed", speed);
    fig_number(numbers, "jump", jump);
}

const fig_figure fig_jammed_walls = {
    .name = "jammed-walls",
    .title = "Walls that close upon a chain, jam, and open again",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
