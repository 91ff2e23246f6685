// Solid geometry of a panel, in world units; widths of lines and balls are in
// points of the page, so they look alike in all figures.
//
// Translucent things are blended in the right order, also where they cross;
// where two translucent triangles coincide, the first one added is seen.
// Coordinates must be finite.
#ifndef FIG_RENDERER_SCENE_H
#define FIG_RENDERER_SCENE_H

#include "renderer/theme.h"
#include "renderer/vector.h"

#include <stdbool.h>

typedef struct fig_scene fig_scene;

/// Count a point as part of the scene when the camera is fitted to it, though
/// nothing is drawn: an animation that reaches all places of its things keeps
/// its camera still.
void fig_scene_reach(fig_scene *scene, tf_vector at);

/// An event: a ball of a diameter in points, FIG_WIDTH_BALL as a rule.
void fig_scene_ball(fig_scene *scene, tf_vector at, double diameter,
                    fig_paint paint);

/// A line as a round tube, FIG_WIDTH_TUBE as a rule.
void fig_scene_tube(fig_scene *scene, tf_vector from, tf_vector to,
                    double width, fig_paint paint);

/// A tube that ends in an arrow head, its tip at `to`: a worldline.
void fig_scene_arrow(fig_scene *scene, tf_vector from, tf_vector to,
                     double width, fig_paint paint);

/// A tube with an arrow head in its middle; for worldlines between two balls.
void fig_scene_worldline(fig_scene *scene, tf_vector from, tf_vector to,
                         double width, fig_paint paint);

/// A tube in dashes as long as the gaps, `dash` points each.
void fig_scene_dashes(fig_scene *scene, tf_vector from, tf_vector to,
                      double width, double dash, fig_paint paint);

/// A polyline as a tube through `count` points.
void fig_scene_path(fig_scene *scene, int count, const tf_vector at[],
                    double width, fig_paint paint);

/// A triangle, seen from both sides.  `crease` is the width of lines along
/// its edges, darker than the triangle; 0 for none.
void fig_scene_triangle(fig_scene *scene, const tf_vector corner[3],
                        double crease, fig_paint paint);

/// A triangle of a large surface, opaque and seen from both sides.
typedef struct fig_facet {
    float at[3][3];     ///< the corners
    float normal[3][3]; ///< at the corners, of length 1, to either side
    fig_role role;
    float shade; ///< as that of a paint
} fig_facet;

/// Note that there was no memory for something of the scene; the call that
/// writes the page tells.
void fig_scene_fail(fig_scene *scene);

/// Add `count` triangles, for the caller to fill in before the next call.  The
/// camera is not fitted to them: see fig_scene_reach.  NULL if there is no
/// memory.
fig_facet *fig_scene_facets(fig_scene *scene, int count);

/// A triangle whose light is known: opaque, seen from both sides, with a color
/// at each corner, which is not lit again and does not fade.
typedef struct fig_painted {
    float at[3][3];    ///< the corners
    float color[3][3]; ///< red, green, blue in linear light
} fig_painted;

/// The same for these triangles.
fig_painted *fig_scene_painted(fig_scene *scene, int count);

/// The four faces of a tetrahedron, and its edges as creases.
void fig_scene_tetrahedron(fig_scene *scene, const tf_vector corner[4],
                           double crease, fig_paint paint);

/// A smooth curved sheet through rows x columns samples, row after row, both
/// at least 2.  Every `lines`-th row and column is drawn as a crease of
/// FIG_WIDTH_HAIR, the border as one of FIG_WIDTH_THIN; lines = 0 draws none.
void fig_scene_patch(fig_scene *scene, int rows, int columns,
                     const tf_vector at[], int lines, fig_paint paint);

/// A plane with corner `origin` and sides u, v as a faint sheet with a grid of
/// nu x nv cells: t = 0 and t = 1 in FIG_ROLE_START and FIG_ROLE_END.
void fig_scene_grid(fig_scene *scene, tf_vector origin, tf_vector u,
                    tf_vector v, int nu, int nv, fig_role role);

#endif
