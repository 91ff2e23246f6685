// A frame of cloth in space: lit triangles on a ground.
#include "kit/cloth_parts.h"
#include "kit/soft_light.h"
#include "kit/surface_normals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Where the eye is as a rule, in degrees, and how far, in sizes of the cloth.
static const double usual_azimuth = 28, usual_elevation = 24, distance = 5.5;

/// Around what all frames reach, in points.
static const double margin = 13;

/// Of lines along borders, and of edges of no triangle, in points.
static const double border_width = 0.6, rope_width = 1.8;

enum {
    GROUND = 104, ///< cells across the ground
    GROUND_CORNERS = (GROUND + 1) * (GROUND + 1)
};

/// How far below everything the ground is, and how far out it goes, in sizes of
/// the cloth, and from which part of that on it fades into the paper.
static const double ground_below = 0.004, ground_out = 1.6, ground_fades = 0.5;

/// How high the strip at the bottom of the picture is in which it fades, too, in
/// heights of the picture.
static const double bottom_fades = 0.2;

/// Red, green and blue of the lamp and of the sky, the light that comes back
/// from the ground, and that of a weak lamp beside the eye, which throws no
/// shadow.
static const float lamp_light[3] = {1.06F, 1.01F, 0.93F};
static const float sky_light[3] = {0.32F, 0.36F, 0.42F};
static const float ground_light = 0.12F, eye_light = 0.15F;

/// How much a surface darkens where it turns away from the eye.
static const float rim_dark = 0.35F;

/// A frame on its way into a scene.
typedef struct stage {
    const fig_cloth *cloth;
    const fig_theme *theme;
    fig_scene *scene;
    const fig_shape *shape; ///< in this frame
    fig_normals normals;
    fig_view view;
    tf_vector lamp;
    int *triangle;      ///< those that are drawn
    int triangles;      ///< how many
    fig_caster *caster; ///< as many
    fig_lit *lit;       ///< three corners a triangle, then the ground's
    tf_vector ground;   ///< its middle
    double seen;        ///< how far out it is seen
} stage;

// Colors -----------------------------------------------------------------

static fig_paint paint_of(const fig_cloth *cloth, const fig_theme *theme,
                          int part)
{
    static const fig_role role[] = {FIG_ROLE_EDGE,     FIG_ROLE_OTHER_EDGE,
                                    FIG_ROLE_TRIANGLE, FIG_ROLE_POINT,
                                    FIG_ROLE_START,    FIG_ROLE_END};
    static const double shade[] = {-0.1, -0.45, 0.25};
    if (!cloth->soft[part])
        return (fig_paint){.role = FIG_ROLE_NEUTRAL,
                           .shade = theme->dark ? 0 : -0.55};
    int color = cloth->color[part];
    return (fig_paint){.role = role[color % 6], .shade = shade[color / 6 % 3]};
}

static void set_linear(float linear[3], fig_rgb color)
{
    linear[0] = (float)fig_rgb_to_linear(color.r);
    linear[1] = (float)fig_rgb_to_linear(color.g);
    linear[2] = (float)fig_rgb_to_linear(color.b);
}

// Places -----------------------------------------------------------------

static tf_vector toward_eye(const stage *s, tf_vector at)
{
    tf_vector eye =
        fig_combination(s->view.center, s->view.distance, s->view.back);
    return fig_normalized(fig_difference(eye, at));
}

static const int *corners_of(const stage *s, int triangle)
{
    return s->shape->triangle + 3 * (size_t)triangle;
}

static int part_of(const stage *s, int triangle)
{
    return s->shape->part[corners_of(s, triangle)[0]];
}

/// The color of a side of a triangle, in linear light.
static void set_color(const stage *s, int triangle, bool front, float linear[3])
{
    static const double back = 0.3, hem = 0.72;
    int part = part_of(s, triangle);
    fig_rgb color =
        fig_paint_color(s->theme, paint_of(s->cloth, s->theme, part));
    fig_rgb pale = {1, 1, 1};
    if (s->cloth->soft[part] && !front)
        color = fig_rgb_mix(color, pale, back);
    if (s->cloth->hem[triangle])
        color = fig_rgb_mix(color, pale, hem);
    set_linear(linear, color);
}

/// 1 or -1, by which a triangle's normal points to the eye.
static float side_seen(const stage *s, int triangle)
{
    const float *n = s->normals.triangle[triangle];
    tf_vector at = s->shape->at[0][corners_of(s, triangle)[0]];
    double along =
        tf_vector_dot((tf_vector){{n[0], n[1], n[2]}}, toward_eye(s, at));
    return along < 0 ? -1 : 1;
}

/// Place the corners of the i-th triangle that is drawn.
static void place_corners(const stage *s, int i)
{
    int triangle = s->triangle[i];
    float side = side_seen(s, triangle);
    for (int c = 0; c < 3; c++) {
        tf_vector at = s->shape->at[0][corners_of(s, triangle)[c]];
        size_t corner = 3 * (size_t)triangle + (size_t)c;
        fig_lit *lit = &s->lit[3 * (size_t)i + (size_t)c];
        for (int k = 0; k < 3; k++) {
            s->caster[i].at[c][k] = lit->at[k] = (float)at.x[k];
            lit->normal[k] = side * s->normals.corner[corner][k];
        }
    }
}

static fig_lit *ground_corners(const stage *s)
{
    return s->lit + 3 * (size_t)s->triangles;
}

static void place_ground(const stage *s)
{
    fig_lit *corner = ground_corners(s);
    double cell = 2 * ground_out * s->cloth->size / GROUND;
    for (int y = -GROUND / 2; y <= GROUND / 2; y++)
        for (int x = -GROUND / 2; x <= GROUND / 2; x++)
            *corner++ = (fig_lit){.at = {(float)(s->ground.x[0] + cell * x),
                                         (float)(s->ground.x[1] + cell * y),
                                         (float)s->ground.x[2]},
                                  .normal = {0, 0, 1}};
}

/// How far out the ground is seen, so that its rim is inside the picture.
static double ground_seen(const stage *s)
{
    double out = ground_out * s->cloth->size;
    fig_point middle = fig_view_project(&s->view, s->ground);
    fig_point rim = fig_view_project(
        &s->view, fig_combination(s->ground, out, s->view.right));
    const fig_box *box = &s->view.box;
    double room = fmin(middle.x - box->x, box->x + box->width - middle.x);
    return out * fmin(1, room / (rim.x - middle.x));
}

static bool begin(stage *s)
{
    size_t triangles = (size_t)s->shape->triangles;
    size_t corners = 3 * triangles + GROUND_CORNERS;
    s->triangle = malloc((triangles + 1) * sizeof *s->triangle);
    s->caster = malloc((triangles + 1) * sizeof *s->caster);
    s->lit = malloc(corners * sizeof *s->lit);
    s->seen = ground_seen(s);
    return s->triangle && s->caster && s->lit &&
           fig_normals_find(&s->normals, s->shape, 0, s->cloth->soft);
}

/// Find the light on all corners of triangles and on those of the ground.
static bool light(stage *s, bool grounded)
{
    if (!begin(s))
        return false;
    for (int i = 0; i < s->shape->triangles; i++)
        if (part_of(s, i) != s->cloth->floor)
            s->triangle[s->triangles++] = i;
    for (int i = 0; i < s->triangles; i++)
        place_corners(s, i);
    if (grounded)
        place_ground(s);
    int count = 3 * s->triangles + (grounded ? GROUND_CORNERS : 0);
    return fig_light_softly(count, s->lit, s->triangles, s->caster, s->lamp);
}

// Smoothing --------------------------------------------------------------

/// The light around a vertex, on the front and on the back of a part.
typedef struct around {
    float lamp, sky;
    int corners;
} around;

static bool shows_front(const stage *s, int triangle)
{
    return side_seen(s, triangle) * (float)s->cloth->face[triangle] > 0;
}

static around *around_corner(const stage *s, around *all, int i, int corner)
{
    int triangle = s->triangle[i], vertex = corners_of(s, triangle)[corner];
    return &all[2 * (size_t)vertex + shows_front(s, triangle)];
}

static void add_light(const stage *s, around *all, int i)
{
    const fig_lit *lit = s->lit + 3 * (size_t)i;
    for (int c = 0; c < 3; c++) {
        around *sum = around_corner(s, all, i, c);
        for (int k = 0; k < 3; k++) {
            sum->lamp += lit[k].lamp;
            sum->sky += lit[k].sky;
        }
        sum->corners += 3;
    }
}

static void take_light(const stage *s, around *all, int i)
{
    fig_lit *lit = s->lit + 3 * (size_t)i;
    for (int c = 0; c < 3; c++) {
        const around *sum = around_corner(s, all, i, c);
        lit[c].lamp = sum->lamp / (float)sum->corners;
        lit[c].sky = sum->sky / (float)sum->corners;
    }
}

/// Smooth the light on what is soft: shadows end between vertices, and would
/// have the teeth of the triangles.
static bool smooth_cloth(const stage *s)
{
    around *all = calloc(2 * (size_t)s->shape->vertices + 1, sizeof *all);
    for (int i = 0; i < s->triangles && all; i++)
        if (s->cloth->soft[part_of(s, s->triangle[i])])
            add_light(s, all, i);
    for (int i = 0; i < s->triangles && all; i++)
        if (s->cloth->soft[part_of(s, s->triangle[i])])
            take_light(s, all, i);
    free(all);
    return all != NULL;
}

/// Give each corner of a row of the ground, which are `step` apart, a half of
/// its light and a quarter of that of either neighbor.
static void smooth_row(fig_lit *row, int step)
{
    float before_lamp = row->lamp, before_sky = row->sky;
    fig_lit *here = row + step;
    for (int i = 1; i < GROUND; i++, here += step) {
        float lamp = here->lamp, sky = here->sky;
        here->lamp = (before_lamp + 2 * lamp + here[step].lamp) / 4;
        here->sky = (before_sky + 2 * sky + here[step].sky) / 4;
        before_lamp = lamp;
        before_sky = sky;
    }
}

/// Smooth the light on the ground: the lamp's shadow is a sum of sharp ones.
static void smooth_ground(const stage *s)
{
    enum {
        ROUNDS = 2
    };
    const int row = GROUND + 1;
    for (int round = 0; round < ROUNDS; round++) {
        fig_lit *corner = ground_corners(s);
        for (int i = 0; i < row; i++, corner += row)
            smooth_row(corner, 1);
        corner = ground_corners(s);
        for (int i = 0; i < row; i++, corner++)
            smooth_row(corner, row);
    }
}

// Triangles --------------------------------------------------------------

/// How much a corner is turned to the eye: the cosine of the angle.
static float facing(const stage *s, const fig_lit *corner)
{
    tf_vector at = {{corner->at[0], corner->at[1], corner->at[2]}};
    tf_vector n = {{corner->normal[0], corner->normal[1], corner->normal[2]}};
    return (float)fabs(tf_vector_dot(n, toward_eye(s, at)));
}

static void paint_corner(const stage *s, const fig_lit *corner,
                         const float color[3], float painted[3])
{
    float front = facing(s, corner), off = 1 - front;
    float dark = 1 - rim_dark * off * off * off;
    float rest =
        ground_light * (0.5F - 0.5F * corner->normal[2]) + eye_light * front;
    for (int k = 0; k < 3; k++)
        painted[k] =
            dark * color[k] *
            (corner->lamp * lamp_light[k] + corner->sky * sky_light[k] + rest);
}

static void paint_triangles(const stage *s)
{
    fig_painted *painted = fig_scene_painted(s->scene, s->triangles);
    for (int i = 0; i < s->triangles && painted; i++) {
        float color[3];
        int triangle = s->triangle[i];
        set_color(s, triangle, shows_front(s, triangle), color);
        for (int c = 0; c < 3; c++)
            paint_corner(s, &s->lit[3 * (size_t)i + (size_t)c], color,
                         painted[i].color[c]);
        memcpy(painted[i].at, s->caster[i].at, sizeof painted[i].at);
    }
}

// The ground -------------------------------------------------------------

static double smooth_step(double part)
{
    part = fmin(1, fmax(0, part));
    return part * part * (3 - 2 * part);
}

/// How much of the paper's color the ground has, 0 to 1: all of it far out, and
/// at the bottom of the picture.
static float ground_fade(const stage *s, const fig_lit *corner)
{
    tf_vector at = {{corner->at[0], corner->at[1], corner->at[2]}};
    tf_vector off = fig_difference(at, s->ground);
    double out = hypot(off.x[0], off.x[1]) / s->seen;
    double far = smooth_step((out - ground_fades) / (1 - ground_fades));
    const fig_box *box = &s->view.box;
    double above = box->y + box->height - fig_view_project(&s->view, at).y;
    double low = smooth_step(1 - above / (bottom_fades * box->height));
    return (float)(1 - (1 - far) * (1 - low));
}

static void paint_ground_corner(const stage *s, const fig_lit *corner,
                                float painted[3])
{
    fig_paint paint = {.role = FIG_ROLE_PAPER,
                       .shade = s->theme->dark ? 0.16 : 0.05};
    float ground[3], paper[3], fade = ground_fade(s, corner);
    set_linear(paper, s->theme->color[FIG_ROLE_PAPER]);
    set_linear(ground, fig_paint_color(s->theme, paint));
    for (int k = 0; k < 3; k++) {
        float here = corner->lamp * lamp_light[k] + corner->sky * sky_light[k];
        float whole = (float)s->lamp.x[2] * lamp_light[k] + sky_light[k];
        painted[k] = ground[k] * here / whole * (1 - fade) + paper[k] * fade;
    }
}

static void paint_half(const stage *s, fig_painted *painted, const int half[3])
{
    for (int c = 0; c < 3; c++) {
        const fig_lit *corner = ground_corners(s) + half[c];
        memcpy(painted->at[c], corner->at, sizeof painted->at[c]);
        paint_ground_corner(s, corner, painted->color[c]);
    }
}

/// A cell of the ground is two triangles, split along alternate diagonals.
static void paint_ground(const stage *s)
{
    smooth_ground(s);
    fig_painted *painted = fig_scene_painted(s->scene, 2 * GROUND * GROUND);
    for (int y = 0; y < GROUND && painted; y++)
        for (int x = 0; x < GROUND; x++) {
            int a = y * (GROUND + 1) + x, b = a + 1;
            int c = a + GROUND + 1, d = c + 1;
            bool odd = (x + y) % 2 == 1;
            paint_half(s, painted++, (int[]){a, b, odd ? d : c});
            paint_half(s, painted++, (int[]){c, d, odd ? a : b});
        }
}

// Lines ------------------------------------------------------------------

/// An end of a line.  Lines along borders are wider than cloth is thick, and
/// would be seen through another sheet on them: they are drawn a bit behind.
static tf_vector line_end(const stage *s, int vertex, bool rope)
{
    tf_vector at = s->shape->at[0][vertex];
    double behind = 1.5 * border_width / s->view.points_per_unit;
    return rope ? at : fig_combination(at, -behind, toward_eye(s, at));
}

/// Borders, the creases of what is stiff, and edges of no triangle.
static void add_lines(const stage *s)
{
    for (int i = 0; i < s->shape->edges; i++) {
        const int *end = s->shape->edge + 2 * (size_t)i;
        int part = s->shape->part[end[0]];
        bool rope = s->shape->degree[i] == 0;
        if ((!rope && !s->normals.crease[i]) || part == s->cloth->floor)
            continue;
        fig_paint paint = paint_of(s->cloth, s->theme, part);
        paint.shade = rope ? paint.shade : fmax(paint.shade, 0) + 0.3;
        fig_scene_tube(s->scene, line_end(s, end[0], rope),
                       line_end(s, end[1], rope),
                       rope ? rope_width : border_width, paint);
    }
}

// The frame --------------------------------------------------------------

static fig_camera camera_of(const fig_cloth *cloth, fig_box box,
                            const fig_cloth_look *look)
{
    fig_camera camera = {.azimuth = usual_azimuth,
                         .elevation = usual_elevation,
                         .distance = distance * cloth->size};
    if (look->turned) {
        camera.azimuth = look->azimuth;
        camera.elevation = look->elevation;
    }
    if (cloth->flat)
        camera = (fig_camera){.elevation = 90};
    return fig_camera_fit(&camera, FIG_CLOTH_REACH, cloth->reach, box.width,
                          box.height, margin);
}

/// From the left, behind the reader, and above.
static tf_vector lamp_of(const fig_view *view)
{
    tf_vector front =
        fig_normalized((tf_vector){{-view->right.x[1], view->right.x[0], 0}});
    tf_vector lamp = {{0, 0, 1}};
    lamp = fig_combination(lamp, -1, view->right);
    return fig_normalized(fig_combination(lamp, -0.3, front));
}

static void fill_scene(stage *s, bool grounded)
{
    if (light(s, grounded) && smooth_cloth(s)) {
        paint_triangles(s);
        if (grounded)
            paint_ground(s);
        add_lines(s);
    } else {
        fig_scene_fail(s->scene);
    }
    fig_normals_free(&s->normals);
    free(s->triangle);
    free(s->caster);
    free(s->lit);
}

static tf_vector ground_of(const fig_cloth *cloth)
{
    tf_vector ground = fig_middle_of(FIG_CLOTH_REACH, cloth->reach);
    ground.x[2] = cloth->bottom - ground_below * cloth->size;
    return ground;
}

/// Whether the ground is drawn: from below it would hide everything.
static bool is_grounded(const stage *s, const fig_cloth_look *look)
{
    bool above = toward_eye(s, s->ground).x[2] > 0;
    return above && !look->groundless && s->shape->triangles > 0 &&
           s->cloth->size > 0;
}

static void draw_in_space(const fig_cloth *cloth, fig_page *page, fig_box box,
                          const fig_shape *shape, const fig_cloth_look *look)
{
    fig_camera camera = camera_of(cloth, box, look);
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_fix(panel);
    stage s = {.cloth = cloth,
               .theme = fig_page_theme(page),
               .scene = fig_panel_scene(panel),
               .shape = shape,
               .view = fig_view_of(&camera, box),
               .ground = ground_of(cloth)};
    s.lamp = lamp_of(&s.view);
    fill_scene(&s, is_grounded(&s, look));
}

static void draw_in_plane(const fig_cloth *cloth, fig_page *page, fig_box box,
                          const fig_shape *shape, const fig_cloth_look *look)
{
    fig_camera camera = camera_of(cloth, box, look);
    fig_view view = fig_view_of(&camera, box);
    for (int i = 0; i < shape->edges; i++) {
        const int *end = shape->edge + 2 * (size_t)i;
        const fig_point at[2] = {fig_view_project(&view, shape->at[0][end[0]]),
                                 fig_view_project(&view, shape->at[0][end[1]])};
        fig_page_line(
            page, 2, at,
            (fig_stroke){.paint = paint_of(cloth, fig_page_theme(page),
                                           shape->part[end[0]]),
                         .width = rope_width,
                         .under_labels = true});
    }
}

void fig_cloth_draw(const fig_cloth *cloth, fig_page *page, fig_box box,
                    int frame, const fig_cloth_look *look)
{
    fig_shape shape = cloth->shape;
    shape.at[0] = shape.at[1] =
        cloth->at + (size_t)frame * (size_t)shape.vertices;
    if (cloth->flat)
        draw_in_plane(cloth, page, box, &shape, look);
    else
        draw_in_space(cloth, page, box, &shape, look);
}
