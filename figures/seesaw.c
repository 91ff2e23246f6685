// A plank turns beneath a fly: staircase motion hits it, linear motion does not.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    STEPS = 4 ///< from the start to the contact
};

static const double normal_length = 1.1, velocity_scale = 0.25;
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
    tf_status status = tf_point_edge(&tf_exact, &s.fly, s.plank, &s.contact);
    TF_REQUIRE(status == TF_OK && s.contact.verdict == TF_HIT);
    s.toi = (s.contact.toi_lo + s.contact.toi_hi) / 2;
    return s;
}

/// The plank at the time t in the plane: its ends and, between them, the crease
/// if it is bent; tells how many points that are.
static int find_plank(const scenario *s, bool bent, double t,
                      double place[3][3])
{
    tf_world_of_edge(s->plank, t, place);
    for (int i = 0; i < 3; i++)
        place[i][2] = 0;
    if (bent)
        return 3;
    tf_add(place[2], 0, place[2], place[1]);
    return 2;
}

/// The middle of the plank, a painted point, at a time up to 1/2.
static void find_middle(const scenario *s, bool bent, double t,
                        double middle[3])
{
    const tf_event *start[2], *end[2];
    for (int i = 0; i < 2; i++) {
        start[i] = &s->plank[i].at[0];
        end[i] = &s->plank[i].at[1];
    }
    for (int k = 0; k < 2; k++) {
        double first = end[0]->x[k] - start[0]->x[k];
        double last = end[1]->x[k] - start[1]->x[k];
        middle[k] = (start[0]->x[k] + start[1]->x[k]) / 2 +
                    t * (bent ? last : (first + last) / 2);
    }
    middle[2] = 0;
}

static void draw_planks(tf_panel *panel, const scenario *s, bool bent)
{
    tf_scene *scene = tf_panel_scene(panel);
    tf_role role = bent ? TF_ROLE_EDGE : TF_ROLE_OTHER_EDGE;
    for (int i = 0; i <= STEPS; i++) {
        double t = s->toi * i / STEPS, place[3][3];
        bool last = i == STEPS;
        tf_paint paint = {.role = role, .shade = last ? 0 : -0.55};
        int count = find_plank(s, bent, t, place);
        tf_scene_path(scene, count, (const double(*)[3])place,
                      last ? TF_WIDTH_TUBE : TF_WIDTH_LINE, paint);
        for (int j = 0; j < count; j += count - 1)
            tf_scene_ball(scene, place[j], last ? TF_WIDTH_BALL : 3.5, paint);
        double middle[3];
        find_middle(s, bent, t, middle);
        tf_scene_ball(scene, middle, last ? 5 : 3.5, (tf_paint){.role = role});
    }
}

/// The names of the plank's ends at the start.
static void name_ends(tf_panel *panel, const scenario *s, tf_role role)
{
    static const char *const name[2] = {"$e_0$", "$e_1$"};
    for (int i = 0; i < 2; i++) {
        double at[3];
        tf_worldline_place(&s->plank[i], 2, 0, at);
        tf_panel_label(panel, at,
                       (tf_label){.text = name[i],
                                  .role = role,
                                  .side = i == 0 ? TF_SIDE_W : TF_SIDE_E});
    }
}

static void draw_fly(tf_panel *panel, const scenario *s, tf_role role)
{
    double at[3];
    tf_worldline_place(&s->fly, 2, 0, at);
    tf_scene_ball(tf_panel_scene(panel), at, TF_WIDTH_MARK,
                  (tf_paint){.role = role});
    tf_panel_label(
        panel, at,
        (tf_label){.text = "$p$", .role = role, .side = TF_SIDE_W, .gap = 7});
}

/// An arrow from the fly with its name at the tip.
static void draw_arrow(tf_panel *panel, const scenario *s,
                       const double direction[3], double scale, tf_label name)
{
    double from[3], tip[3];
    tf_worldline_place(&s->fly, 2, 0, from);
    tf_add(from, scale, direction, tip);
    tf_scene_arrow(tf_panel_scene(panel), from, tip, TF_WIDTH_TUBE,
                   (tf_paint){.role = name.role});
    tf_panel_label(panel, tip, name);
}

static tf_panel *begin_panel(tf_page *page, double left, const scenario *s,
                             bool bent)
{
    tf_box box = {left, 4, tf_page_width(page) / 2, panel_height};
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.elevation = 90});
    tf_panel_fix(panel);
    draw_planks(panel, s, bent);
    name_ends(panel, s, bent ? TF_ROLE_EDGE : TF_ROLE_OTHER_EDGE);
    tf_page_caption(page, box, bent ? "*staircase motion*" : "*linear motion*");
    return panel;
}

static void print_numbers(const scenario *s, FILE *numbers)
{
    tf_figure_number(numbers, "toi", s->toi);
    tf_figure_number(numbers, "weight_0", s->contact.weight[1][0]);
    tf_figure_number(numbers, "weight_1", s->contact.weight[1][1]);
    tf_figure_number(numbers, "normal_x", s->contact.normal[0]);
    tf_figure_number(numbers, "normal_y", s->contact.normal[1]);
    tf_figure_number(numbers, "velocity_x", s->contact.velocity[0]);
    tf_figure_number(numbers, "velocity_y", s->contact.velocity[1]);
    tf_figure_number(numbers, "speed", s->contact.speed);
}

static void draw(tf_page *page, FILE *numbers)
{
    scenario s = make_scenario();
    tf_panel *bent = begin_panel(page, 0, &s, true);
    draw_fly(bent, &s, TF_ROLE_CONTACT);
    draw_arrow(bent, &s, s.contact.normal, normal_length,
               (tf_label){.text = "$\\b{n}$", .side = TF_SIDE_E, .gap = 4});
    draw_arrow(bent, &s, s.contact.velocity, velocity_scale,
               (tf_label){.text = "$\\b{v}$/4",
                          .role = TF_ROLE_POINT,
                          .side = TF_SIDE_S,
                          .gap = 6});
    tf_panel *straight = begin_panel(page, tf_page_width(page) / 2, &s, false);
    draw_fly(straight, &s, TF_ROLE_POINT);
    print_numbers(&s, numbers);
}

const tf_figure tf_figure_seesaw = {
    .name = "seesaw",
    .title = "A plank turns beneath a fly, in two models of motion",
    .width = TF_FIGURE_WIDTH,
    .height = 204,
    .draw = draw,
};
