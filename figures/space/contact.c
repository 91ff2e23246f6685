// What describes a contact: normal, relative velocity and barycentric
// coordinates, of a point on a triangle and of two edges.
#include "arithmetic/exact.h"
#include "kit/figures.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    CORNERS = 3
};

// Nothing turns or stretches: the weights are areas; both normals are
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

static const fig_camera camera = {.azimuth = 18, .elevation = 22};
static const double normal_length = 2, velocity_scale = 0.4;
static const double parallelogram_scale = 0.45, small_ball = 4.5;

static void print_contact(const char *name, const tf_contact *contact,
                          FILE *numbers)
{
    char key[64];
    for (int k = 0; k < 3; k++) {
        snprintf(key, sizeof key, "%s_normal_%c", name, 'x' + k);
        fig_number(numbers, key, contact->normal[k]);
        snprintf(key, sizeof key, "%s_velocity_%c", name, 'x' + k);
        fig_number(numbers, key, contact->velocity[k]);
    }
    snprintf(key, sizeof key, "%s_toi", name);
    fig_number(numbers, key, fig_toi(contact));
    snprintf(key, sizeof key, "%s_normal_velocity", name);
    fig_number(numbers, key, contact->normal_velocity);
}

static void print_barycentric(const char *name, int count,
                              const double weight[], FILE *numbers)
{
    for (int i = 0; i < count; i++) {
        char key[64];
        snprintf(key, sizeof key, "%s_barycentric_%d", name, i);
        fig_number(numbers, key, weight[i]);
    }
}

// Normal and velocity ----------------------------------------------------

static void add_ball(fig_panel *panel, tf_vector at, double diameter,
                     fig_label name)
{
    fig_scene_ball(fig_panel_scene(panel), at, diameter,
                   (fig_paint){.role = name.role});
    if (name.text != NULL)
        fig_panel_label(panel, at, name);
}

/// An arrow with its name beside its middle or, for the normal, at its tip.
static void add_arrow(fig_panel *panel, tf_vector from, tf_vector to,
                      double width, double named, fig_label name)
{
    fig_scene_arrow(fig_panel_scene(panel), from, to, width,
                    (fig_paint){.role = name.role});
    tf_vector along = fig_difference(to, from);
    fig_panel_label(panel, fig_combination(from, named, along), name);
}

/// The normal, and the relative velocity, which ends at the contact, in its
/// parts along the normal and across.  They stand on the side `outside`.
static void add_arrows(fig_panel *panel, const tf_contact *contact,
                       fig_role role, fig_side outside, tf_vector at)
{
    tf_vector normal = fig_vector_of(contact->normal);
    tf_vector tip = fig_combination(at, normal_length, normal);
    tf_vector from =
        fig_combination(at, -velocity_scale, fig_vector_of(contact->velocity));
    tf_vector foot = fig_combination(
        from, velocity_scale * contact->normal_velocity, normal);
    add_arrow(panel, at, tip, FIG_WIDTH_TUBE, 1,
              (fig_label){.text = "$\\b{n}$", .side = FIG_SIDE_NE, .gap = 6});
    add_arrow(panel, from, at, FIG_WIDTH_TUBE, 0.5,
              (fig_label){.text = "$\\b{v}$", .role = role, .gap = 3});
    add_arrow(panel, from, foot, FIG_WIDTH_LINE, 0.5,
              (fig_label){.text = "$(\\b{v}·\\b{n})\\b{n}$",
                          .role = role,
                          .side = outside,
                          .gap = 7});
    fig_scene_dashes(fig_panel_scene(panel), foot, at, FIG_WIDTH_THIN, 2,
                     (fig_paint){.role = role});
    add_ball(panel, at, FIG_WIDTH_MARK, (fig_label){.role = FIG_ROLE_CONTACT});
}

/// A weight in the middle of what it measures.
static void add_weight(fig_panel *panel, tf_vector at, double weight)
{
    char text[16];
    snprintf(text, sizeof text, "%g", weight);
    fig_panel_label(panel, at,
                    (fig_label){.text = text,
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_S,
                                .gap = 3});
}

// A point on a triangle --------------------------------------------------

/// The areas into which the contact divides the triangle: across from a corner
/// is the corner's weight.
static void add_areas(fig_panel *panel, const tf_vector corner[CORNERS],
                      tf_vector at, const double weight[CORNERS])
{
    static const double shade[CORNERS] = {-0.35, 0, 0.3};
    for (int i = 0; i < CORNERS; i++) {
        tf_vector area[3] = {at, corner[(i + 1) % CORNERS],
                             corner[(i + 2) % CORNERS]};
        tf_vector sum = fig_sum(fig_sum(area[0], area[1]), area[2]);
        fig_scene_triangle(fig_panel_scene(panel), area, FIG_WIDTH_THIN,
                           (fig_paint){.role = FIG_ROLE_TRIANGLE,
                                       .opacity = 0.6,
                                       .shade = shade[i]});
        add_weight(panel, tf_vector_scaled(1.0 / 3, sum), weight[i]);
    }
}

static void draw_point_triangle(fig_panel *panel, FILE *numbers)
{
    static const char *const name[CORNERS] = {"$a$", "$b$", "$c$"};
    tf_worldline point = tf_worldline_between(3, point_start, point_end);
    tf_worldline triangle[CORNERS];
    for (int i = 0; i < CORNERS; i++)
        triangle[i] = tf_worldline_between(3, corner_start[i], corner_end[i]);
    tf_contact contact;
    tf_query(&tf_exact, 3, 1, &point, 3, triangle, &contact);
    print_contact("point_triangle", &contact, numbers);
    print_barycentric("point_triangle", CORNERS, contact.barycentric[1],
                      numbers);

    tf_vector corner[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        corner[i] = fig_worldline_place(&triangle[i], 3, fig_toi(&contact));
        add_ball(panel, corner[i], small_ball,
                 (fig_label){.text = name[i], .role = FIG_ROLE_TRIANGLE});
    }
    tf_vector at = fig_worldline_place(&point, 3, fig_toi(&contact));
    add_areas(panel, corner, at, contact.barycentric[1]);
    add_arrows(panel, &contact, FIG_ROLE_POINT, FIG_SIDE_W, at);
}

// Two edges --------------------------------------------------------------

/// An edge at the time of contact, which divides it by the weights: across from
/// an end is the end's weight.
static void add_edge(fig_panel *panel, const tf_vector end[2], tf_vector at,
                     const char *const name[2], fig_role role,
                     const double weight[2])
{
    fig_scene_tube(fig_panel_scene(panel), end[0], end[1], FIG_WIDTH_TUBE,
                   (fig_paint){.role = role});
    for (int i = 0; i < 2; i++) {
        add_ball(panel, end[i], small_ball,
                 (fig_label){.text = name[i], .role = role});
        tf_vector across = fig_difference(end[1 - i], at);
        tf_vector between = fig_combination(at, 0.5, across);
        add_weight(panel, between, weight[i]);
    }
}

/// The parallelogram of both edges' directions around the contact, to which the
/// normal is at right angles.
static void add_parallelogram(fig_scene *scene, tf_vector end[2][2],
                              tf_vector at)
{
    tf_vector side[2], corner = at;
    for (int k = 0; k < 2; k++) {
        side[k] = tf_vector_scaled(parallelogram_scale,
                                   fig_difference(end[k][1], end[k][0]));
        corner = fig_combination(corner, -0.5, side[k]);
    }
    fig_scene_grid(scene, corner, side[0], side[1], 2, 2, FIG_ROLE_NEUTRAL);
}

static void draw_edge_edge(fig_panel *panel, FILE *numbers)
{
    static const char *const name[2][2] = {{"$a_0$", "$a_1$"},
                                           {"$b_0$", "$b_1$"}};
    static const fig_role role[2] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
    tf_worldline edge[2][2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            edge[k][i] =
                tf_worldline_between(3, edge_start[k][i], edge_end[k][i]);
    tf_contact contact;
    tf_query(&tf_exact, 3, 2, edge[0], 2, edge[1], &contact);
    print_contact("edge_edge", &contact, numbers);
    print_barycentric("edge_edge_first", 2, contact.barycentric[0], numbers);
    print_barycentric("edge_edge_second", 2, contact.barycentric[1], numbers);

    tf_vector end[2][2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            end[k][i] = fig_worldline_place(&edge[k][i], 3, fig_toi(&contact));
    tf_vector along = fig_difference(end[0][1], end[0][0]);
    tf_vector at = fig_combination(end[0][0], contact.barycentric[0][1], along);
    for (int k = 0; k < 2; k++)
        add_edge(panel, end[k], at, name[k], role[k], contact.barycentric[k]);
    add_parallelogram(fig_panel_scene(panel), end, at);
    add_arrows(panel, &contact, FIG_ROLE_EDGE, FIG_SIDE_E, at);
}

static fig_panel *add_panel(fig_page *page, double x, const char *title)
{
    double top = 16, width = fig_page_width(page) / 2;
    fig_page_text(page, x + width / 2, 14, FIG_ALIGN_CENTER, title,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_panel *panel = fig_page_panel(
        page, (fig_box){x, top, width, fig_page_height(page) - top});
    fig_panel_look(panel, camera);
    return panel;
}

static void draw(fig_page *page, FILE *numbers)
{
    draw_point_triangle(add_panel(page, 0, "point and triangle"), numbers);
    draw_edge_edge(add_panel(page, fig_page_width(page) / 2, "edge and edge"),
                   numbers);
}

const fig_figure fig_contact = {
    .name = "contact",
    .title = "Normal, velocity and barycentric coordinates of a contact",
    .width = FIG_PAGE_WIDTH,
    .height = 224,
    .draw = draw,
};
