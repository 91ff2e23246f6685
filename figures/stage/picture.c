#include "stage/picture.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    TILE = 512,   ///< pixels; what is drawn at once
    STEPS = 16384 ///< of the table from linear light
};

/// Pixels of a picture or of a part of it; right and bottom are outside.
typedef struct area {
    int left, top, right, bottom;
} area;

static area intersect(area a, area b)
{
    return (area){a.left > b.left ? a.left : b.left,
                  a.top > b.top ? a.top : b.top,
                  a.right < b.right ? a.right : b.right,
                  a.bottom < b.bottom ? a.bottom : b.bottom};
}

static area pixels_of(tf_box box, tf_raster raster)
{
    double s = raster.scale;
    return (area){(int)floor(box.x * s) + raster.shift_x,
                  (int)floor(box.y * s) + raster.shift_y,
                  (int)ceil((box.x + box.width) * s) + raster.shift_x,
                  (int)ceil((box.y + box.height) * s) + raster.shift_y};
}

static tf_window window_of(area a, tf_raster raster)
{
    double s = raster.scale;
    tf_window window = {.width = a.right - a.left, .height = a.bottom - a.top};
    window.box =
        (tf_box){(a.left - raster.shift_x) / s, (a.top - raster.shift_y) / s,
                 window.width / s, window.height / s};
    return window;
}

/// The pixels on which a mesh falls, and one around.
static area mesh_area(const tf_mesh *mesh, const tf_view *view,
                      tf_raster raster)
{
    double lo[2] = {DBL_MAX, DBL_MAX}, hi[2] = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < mesh->count; i++) {
        double world[3], at[2];
        for (int k = 0; k < 3; k++)
            world[k] = view->center[k] + mesh->vertices[i].at[k];
        tf_view_project(view, world, at);
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], fmax(at[k], view->box.x - 1e4));
            hi[k] = fmax(hi[k], fmin(at[k], view->box.x + 1e4));
        }
    }
    if (mesh->count == 0)
        return (area){0, 0, 0, 0};
    area a =
        pixels_of((tf_box){lo[0], lo[1], hi[0] - lo[0], hi[1] - lo[1]}, raster);
    return (area){a.left - 1, a.top - 1, a.right + 1, a.bottom + 1};
}

// Colours ----------------------------------------------------------------

/// What a pixel needs on its way from linear light.
typedef struct encoder {
    float encoded[STEPS + 1];
    double paper[3];
} encoder;

static void make_encoder(encoder *e, tf_rgb paper)
{
    const double component[3] = {paper.r, paper.g, paper.b};
    for (int i = 0; i <= STEPS; i++)
        e->encoded[i] = (float)tf_rgb_from_linear((double)i / STEPS);
    for (int k = 0; k < 3; k++)
        e->paper[k] = component[k];
}

/// The pixel which cairo, blending encoded colours over the paper, makes the
/// light (red, green, blue) of; of an opacity as near as can be to the fourth.
static unsigned encode(const encoder *e, const float light[4])
{
    double opacity = fmax(0, fmin(light[3], 1)), wanted[3];
    double least = opacity;
    for (int k = 0; k < 3; k++) {
        int step = (int)(STEPS * fmax(0, fmin(light[k], 1)) + 0.5);
        wanted[k] = e->encoded[step];
        double paper = e->paper[k];
        if (wanted[k] > paper)
            least = fmax(least, (wanted[k] - paper) / (1 - paper));
        else if (wanted[k] < paper)
            least = fmax(least, 1 - wanted[k] / paper);
    }
    if (opacity == 0)
        return 0;
    least = ceil(255 * least) / 255;
    unsigned pixel = (unsigned)(255 * least + 0.5);
    for (int k = 0; k < 3; k++) {
        double own = wanted[k] - (1 - least) * e->paper[k];
        pixel = pixel << 8 | (unsigned)(255 * fmax(0, fmin(own, least)) + 0.5);
    }
    return pixel;
}

// Tiles ------------------------------------------------------------------

/// A picture in the making.
typedef struct painting {
    tf_renderer *renderer;
    const tf_mesh *mesh;
    const tf_view *view;
    const tf_theme *theme;
    tf_raster raster;
    area whole;
    encoder encoder;
    float *light; ///< of a tile and the pixels around it
    cairo_surface_t *surface;
} painting;

static void copy_tile(const painting *p, area tile, area drawn)
{
    unsigned char *bytes = cairo_image_surface_get_data(p->surface);
    size_t stride = (size_t)cairo_image_surface_get_stride(p->surface);
    size_t width = (size_t)(drawn.right - drawn.left);
    for (int y = tile.top; y < tile.bottom; y++) {
        const float *light = p->light + 4 * ((size_t)(y - drawn.top) * width +
                                             (size_t)(tile.left - drawn.left));
        unsigned char *row = bytes + stride * (size_t)(y - p->whole.top) +
                             4 * (size_t)(tile.left - p->whole.left);
        for (int x = tile.left; x < tile.right; x++, light += 4, row += 4) {
            unsigned pixel = encode(&p->encoder, light);
            memcpy(row, &pixel, 4);
        }
    }
}

/// Draw a tile with the pixels around it, which its own ones depend on.
static tf_stage_status draw_tile(const painting *p, area tile)
{
    int around = (int)ceil(2 * p->raster.scale);
    area drawn =
        intersect(p->whole, (area){tile.left - around, tile.top - around,
                                   tile.right + around, tile.bottom + around});
    tf_stage_status status =
        tf_renderer_draw(p->renderer, p->mesh, p->view,
                         window_of(drawn, p->raster), p->theme, p->light);
    if (status == TF_STAGE_OK)
        copy_tile(p, tile, drawn);
    return status;
}

static tf_stage_status draw_tiles(const painting *p)
{
    tf_stage_status status = TF_STAGE_OK;
    for (int y = p->whole.top; y < p->whole.bottom; y += TILE)
        for (int x = p->whole.left; x < p->whole.right; x += TILE)
            if (status == TF_STAGE_OK)
                status = draw_tile(
                    p, intersect(p->whole, (area){x, y, x + TILE, y + TILE}));
    cairo_surface_mark_dirty(p->surface);
    return status;
}

static tf_stage_status paint(painting *p)
{
    size_t side = TILE + 2 * (size_t)ceil(2 * p->raster.scale);
    size_t width = (size_t)(p->whole.right - p->whole.left);
    size_t height = (size_t)(p->whole.bottom - p->whole.top);
    width = width < side ? width : side;
    height = height < side ? height : side;
    p->light = malloc(width * height * 4 * sizeof *p->light);
    p->surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32,
                                            p->whole.right - p->whole.left,
                                            p->whole.bottom - p->whole.top);
    tf_stage_status status = TF_STAGE_NO_MEMORY;
    if (p->light != NULL &&
        cairo_surface_status(p->surface) == CAIRO_STATUS_SUCCESS)
        status = draw_tiles(p);
    free(p->light);
    return status;
}

tf_stage_status tf_picture_draw(tf_renderer *renderer, const tf_panel *panel,
                                tf_raster raster, tf_picture *picture)
{
    *picture = (tf_picture){.surface = NULL};
    const tf_theme *theme = panel->page->options.theme;
    tf_view view = tf_panel_view(panel);
    tf_mesh mesh = tf_mesh_of(&panel->scene, &view, theme);
    if (mesh.out_of_memory || panel->scene.out_of_memory) {
        free(mesh.vertices);
        return TF_STAGE_NO_MEMORY;
    }
    area whole = {0, 0, raster.pixels_x, raster.pixels_y};
    whole = intersect(whole, pixels_of(panel->box, raster));
    whole = intersect(whole, mesh_area(&mesh, &view, raster));
    tf_stage_status status = TF_STAGE_OK;
    if (whole.left < whole.right && whole.top < whole.bottom) {
        painting p = {.renderer = renderer,
                      .mesh = &mesh,
                      .view = &view,
                      .theme = theme,
                      .raster = raster,
                      .whole = whole};
        make_encoder(&p.encoder, theme->color[TF_ROLE_PAPER]);
        status = paint(&p);
        *picture = (tf_picture){p.surface, whole.left, whole.top};
    }
    free(mesh.vertices);
    return status;
}
