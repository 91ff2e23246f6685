// A plank rises to a fly: the proposed step, and what a push by either of two
// rows makes of it.
#include "kit/figures.h"

#include "kit/film.h"
#include "kit/pushed_pair.h"
#include "kit/worlds.h"
#include "renderer/plot.h"

enum {
    PANELS = 3
};

static const double still = 0.75;
static const double panel_gap = 12, panel_height = 116;

/// A step, and where it hits if it does.
typedef struct state {
    const char *title;
    fig_pair pair;
    bool hits;
    double toi;
    tf_contact contact;
} state;

static const fig_pair proposed = {
    .axes = 2,
    .first = 1,
    .count = 3,
    .start = {{{0, 0.125, 0}}, {{-2, 0, 0}}, {{2, 0, 0}}},
    .move = {{{0, 0, 0}}, {{0, 1, 0}}, {{0, 1, 0}}}};

static void look(state *s)
{
    s->hits = fig_pair_meets(&s->pair, &s->contact);
    s->toi = fig_toi(&s->contact);
}

static void push(state *s, const state *from, fig_candidate candidate)
{
    s->pair = from->pair;
    fig_pair_row row = fig_pair_row_of(&s->pair, &from->contact, candidate);
    fig_pair_push(&s->pair, &row);
    look(s);
}

static void make_states(state s[PANELS])
{
    s[0] = (state){.title = "*as proposed*", .pair = proposed};
    look(&s[0]);
    s[1].title = "*pushed by the gradient*";
    push(&s[1], &s[0], FIG_BY_GRADIENT);
    s[2].title = "*pushed by the coordinates*";
    push(&s[2], &s[0], FIG_BY_COORDINATES);
}

// Drawing ----------------------------------------------------------------

static tf_worldline worldline_of(const fig_pair *pair, int vertex)
{
    tf_vector end = fig_sum(pair->start[vertex], pair->move[vertex]);
    return tf_worldline_between(2, pair->start[vertex].x, end.x);
}

/// Where the vertices and the crease of the edge are at the time t.
static void place_edge(const fig_pair *pair, double t, fig_point at[3])
{
    tf_worldline edge[2] = {worldline_of(pair, 1), worldline_of(pair, 2)};
    tf_vector world[3];
    fig_world_of_edge(edge, t, world);
    for (int i = 0; i < 3; i++)
        at[i] = (fig_point){world[i].x[0], world[i].x[1]};
}

static void draw_edge(fig_page *page, const fig_plot *plot,
                      const fig_pair *pair, double t, double shade)
{
    fig_point at[3];
    place_edge(pair, t, at);
    fig_paint paint = {.role = FIG_ROLE_EDGE, .shade = shade};
    fig_plot_curve(page, plot, 3, at,
                   (fig_stroke){.paint = paint, .width = 2.2});
    for (int i = 0; i < 3; i += 2) {
        fig_point end = fig_plot_place(plot, at[i].x, at[i].y);
        fig_page_dot(page, end.x, end.y, 5.5, paint);
    }
}

static void draw_contact(fig_page *page, const fig_plot *plot, const state *s)
{
    tf_worldline fly = worldline_of(&s->pair, 0);
    tf_vector at = fig_worldline_place(&fly, 2, s->toi);
    fig_point place = fig_plot_place(plot, at.x[0], at.x[1]);
    fig_page_dot(page, place.x, place.y, FIG_WIDTH_MARK,
                 (fig_paint){.role = FIG_ROLE_CONTACT});
}

static void draw_state(fig_page *page, const fig_plot *plot, const state *s,
                       double t)
{
    draw_edge(page, plot, &s->pair, 0, -0.7);
    draw_edge(page, plot, &s->pair, t, 0);
    tf_worldline fly = worldline_of(&s->pair, 0);
    tf_vector at = fig_worldline_place(&fly, 2, t);
    bool marked = s->hits && t >= s->toi;
    if (marked)
        draw_contact(page, plot, s);
    if (!marked || t != s->toi)
        fig_plot_dot(page, plot, at.x[0], at.x[1], 6, FIG_ROLE_POINT);
}

static void write_verdict(fig_page *page, fig_box box, const state *s)
{
    char text[48] = "clear";
    if (s->hits)
        snprintf(text, sizeof text, "hit at $t = %.4g$", s->toi);
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 10,
                  FIG_ALIGN_CENTER, s->title, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 23,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL,
                  s->hits ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

/// Names of the vertices beside their starts, which never move.
static void name_vertices(fig_page *page, const fig_plot *plot)
{
    static const char *const name[2] = {"$e_0$", "$e_1$"};
    for (int i = 0; i < 2; i++) {
        fig_point at = fig_plot_place(plot, proposed.start[1 + i].x[0], 0);
        fig_page_text(page, at.x, at.y + 14, FIG_ALIGN_CENTER, name[i],
                      FIG_LETTERS_SMALL, FIG_ROLE_EDGE);
    }
}

static void print_numbers(const state s[PANELS], FILE *numbers)
{
    static const char *const name[PANELS] = {"proposed", "gradient",
                                             "coordinates"};
    for (int i = 0; i < PANELS; i++) {
        char key[48];
        snprintf(key, sizeof key, "toi_%s", name[i]);
        fig_number(numbers, key, s[i].toi);
        for (int v = 0; v < 3; v++) {
            snprintf(key, sizeof key, "move_%d_%s", v, name[i]);
            fig_number(numbers, key, s[i].pair.move[v].x[1]);
        }
    }
    fig_pair pair = proposed;
    fig_number(numbers, "rounds_gradient",
               fig_pair_part(&pair, FIG_BY_GRADIENT));
    fig_number(numbers, "left_end", pair.move[1].x[1]);
    fig_number(numbers, "right_end", pair.move[2].x[1]);
}

static void draw(fig_page *page, FILE *numbers)
{
    state s[PANELS];
    make_states(s);
    double t = fig_film_time(page, numbers, still, s[1].toi);
    double width = (fig_page_width(page) - (PANELS - 1) * panel_gap) / PANELS;
    for (int i = 0; i < PANELS; i++) {
        fig_box box = {i * (width + panel_gap), 2, width, panel_height};
        fig_plot plot = {.box = box, .x = {-2.3, 2.3}, .y = {-0.32, 1.08}};
        name_vertices(page, &plot);
        draw_state(page, &plot, &s[i], t);
        write_verdict(page, box, &s[i]);
    }
    fig_film_clock(page, fig_page_width(page) / 2 - 80,
                   fig_page_height(page) - 7, 160, t, -1, "");
    print_numbers(s, numbers);
}

const fig_figure fig_rising_plank = {
    .name = "rising-plank",
    .title = "A plank that rises to a fly, and two ways to part them",
    .width = FIG_PAGE_WIDTH,
    .height = 166,
    .moves = true,
    .draw = draw,
};
