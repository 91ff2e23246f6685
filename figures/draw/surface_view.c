#include "draw/surface_view.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double degree = 0.017453292519943295;

// Samples ----------------------------------------------------------------

enum {
    SAMPLES = 6000,
    SPOTS = 1000,
    CELLS = 56 ///< of the picture, across and down, when looking for samples
};

/// How much all the spots count, and the first one besides, where the whole
/// surface counts 1.
static const double spots_weight = 0.5, first_weight = 0.3;

/// How far behind what is nearest in its cell a sample is still seen, in cells.
static const double depth_cells = 2;

typedef struct sample {
    tf_vector at, normal; ///< the latter is of length 1; of a spot, zero
    double weight;
} sample;

typedef struct samples {
    int count;
    sample samples[SAMPLES + SPOTS];
} samples;

static tf_vector normal_of(const tf_vector corner[3])
{
    return fig_cross(fig_difference(corner[1], corner[0]),
                     fig_difference(corner[2], corner[0]));
}

static double area_of(const fig_shape *shape, int triangle, double t)
{
    tf_vector piece[FIG_BENT_PIECES][3];
    fig_shape_pieces(shape, triangle, FIG_STRAIGHT, t, piece);
    return fig_length(normal_of(piece[0]));
}

static double fraction(double x)
{
    return x - floor(x);
}

/// Add the n-th sample, which is somewhere in a triangle.
static void add_sample(samples *all, const fig_shape *shape, int triangle,
                       double t, int n)
{
    tf_vector piece[FIG_BENT_PIECES][3];
    fig_shape_pieces(shape, triangle, FIG_STRAIGHT, t, piece);
    const tf_vector *corner = piece[0];
    // Multiples of these two are spread evenly over the square.
    double u = fraction(0.7548776662466927 * n);
    double v = fraction(0.5698402909980532 * n);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    tf_vector at =
        fig_combination(corner[0], u, fig_difference(corner[1], corner[0]));
    at = fig_combination(at, v, fig_difference(corner[2], corner[0]));
    all->samples[all->count++] =
        (sample){at, fig_normalized(normal_of(corner)), 1.0 / SAMPLES};
}

/// Spread samples over the surface, as many for equal areas.
static void add_samples(samples *all, const fig_shape *shape, double t)
{
    double total = 0, passed = 0;
    for (int i = 0; i < shape->triangles; i++)
        total += area_of(shape, i, t);
    for (int i = 0; i < shape->triangles && total > 0; i++) {
        passed += area_of(shape, i, t);
        while (all->count < SAMPLES &&
               (all->count + 0.5) / SAMPLES * total < passed)
            add_sample(all, shape, i, t, all->count);
    }
}

/// Edges of no triangle, and vertices alone, count by their ends.
static void add_ends(samples *all, const fig_shape *shape, double t)
{
    int step = 1 + shape->vertices / SAMPLES;
    for (int i = 0; i < shape->vertices && all->count < SAMPLES; i += step)
        all->samples[all->count++] = (sample){
            .at = fig_shape_place(shape, i, t), .weight = 1.0 / SAMPLES};
}

static void add_spot(samples *all, const fig_shape *shape, const fig_spot *spot,
                     double weight, double t)
{
    if (all->count < SAMPLES + SPOTS)
        all->samples[all->count++] =
            (sample){.at = fig_shape_point(shape, spot->vertices, spot->vertex,
                                           spot->weight, FIG_STRAIGHT, t),
                     .weight = weight};
}

static void add_spots(samples *all, const fig_shape *shape,
                      const fig_marks *marks, double t)
{
    int step = 1 + marks->count / (SPOTS - 1), first = 0;
    for (int i = 0; i < marks->count; i++)
        first = marks->spot[i].toi < marks->spot[first].toi ? i : first;
    if (marks->count > 0)
        add_spot(all, shape, &marks->spot[first], first_weight, t);
    for (int i = 0; i < marks->count; i += step)
        add_spot(all, shape, &marks->spot[i],
                 spots_weight * step / marks->count, t);
}

// Seeing -----------------------------------------------------------------

/// The samples as a camera sees them, on a grid of cells.
typedef struct sight {
    fig_view view;
    double nearest[CELLS][CELLS];
} sight;

static double *cell_of(sight *s, tf_vector at)
{
    fig_point p = fig_view_project(&s->view, at);
    int x = (int)fmax(0, fmin(p.x, CELLS - 1));
    int y = (int)fmax(0, fmin(p.y, CELLS - 1));
    return &s->nearest[y][x];
}

/// How much of the samples a camera sees; what is seen slantwise counts less.
static double seen_by(const samples *all, const fig_camera *camera)
{
    // All of the box is in view from all sides.
    fig_camera whole = *camera;
    whole.height = 1.74;
    sight s = {.view = fig_view_of(&whole, (fig_box){0, 0, CELLS, CELLS})};
    for (int i = 0; i < CELLS * CELLS; i++)
        s.nearest[i / CELLS][i % CELLS] = DBL_MAX;
    for (int i = 0; i < all->count; i++) {
        double *cell = cell_of(&s, all->samples[i].at);
        *cell = fmin(*cell, fig_view_depth(&s.view, all->samples[i].at));
    }
    double sum = 0, behind = depth_cells / s.view.points_per_unit;
    for (int i = 0; i < all->count; i++) {
        const sample *one = &all->samples[i];
        double slant = fabs(tf_vector_dot(one->normal, s.view.back));
        bool flat = fig_length(one->normal) > 0;
        if (fig_view_depth(&s.view, one->at) <= *cell_of(&s, one->at) + behind)
            sum += one->weight * (flat ? sqrt(sqrt(slant)) : 1);
    }
    return sum;
}

// Choosing ---------------------------------------------------------------

/// The direction, in degrees from the first axis, in which the samples spread
/// most as seen from above; 0 if they do not in any.
static double longest_direction(const samples *all)
{
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (int i = 0; i < all->count; i++) {
        x += all->samples[i].at.x[0] / all->count;
        y += all->samples[i].at.x[1] / all->count;
    }
    for (int i = 0; i < all->count; i++) {
        double dx = all->samples[i].at.x[0] - x,
               dy = all->samples[i].at.x[1] - y;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
    bool round = hypot(xx - yy, 2 * xy) < 0.1 * (xx + yy);
    return round ? 0 : atan2(2 * xy, xx - yy) / 2 / degree;
}

fig_camera fig_surface_camera(const fig_shape *shape, const fig_marks *marks,
                              double t)
{
    static const double turn[] = {30, -30, 150, -150, 60, -60};
    static const double elevation[] = {24, 36, 14};
    // What is as good is seen from where figures of the book are.
    static const double habit = 0.01;
    fig_camera best = {.azimuth = turn[0], .elevation = elevation[0]};
    samples *all = calloc(1, sizeof *all);
    if (!all)
        return best;
    add_samples(all, shape, t);
    if (all->count == 0)
        add_ends(all, shape, t);
    if (marks)
        add_spots(all, shape, marks, t);
    double most = -1, direction = longest_direction(all);
    for (int i = 0; i < 18; i++) {
        fig_camera camera = {.azimuth = direction + turn[i / 3],
                             .elevation = elevation[i % 3]};
        double seen = seen_by(all, &camera) - habit * i;
        if (seen > most)
            best = camera;
        most = fmax(most, seen);
    }
    free(all);
    return best;
}

// Fitting ----------------------------------------------------------------

enum {
    DIRECTIONS = 400
};

/// The n-th of directions that are spread evenly over the sphere.
static tf_vector direction_of(int n)
{
    double up = 1 - (2 * n + 1.0) / DIRECTIONS, out = sqrt(1 - up * up);
    double turn = 2.399963229728653 * n;
    return (tf_vector){{out * cos(turn), out * sin(turn), up}};
}

/// The vertex that is farthest in a direction.
static tf_vector farthest(const fig_shape *shape, int t, tf_vector direction)
{
    int best = 0;
    double most = -DBL_MAX;
    for (int i = 0; i < shape->vertices; i++) {
        double along = tf_vector_dot(shape->at[t][i], direction);
        if (along > most) {
            most = along;
            best = i;
        }
    }
    return shape->at[t][best];
}

int fig_surface_outline(const fig_shape *shape, tf_vector point[FIG_OUTLINE])
{
    // In mid-step all is between places of the start and the end.
    int count = 0;
    bool few = shape->vertices <= FIG_OUTLINE / 2;
    for (int t = 0; t < 2; t++)
        for (int i = 0; i < (few ? shape->vertices : DIRECTIONS); i++)
            point[count++] =
                few ? shape->at[t][i] : farthest(shape, t, direction_of(i));
    return count;
}
