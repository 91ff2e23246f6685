// What a contact knows: normal, relative velocity and weights, of a point on a
// triangle and of two edges.
#include "arithmetic/exact.h"
#include "figures.h"
#include "query/edge_edge.h"
#include "query/point_triangle.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    CORNERS = 3
};

// Nothing turns, so that the weights are areas; both normals are
// (-1, -4, 8) / 9.
static const double point_start[] = {-1, 1.625, 2.5},
                    point_end[] = {4, 1.625, -0.5};
static const double corner_start[CORNERS][3] = {
    {-0.5, 0, -0.5}, {3.5, -1, -0.5}, {0.5, 3.75, 1.5}};
static const double corner_end[CORNERS][3] = {
    {0.5, 0, 0.5}, {4.5, -1, 0.5}, {1.5, 3.75, 2.5}};

static const double edge_start[2][2][3] = {
    {{-0.375, 0.96875, 2.5}, {4.625, -0.28125, 2.5}},
    {{-0.5, -2, -1.25}, {-0.5, 2, 0.75}}};
static const double edge_end[2][2][3] = {
    {{-3.375, 0.96875, -2.5}, {1.625, -0.28125, -2.5}},
    {{0.5, -2, -1.25}, {0.5, 2, 0.75}}};

static const tf_camera camera = {.azimuth = 18, .elevation = 22};
static const double normal_length = 2, velocity_scale = 0.4;
static const double parallelogram_scale = 0.45, small_ball = 4.5;

static double middle(const tf_contact *contact)
{
    return (contact->toi_lo + contact->toi_hi) / 2;
}

static void print_contact(const char *name, const tf_contact *contact,
                          FILE *numbers)
{
    char key[64];
    for (int k = 0; k < 3; k++) {
        snprintf(key, sizeof key, "%s_normal_%c", name, 'x' + k);
        tf_figure_number(numbers, key, contact->normal[k]);
        snprintf(key, sizeof key, "%s_velocity_%c", name, 'x' + k);
        tf_figure_number(numbers, key, contact->velocity[k]);
    }
    snprintf(key, sizeof key, "%s_toi", name);
    tf_figure_number(numbers, key, middle(contact));
    snprintf(key, sizeof key, "%s_speed", name);
    tf_figure_number(numbers, key, contact->speed);
}

static void print_weights(const char *name, int count, const double weight[],
                          FILE *numbers)
{
    for (int i = 0; i < count; i++) {
        char key[64];
        snprintf(key, sizeof key, "%s_weight_%d", name, i);
        tf_figure_number(numbers, key, weight[i]);
    }
}

// Normal and velocity ----------------------------------------------------

static void add_ball(tf_panel *panel, const double at[3], double diameter,
                     tf_label name)
{
    tf_scene_ball(tf_panel_scene(panel), at, diameter,
                  (tf_paint){.role = name.role});
    if (name.text != NULL)
        tf_panel_label(panel, at, name);
}

/// An arrow with its name beside its middle or, for the normal, at its tip.
static void add_arrow(tf_panel *panel, const double from[3], const double to[3],
                      double width, double named, tf_label name)
{
    double along[3], place[3];
    tf_scene_arrow(tf_panel_scene(panel), from, to, width,
                   (tf_paint){.role = name.role});
    tf_add(to, -1, from, along);
    tf_add(from, named, along, place);
    tf_panel_label(panel, place, name);
}

/// The normal, and the relative velocity, which ends at the contact, in its
/// parts along the normal and across.  They stand on the side `outside`.
static void add_arrows(tf_panel *panel, const tf_contact *contact, tf_role role,
                       tf_side outside, const double at[3])
{
    double tip[3], from[3], foot[3];
    tf_add(at, normal_length, contact->normal, tip);
    tf_add(at, -velocity_scale, contact->velocity, from);
    tf_add(from, velocity_scale * contact->speed, contact->normal, foot);
    add_arrow(panel, at, tip, TF_WIDTH_TUBE, 1,
              (tf_label){.text = "$\\b{n}$", .side = TF_SIDE_NE, .gap = 6});
    add_arrow(panel, from, at, TF_WIDTH_TUBE, 0.5,
              (tf_label){.text = "$\\b{v}$", .role = role, .gap = 3});
    add_arrow(panel, from, foot, TF_WIDTH_LINE, 0.5,
              (tf_label){.text = "$(\\b{v}·\\b{n})\\b{n}$",
                         .role = role,
                         .side = outside,
                         .gap = 3});
    tf_scene_dashes(tf_panel_scene(panel), foot, at, TF_WIDTH_THIN, 2,
                    (tf_paint){.role = role});
    add_ball(panel, at, TF_WIDTH_MARK, (tf_label){.role = TF_ROLE_CONTACT});
}

/// A weight in the middle of what it measures.
static void add_weight(tf_panel *panel, const double at[3], double weight)
{
    char text[16];
    snprintf(text, sizeof text, "%g", weight);
    tf_panel_label(panel, at,
                   (tf_label){.text = text,
                              .size = TF_LETTERS_SMALL,
                              .side = TF_SIDE_S,
                              .gap = 3});
}

// A point on a triangle --------------------------------------------------

/// The areas into which the contact divides the triangle: across from a corner
/// is the corner's weight.
static void add_areas(tf_panel *panel, const double corner[CORNERS][3],
                      const double at[3], const double weight[CORNERS])
{
    static const double shade[CORNERS] = {-0.35, 0, 0.3};
    for (int i = 0; i < CORNERS; i++) {
        const double *next = corner[(i + 1) % CORNERS];
        const double *last = corner[(i + 2) % CORNERS];
        double area[3][3], centroid[3];
        for (int k = 0; k < 3; k++) {
            area[0][k] = at[k];
            area[1][k] = next[k];
            area[2][k] = last[k];
            centroid[k] = (at[k] + next[k] + last[k]) / 3;
        }
        tf_scene_triangle(
            tf_panel_scene(panel), (const double(*)[3])area, TF_WIDTH_THIN,
            (tf_paint){
                .role = TF_ROLE_TRIANGLE, .opacity = 0.6, .shade = shade[i]});
        add_weight(panel, centroid, weight[i]);
    }
}

static void draw_point_triangle(tf_panel *panel, FILE *numbers)
{
    static const char *const name[CORNERS] = {"$a$", "$b$", "$c$"};
    tf_worldline point = tf_worldline_between(3, point_start, point_end);
    tf_worldline triangle[CORNERS];
    for (int i = 0; i < CORNERS; i++)
        triangle[i] = tf_worldline_between(3, corner_start[i], corner_end[i]);
    tf_contact contact;
    tf_point_triangle(&tf_exact, &point, triangle, &contact);
    print_contact("point_triangle", &contact, numbers);
    print_weights("point_triangle", CORNERS, contact.weight[1], numbers);

    double corner[CORNERS][3], at[3];
    for (int i = 0; i < CORNERS; i++) {
        tf_worldline_place(&triangle[i], 3, middle(&contact), corner[i]);
        add_ball(panel, corner[i], small_ball,
                 (tf_label){.text = name[i], .role = TF_ROLE_TRIANGLE});
    }
    tf_worldline_place(&point, 3, middle(&contact), at);
    add_areas(panel, (const double(*)[3])corner, at, contact.weight[1]);
    add_arrows(panel, &contact, TF_ROLE_POINT, TF_SIDE_W, at);
}

// Two edges --------------------------------------------------------------

/// An edge at the time of contact, which divides it by the weights: across from
/// an end is the end's weight.
static void add_edge(tf_panel *panel, const double end[2][3],
                     const double at[3], const char *const name[2],
                     tf_role role, const double weight[2])
{
    tf_scene_tube(tf_panel_scene(panel), end[0], end[1], TF_WIDTH_TUBE,
                  (tf_paint){.role = role});
    for (int i = 0; i < 2; i++) {
        double across[3], between[3];
        add_ball(panel, end[i], small_ball,
                 (tf_label){.text = name[i], .role = role});
        tf_add(end[1 - i], -1, at, across);
        tf_add(at, 0.5, across, between);
        add_weight(panel, between, weight[i]);
    }
}

/// The parallelogram of both edges' directions around the contact, to which the
/// normal is at right angles.
static void add_parallelogram(tf_scene *scene, const double end[2][2][3],
                              const double at[3])
{
    double side[2][3], corner[3];
    tf_add(at, 0, at, corner);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++)
            side[k][i] = parallelogram_scale * (end[k][1][i] - end[k][0][i]);
        tf_add(corner, -0.5, side[k], corner);
    }
    tf_scene_grid(scene, corner, side[0], side[1], 2, 2, TF_ROLE_NEUTRAL);
}

static void draw_edge_edge(tf_panel *panel, FILE *numbers)
{
    static const char *const name[2][2] = {{"$a_0$", "$a_1$"},
                                           {"$b_0$", "$b_1$"}};
    static const tf_role role[2] = {TF_ROLE_EDGE, TF_ROLE_OTHER_EDGE};
    tf_worldline edge[2][2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            edge[k][i] =
                tf_worldline_between(3, edge_start[k][i], edge_end[k][i]);
    tf_contact contact;
    tf_edge_edge(&tf_exact, edge[0], edge[1], &contact);
    print_contact("edge_edge", &contact, numbers);
    print_weights("edge_edge_first", 2, contact.weight[0], numbers);
    print_weights("edge_edge_second", 2, contact.weight[1], numbers);

    double end[2][2][3], along[3], at[3];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            tf_worldline_place(&edge[k][i], 3, middle(&contact), end[k][i]);
    tf_add(end[0][1], -1, end[0][0], along);
    tf_add(end[0][0], contact.weight[0][1], along, at);
    for (int k = 0; k < 2; k++)
        add_edge(panel, (const double(*)[3])end[k], at, name[k], role[k],
                 contact.weight[k]);
    add_parallelogram(tf_panel_scene(panel), (const double(*)[2][3])end, at);
    add_arrows(panel, &contact, TF_ROLE_EDGE, TF_SIDE_E, at);
}

static tf_panel *add_panel(tf_page *page, double x, const char *title)
{
    double top = 16, width = tf_page_width(page) / 2;
    tf_page_text(page, x + width / 2, 14, TF_ALIGN_CENTER, title,
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    tf_panel *panel = tf_page_panel(
        page, (tf_box){x, top, width, tf_page_height(page) - top});
    tf_panel_look(panel, camera);
    return panel;
}

static void draw(tf_page *page, FILE *numbers)
{
    draw_point_triangle(add_panel(page, 0, "point and triangle"), numbers);
    draw_edge_edge(add_panel(page, tf_page_width(page) / 2, "edge and edge"),
                   numbers);
}

const tf_figure tf_figure_contact = {
    .name = "contact",
    .title = "Normal, velocity and weights of a contact",
    .width = TF_FIGURE_WIDTH,
    .height = 224,
    .draw = draw,
};
