// Solid geometry of a panel, in world units; widths of lines and balls are in
// points of the page, so they look alike in all figures.
//
// Translucent things are blended in the right order, also where they cross;
// where two translucent triangles coincide, the first one added is seen.
// Coordinates must be finite.
#ifndef TF_STAGE_SCENE_H
#define TF_STAGE_SCENE_H

#include "stage/theme.h"

#include <stdbool.h>

typedef struct tf_scene tf_scene;

/// Count a point as part of the scene when the camera is fitted to it, though
/// nothing is drawn: an animation that reaches all places of its things keeps
/// its camera still.
void tf_scene_reach(tf_scene *scene, const double at[3]);

/// An event: a ball of a diameter in points, TF_WIDTH_BALL as a rule.
void tf_scene_ball(tf_scene *scene, const double at[3], double diameter,
                   tf_paint paint);

/// A line as a round tube, TF_WIDTH_TUBE as a rule.
void tf_scene_tube(tf_scene *scene, const double from[3], const double to[3],
                   double width, tf_paint paint);

/// A tube that ends in an arrow head, its tip at `to`: a worldline.
void tf_scene_arrow(tf_scene *scene, const double from[3], const double to[3],
                    double width, tf_paint paint);

/// A tube with an arrow head in its middle; for worldlines between two balls.
void tf_scene_worldline(tf_scene *scene, const double from[3],
                        const double to[3], double width, tf_paint paint);

/// A tube in dashes as long as the gaps, `dash` points each.
void tf_scene_dashes(tf_scene *scene, const double from[3], const double to[3],
                     double width, double dash, tf_paint paint);

/// A polyline as a tube through `count` points.
void tf_scene_path(tf_scene *scene, int count, const double at[][3],
                   double width, tf_paint paint);

/// A triangle, seen from both sides.  `crease` is the width of lines along
/// its edges, darker than the triangle; 0 for none.
void tf_scene_triangle(tf_scene *scene, const double corner[3][3],
                       double crease, tf_paint paint);

/// The four faces of a tetrahedron, and its edges as creases.
void tf_scene_tetrahedron(tf_scene *scene, const double corner[4][3],
                          double crease, tf_paint paint);

/// A smooth curved sheet through rows x columns samples, row after row, both
/// at least 2.  Every `lines`-th row and column is drawn as a crease of
/// TF_WIDTH_HAIR, the border as one of TF_WIDTH_THIN; lines = 0 draws none.
void tf_scene_patch(tf_scene *scene, int rows, int columns,
                    const double at[][3], int lines, tf_paint paint);

/// A plane with corner `origin` and sides u, v as a faint sheet with a grid of
/// nu x nv cells: t = 0 and t = 1 in TF_ROLE_START and TF_ROLE_END.
void tf_scene_grid(tf_scene *scene, const double origin[3], const double u[3],
                   const double v[3], int nu, int nv, tf_role role);

/// Where a thing of a shrunken or exploded drawing goes: `point` moved towards
/// (scale < 1) or from `center`.
void tf_scale_about(const double center[3], double scale, const double point[3],
                    double moved[3]);

#endif
