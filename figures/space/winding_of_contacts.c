// All pairs of border points of two edges of the plane at all times: a ring,
// inside t = 0 and outside t = 1.  Beside it the edges at the start, at each
// contact and at the end.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "intersect/cascade.h"
#include "kit/worlds.h"

#include <math.h>
#include <stddef.h>

enum {
    EDGES = 2,
    BEND = 3,     ///< the points of a bent edge
    CONTACTS = 3, ///< of this example
    PANELS = CONTACTS + 2,
    CIRCLE = 64
};

static const double start[EDGES][2][2] = {{{-0.25, 0.25}, {-1.5, 1.5}},
                                          {{-0.75, 0.25}, {1.5, -1}}};
static const double end[EDGES][2][2] = {{{0.25, -1.5}, {1, 0.25}},
                                        {{0.75, 1}, {1, -1}}};

static const fig_role role[EDGES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};

/// A point of the ring, in [-2, 2] x [-2, 2]: the square of both barycentric
/// coordinates, 1 + t times as large.
typedef struct ring_point {
    double x, y;
} ring_point;

typedef struct contact {
    double t;
    ring_point at;
    int edge, end; ///< the end of that edge meets the other one
    double sign;
} contact;

typedef struct step {
    tf_worldline edge[EDGES][2];
    int count;
    contact contact[CONTACTS];
} step;

// The difference -------------------------------------------------------------

/// The place of an edge's point with the barycentric coordinate s at time t.
static tf_vector painted(const tf_worldline edge[2], double s, double t)
{
    tf_vector place[BEND];
    fig_world_of_edge(edge, t, place);
    for (int i = 0; i < BEND; i++)
        place[i].x[2] = 0;
    if (s <= t)
        return t == 0 ? place[0] : fig_lerp(place[0], place[1], s / t);
    return fig_lerp(place[1], place[2], (s - t) / (1 - t));
}

static tf_vector difference_at(const step *all, ring_point at)
{
    double size = fmax(fabs(at.x), fabs(at.y));
    double t = fmin(fmax(size - 1, 0), 1);
    double s = (at.x / size + 1) / 2, u = (at.y / size + 1) / 2;
    return fig_difference(painted(all->edge[0], s, t),
                          painted(all->edge[1], u, t));
}

/// How often the difference goes around the origin on a circle in the ring.
static double turns_around(const step *all, ring_point center, double radius)
{
    double sum = 0;
    tf_vector last = {{0, 0, 0}};
    for (int i = 0; i <= CIRCLE; i++) {
        double angle = 2 * acos(-1) * i / CIRCLE;
        tf_vector now =
            difference_at(all, (ring_point){center.x + radius * cos(angle),
                                            center.y + radius * sin(angle)});
        if (i > 0)
            sum += atan2(fig_cross(last, now).x[2], tf_vector_dot(last, now));
        last = now;
    }
    return round(sum / (2 * acos(-1))) + 0.0;
}

/// The same on the border of the square, at an end of the step.
static double turns_at(const step *all, int t)
{
    static const ring_point corner[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        ring_point a = corner[i], b = corner[(i + 1) % 4];
        tf_vector from =
            difference_at(all, (ring_point){(1 + t) * a.x, (1 + t) * a.y});
        tf_vector to =
            difference_at(all, (ring_point){(1 + t) * b.x, (1 + t) * b.y});
        sum += atan2(fig_cross(from, to).x[2], tf_vector_dot(from, to));
    }
    return round(sum / (2 * acos(-1))) + 0.0;
}

// Contacts --------------------------------------------------------------------

/// Note that an end of an edge is at the point s of the other one.
static void add_contact(step *all, int edge, int at, double t, double s)
{
    double own = at == 0 ? -1 : 1, other = 2 * s - 1, size = 1 + t;
    contact c = {.t = t, .edge = edge, .end = at};
    c.at = edge == 0 ? (ring_point){size * own, size * other}
                     : (ring_point){size * other, size * own};
    c.sign = turns_around(all, c.at, 0.05);
    TF_REQUIRE(all->count < CONTACTS);
    int i = all->count++;
    for (; i > 0 && all->contact[i - 1].t > t; i--)
        all->contact[i] = all->contact[i - 1];
    all->contact[i] = c;
}

static void find_contacts(step *all, int edge, int at)
{
    const tf_worldline *other = all->edge[1 - edge];
    tf_simplex path[1], sweep[2];
    tf_sweep(1, &all->edge[edge][at], path);
    tf_sweep(2, other, sweep);
    for (int j = 0; j < 2; j++) {
        tf_pair pair = tf_pair_of(&path[0], &sweep[j], 2);
        tf_intersection found = tf_intersect(&tf_exact, &pair, TF_WITH_POINT);
        if (found.verdict != TF_HIT)
            continue;
        double t = (found.toi_lo + found.toi_hi) / 2;
        // Along the slice, from corner 0 to 1 of this simplex.
        fig_slice slice = fig_slice_of(&sweep[j], 2, t);
        tf_vector u = fig_difference(slice.corner[1], slice.corner[0]);
        tf_vector to = fig_difference(
            fig_worldline_place(&all->edge[edge][at], 2, t), slice.corner[0]);
        double part = tf_vector_dot(u, to) / tf_vector_dot(u, u);
        // The last pivot's slice is from the crease on, at the coordinate t.
        add_contact(all, edge, at, t, j == 0 ? t + part * (1 - t) : part * t);
    }
}

static void solve(step *all)
{
    *all = (step){.count = 0};
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            all->edge[k][i] = tf_worldline_between(2, start[k][i], end[k][i]);
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            find_contacts(all, k, i);
    TF_REQUIRE(all->count == CONTACTS);
}

// Drawing ---------------------------------------------------------------------

/// From the ring to the page.
static fig_point place_in(fig_box box, ring_point at)
{
    return (fig_point){box.x + box.width * (at.x + 2.2) / 4.4,
                       box.y + box.height * (2.2 - at.y) / 4.4};
}

/// One of the ring's four sides, in the color of the edge that is there against
/// an end of the other one.
static void draw_side(fig_page *page, fig_box box, int side)
{
    static const ring_point corner[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    ring_point a = corner[side], b = corner[(side + 1) % 4];
    fig_point around[4] = {
        place_in(box, a), place_in(box, (ring_point){2 * a.x, 2 * a.y}),
        place_in(box, (ring_point){2 * b.x, 2 * b.y}), place_in(box, b)};
    fig_page_fill(page, 4, around,
                  (fig_paint){.role = role[side % 2], .opacity = 0.25});
    fig_page_line(page, 4, around,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_THIN,
                               .closed = true,
                               .under_labels = true});
}

static void write_sign(char text[8], double sign)
{
    snprintf(text, 8, sign > 0 ? "$+1$" : "$-1$");
}

static void draw_ring(fig_page *page, fig_box box, const step *all)
{
    for (int i = 0; i < 4; i++)
        draw_side(page, box, i);
    for (int i = 0; i < all->count; i++) {
        const contact *c = &all->contact[i];
        fig_point at = place_in(box, c->at);
        fig_page_dot(page, at.x, at.y, 5,
                     (fig_paint){.role = FIG_ROLE_CONTACT});
        fig_page_arc(page, at.x, at.y, 6.5, 0, 360,
                     (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT},
                                  .width = FIG_WIDTH_THIN});
        char text[8];
        write_sign(text, c->sign);
        fig_page_label(page, at.x, at.y,
                       (fig_label){.text = text,
                                   .size = FIG_LETTERS_SMALL,
                                   .role = FIG_ROLE_CONTACT,
                                   .side = FIG_SIDE_S,
                                   .gap = 7});
    }
    char text[48];
    fig_point middle = place_in(box, (ring_point){0, 0});
    snprintf(text, sizeof text, "winding number %g", turns_at(all, 0));
    fig_page_text(page, middle.x, middle.y - 3, FIG_ALIGN_CENTER, "$t = 0$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, middle.x, middle.y + 9, FIG_ALIGN_CENTER, text, 7.5,
                  FIG_ROLE_INK);
    snprintf(text, sizeof text, "$t = 1$: winding number $%g$",
             turns_at(all, 1));
    fig_page_caption(page, box, text);
}

static void draw_edges(fig_page *page, fig_box box, const step *all, int which)
{
    const contact *c =
        which > 0 && which <= all->count ? &all->contact[which - 1] : NULL;
    double t = c ? c->t : which > 0;
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_margin(panel, 8);
    fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    for (int k = 0; k < EDGES; k++) {
        tf_vector place[BEND];
        for (int at = 0; at < 2; at++)
            for (int i = 0; i < 2; i++)
                fig_scene_reach(scene,
                                fig_worldline_place(&all->edge[k][i], 2, at));
        fig_world_of_edge(all->edge[k], t, place);
        for (int i = 0; i < BEND; i++)
            place[i].x[2] = 0;
        fig_scene_path(scene, BEND, place, FIG_WIDTH_TUBE,
                       (fig_paint){.role = role[k]});
        for (int i = 0; i < BEND; i += BEND - 1)
            fig_scene_ball(scene, place[i], 4, (fig_paint){.role = role[k]});
        if (c && c->edge == k)
            fig_scene_ball(scene, place[(ptrdiff_t)2 * c->end], FIG_WIDTH_BALL,
                           (fig_paint){.role = FIG_ROLE_CONTACT});
    }
    char text[48], sign[8] = "";
    if (c)
        write_sign(sign, c->sign);
    snprintf(text, sizeof text, c ? "$t = %.2f$: %s" : "$t = %g$%s", t, sign);
    fig_page_caption(page, box, text);
}

static void draw(fig_page *page, FILE *numbers)
{
    step all;
    solve(&all);
    double side = fig_page_height(page) - 22, left = side + 14;
    double width = (fig_page_width(page) - left) / 3, height = 80;
    draw_ring(page, (fig_box){0, 0, side, side}, &all);
    for (int i = 0; i < PANELS; i++) {
        int row = i / 3;
        draw_edges(page,
                   (fig_box){left + width * (i % 3) + 2,
                             4 + row * (height + 22), width - 4, height},
                   &all, i);
    }
    fig_number(numbers, "winding_start", turns_at(&all, 0));
    fig_number(numbers, "winding_end", turns_at(&all, 1));
    for (int i = 0; i < all.count; i++) {
        char key[32];
        snprintf(key, sizeof key, "toi_%d", i);
        fig_number(numbers, key, all.contact[i].t);
        snprintf(key, sizeof key, "sign_%d", i);
        fig_number(numbers, key, all.contact[i].sign);
    }
}

const fig_figure fig_winding_of_contacts = {
    .name = "winding-of-contacts",
    .title = "The contacts of two edges in a ring of all times",
    .width = FIG_PAGE_WIDTH,
    .height = 208,
    .draw = draw,
};
