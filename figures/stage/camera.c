#include "stage/camera.h"

#include "contract.h"
#include "stage/vector.h"

#include <float.h>

static const double degree = 0.017453292519943295;

enum {
    ROUNDS = 12
}; ///< of fitting; in perspective each moves what is seen of the scene

tf_view tf_view_of(const tf_camera *camera, tf_box box)
{
    TF_REQUIRE(camera->height > 0);
    double a = camera->azimuth * degree, e = camera->elevation * degree;
    tf_view view = {
        .box = box,
        .right = {cos(a), sin(a), 0},
        .back = {sin(a) * cos(e), -cos(a) * cos(e), sin(e)},
        .distance = camera->distance,
        .points_per_unit = box.height / camera->height,
    };
    tf_cross(view.back, view.right, view.up);
    tf_add(camera->center, 0, camera->center, view.center);
    return view;
}

double tf_view_project(const tf_view *view, const double world[3],
                       double page[2])
{
    double d[3];
    tf_add(world, -1, view->center, d);
    double nearness = tf_dot(d, view->back), scale = view->points_per_unit;
    if (view->distance > 0) {
        double off = view->distance - nearness, least = view->distance / 1024;
        scale *= view->distance / (off > least ? off : least);
    }
    page[0] =
        view->box.x + view->box.width / 2 + scale * tf_dot(d, view->right);
    page[1] = view->box.y + view->box.height / 2 - scale * tf_dot(d, view->up);
    return -nearness;
}

/// The box around the projections of points.
static tf_box projected_bounds(const tf_view *view, int count,
                               const double points[][3])
{
    double lo[2] = {DBL_MAX, DBL_MAX}, hi[2] = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < count; i++) {
        double at[2];
        tf_view_project(view, points[i], at);
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], at[k]);
            hi[k] = fmax(hi[k], at[k]);
        }
    }
    return (tf_box){lo[0], lo[1], hi[0] - lo[0], hi[1] - lo[1]};
}

static void find_middle(int count, const double points[][3], double middle[3])
{
    for (int k = 0; k < 3; k++) {
        double lo = DBL_MAX, hi = -DBL_MAX;
        for (int i = 0; i < count; i++) {
            lo = fmin(lo, points[i][k]);
            hi = fmax(hi, points[i][k]);
        }
        middle[k] = (lo + hi) / 2;
    }
}

/// Bring what is seen in `bounds` to the middle of the view's box and to a
/// size of `width` x `height`.
static void improve(tf_camera *camera, const tf_view *view, tf_box bounds,
                    double width, double height)
{
    double dx = bounds.x + bounds.width / 2 - view->box.width / 2;
    double dy = bounds.y + bounds.height / 2 - view->box.height / 2;
    tf_add(camera->center, dx / view->points_per_unit, view->right,
           camera->center);
    tf_add(camera->center, -dy / view->points_per_unit, view->up,
           camera->center);
    double scale = fmax(bounds.width / width, bounds.height / height);
    if (scale > 0)
        camera->height *= scale;
}

tf_camera tf_camera_fit(const tf_camera *camera, int count,
                        const double points[][3], double width, double height,
                        double margin)
{
    TF_REQUIRE(count > 0 && width > 0 && height > 0);
    double inner_width = fmax(width - 2 * margin, width / 16);
    double inner_height = fmax(height - 2 * margin, height / 16);
    tf_box box = {0, 0, width, height};
    tf_camera fitted = *camera;
    fitted.height = 1;
    find_middle(count, points, fitted.center);
    for (int round = 0; round < ROUNDS; round++) {
        tf_view view = tf_view_of(&fitted, box);
        improve(&fitted, &view, projected_bounds(&view, count, points),
                inner_width, inner_height);
    }
    return fitted;
}
