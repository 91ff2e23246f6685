// A plank turns beneath a fly: staircase motion hits it, linear motion misses.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    STEPS = 4 ///< from the start to the contact
};

static const double velocity_scale = 0.25;
static const double panel_height = 176;

/// What moves, and where it meets.
typedef struct scenario {
    tf_worldline fly, plank[2];
    tf_contact contact;
    double toi;
} scenario;

static scenario make_scenario(void)
{
    static const double still[2] = {0, 1};
    scenario s = {
        .fly = tf_worldline_between(2, still, still),
        .plank = {
            tf_worldline_between(2, (double[]){-2, 2}, (double[]){-2, -2}),
            tf_worldline_between(2, (double[]){2, -2}, (double[]){2, 2})}};
    tf_status status =
        tf_query(&tf_exact, 2, 1, &s.fly, 2, s.plank, &s.contact);
    TF_REQUIRE(status == TF_OK && s.contact.verdict == TF_HIT);
    s.toi = fig_toi(&s.contact);
    return s;
}

/// The plank at the time t in the plane: its ends and, between them, the crease
/// if it is bent; tells how many points that are.
static int find_plank(const scenario *s, bool bent, double t,
                      tf_vector place[3])
{
    fig_world_of_edge(s->plank, t, place);
    for (int i = 0; i < 3; i++)
        place[i].x[2] = 0;
    if (bent)
        return 3;
    place[1] = place[2];
    return 2;
}

/// The middle of the plank, a painted point, at a time up to 1/2.
static tf_vector find_middle(const scenario *s, bool bent, double t)
{
    tf_vector start[2], move[2];
    for (int i = 0; i < 2; i++) {
        start[i] = fig_worldline_place(&s->plank[i], 2, 0);
        move[i] =
            fig_difference(fig_worldline_place(&s->plank[i], 2, 1), start[i]);
    }
    return fig_combination(fig_lerp(start[0], start[1], 0.5), t,
                           bent ? move[1] : fig_lerp(move[0], move[1], 0.5));
}

static void draw_planks(fig_panel *panel, const scenario *s, bool bent)
{
    fig_scene *scene = fig_panel_scene(panel);
    fig_role role = bent ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE;
    for (int i = 0; i <= STEPS; i++) {
        double t = s->toi * i / STEPS;
        tf_vector place[3];
        bool last = i == STEPS;
        fig_paint paint = {.role = role, .shade = last ? 0 : -0.55};
        int count = find_plank(s, bent, t, place);
        fig_scene_path(scene, count, place,
                       last ? FIG_WIDTH_TUBE : FIG_WIDTH_LINE, paint);
        for (int j = 0; j < count; j += count - 1)
            fig_scene_ball(scene, place[j], last ? FIG_WIDTH_BALL : 3.5, paint);
        fig_scene_ball(scene, find_middle(s, bent, t), last ? 5 : 3.5,
                       (fig_paint){.role = role});
    }
}

/// A small label below or beside a place of the plank's second end.
static void name_time(fig_panel *panel, const scenario *s, double t,
                      const char *text, fig_side side)
{
    fig_panel_label(
        panel, fig_worldline_place(&s->plank[1], 2, t),
        (fig_label){.text = text, .size = FIG_LETTERS_SMALL, .side = side});
}

/// The names of the plank's ends at the start, and its first and last time.
static void name_ends(fig_panel *panel, const scenario *s, fig_role role)
{
    static const char *const name[2] = {"$e_0$", "$e_1$"};
    for (int i = 0; i < 2; i++) {
        tf_vector at = fig_worldline_place(&s->plank[i], 2, 0);
        fig_panel_label(panel, at,
                        (fig_label){.text = name[i],
                                    .role = role,
                                    .side = i == 0 ? FIG_SIDE_W : FIG_SIDE_E});
    }
    name_time(panel, s, 0, "$t = 0$", FIG_SIDE_S);
    name_time(panel, s, s->toi, "$t = 1/4$", FIG_SIDE_NE);
}

static void draw_fly(fig_panel *panel, const scenario *s, fig_role role)
{
    tf_vector at = fig_worldline_place(&s->fly, 2, 0);
    fig_scene_ball(fig_panel_scene(panel), at, FIG_WIDTH_MARK,
                   (fig_paint){.role = role});
    fig_panel_label(
        panel, at,
        (fig_label){.text = "$p$", .role = role, .side = FIG_SIDE_W, .gap = 7});
}

/// An arrow from the fly with its name at the tip.
static void draw_arrow(fig_panel *panel, const scenario *s,
                       const double direction[3], double scale, fig_label name)
{
    tf_vector from = fig_worldline_place(&s->fly, 2, 0);
    tf_vector tip = fig_combination(from, scale, fig_vector_of(direction));
    fig_scene_arrow(fig_panel_scene(panel), from, tip, FIG_WIDTH_TUBE,
                    (fig_paint){.role = name.role});
    fig_panel_label(panel, tip, name);
}

static fig_panel *begin_panel(fig_page *page, double left, const scenario *s,
                              bool bent)
{
    fig_box box = {left, 4, fig_page_width(page) / 2, panel_height};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    draw_planks(panel, s, bent);
    name_ends(panel, s, bent ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE);
    fig_page_caption(page, box,
                     bent ? "*staircase motion*" : "*linear motion*");
    return panel;
}

static void print_numbers(const scenario *s, FILE *numbers)
{
    fig_number(numbers, "toi", s->toi);
    fig_number(numbers, "barycentric_0", s->contact.barycentric[1][0]);
    fig_number(numbers, "barycentric_1", s->contact.barycentric[1][1]);
    fig_number(numbers, "normal_x", s->contact.normal[0]);
    fig_number(numbers, "normal_y", s->contact.normal[1]);
    fig_number(numbers, "velocity_x", s->contact.velocity[0]);
    fig_number(numbers, "velocity_y", s->contact.velocity[1]);
    fig_number(numbers, "normal_velocity", s->contact.normal_velocity);
}

static void draw(fig_page *page, FILE *numbers)
{
    scenario s = make_scenario();
    fig_panel *bent = begin_panel(page, 0, &s, true);
    draw_fly(bent, &s, FIG_ROLE_CONTACT);
    draw_arrow(bent, &s, s.contact.normal, 1,
               (fig_label){.text = "normal", .side = FIG_SIDE_E, .gap = 4});
    draw_arrow(bent, &s, s.contact.velocity, velocity_scale,
               (fig_label){.text = "a quarter of the\nrelative velocity",
                           .role = FIG_ROLE_POINT,
                           .size = FIG_LETTERS_SMALL,
                           .side = FIG_SIDE_SW,
                           .gap = 6});
    fig_panel *straight =
        begin_panel(page, fig_page_width(page) / 2, &s, false);
    draw_fly(straight, &s, FIG_ROLE_POINT);
    fig_panel_label(straight, (tf_vector){{0, 0, 0}},
                    (fig_label){.text = "fulcrum",
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_S});
    print_numbers(&s, numbers);
}

const fig_figure fig_turning_plank = {
    .name = "turning-plank",
    .title = "A plank turns beneath a fly, in two models of motion",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .draw = draw,
};
