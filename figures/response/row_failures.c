// Three pairs whose contact the row of the point in contact cannot answer.
#include "kit/figures.h"

#include "base/require.h"
#include "kit/pushed_pair.h"
#include "kit/worlds.h"
#include "renderer/plot.h"

enum {
    PANELS = 3
};

static const double panel_gap = 14;

/// A pair, and the square of the plane that its panel shows.
typedef struct failure {
    const char *key, *title;
    fig_pair pair;
    double x, y, side; ///< the square's middle, and its side
} failure;

static const failure failures[PANELS] = {
    {"slide",
     "*no side at all*",
     {2,
      1,
      3,
      {{{0, 0, 0}}, {{1, 0, 0}}, {{3, 0, 0}}},
      {{{2, 0, 0}}, {{0, 0, 0}}, {{0, 0, 0}}}},
     1.5,
     0,
     3.9},
    {"seesaw",
     "*nothing left to want*",
     {2,
      1,
      3,
      {{{0, 1, 0}}, {{-2, 2, 0}}, {{2, -2, 0}}},
      {{{0, 0, 0}}, {{0, -4, 0}}, {{0, 4, 0}}}},
     0,
     0,
     5},
    {"turn",
     "*two opinions of the side*",
     {2,
      1,
      3,
      {{{1, 1, 0}}, {{0, 0, 0}}, {{4, 0, 0}}},
      {{{0, -3, 0}}, {{1, 2, 0}}, {{-2, -2, 0}}}},
     2,
     -0.2,
     5.2}};

typedef struct found {
    tf_contact contact;
    tf_vector vector; ///< from the edge's point of contact to the point, before
    double gap, parting, toi;
} found;

static found look(const failure *f)
{
    found s;
    bool meets = fig_pair_meets(&f->pair, &s.contact);
    TF_REQUIRE(meets);
    s.toi = fig_toi(&s.contact);
    s.vector = fig_pair_vector(&f->pair, &s.contact);
    s.gap = tf_vector_dot(s.vector, fig_vector_of(s.contact.normal));
    fig_pair_row row =
        fig_pair_row_of(&f->pair, &s.contact, FIG_BY_COORDINATES);
    s.parting = fig_pair_parting(&f->pair, &row);
    return s;
}

// Drawing ----------------------------------------------------------------

static fig_point on_page(const fig_plot *plot, tf_vector at)
{
    return fig_plot_place(plot, at.x[0], at.x[1]);
}

static tf_worldline worldline_of(const fig_pair *pair, int vertex)
{
    tf_vector end = fig_sum(pair->start[vertex], pair->move[vertex]);
    return tf_worldline_between(2, pair->start[vertex].x, end.x);
}

/// The edge at the time t: bent in mid-step.
static void draw_edge(fig_page *page, const fig_plot *plot,
                      const fig_pair *pair, double t, fig_stroke stroke)
{
    tf_worldline edge[2] = {worldline_of(pair, 1), worldline_of(pair, 2)};
    tf_vector world[3];
    fig_point at[3];
    fig_world_of_edge(edge, t, world);
    for (int i = 0; i < 3; i++)
        at[i] = fig_plot_place(plot, world[i].x[0], world[i].x[1]);
    fig_page_line(page, 3, at, stroke);
    for (int i = 0; i < 3; i += 2)
        fig_page_dot(page, at[i].x, at[i].y, 4.5, stroke.paint);
}

static void draw_arrow(fig_page *page, const fig_plot *plot, tf_vector from,
                       tf_vector by, fig_paint paint, double width)
{
    fig_point at[2] = {on_page(plot, from), on_page(plot, fig_sum(from, by))};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint = paint, .width = width, .arrow = true});
}

static void name_at(fig_page *page, const fig_plot *plot, tf_vector at,
                    const char *text, fig_role role, fig_side side)
{
    fig_point place = on_page(plot, at);
    fig_page_label(page, place.x, place.y,
                   (fig_label){.text = text,
                               .role = role,
                               .size = FIG_LETTERS_SMALL,
                               .side = side,
                               .gap = 5});
}

/// The displacements of the two pivots, those that are not zero.
static void draw_pivots(fig_page *page, const fig_plot *plot, const failure *f,
                        const found *s)
{
    static const char *const name[] = {"$p$", "$e_0$", "$e_1$"};
    for (int i = 0; i < 2; i++) {
        int v = i == 0 ? 0 : 1 + s->contact.pivot[1];
        fig_role role = i == 0 ? FIG_ROLE_POINT : FIG_ROLE_EDGE;
        if (fig_length(f->pair.move[v]) > 0)
            draw_arrow(page, plot, f->pair.start[v], f->pair.move[v],
                       (fig_paint){.role = role, .shade = -0.35},
                       FIG_WIDTH_LINE);
        name_at(page, plot, f->pair.start[v], name[v], role,
                i == 0 ? FIG_SIDE_W : FIG_SIDE_E);
    }
}

/// The path of the edge's point of contact from the start to the contact.
static void draw_way(fig_page *page, const fig_plot *plot, const failure *f,
                     const found *s, tf_vector from)
{
    double turn = fmin(s->contact.barycentric[1][1], s->toi);
    tf_vector at[3] = {from};
    at[1] = fig_combination(at[0], turn, f->pair.move[2]);
    at[2] = fig_combination(at[1], s->toi - turn, f->pair.move[1]);
    fig_point place[3];
    for (int i = 0; i < 3; i++)
        place[i] = on_page(plot, at[i]);
    fig_page_line(page, 3, place,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_LINE,
                               .dash = 2});
    fig_page_dot(page, place[0].x, place[0].y, 4,
                 (fig_paint){.role = FIG_ROLE_INK});
}

static void draw_failure(fig_page *page, fig_box box, const failure *f,
                         const found *s)
{
    double half = f->side / 2;
    fig_plot plot = {.box = box,
                     .x = {f->x - half, f->x + half},
                     .y = {f->y - half, f->y + half}};
    const fig_paint edge = {.role = FIG_ROLE_EDGE};
    draw_edge(page, &plot, &f->pair, 0,
              (fig_stroke){.paint = {.role = FIG_ROLE_EDGE, .shade = -0.6},
                           .width = 1.6});
    draw_edge(page, &plot, &f->pair, s->toi,
              (fig_stroke){.paint = edge, .width = 2});
    draw_pivots(page, &plot, f, s);
    tf_worldline fly = worldline_of(&f->pair, 0);
    tf_vector met = fig_worldline_place(&fly, 2, s->toi);
    tf_vector from = fig_difference(f->pair.start[0], s->vector);
    draw_way(page, &plot, f, s, from);
    draw_arrow(page, &plot, from, s->vector, (fig_paint){.role = FIG_ROLE_INK},
               FIG_WIDTH_LINE);
    name_at(page, &plot, fig_lerp(from, f->pair.start[0], 0.5), "$r$",
            FIG_ROLE_INK, FIG_SIDE_NE);
    tf_vector normal =
        tf_vector_scaled(0.2 * f->side, fig_vector_of(s->contact.normal));
    draw_arrow(page, &plot, met, normal, (fig_paint){.role = FIG_ROLE_CONTACT},
               FIG_WIDTH_LINE);
    name_at(page, &plot, fig_sum(met, normal), "$n$", FIG_ROLE_CONTACT,
            FIG_SIDE_E);
    fig_point start = on_page(&plot, f->pair.start[0]);
    fig_page_dot(page, start.x, start.y, 5.5,
                 (fig_paint){.role = FIG_ROLE_POINT});
    fig_point place = on_page(&plot, met);
    fig_page_dot(page, place.x, place.y, 7,
                 (fig_paint){.role = FIG_ROLE_CONTACT});
    fig_page_caption(page, box, f->title);
}

static void print_number(FILE *numbers, const failure *f, const char *what,
                         double value)
{
    char key[48];
    snprintf(key, sizeof key, "%s_%s", f->key, what);
    fig_number(numbers, key, value);
}

static void print_numbers(FILE *numbers, const failure *f, const found *s)
{
    print_number(numbers, f, "toi", s->toi);
    print_number(numbers, f, "gap", s->gap);
    print_number(numbers, f, "normal_velocity", s->contact.normal_velocity);
    print_number(numbers, f, "parting", s->parting);
    fig_pair pair = f->pair;
    print_number(numbers, f, "rounds", fig_pair_part_as_library(&pair));
    for (int v = 0; v < 3; v++)
        for (int k = 0; k < 2; k++) {
            char what[16];
            snprintf(what, sizeof what, "end_%d_%c", v, "xy"[k]);
            print_number(numbers, f, what,
                         pair.start[v].x[k] + pair.move[v].x[k]);
        }
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = (fig_page_width(page) - (PANELS - 1) * panel_gap) / PANELS;
    for (int i = 0; i < PANELS; i++) {
        found s = look(&failures[i]);
        draw_failure(page, (fig_box){i * (width + panel_gap), 2, width, width},
                     &failures[i], &s);
        print_numbers(numbers, &failures[i], &s);
    }
}

const fig_figure fig_row_failures = {
    .name = "row-failures",
    .title = "Three contacts that a row by coordinates cannot handle",
    .width = FIG_PAGE_WIDTH,
    .height = 142,
    .draw = draw,
};
