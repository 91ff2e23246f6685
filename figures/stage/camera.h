// From world to picture.  The world's third axis is up; in figures of plane
// space-time it is time.
#ifndef TF_STAGE_CAMERA_H
#define TF_STAGE_CAMERA_H

/// A rectangle in points; x to the right and y down, (x, y) its upper left.
typedef struct tf_box {
    double x, y, width, height;
} tf_box;

/// Where the eye is.  Zero-initialised: seen from the front (along +y), x to
/// the right, orthographic, and fitted to the scene.
typedef struct tf_camera {
    double azimuth;   ///< degrees the eye has walked to the right, around up
    double elevation; ///< degrees above the horizon, -90..90
    double distance;  ///< eye to center, world units; 0 is orthographic
    double height;    ///< of the world around center that fills the panel's
                      ///< height; 0 fits center and height to the scene
    double center[3]; ///< the world point in the middle of the panel
} tf_camera;

/// A camera that looks at a box of the page: a projection.
typedef struct tf_view {
    tf_box box;
    double right[3], up[3], back[3]; ///< orthonormal; back points to the eye
    double center[3];
    double distance;        ///< as the camera's
    double points_per_unit; ///< of the world, at the depth of center
} tf_view;

/// `camera` must have a height > 0.
tf_view tf_view_of(const tf_camera *camera, tf_box box);

/// Project a world point to page points.  Returns its depth: how far it is
/// behind `center`, in world units (negative: in front).  In perspective a
/// point at or behind the eye is projected as if just before the eye.
double tf_view_project(const tf_view *view, const double world[3],
                       double page[2]);

/// The camera with `center` and `height` such that all `count` > 0 points lie
/// in a box of `width` x `height` points, `margin` points from its border.
tf_camera tf_camera_fit(const tf_camera *camera, int count,
                        const double points[][3], double width, double height,
                        double margin);

#endif
