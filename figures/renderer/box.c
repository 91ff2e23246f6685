#include "renderer/box.h"

double fig_box_overlap(const fig_box *a, const fig_box *b)
{
    double width = fmin(a->x + a->width, b->x + b->width) - fmax(a->x, b->x);
    double height = fmin(a->y + a->height, b->y + b->height) - fmax(a->y, b->y);
    return width > 0 && height > 0 ? width * height : 0;
}

/// Clip to lo..hi along one axis, on which the segment goes `step` from `at`.
static bool clip_axis(double at, double step, double lo, double hi,
                      double part[2])
{
    if (step == 0)
        return at >= lo && at <= hi;
    double a = (lo - at) / step, b = (hi - at) / step;
    part[0] = fmax(part[0], fmin(a, b));
    part[1] = fmin(part[1], fmax(a, b));
    return part[0] <= part[1];
}

bool fig_box_clip(const fig_box *box, fig_point from, fig_point to,
                  double part[2])
{
    part[0] = 0;
    part[1] = 1;
    return clip_axis(from.x, to.x - from.x, box->x, box->x + box->width,
                     part) &&
           clip_axis(from.y, to.y - from.y, box->y, box->y + box->height, part);
}
