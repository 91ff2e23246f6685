// A pinch in four stages: three vertices of a loop get copies, one after the
// other, and the ring between is exchanged for two caps.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/patches.h"

#include "topology/component.h"
#include "topology/pinch.h"

#include <math.h>

enum {
    LOOP = 3,
    AROUND = 6,   ///< vertices of the ring above, and of that below
    ABOVE = LOOP, ///< the first vertex of the ring above
    BELOW = ABOVE + AROUND,
    COPIES = BELOW + AROUND,
    PLACES = COPIES + LOOP,
    TRIANGLES = 18,
    HALF = TRIANGLES / 2, ///< the triangles above come first
    RING = 6,
    SHOWN = 4
};

/// When the caps appear.
static const double capped = 0.86;

// The neck --------------------------------------------------------------------

static tf_vector on_circle(double turn, double radius, double height)
{
    double angle = (turn / AROUND + 0.13) * 2 * acos(-1);
    return (tf_vector){{radius * cos(angle), radius * sin(angle), height}};
}

/// The loop, the rings, and where the copies of the loop end.
static void make_places(tf_vector at[PLACES])
{
    for (int i = 0; i < LOOP; i++) {
        at[i] = on_circle(2 * i, 0.36, -0.2);
        at[COPIES + i] = on_circle(2 * i, 0.42, 0.45);
    }
    for (int i = 0; i < AROUND; i++) {
        at[ABOVE + i] = on_circle(i, 0.95, 1.15);
        at[BELOW + i] = on_circle(i, 0.95, -1.1);
    }
}

static void set(int triangle[3], int a, int b, int c)
{
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

static void make_triangles(int triangle[TRIANGLES][3])
{
    for (int i = 0; i < LOOP; i++) {
        int next = (i + 1) % LOOP, even = 2 * i, odd = even + 1;
        int last = (even + 2) % AROUND;
        int(*above)[3] = triangle + (ptrdiff_t)3 * i;
        int(*below)[3] = above + HALF;
        set(above[0], i, next, ABOVE + odd);
        set(above[1], i, ABOVE + odd, ABOVE + even);
        set(above[2], next, ABOVE + last, ABOVE + odd);
        set(below[0], BELOW + even, BELOW + odd, i);
        set(below[1], BELOW + odd, next, i);
        set(below[2], BELOW + odd, BELOW + last, next);
    }
}

// Trying ----------------------------------------------------------------------

static int count_parts(const tf_adaptive_surface *surface)
{
    tf_components parts = {0};
    int count = 0;
    TF_REQUIRE(tf_components_begin(&parts, surface));
    for (int t = 0; t < surface->triangles; t++)
        if (tf_is_triangle(surface, t))
            count += tf_components_add(&parts, surface, t) > 0;
    tf_components_free(&parts);
    return count;
}

/// Pinches the neck as the library does, and counts.
static void print_numbers(FILE *numbers)
{
    static const int loop[] = {0, 1, 2};
    tf_vector at[PLACES];
    int triangle[TRIANGLES][3], vertex[LOOP];
    double place[COPIES][3], copies[3 * LOOP];
    make_places(at);
    make_triangles(triangle);
    for (int i = 0; i < 3 * COPIES; i++)
        place[i / 3][i % 3] = at[i / 3].x[i % 3];
    for (int i = 0; i < 3 * LOOP; i++)
        copies[i] = at[COPIES + i / 3].x[i % 3];
    const tf_mesh mesh = {.axes = 3,
                          .vertices = COPIES,
                          .triangles = TRIANGLES,
                          .triangle = triangle[0]};
    tf_adaptive_surface *surface;
    tf_outcome outcome;
    TF_REQUIRE(tf_adaptive_create(&mesh, place[0], &surface, NULL) == TF_OK);
    fig_number(numbers, "parts_before", count_parts(surface));
    TF_REQUIRE(tf_adaptive_pinch(surface, loop, copies, vertex, &outcome) ==
               TF_OK);
    fig_number(numbers, "done", outcome == TF_COMMITTED);
    fig_number(numbers, "parts_after", count_parts(surface));
    fig_number(numbers, "ring", RING);
    tf_adaptive_free(surface);
}

// Drawing ---------------------------------------------------------------------

/// How far a copy has come: one after the other.
static double progress(int i, double t)
{
    return fmin(fmax(t / capped * (LOOP + 0.4) - i, 0), 1);
}

static void draw_ring(fig_scene *scene, const tf_vector at[], double t)
{
    for (int i = 0; i < LOOP && progress(i, t) > 0; i++) {
        int next = (i + 1) % LOOP, before = (i + 2) % LOOP;
        int after_copy = next < i ? COPIES + next : next;
        int before_copy = before < i ? COPIES + before : before;
        const int opened[2][3] = {{i, after_copy, COPIES + i},
                                  {before_copy, i, COPIES + i}};
        fig_patch_triangles(scene, at, 2, opened,
                            (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.4});
    }
}

static void draw_caps(fig_scene *scene, const tf_vector at[])
{
    static const int caps[2][3] = {{0, 1, 2}, {COPIES, COPIES + 2, COPIES + 1}};
    fig_patch_triangles(scene, at, 2, caps,
                        (fig_paint){.role = FIG_ROLE_CONTACT});
}

/// The triangles above have the copies instead of the loop.
static void draw_neck(fig_scene *scene, const tf_vector at[])
{
    int triangle[TRIANGLES][3];
    make_triangles(triangle);
    for (int i = 0; i < 3 * HALF; i++) {
        int *v = &triangle[i / 3][i % 3];
        *v += *v < LOOP ? COPIES : 0;
    }
    fig_patch_triangles(
        scene, at, TRIANGLES, (const int(*)[3])triangle,
        (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.25});
}

static void draw_copy(fig_page *page, fig_panel *panel, tf_vector at, int i,
                      double t)
{
    static const char *const name[LOOP] = {"$a'$", "$b'$", "$c'$"};
    fig_scene_ball(fig_panel_scene(panel), at, FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    static const double beside[LOOP][2] = {{10, -3}, {-10, -3}, {21, 0}};
    if (progress(i, t) > 0)
        fig_film_name(page, panel, at, beside[i][0], beside[i][1], name[i],
                      FIG_ROLE_INK);
}

static void draw_time(fig_page *page, fig_box box, double t)
{
    static const int loop[] = {0, 1, 2};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 12, .elevation = 17});
    fig_panel_margin(panel, 8);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    make_places(at);
    for (int v = 0; v < PLACES; v++)
        fig_scene_reach(scene, at[v]);
    for (int i = 0; i < LOOP; i++)
        at[COPIES + i] = fig_lerp(at[i], at[COPIES + i], progress(i, t));
    draw_neck(scene, at);
    if (t < capped)
        draw_ring(scene, at, t);
    else
        draw_caps(scene, at);
    fig_patch_outline(scene, at, LOOP, loop,
                      (fig_paint){.role = FIG_ROLE_TRIANGLE, .shade = 0.35});
    for (int i = 0; i < LOOP; i++)
        draw_copy(page, panel, at[COPIES + i], i, t);
}

static void draw(fig_page *page, FILE *numbers)
{
    static const double shown[SHOWN] = {0, 0.19, 0.66, 1};
    static const char *const titles[SHOWN] = {"a loop", "$a'$ moves",
                                              "$c'$ moves", "two caps"};
    double t = fig_film_time(page, numbers, 0.66, -1);
    double width = fig_page_width(page), height = fig_page_height(page);
    if (fig_page_moves(page)) {
        draw_time(page, (fig_box){0, 0, width, height - 30}, t);
        fig_film_clock(page, 4, height - 10, width - 8, t, -1, "");
    }
    for (int i = 0; i < SHOWN && !fig_page_moves(page); i++) {
        fig_box box = {width * i / SHOWN, 18, width / SHOWN, height - 18};
        draw_time(page, box, shown[i]);
        fig_page_title(page, box, titles[i]);
    }
    print_numbers(numbers);
}

const fig_figure fig_pinch_stages = {
    .name = "pinch-stages",
    .title = "A pinch in four stages",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .moves = true,
    .draw = draw,
};
