// A sheet that folds onto itself within a step, and its contacts.
#include "base/require.h"
#include "fast/detect.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/meshes.h"
#include "kit/worlds.h"

#include <stdlib.h>

enum {
    ROWS = 18,
    COLUMNS = 36,
    PANELS = 3
};

/// How far the sheet is folded at the start and at the end, in degrees.
static const double start_angle = 112, end_angle = 200;

/// When the large picture shows it.
static const double shown = 0.875;

static const double text_room = 18;

/// Half the thickness of the sheet: its two sides have two colors.
static const double thickness = 0.0012;

/// Of lines within the sheet, in points: wider than it is thick.
static const double line_width = 0.5;

static const fig_camera camera = {.azimuth = 27, .elevation = 33};

typedef struct sheet {
    fig_some_mesh mesh[2]; ///< at the start and at the end
    tf_surface *surface;
    tf_contacts found;
    double toi; ///< of the first contact
    const tf_surface_contact *first;
    float *since; ///< of each triangle: from when on it is in contact; 2: never
} sheet;

// Contacts ---------------------------------------------------------------

static double time_of(const tf_surface_contact *contact)
{
    return fig_toi(&contact->contact);
}

/// Whether a triangle has all of `count` vertices.
static bool has_all(const int corner[3], int count, const int vertex[])
{
    for (int i = 0; i < count; i++)
        if (vertex[i] != corner[0] && vertex[i] != corner[1] &&
            vertex[i] != corner[2])
            return false;
    return true;
}

/// Mark the triangles that an element is, or that are beside it.
static void mark(sheet *s, int count, const int vertex[], double toi)
{
    for (int i = 0; i < s->mesh[0].triangles; i++)
        if (has_all(s->mesh[0].triangle + 3 * (size_t)i, count, vertex))
            s->since[i] = fminf(s->since[i], (float)toi);
}

static void find_contacts(sheet *s)
{
    const tf_motion motion = {3, s->mesh[0].vertices, s->mesh[0].x,
                              s->mesh[1].x};
    const tf_mesh mesh = fig_mesh_in_space(&s->mesh[0]);
    TF_REQUIRE(tf_surface_create(&mesh, &s->surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_detect(s->surface, &motion, NULL, &s->found, NULL) ==
               TF_OK);
    s->since = calloc((size_t)mesh.triangles, sizeof *s->since);
    TF_REQUIRE(s->since);
    for (int i = 0; i < mesh.triangles; i++)
        s->since[i] = 2;
    s->toi = 2;
    for (size_t i = 0; i < s->found.count; i++) {
        const tf_surface_contact *contact = &s->found.contact[i];
        int first = contact->kind == TF_EDGE_EDGE ? 2 : 1;
        double toi = time_of(contact);
        if (toi < s->toi)
            s->first = contact;
        s->toi = fmin(s->toi, toi);
        // Of a vertex the marked triangle below or above is enough.
        if (first == 2)
            mark(s, 2, contact->vertex, toi);
        mark(s, 4 - first, contact->vertex + first, toi);
    }
}

static sheet fold(void)
{
    sheet s = {.mesh = {fig_folded_sheet(ROWS, COLUMNS, start_angle),
                        fig_folded_sheet(ROWS, COLUMNS, end_angle)}};
    find_contacts(&s);
    return s;
}

static void unfold(sheet *s)
{
    fig_some_mesh_free(&s->mesh[0]);
    fig_some_mesh_free(&s->mesh[1]);
    tf_surface_free(s->surface);
    free(s->since);
}

static int contacts_until(const sheet *s, double t)
{
    int count = 0;
    for (size_t i = 0; i < s->found.count; i++)
        count += time_of(&s->found.contact[i]) <= t;
    return count;
}

static void print_numbers(const sheet *s, FILE *numbers)
{
    int kinds[TF_EDGE_EDGE + 1] = {0};
    for (size_t i = 0; i < s->found.count; i++)
        kinds[s->found.contact[i].kind]++;
    fig_number(numbers, "triangles", s->mesh[0].triangles);
    fig_number(numbers, "candidates", (double)s->found.statistics.candidates);
    fig_number(numbers, "contacts", (double)s->found.count);
    fig_number(numbers, "point_triangle", kinds[TF_POINT_TRIANGLE]);
    fig_number(numbers, "edge_edge", kinds[TF_EDGE_EDGE]);
    fig_number(numbers, "toi", s->toi);
    fig_number(numbers, "time", shown);
    fig_number(numbers, "contacts_by_then", contacts_until(s, shown));
}

// Drawing ----------------------------------------------------------------

static tf_worldline worldline_of(const sheet *s, int vertex)
{
    return tf_worldline_between(3, s->mesh[0].x + 3 * (size_t)vertex,
                                s->mesh[1].x + 3 * (size_t)vertex);
}

/// Add both sides of a triangle, the one that `outward` points to first.
static void add_sides(fig_scene *scene, const tf_vector corner[3],
                      tf_vector outward, bool touches)
{
    static const fig_paint side[2] = {
        {.role = FIG_ROLE_EDGE, .shade = -0.3},
        {.role = FIG_ROLE_OTHER_EDGE, .shade = -0.25}};
    for (int k = 0; k < 2; k++) {
        double off = k == 0 ? thickness : -thickness;
        tf_vector moved[3];
        for (int i = 0; i < 3; i++)
            moved[i] = fig_combination(corner[i], off, outward);
        fig_scene_triangle(scene, moved, 0,
                           touches ? (fig_paint){.role = FIG_ROLE_CONTACT,
                                                 .shade = k == 0 ? 0 : -0.15}
                                   : side[k]);
    }
}

static void add_slice(fig_scene *scene, const fig_slice *slice, bool flipped,
                      bool touches)
{
    tf_vector across = fig_cross(
        fig_difference(slice->corner[2], slice->corner[0]),
        fig_difference(slice->corner[slice->count - 1], slice->corner[1]));
    tf_vector outward =
        tf_vector_scaled(flipped ? -1 : 1, fig_normalized(across));
    for (int i = 2; i < slice->count; i++) {
        const tf_vector corner[3] = {slice->corner[0], slice->corner[i - 1],
                                     slice->corner[i]};
        add_sides(scene, corner, outward, touches);
    }
}

/// Sort three vertices; returns whether that turns the triangle over.
static bool sort_corners(int corner[3])
{
    bool turned = false;
    for (int i = 0; i < 3; i++) {
        int a = i % 2, b = a + 1;
        if (corner[a] > corner[b]) {
            int kept = corner[a];
            corner[a] = corner[b];
            corner[b] = kept;
            turned = !turned;
        }
    }
    return turned;
}

/// A triangle as its sweep has it at the time t: bent.
static void add_triangle(fig_scene *scene, const sheet *s, int i, double t)
{
    const int *given = s->mesh[0].triangle + 3 * (size_t)i;
    int corner[3] = {given[0], given[1], given[2]};
    bool turned = sort_corners(corner);
    tf_worldline worldline[3];
    tf_simplex sweep[3];
    for (int c = 0; c < 3; c++)
        worldline[c] = worldline_of(s, corner[c]);
    tf_sweep(3, worldline, sweep);
    for (int k = 0; k < 3; k++) {
        fig_slice slice = fig_slice_of(&sweep[k], 3, t);
        add_slice(scene, &slice, turned, s->since[i] <= t);
    }
}

/// Lines along the rows and columns; an edge bends where its sweep does.
static void add_edge(fig_scene *scene, const sheet *s, int low, int high,
                     double t, double width)
{
    tf_worldline a = worldline_of(s, low), b = worldline_of(s, high);
    const tf_vector at[3] = {
        fig_worldline_place(&a, 3, t),
        fig_lerp(fig_vector_of(a.at[0].x), fig_vector_of(b.at[1].x), t),
        fig_worldline_place(&b, 3, t)};
    fig_scene_path(scene, 3, at, width,
                   (fig_paint){.role = FIG_ROLE_INK, .shade = -0.35});
}

static void add_lines(fig_scene *scene, const sheet *s, double t)
{
    for (int i = 0; i <= ROWS; i++)
        for (int j = 0; j <= COLUMNS; j++) {
            int here = i * (COLUMNS + 1) + j;
            if (j < COLUMNS)
                add_edge(scene, s, here, here + 1, t,
                         i % ROWS == 0 ? FIG_WIDTH_THIN : line_width);
            if (i < ROWS)
                add_edge(scene, s, here, here + COLUMNS + 1, t,
                         j % COLUMNS == 0 ? FIG_WIDTH_THIN : line_width);
        }
}

/// Mark the place of the first contact, on its first element: when the element
/// is swept, its last vertex is the first to move.
static void add_first(fig_scene *scene, const sheet *s)
{
    int count = s->first->kind == TF_EDGE_EDGE ? 2 : 1;
    const double *weight = s->first->contact.barycentric[0];
    double left = s->toi;
    tf_vector place = {{0}};
    for (int i = count - 1; i >= 0; i--) {
        tf_worldline end = worldline_of(s, s->first->vertex[i]);
        double late = fmin(weight[i], left);
        left -= late;
        place = fig_combination(place, weight[i] - late,
                                fig_vector_of(end.at[0].x));
        place = fig_combination(place, late, fig_vector_of(end.at[1].x));
    }
    fig_scene_ball(scene, place, FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
}

/// The camera stays where it is as the sheet moves.
static void reach_all(fig_scene *scene, const sheet *s)
{
    for (int t = 0; t < 2; t++)
        for (int i = 0; i < s->mesh[t].vertices; i++)
            fig_scene_reach(scene, fig_vector_of(s->mesh[t].x + 3 * (size_t)i));
}

static void write_state(fig_page *page, const sheet *s, fig_box box, double t)
{
    char text[64];
    int count = contacts_until(s, t);
    const char *plural = count == 1 ? "" : "s";
    if (fig_page_moves(page))
        snprintf(text, sizeof text, "$t = %.2f$, %d contact%s", t, count,
                 plural);
    else
        snprintf(text, sizeof text, "$t %s %.4g$, %d contact%s",
                 t == s->toi ? "≈" : "=", t, count, plural);
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 11,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL,
                  count > 0 ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

/// The sheet at the time t; `all`: with room for all of the step.
static void draw_time(fig_page *page, const sheet *s, double t, fig_box box,
                      bool all)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, 5);
    fig_scene *scene = fig_panel_scene(panel);
    if (all)
        reach_all(scene, s);
    for (int i = 0; i < s->mesh[0].triangles; i++)
        add_triangle(scene, s, i, t);
    add_lines(scene, s, t);
    if (t == s->toi)
        add_first(scene, s);
    write_state(page, s, box, t);
}

static void draw_still(fig_page *page, const sheet *s)
{
    double width = fig_page_width(page), height = fig_page_height(page);
    double side = 134, half = height / 2 - text_room;
    draw_time(page, s, 0, (fig_box){0, 0, side, half}, true);
    draw_time(page, s, s->toi, (fig_box){0, height / 2, side, half}, true);
    draw_time(page, s, shown,
              (fig_box){side, 0, width - side, height - text_room}, false);
}

/// Smaller than the page: a film weighs as much as the pixels that change.
static void draw_frame(fig_page *page, const sheet *s, double t)
{
    double width = fig_page_width(page), height = fig_page_height(page);
    double inset = 0.04 * width;
    draw_time(page, s, t,
              (fig_box){inset, inset, width - 2 * inset,
                        height - text_room - 2 * inset},
              true);
}

static void draw(fig_page *page, FILE *numbers)
{
    sheet s = fold();
    double t = fig_film_time(page, numbers, shown, s.toi);
    if (fig_page_moves(page))
        draw_frame(page, &s, t);
    else
        draw_still(page, &s);
    print_numbers(&s, numbers);
    unfold(&s);
}

const fig_figure fig_folding_sheet = {
    .name = "folding-sheet",
    .title = "A sheet that folds onto itself, and its contacts",
    .width = FIG_PAGE_WIDTH,
    .height = 236,
    .moves = true,
    .draw = draw,
};
