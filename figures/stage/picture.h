// A panel's solid geometry as a picture for cairo.
#ifndef TF_STAGE_PICTURE_H
#define TF_STAGE_PICTURE_H

#include "stage/page_parts.h"
#include "stage/render.h"

/// A picture and where on the page its upper left pixel is, in pixels of the
/// raster.  `surface` is NULL if there is nothing to be seen.
typedef struct tf_picture {
    cairo_surface_t *surface;
    int x, y;
} tf_picture;

/// Draw what a panel sees, translucent where it is; over the theme's paper the
/// colours are exactly those of the renderer.  The caller destroys the surface.
tf_stage_status tf_picture_draw(tf_renderer *renderer, const tf_panel *panel,
                                tf_raster raster, tf_picture *picture);

#endif
