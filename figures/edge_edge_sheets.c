// Two moving edges: their sweeps in space, and the four pairs of triangles of
// space-time that decide whether and when they meet.
#include "arithmetic/exact.h"
#include "figures.h"
#include "query/edge_edge.h"
#include "spacetime/meet.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    EDGES = 2,
    TRIANGLES = 2, ///< in the sweep of an edge
    STRIPES = 4    ///< between the times that are drawn
};

// Chosen to meet at half time.
static const double start[EDGES][2][3] = {
    {{-2.625, -1, -1}, {1.375, 0.5, -2}},
    {{0.5, -1.375, 2.75}, {-0.5, 2.625, 1.5}}};
static const double end[EDGES][2][3] = {
    {{-2.875, -0.5, 0.5}, {1.375, -0.5, 2.75}},
    {{-0.25, -1.375, -2}, {0.75, 2.625, -1}}};

static const tf_role role[EDGES] = {TF_ROLE_EDGE, TF_ROLE_OTHER_EDGE};
static const char *const vertex_name[EDGES][2][2] = {
    {{"$a_0$", "$a_0'$"}, {"$a_1$", "$a_1'$"}},
    {{"$b_0$", "$b_0'$"}, {"$b_1$", "$b_1'$"}}};
static const char *const triangle_name[EDGES][TRIANGLES] = {
    {"$a_0\u2009a_1\u2009a_1'$", "$a_0\u2009a_0'\u2009a_1'$"},
    {"$b_0\u2009b_1\u2009b_1'$", "$b_0\u2009b_0'\u2009b_1'$"}};

static const tf_camera camera = {.azimuth = 42, .elevation = 20};

typedef struct encounter {
    tf_worldline edge[EDGES][2];
    tf_simplex sweep[EDGES][TRIANGLES];
    tf_meeting meeting[TRIANGLES][TRIANGLES];
    tf_contact contact;
    double place[3]; ///< of the contact
} encounter;

static double middle(const tf_contact *contact)
{
    return (contact->toi_lo + contact->toi_hi) / 2;
}

/// The point of the first edge's triangle that has the meeting's weights.
static void find_place(const tf_pair *pair, const tf_meeting *meeting,
                       double place[3])
{
    for (int k = 0; k < 3; k++) {
        place[k] = 0;
        for (int i = 0; i < pair->count; i++)
            if (pair->side[i] > 0)
                place[k] += meeting->weight[i] * pair->event[i]->x[k];
    }
}

static void solve(encounter *e)
{
    for (int k = 0; k < EDGES; k++) {
        for (int i = 0; i < 2; i++)
            e->edge[k][i] = tf_worldline_between(3, start[k][i], end[k][i]);
        tf_sweep(2, e->edge[k], e->sweep[k]);
    }
    for (int i = 0; i < TRIANGLES; i++)
        for (int j = 0; j < TRIANGLES; j++) {
            tf_pair pair = tf_pair_of(&e->sweep[0][i], &e->sweep[1][j], 3);
            e->meeting[i][j] = tf_meet(&tf_exact, &pair);
            if (e->meeting[i][j].verdict == TF_HIT)
                find_place(&pair, &e->meeting[i][j], e->place);
        }
    tf_edge_edge(&tf_exact, e->edge[0], e->edge[1], &e->contact);
}

static void print_numbers(const encounter *e, FILE *numbers)
{
    for (int i = 0; i < TRIANGLES; i++)
        for (int j = 0; j < TRIANGLES; j++) {
            char key[16];
            snprintf(key, sizeof key, "hit_%d%d", i, j);
            tf_figure_number(numbers, key, e->meeting[i][j].verdict == TF_HIT);
        }
    tf_figure_number(numbers, "toi", middle(&e->contact));
    tf_figure_number(numbers, "weight_a1", e->contact.weight[0][1]);
    tf_figure_number(numbers, "weight_b1", e->contact.weight[1][1]);
}

// The sheets -------------------------------------------------------------

/// A triangle of a sweep, seen in space, and where its edge is at some times.
static void add_triangle(tf_scene *scene, const encounter *e, int edge,
                         int triangle)
{
    const tf_simplex *simplex = &e->sweep[edge][triangle];
    const double *const at[3] = {simplex->event[0]->x, simplex->event[1]->x,
                                 simplex->event[2]->x};
    double corner[3][3];
    for (int i = 0; i < 3; i++)
        tf_add(at[i], 0, at[i], corner[i]);
    tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                      (tf_paint){.role = role[edge], .opacity = 0.4});
    for (int i = 1; i < STRIPES; i++) {
        tf_slice slice = tf_slice_of(simplex, 3, (double)i / STRIPES);
        tf_scene_tube(scene, slice.corner[0], slice.corner[1], TF_WIDTH_HAIR,
                      (tf_paint){.role = role[edge], .shade = 0.3});
    }
}

/// The part of a bent edge that is of one triangle, at the time of contact.
static void add_edge_part(tf_scene *scene, const encounter *e, int edge,
                          int triangle)
{
    tf_slice slice =
        tf_slice_of(&e->sweep[edge][triangle], 3, middle(&e->contact));
    tf_scene_tube(scene, slice.corner[0], slice.corner[1], TF_WIDTH_TUBE,
                  (tf_paint){.role = role[edge]});
}

static void add_contact(tf_scene *scene, const encounter *e)
{
    tf_scene_ball(scene, e->place, TF_WIDTH_MARK,
                  (tf_paint){.role = TF_ROLE_CONTACT});
}

static void add_names(tf_panel *panel, const encounter *e)
{
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            for (int t = 0; t < 2; t++)
                tf_panel_label(
                    panel, e->edge[k][i].at[t].x,
                    (tf_label){.text = vertex_name[k][i][t], .role = role[k]});
}

static void draw_sheets(tf_page *page, const encounter *e, tf_box box)
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, camera);
    tf_scene *scene = tf_panel_scene(panel);
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < TRIANGLES; i++) {
            add_triangle(scene, e, k, i);
            add_edge_part(scene, e, k, i);
        }
    add_contact(scene, e);
    add_names(panel, e);
}

// The matrix of pairs ----------------------------------------------------

/// Let all pairs be seen from the same place.
static void reach_all(tf_scene *scene, const encounter *e)
{
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            for (int t = 0; t < 2; t++)
                tf_scene_reach(scene, e->edge[k][i].at[t].x);
}

static void draw_pair(tf_page *page, const encounter *e, int i, int j,
                      tf_box box)
{
    bool hit = e->meeting[i][j].verdict == TF_HIT;
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, camera);
    tf_panel_margin(panel, 4);
    tf_scene *scene = tf_panel_scene(panel);
    reach_all(scene, e);
    add_triangle(scene, e, 0, i);
    add_triangle(scene, e, 1, j);
    if (hit)
        add_contact(scene, e);
    char text[32] = "apart";
    if (hit)
        snprintf(text, sizeof text, "hit at $t = %g$", middle(&e->contact));
    tf_page_text(page, box.x + box.width / 2, box.y + box.height + 7,
                 TF_ALIGN_CENTER, text, TF_LETTERS_SMALL,
                 hit ? TF_ROLE_CONTACT : TF_ROLE_INK);
}

static void draw_matrix(tf_page *page, const encounter *e, tf_box box)
{
    double width = box.width / TRIANGLES, height = box.height / TRIANGLES;
    for (int i = 0; i < TRIANGLES; i++) {
        double y = box.y + height * i, x = box.x + width * i;
        tf_page_text(page, x + width / 2, box.y - 8, TF_ALIGN_CENTER,
                     triangle_name[1][i], TF_LETTERS, role[1]);
        tf_page_text_upwards(page, box.x - 4, y + height / 2, TF_ALIGN_CENTER,
                             triangle_name[0][i], TF_LETTERS, role[0]);
        for (int j = 0; j < TRIANGLES; j++)
            draw_pair(
                page, e, i, j,
                (tf_box){box.x + width * j + 3, y + 2, width - 6, height - 20});
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    double left = 200, height = tf_page_height(page);
    draw_sheets(page, &e, (tf_box){0, 0, left, height});
    draw_matrix(
        page, &e,
        (tf_box){left + 18, 26, tf_page_width(page) - left - 20, height - 28});
    print_numbers(&e, numbers);
}

const tf_figure tf_figure_edge_edge_sheets = {
    .name = "edge-edge-sheets",
    .title = "The sweeps of two edges, and the four pairs of their triangles",
    .width = TF_FIGURE_WIDTH,
    .height = 240,
    .draw = draw,
};
