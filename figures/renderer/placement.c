#include "renderer/placement.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum {
    DIRECTIONS = 16,
    DISTANCES = 6,
    SWEEPS = 4
};

/// Costs: outside of the page, over another label (for each square point),
/// off the wished direction (opposite to it).
static const double outside_cost = 1e6, overlap_cost = 1e3, turn_cost = 12;

/// Labels keep this many points from each other.
static const double clearance = 1.5;

/// All that a label is placed among.
typedef struct surroundings {
    fig_box page;
    int taken_count, obstacle_count;
    const fig_box *taken;
    const fig_obstacle *obstacle;
    int wishes;
    const fig_wish *wish;
    fig_box *placed;
    bool *is_placed;
} surroundings;

static fig_box grown(const fig_box *box, double by)
{
    return (fig_box){box->x - by, box->y - by, box->width + 2 * by,
                     box->height + 2 * by};
}

/// The box in a direction from the anchor, its border `gap` off.
static fig_box box_towards(const fig_wish *wish, double direction, double gap)
{
    double dx = cos(direction), dy = -sin(direction);
    double half_width = wish->width / 2, half_height = wish->height / 2;
    // Move the box's middle until the circle of radius gap around the anchor
    // touches the box: that middle lies on a rounded rectangle.
    double lo = 0, hi = gap + half_width + half_height;
    for (int i = 0; i < 30; i++) {
        double mid = (lo + hi) / 2;
        double outside_x = fmax(fabs(mid * dx) - half_width, 0);
        double outside_y = fmax(fabs(mid * dy) - half_height, 0);
        if (hypot(outside_x, outside_y) < gap)
            lo = mid;
        else
            hi = mid;
    }
    return (fig_box){wish->anchor.x + hi * dx - half_width,
                     wish->anchor.y + hi * dy - half_height, wish->width,
                     wish->height};
}

static double outside(const fig_box *page, const fig_box *box)
{
    double over = fmax(page->x - box->x, 0) + fmax(page->y - box->y, 0);
    over += fmax(box->x + box->width - page->x - page->width, 0);
    return over + fmax(box->y + box->height - page->y - page->height, 0);
}

/// How much of an obstacle a box covers, in points; a dot counts as its width.
static double covered(const fig_obstacle *o, const fig_box *box)
{
    fig_box wide = grown(box, o->radius);
    double dx = o->to.x - o->from.x, dy = o->to.y - o->from.y;
    if (fabs(dx) + fabs(dy) < 1e-9) {
        bool in = o->from.x > wide.x && o->from.x < wide.x + wide.width &&
                  o->from.y > wide.y && o->from.y < wide.y + wide.height;
        return in ? 2 * o->radius + 2 : 0;
    }
    double part[2];
    bool inside =
        fig_box_clip(&wide, o->from, o->to, part) && part[1] > part[0];
    return inside ? (part[1] - part[0]) * hypot(dx, dy) + 4 : 0;
}

static double cost_of(const surroundings *s, int own, const fig_box *box)
{
    fig_box wide = grown(box, clearance);
    double cost = outside_cost * outside(&s->page, box);
    for (int i = 0; i < s->taken_count; i++)
        cost += overlap_cost * fig_box_overlap(&wide, &s->taken[i]);
    for (int i = 0; i < s->wishes; i++)
        if (i != own && s->is_placed[i])
            cost += overlap_cost * fig_box_overlap(&wide, &s->placed[i]);
    for (int i = 0; i < s->obstacle_count; i++)
        cost += s->obstacle[i].weight * covered(&s->obstacle[i], box);
    return cost;
}

static double turn_between(double a, double b)
{
    return fabs(remainder(a - b, 6.283185307179586));
}

/// Put one label where it costs least among the others.
static void place_one(const surroundings *s, int own)
{
    const fig_wish *wish = &s->wish[own];
    double least = DBL_MAX;
    for (int i = 0; i < DISTANCES; i++)
        for (int j = 0; j < DIRECTIONS; j++) {
            double far = wish->reach * i / (DISTANCES - 1);
            // The wished direction is tried first, so it wins a tie.
            int steps = (j + 1) / 2 * (j % 2 ? -1 : 1);
            double turn = steps * (6.283185307179586 / DIRECTIONS);
            double direction = wish->direction + turn;
            fig_box box = box_towards(wish, direction, wish->gap + far);
            double turned = turn_between(direction, wish->direction);
            double cost = far * wish->distance_cost + cost_of(s, own, &box);
            cost += (wish->any_side ? 0.1 : 1) * turn_cost * turned / 3.1416;
            if (cost < least) {
                least = cost;
                s->placed[own] = box;
            }
        }
    s->is_placed[own] = true;
}

bool fig_place(fig_box page, int wishes, const fig_wish wish[], int taken_count,
               const fig_box taken[], int obstacles,
               const fig_obstacle obstacle[], fig_box placed[])
{
    bool *is_placed = calloc((size_t)wishes + 1, sizeof *is_placed);
    if (is_placed == NULL)
        return false;
    surroundings s = {page,   taken_count, obstacles, taken,    obstacle,
                      wishes, wish,        placed,    is_placed};
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (int i = 0; i < wishes; i++)
            place_one(&s, i);
    free(is_placed);
    return true;
}
