// From triangles to a picture: peeled layers, summed over shifted pictures.
#ifndef FIG_RENDERER_RENDER_H
#define FIG_RENDERER_RENDER_H

#include "renderer/camera.h"
#include "renderer/mesh.h"
#include "renderer/status.h"
#include "renderer/theme.h"

#include <stdbool.h>

typedef struct fig_renderer fig_renderer;

/// Open a context and make ready.  *renderer is NULL after a failure.
fig_status fig_renderer_new(fig_renderer **renderer);
void fig_renderer_free(fig_renderer *renderer);

/// The part of the page that a picture shows, in points, and its pixels.
typedef struct fig_window {
    fig_box box;
    int width, height;
    bool steady; ///< one of a film: colors do not fade with the distance, since
                 ///< the farthest things change
    bool coarse; ///< edges get coarser steps, which takes half the time
} fig_window;

/// Draw a mesh into `pixels`, width x height x 4 floats, row after row from
/// the top: red, green, blue in linear light as seen over the theme's paper,
/// and opacity.  The same input gives the same bytes.
fig_status fig_renderer_draw(fig_renderer *renderer, const fig_mesh *mesh,
                             const fig_view *view, fig_window window,
                             const fig_theme *theme, float *pixels);

#endif
