#include "renderer/camera.h"

#include "base/require.h"

#include <float.h>

static const double degree = 0.017453292519943295;

enum {
    ROUNDS = 12
}; ///< of fitting; in perspective each moves what is seen of the scene

fig_view fig_view_of(const fig_camera *camera, fig_box box)
{
    TF_REQUIRE(camera->height > 0);
    double a = camera->azimuth * degree, e = camera->elevation * degree;
    tf_vector right = {{cos(a), sin(a), 0}};
    tf_vector back = {{sin(a) * cos(e), -cos(a) * cos(e), sin(e)}};
    return (fig_view){
        .box = box,
        .right = right,
        .up = fig_cross(back, right),
        .back = back,
        .center = camera->center,
        .distance = camera->distance,
        .points_per_unit = box.height / camera->height,
    };
}

double fig_view_depth(const fig_view *view, tf_vector world)
{
    return -tf_vector_dot(fig_difference(world, view->center), view->back);
}

fig_point fig_view_project(const fig_view *view, tf_vector world)
{
    tf_vector d = fig_difference(world, view->center);
    double scale = view->points_per_unit;
    if (view->distance > 0) {
        double off = view->distance + fig_view_depth(view, world);
        scale *= view->distance / fmax(off, view->distance / 1024);
    }
    return (fig_point){view->box.x + view->box.width / 2 +
                           scale * tf_vector_dot(d, view->right),
                       view->box.y + view->box.height / 2 -
                           scale * tf_vector_dot(d, view->up)};
}

/// The box around the projections of points.
static fig_box projected_bounds(const fig_view *view, int count,
                                const tf_vector points[])
{
    fig_point lo = {DBL_MAX, DBL_MAX}, hi = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < count; i++) {
        fig_point at = fig_view_project(view, points[i]);
        lo = (fig_point){fmin(lo.x, at.x), fmin(lo.y, at.y)};
        hi = (fig_point){fmax(hi.x, at.x), fmax(hi.y, at.y)};
    }
    return (fig_box){lo.x, lo.y, hi.x - lo.x, hi.y - lo.y};
}

tf_vector fig_middle_of(int count, const tf_vector points[])
{
    tf_vector middle;
    for (int k = 0; k < 3; k++) {
        double lo = DBL_MAX, hi = -DBL_MAX;
        for (int i = 0; i < count; i++) {
            lo = fmin(lo, points[i].x[k]);
            hi = fmax(hi, points[i].x[k]);
        }
        middle.x[k] = (lo + hi) / 2;
    }
    return middle;
}

/// Bring what is seen in `bounds` to the middle of the view's box and to a
/// size of `width` x `height`.
static void improve(fig_camera *camera, const fig_view *view, fig_box bounds,
                    double width, double height)
{
    double dx = bounds.x + bounds.width / 2 - view->box.width / 2;
    double dy = bounds.y + bounds.height / 2 - view->box.height / 2;
    camera->center = fig_combination(camera->center, dx / view->points_per_unit,
                                     view->right);
    camera->center =
        fig_combination(camera->center, -dy / view->points_per_unit, view->up);
    double scale = fmax(bounds.width / width, bounds.height / height);
    if (scale > 0)
        camera->height *= scale;
}

fig_camera fig_camera_fit(const fig_camera *camera, int count,
                          const tf_vector points[], double width, double height,
                          double margin)
{
    TF_REQUIRE(count > 0 && width > 0 && height > 0);
    double inner_width = fmax(width - 2 * margin, width / 16);
    double inner_height = fmax(height - 2 * margin, height / 16);
    fig_box box = {0, 0, width, height};
    fig_camera fitted = *camera;
    fitted.height = 1;
    fitted.center = fig_middle_of(count, points);
    for (int round = 0; round < ROUNDS; round++) {
        fig_view view = fig_view_of(&fitted, box);
        improve(&fitted, &view, projected_bounds(&view, count, points),
                inner_width, inner_height);
    }
    return fitted;
}
