// A shorter step is another step: half of a step may have a contact although
// the whole of it has its first one later.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/random.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    STEPS = 2000,   ///< random ones with a contact
    FRACTIONS = 64, ///< that are tried of each
    CELLS = 200,    ///< of the scale
    VERTICES = 4,   ///< at most
    HALVINGS = 3
};

/// A vertex or two elements' vertices in a step, in the order of their indices.
typedef struct step {
    int axes, vertices, others; ///< of the first element, and of the second
    tf_worldline line[VERTICES];
} step;

/// The same step with all displacements scaled, and rounded.
static step scaled(const step *s, double fraction)
{
    step made = *s;
    for (int v = 0; v < s->vertices + s->others; v++) {
        const double *start = s->line[v].at[0].x;
        double end[TF_AXES];
        for (int k = 0; k < s->axes; k++)
            end[k] = start[k] + fraction * (s->line[v].at[1].x[k] - start[k]);
        made.line[v] = tf_worldline_between(s->axes, start, end);
    }
    return made;
}

static tf_contact find_contact(const step *s)
{
    tf_contact contact;
    TF_REQUIRE(tf_query(&tf_exact, s->axes, s->vertices, s->line, s->others,
                        s->line + s->vertices, &contact) == TF_OK);
    return contact;
}

static bool is_clear(const step *s, double fraction)
{
    step part = scaled(s, fraction);
    return find_contact(&part).verdict != TF_HIT;
}

// Random steps ----------------------------------------------------------------

/// What the fractions of a random step have.
typedef struct outcome {
    bool hit;     ///< the whole step has a contact
    bool early;   ///< and a fraction below its time of impact has one
    bool touched; ///< some fraction has a contact
    bool again;   ///< and some fraction above it has none
} outcome;

/// Tries the fractions of a random step of a point and an edge or a triangle.
static outcome try_random_step(uint64_t *state, int axes)
{
    step made = {.axes = axes, .vertices = 1, .others = axes};
    fig_random_vertices(state, axes, 1, 1 + axes, made.line);
    tf_contact contact = find_contact(&made);
    outcome seen = {.hit = contact.verdict == TF_HIT};
    for (int j = 1; j <= FRACTIONS; j++) {
        double fraction = (double)j / FRACTIONS;
        bool clear = is_clear(&made, fraction);
        seen.early |= seen.hit && !clear && fraction < contact.toi_lo;
        seen.again |= clear && seen.touched;
        seen.touched |= !clear;
    }
    return seen;
}

/// How many percent of the steps that have a contact have one at a fraction
/// below the time of impact; and how many percent of those with a contact at
/// some fraction are clear at a fraction above it.
static void count(int axes, double *early, double *again)
{
    uint64_t state = 1;
    int hit = 0, early_steps = 0, touched = 0, again_steps = 0;
    while (hit < STEPS) {
        outcome seen = try_random_step(&state, axes);
        hit += seen.hit;
        early_steps += seen.early;
        touched += seen.touched;
        again_steps += seen.again;
    }
    *early = 100.0 * early_steps / STEPS;
    *again = 100.0 * again_steps / touched;
}

static void count_random_steps(FILE *numbers)
{
    double early[2], again[2];
    for (int axes = 2; axes <= 3; axes++)
        count(axes, &early[axes - 2], &again[axes - 2]);
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "early_plane", early[0]);
    fig_number(numbers, "early_space", early[1]);
    fig_number(numbers, "again_plane", again[0]);
    fig_number(numbers, "again_space", again[1]);
}

// The step that is shown ------------------------------------------------------

static step shown_step(void)
{
    step made = {.axes = 2, .vertices = 1, .others = 2};
    const double point[] = {0.5, 0.2}, right[] = {1, 0}, up[] = {1, 1},
                 left[] = {0, 0};
    made.line[0] = tf_worldline_between(2, point, point);
    made.line[1] = tf_worldline_between(2, right, up);
    made.line[2] = tf_worldline_between(2, left, left);
    return made;
}

static void draw_path(fig_page *page, const fig_plot *plot, int count,
                      const tf_vector at[], fig_stroke stroke)
{
    fig_point point[3];
    for (int i = 0; i < count; i++)
        point[i] = (fig_point){at[i].x[0], at[i].x[1]};
    fig_plot_curve(page, plot, count, point, stroke);
}

/// The edge at one time of a step, and where it starts.
static void draw_time(fig_page *page, fig_box box, const step *s, double t,
                      const char *title)
{
    fig_plot plot = {.box = box, .x = {-0.1, 1.15}, .y = {-0.12, 0.94}};
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    for (int i = 0; i < 2; i++) {
        tf_vector edge[3];
        fig_world_of_edge(s->line + 1, i == 0 ? 0 : t, edge);
        for (int k = 0; k < 3; k++)
            edge[k] = fig_vector_of(edge[k].x);
        draw_path(page, &plot, 3, edge,
                  (fig_stroke){.paint = {.role = FIG_ROLE_EDGE,
                                         .shade = i == 0 ? -0.45 : 0},
                               .width = FIG_WIDTH_TUBE});
    }
    step until = *s;
    tf_contact contact = find_contact(&until);
    bool touching = fabs(fig_toi(&contact) - t) < 1e-9;
    fig_plot_dot(page, &plot, s->line[0].at[0].x[0], s->line[0].at[0].x[1],
                 FIG_WIDTH_BALL, touching ? FIG_ROLE_CONTACT : FIG_ROLE_POINT);
    fig_page_title(page, box, title);
}

/// A tick above the scale with a name.
static void draw_mark(fig_page *page, fig_box box, double fraction,
                      const char *name, fig_role role)
{
    double x = box.x + fraction * box.width;
    fig_point at[] = {{x, box.y - 3}, {x, box.y + box.height + 3}};
    fig_page_line(
        page, 2, at,
        (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_LINE});
    fig_page_text(page, x, box.y - 6, FIG_ALIGN_CENTER, name, FIG_LETTERS_SMALL,
                  role);
}

/// Whether the i-th cell of the scale is clear, in its middle.
static bool is_clear_at(const step *s, int i)
{
    return is_clear(s, (i + 0.5) / CELLS);
}

/// All fractions of the step: those with a contact are red.
static void draw_scale(fig_page *page, fig_box box, const step *s, double toi)
{
    for (int i = 0, next; i < CELLS; i = next) {
        bool clear = is_clear_at(s, i);
        for (next = i + 1; next < CELLS && is_clear_at(s, next) == clear;)
            next++;
        fig_box run = {box.x + i * box.width / CELLS, box.y,
                       (next - i) * box.width / CELLS, box.height};
        fig_page_fill_box(
            page, run,
            (fig_paint){.role = clear ? FIG_ROLE_NEUTRAL : FIG_ROLE_CONTACT,
                        .opacity = clear ? 0.25 : 0.7});
    }
    static const char *const names[HALVINGS] = {"1/2", "1/4", "1/8"};
    for (int k = 0; k < HALVINGS; k++)
        draw_mark(page, box, ldexp(1, -1 - k), names[k], FIG_ROLE_INK);
    draw_mark(page, box, toi, "time of impact", FIG_ROLE_POINT);
    draw_mark(page, box, 1, "1", FIG_ROLE_INK);
    draw_mark(page, box, 0, "0", FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    step whole = shown_step(), half = scaled(&whole, 0.5);
    tf_contact contact = find_contact(&whole);
    double toi = fig_toi(&contact), width = fig_page_width(page);
    fig_box left = {8, 18, width / 2 - 16, 134};
    fig_box right = {width / 2 + 8, 18, width / 2 - 16, 134};
    draw_time(page, left, &whole, toi, "the whole step at $t = 0.7$");
    draw_time(page, right, &half, 1, "half the step at its end");
    draw_scale(page, (fig_box){20, 180, width - 40, 11}, &whole, toi);
    fig_number(numbers, "toi", toi);
    fig_number(numbers, "half_clear", is_clear(&whole, 0.5));
    fig_number(numbers, "quarter_clear", is_clear(&whole, 0.25));
    count_random_steps(numbers);
}

const fig_figure fig_clear_fractions = {
    .name = "clear-fractions",
    .title = "The fractions of a step that are clear",
    .width = FIG_PAGE_WIDTH,
    .height = 200,
    .draw = draw,
};
