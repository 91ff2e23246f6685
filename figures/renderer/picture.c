#include "renderer/picture.h"

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

static area pixels_of(fig_box box, fig_raster raster)
{
    double s = raster.scale;
    return (area){(int)floor(box.x * s) + raster.shift_x,
                  (int)floor(box.y * s) + raster.shift_y,
                  (int)ceil((box.x + box.width) * s) + raster.shift_x,
                  (int)ceil((box.y + box.height) * s) + raster.shift_y};
}

static fig_window window_of(area a, fig_raster raster)
{
    double s = raster.scale;
    fig_window window = {.width = a.right - a.left, .height = a.bottom - a.top};
    window.box =
        (fig_box){(a.left - raster.shift_x) / s, (a.top - raster.shift_y) / s,
                  window.width / s, window.height / s};
    return window;
}

/// Where the i-th vertex of a mesh is in the world.
static tf_vector place_of(const fig_mesh *mesh, const fig_view *view, int i)
{
    tf_vector world = view->center;
    for (int k = 0; k < 3; k++)
        world.x[k] += mesh->vertices[i].at[k];
    return world;
}

/// The pixels on which a mesh falls, and one around.
static area mesh_area(const fig_mesh *mesh, const fig_view *view,
                      fig_raster raster)
{
    double least = view->box.x - 1e4, most = view->box.x + 1e4;
    fig_point lo = {DBL_MAX, DBL_MAX}, hi = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < mesh->count; i++) {
        fig_point at = fig_view_project(view, place_of(mesh, view, i));
        lo.x = fmin(lo.x, fmax(at.x, least));
        lo.y = fmin(lo.y, fmax(at.y, least));
        hi.x = fmax(hi.x, fmin(at.x, most));
        hi.y = fmax(hi.y, fmin(at.y, most));
    }
    if (mesh->count == 0)
        return (area){0, 0, 0, 0};
    area a = pixels_of((fig_box){lo.x, lo.y, hi.x - lo.x, hi.y - lo.y}, raster);
    return (area){a.left - 1, a.top - 1, a.right + 1, a.bottom + 1};
}

// Colours ----------------------------------------------------------------

/// What a pixel needs on its way from linear light.
typedef struct encoder {
    float encoded[STEPS + 1];
    double paper[3];
} encoder;

static void make_encoder(encoder *e, fig_rgb paper)
{
    const double component[3] = {paper.r, paper.g, paper.b};
    for (int i = 0; i <= STEPS; i++)
        e->encoded[i] = (float)fig_rgb_from_linear((double)i / STEPS);
    for (int k = 0; k < 3; k++)
        e->paper[k] = component[k];
}

static double clamped(double x, double most)
{
    return x > most ? most : x > 0 ? x : 0;
}

/// The pixel which cairo, blending encoded colours over the paper, makes the
/// light (red, green, blue) of; of an opacity as near as can be to the fourth.
static unsigned encode(const encoder *e, const float light[4])
{
    double least = clamped(light[3], 1), wanted[3];
    if (least == 0)
        return 0;
    for (int k = 0; k < 3; k++) {
        int step = (int)(STEPS * clamped(light[k], 1) + 0.5);
        wanted[k] = e->encoded[step];
        double paper = e->paper[k];
        if (wanted[k] > paper)
            least = fmax(least, (wanted[k] - paper) / (1 - paper));
        else if (wanted[k] < paper)
            least = fmax(least, 1 - wanted[k] / paper);
    }
    least = ceil(255 * least) / 255;
    unsigned pixel = (unsigned)(255 * least + 0.5);
    for (int k = 0; k < 3; k++) {
        double own = wanted[k] - (1 - least) * e->paper[k];
        pixel = pixel << 8 | (unsigned)(255 * clamped(own, least) + 0.5);
    }
    return pixel;
}

// Tiles ------------------------------------------------------------------

/// A picture in the making.
typedef struct painting {
    fig_renderer *renderer;
    const fig_mesh *mesh;
    const fig_view *view;
    const fig_theme *theme;
    fig_raster raster;
    area whole;
    bool steady, coarse;
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
static fig_status draw_tile(const painting *p, area tile)
{
    int around = (int)ceil(2 * p->raster.scale);
    area drawn =
        intersect(p->whole, (area){tile.left - around, tile.top - around,
                                   tile.right + around, tile.bottom + around});
    fig_window window = window_of(drawn, p->raster);
    window.steady = p->steady;
    window.coarse = p->coarse;
    fig_status status = fig_renderer_draw(p->renderer, p->mesh, p->view, window,
                                          p->theme, p->light);
    if (status == FIG_OK)
        copy_tile(p, tile, drawn);
    return status;
}

static fig_status draw_tiles(const painting *p)
{
    fig_status status = FIG_OK;
    for (int y = p->whole.top; y < p->whole.bottom; y += TILE)
        for (int x = p->whole.left; x < p->whole.right; x += TILE)
            if (status == FIG_OK)
                status = draw_tile(
                    p, intersect(p->whole, (area){x, y, x + TILE, y + TILE}));
    cairo_surface_mark_dirty(p->surface);
    return status;
}

static fig_status paint(painting *p)
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
    fig_status status = FIG_NO_MEMORY;
    if (p->light != NULL &&
        cairo_surface_status(p->surface) == CAIRO_STATUS_SUCCESS)
        status = draw_tiles(p);
    free(p->light);
    return status;
}

fig_status fig_picture_draw(fig_renderer *renderer, const fig_panel *panel,
                            fig_raster raster, fig_picture *picture)
{
    *picture = (fig_picture){.surface = NULL};
    const fig_theme *theme = panel->page->options.theme;
    fig_view view = fig_panel_view(panel);
    fig_mesh mesh = fig_mesh_of(&panel->scene, &view, theme);
    if (mesh.out_of_memory || panel->scene.out_of_memory) {
        free(mesh.vertices);
        return FIG_NO_MEMORY;
    }
    area whole = {0, 0, raster.pixels_x, raster.pixels_y};
    whole = intersect(whole, pixels_of(panel->box, raster));
    whole = intersect(whole, mesh_area(&mesh, &view, raster));
    fig_status status = FIG_OK;
    if (whole.left < whole.right && whole.top < whole.bottom) {
        painting p = {.renderer = renderer,
                      .mesh = &mesh,
                      .view = &view,
                      .theme = theme,
                      .raster = raster,
                      .whole = whole,
                      .steady = panel->page->options.moves,
                      .coarse = panel->page->options.moves &&
                                panel->scene.painted_count == 0};
        make_encoder(&p.encoder, theme->color[FIG_ROLE_PAPER]);
        status = paint(&p);
        *picture = (fig_picture){p.surface, whole.left, whole.top};
    }
    free(mesh.vertices);
    return status;
}
