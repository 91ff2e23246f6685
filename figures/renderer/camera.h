// From world to picture.  The world's third axis is up; in figures of plane
// space-time it is time.
#ifndef FIG_RENDERER_CAMERA_H
#define FIG_RENDERER_CAMERA_H

#include "renderer/box.h"
#include "renderer/vector.h"

/// Where the eye is.  Zero-initialised: seen from the front (along +y), x to
/// the right, orthographic, and fitted to the scene.
typedef struct fig_camera {
    double azimuth;   ///< degrees the eye has walked to the right, around up
    double elevation; ///< degrees above the horizon, -90..90
    double distance;  ///< eye to center, world units; 0 is orthographic
    double height;    ///< of the world around center that fills the panel's
                      ///< height; 0 fits center and height to the scene
    tf_vector center; ///< the world point in the middle of the panel
} fig_camera;

/// A camera that looks at a box of the page: a projection.
typedef struct fig_view {
    fig_box box;
    tf_vector right, up, back; ///< orthonormal; back points to the eye
    tf_vector center;
    double distance;        ///< as the camera's
    double points_per_unit; ///< of the world, at the depth of center
} fig_view;

/// `camera` must have a height > 0.
fig_view fig_view_of(const fig_camera *camera, fig_box box);

/// How far a world point is behind `center`; negative: in front of it.
double fig_view_depth(const fig_view *view, tf_vector world);

/// Project a world point to the page.  In perspective a point at or behind the
/// eye is projected as if just before the eye.
fig_point fig_view_project(const fig_view *view, tf_vector world);

/// The middle of the bounds of `count` > 0 points.
tf_vector fig_middle_of(int count, const tf_vector points[]);

/// The camera with `center` and `height` such that all `count` > 0 points lie
/// in a box of `width` x `height` points, `margin` points from its border.
fig_camera fig_camera_fit(const fig_camera *camera, int count,
                          const tf_vector points[], double width, double height,
                          double margin);

#endif
