#include "kit/turning.h"

#include "kit/film.h"
#include "kit/worlds.h"

#include <math.h>

enum {
    CORNERS = 4,
    FACES = 4,
    SHOWN = 3
};

static const double start[CORNERS][3] = {
    {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
static const int faces[FACES][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

/// Degrees that the picture is turned by about the axis.
static const double turned_by = 70;

// The tetrahedron -------------------------------------------------------------

typedef struct tetrahedron {
    tf_vector corner[CORNERS];
} tetrahedron;

static tetrahedron at_time(const fig_turning *turning, double t)
{
    tetrahedron made;
    for (int i = 0; i < CORNERS; i++)
        for (int k = 0; k < 3; k++)
            made.corner[i].x[k] =
                i == 0 ? (1 - t) * start[0][k] + t * turning->end[k]
                       : start[i][k];
    return made;
}

static double volume(const tetrahedron *t)
{
    const tf_vector *x = t->corner;
    tf_vector u = fig_difference(x[1], x[0]), v = fig_difference(x[2], x[0]),
              w = fig_difference(x[3], x[0]);
    return -tf_vector_dot(fig_cross(u, v), w) / 6;
}

// Drawing ---------------------------------------------------------------------

/// So turned that the diagonal of the axes is up.
static tf_vector upright(tf_vector place)
{
    double x = (place.x[0] - place.x[1]) / sqrt(2);
    double y = (place.x[0] + place.x[1] - 2 * place.x[2]) / sqrt(6);
    double z = (place.x[0] + place.x[1] + place.x[2]) / sqrt(3);
    double angle = turned_by * acos(-1) / 180, c = cos(angle), s = sin(angle);
    return (tf_vector){{c * x - s * y, s * x + c * y, z}};
}

static tf_vector to_the_eye(fig_camera from)
{
    double azimuth = from.azimuth * acos(-1) / 180;
    double elevation = from.elevation * acos(-1) / 180;
    return (tf_vector){{sin(azimuth) * cos(elevation),
                        -cos(azimuth) * cos(elevation), sin(elevation)}};
}

/// Blue from outside, orange from inside.
static void draw_face(fig_scene *scene, fig_camera from,
                      const tf_vector corner[3])
{
    tf_vector normal = fig_cross(fig_difference(corner[1], corner[0]),
                                 fig_difference(corner[2], corner[0]));
    bool outside = tf_vector_dot(normal, to_the_eye(from)) > 0;
    fig_scene_triangle(
        scene, corner, FIG_WIDTH_LINE,
        (fig_paint){.role = outside ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE,
                    .opacity = outside ? 0.72 : 0.85});
}

static void draw_tetrahedron(fig_scene *scene, fig_camera from,
                             const tetrahedron *t)
{
    for (int i = 0; i < FACES; i++) {
        tf_vector corner[3];
        for (int j = 0; j < 3; j++)
            corner[j] = upright(t->corner[faces[i][j]]);
        draw_face(scene, from, corner);
    }
}

/// The path of the corner, and how far it has come.
static void draw_path(fig_scene *scene, const fig_turning *turning, double t)
{
    tf_vector from = upright(at_time(turning, 0).corner[0]);
    tf_vector to = upright(at_time(turning, 1).corner[0]);
    fig_scene_dashes(scene, from, to, FIG_WIDTH_LINE, 3,
                     (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_ball(scene, upright(at_time(turning, t).corner[0]),
                   FIG_WIDTH_BALL, (fig_paint){.role = FIG_ROLE_POINT});
}

static void draw_meeting(fig_scene *scene, const fig_turning *turning)
{
    tf_vector at = upright((tf_vector){
        {turning->meeting[0], turning->meeting[1], turning->meeting[2]}});
    fig_scene_ball(scene, at, FIG_WIDTH_MARK,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
}

static void draw_time(fig_page *page, fig_box box, const fig_turning *turning,
                      double t)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, turning->camera);
    fig_panel_fix(panel);
    fig_panel_margin(panel, 10);
    fig_scene *scene = fig_panel_scene(panel);
    // Where two faces coincide, those of a moment earlier are drawn.
    tetrahedron now = at_time(turning, t == turning->time ? t - 0.01 : t);
    for (int at = 0; at < 2; at++) {
        tetrahedron then = at_time(turning, at);
        for (int i = 0; i < CORNERS; i++)
            fig_scene_reach(scene, upright(then.corner[i]));
    }
    draw_tetrahedron(scene, turning->camera, &now);
    draw_path(scene, turning, t);
    if (t == turning->time)
        draw_meeting(scene, turning);
    char text[48];
    snprintf(text, sizeof text, "volume $%.2f$", volume(&now) + 0.0);
    fig_page_caption(page, box, t == turning->time ? "volume $0$" : text);
}

static void print_numbers(FILE *numbers, const fig_turning *turning)
{
    tetrahedron first = at_time(turning, 0), last = at_time(turning, 1);
    fig_number(numbers, "time", turning->time);
    fig_number(numbers, "volume_start", volume(&first));
    fig_number(numbers, "volume_end", volume(&last));
}

void fig_turning_draw(fig_page *page, FILE *numbers, const fig_turning *turning)
{
    double t = fig_film_time(page, numbers, turning->time, turning->time);
    double width = fig_page_width(page), height = fig_page_height(page);
    const double shown[SHOWN] = {0, turning->time, 1};
    if (fig_page_moves(page)) {
        fig_box whole = {0, 0, width, height - 40};
        draw_time(page, whole, turning, t);
        fig_film_clock(page, 4, height - 10, width - 8, t, turning->time,
                       turning->name);
    }
    for (int i = 0; i < SHOWN && !fig_page_moves(page); i++) {
        fig_box box = {width * i / SHOWN, 18, width / SHOWN, height - 38};
        draw_time(page, box, turning, shown[i]);
        char text[32];
        snprintf(text, sizeof text, i == 1 ? "$t = %.2f$" : "$t = %g$",
                 shown[i]);
        fig_page_title(page, box, text);
    }
    print_numbers(numbers, turning);
}
