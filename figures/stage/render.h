// From triangles to a picture: peeled layers, summed over shifted pictures.
#ifndef TF_STAGE_RENDER_H
#define TF_STAGE_RENDER_H

#include "stage/camera.h"
#include "stage/mesh.h"
#include "stage/status.h"
#include "stage/theme.h"

typedef struct tf_renderer tf_renderer;

/// Open a context and make ready.  *renderer is NULL after a failure.
tf_stage_status tf_renderer_new(tf_renderer **renderer);
void tf_renderer_free(tf_renderer *renderer);

/// The part of the page that a picture shows, in points, and its pixels.
typedef struct tf_window {
    tf_box box;
    int width, height;
} tf_window;

/// Draw a mesh into `pixels`, width x height x 4 floats, row after row from
/// the top: red, green, blue in linear light as seen over the theme's paper,
/// and opacity.  The same input gives the same bytes.
tf_stage_status tf_renderer_draw(tf_renderer *renderer, const tf_mesh *mesh,
                                 const tf_view *view, tf_window window,
                                 const tf_theme *theme, float *pixels);

#endif
