// A panel's solid geometry as a picture for cairo.
#ifndef FIG_RENDERER_PICTURE_H
#define FIG_RENDERER_PICTURE_H

#include "renderer/page_parts.h"
#include "renderer/render.h"

/// A picture and where on the page its upper left pixel is, in pixels of the
/// raster.  `surface` is NULL if there is nothing to be seen.
typedef struct fig_picture {
    cairo_surface_t *surface;
    int x, y;
} fig_picture;

/// Draw what a panel sees, translucent where it is; over the theme's paper the
/// colours are exactly those of the renderer.  The caller destroys the surface.
fig_status fig_picture_draw(fig_renderer *renderer, const fig_panel *panel,
                            fig_raster raster, fig_picture *picture);

#endif
