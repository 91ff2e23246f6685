#include "base/require.h"
#include "kit/cloth_parts.h"
#include "renderer/list.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/// How far up and down a floor may reach, in sides of the box.
static const double floor_height = 1e-6;

/// By how much an edge of a part that keeps its shape may change its length, of
/// that length and of the side of the box.
static const double length_change = 1e-6, length_rounding = 1e-12;

// Frames -----------------------------------------------------------------

fig_cloth *fig_cloth_new(const tf_surface *surface, int axes)
{
    fig_cloth *cloth = calloc(1, sizeof *cloth);
    if (cloth) {
        cloth->surface = surface;
        cloth->axes = axes;
        cloth->up = FIG_UP_Z;
        cloth->flat = true;
    }
    return cloth;
}

void fig_cloth_set_up(fig_cloth *cloth, fig_up up)
{
    TF_REQUIRE(cloth->frames == 0);
    cloth->up = up;
}

void fig_cloth_free(fig_cloth *cloth)
{
    if (!cloth)
        return;
    fig_shape_free(&cloth->shape);
    free(cloth->at);
    free(cloth->obstacle);
    free(cloth->soft);
    free(cloth->color);
    free(cloth->face);
    free(cloth->hem);
    free(cloth);
}

static bool make_shape(fig_cloth *cloth, int vertices, const double x[])
{
    const tf_motion rest = {3, vertices, x, x};
    return fig_shape_make(&cloth->shape, cloth->surface, cloth->axes, &rest,
                          cloth->up);
}

bool fig_cloth_add(fig_cloth *cloth, int vertices, const double x[])
{
    if (cloth->frames == 0 && !make_shape(cloth, vertices, x))
        return false;
    TF_REQUIRE(vertices == cloth->shape.vertices);
    int count = cloth->frames * vertices;
    if (!fig_list_room(&cloth->at, count, vertices, &cloth->room,
                       sizeof *cloth->at))
        return false;
    for (int i = 0; i < vertices; i++, x += cloth->axes) {
        tf_vector at = fig_turned(cloth->axes, cloth->up, x);
        cloth->at[count + i] = at;
        cloth->flat = cloth->flat && at.x[2] == 0;
    }
    cloth->frames++;
    return true;
}

bool fig_cloth_set_obstacles(fig_cloth *cloth, const bool of_obstacle[])
{
    const fig_shape *shape = &cloth->shape;
    TF_REQUIRE(cloth->frames > 0 && !cloth->obstacle);
    cloth->obstacle = calloc((size_t)shape->parts + 1, sizeof *cloth->obstacle);
    for (int v = 0; v < shape->vertices && cloth->obstacle; v++)
        if (shape->part[v] >= 0)
            cloth->obstacle[shape->part[v]] = of_obstacle[v];
    return cloth->obstacle != NULL;
}

int fig_cloth_frames(const fig_cloth *cloth)
{
    return cloth->frames;
}

const fig_shape *fig_cloth_shape(const fig_cloth *cloth)
{
    return &cloth->shape;
}

// What keeps its shape ---------------------------------------------------

static double edge_length(const fig_cloth *cloth, int frame, int edge)
{
    const int *end = cloth->shape.edge + 2 * (size_t)edge;
    const tf_vector *at =
        cloth->at + (size_t)frame * (size_t)cloth->shape.vertices;
    return fig_length(fig_difference(at[end[0]], at[end[1]]));
}

static void find_soft_parts(fig_cloth *cloth)
{
    const fig_shape *shape = &cloth->shape;
    for (int i = 0; i < shape->edges; i++) {
        double length = edge_length(cloth, 0, i);
        bool *soft = &cloth->soft[shape->part[shape->edge[2 * (size_t)i]]];
        for (int f = 1; f < cloth->frames && !*soft; f++)
            *soft = fabs(edge_length(cloth, f, i) - length) >
                    length_change * length + length_rounding;
    }
}

/// Take for soft what moves at all.
static void find_moving_parts(fig_cloth *cloth)
{
    const fig_shape *shape = &cloth->shape;
    for (int f = 1, i = shape->vertices; f < cloth->frames; f++)
        for (int v = 0; v < shape->vertices; v++, i++)
            if (shape->part[v] >= 0 &&
                fig_length(fig_difference(cloth->at[i], cloth->at[v])) >
                    length_rounding)
                cloth->soft[shape->part[v]] = true;
}

static int count_soft(const fig_cloth *cloth)
{
    int count = 0;
    for (int p = 0; p < cloth->shape.parts; p++)
        count += cloth->soft[p];
    return count;
}

/// Take for soft what is no obstacle.
static void find_free_parts(fig_cloth *cloth)
{
    for (int p = 0; p < cloth->shape.parts && cloth->obstacle; p++)
        cloth->soft[p] = !cloth->obstacle[p];
}

/// The soft parts are what the film is about, so there must be some.
static void choose_colors(fig_cloth *cloth)
{
    find_free_parts(cloth);
    if (count_soft(cloth) == 0)
        find_soft_parts(cloth);
    if (count_soft(cloth) == 0)
        find_moving_parts(cloth);
    bool all = count_soft(cloth) == 0;
    for (int p = 0, next = 0; p < cloth->shape.parts; p++) {
        cloth->soft[p] = cloth->soft[p] || all;
        cloth->color[p] = cloth->soft[p] ? next++ : 0;
    }
}

bool fig_cloth_is_stiff(const fig_cloth *cloth, int part)
{
    return !cloth->soft[part];
}

// Fronts -----------------------------------------------------------------

/// The normals of a sheet in the first frame, all to the same side.
typedef struct sides {
    double area;   ///< twice that
    double upward; ///< how much of the area is seen from above
    double
        outward; ///< and how much from outside, by the distance from there to
                 ///< the first corner
} sides;

static void add_side(const fig_cloth *cloth, int triangle, int first,
                     sides *sum)
{
    const int *v = cloth->shape.triangle + 3 * (size_t)triangle;
    const tf_vector *at = cloth->at;
    tf_vector normal = fig_cross(fig_difference(at[v[1]], at[v[0]]),
                                 fig_difference(at[v[2]], at[v[0]]));
    tf_vector out = fig_difference(at[v[0]], at[first]);
    sum->area += fig_length(normal);
    sum->upward += cloth->face[triangle] * normal.x[2];
    sum->outward += cloth->face[triangle] * tf_vector_dot(normal, out);
}

/// Turn the triangle beyond one of the sides of a triangle to the same front,
/// if it has none yet; -1: it has.
static int turn_neighbor(fig_cloth *cloth, int triangle, int side)
{
    const fig_shape *shape = &cloth->shape;
    int edge = shape->side[3 * (size_t)triangle + (size_t)side];
    if (shape->degree[edge] != 2)
        return -1;
    int other = shape->beside[edge][shape->beside[edge][0] == triangle];
    if (cloth->face[other] != 0)
        return -1;
    double sense = fig_shape_sense(shape, edge) * cloth->face[triangle];
    cloth->face[other] = sense > 0 ? 1 : -1;
    return other;
}

/// Turn all that is joined to a triangle to one front: what is up in the first
/// frame or, in a tube for instance, where no side is, what is outside.  `found`
/// has room for all triangles.
static void turn_sheet(fig_cloth *cloth, int first, int found[])
{
    static const double mostly = 0.2;
    int count = 0, corner = cloth->shape.triangle[3 * (size_t)first];
    sides sum = {0};
    cloth->face[first] = 1;
    found[count++] = first;
    for (int i = 0; i < count; i++) {
        add_side(cloth, found[i], corner, &sum);
        for (int side = 0; side < 3; side++) {
            int other = turn_neighbor(cloth, found[i], side);
            if (other >= 0)
                found[count++] = other;
        }
    }
    bool level = fabs(sum.upward) > mostly * sum.area;
    bool wrong = (level ? sum.upward : sum.outward) < 0;
    for (int i = 0; i < count && wrong; i++)
        cloth->face[found[i]] = (signed char)-cloth->face[found[i]];
}

static bool find_fronts(fig_cloth *cloth)
{
    size_t triangles = (size_t)cloth->shape.triangles;
    int *found = malloc((triangles + 1) * sizeof *found);
    for (int i = 0; i < cloth->shape.triangles && found; i++)
        if (cloth->face[i] == 0)
            turn_sheet(cloth, i, found);
    free(found);
    return found != NULL;
}

// The floor --------------------------------------------------------------

typedef struct heights {
    double lo, hi;
} heights;

static bool is_of(const fig_cloth *cloth, int vertex, int part)
{
    int own = cloth->shape.part[vertex];
    return part >= 0 ? own == part : own >= 0 && cloth->soft[own];
}

/// The least and the greatest height in all frames of a part or, for -1, of all
/// soft ones.
static heights heights_of(const fig_cloth *cloth, int part)
{
    heights all = {DBL_MAX, -DBL_MAX};
    for (int f = 0, i = 0; f < cloth->frames; f++)
        for (int v = 0; v < cloth->shape.vertices; v++, i++)
            if (is_of(cloth, v, part)) {
                all.lo = fmin(all.lo, cloth->at[i].x[2]);
                all.hi = fmax(all.hi, cloth->at[i].x[2]);
            }
    return all;
}

static void find_floor(fig_cloth *cloth)
{
    double lowest = heights_of(cloth, -1).lo;
    cloth->floor = -1;
    for (int p = 0; p < cloth->shape.parts; p++) {
        if (cloth->soft[p])
            continue;
        heights own = heights_of(cloth, p);
        if (own.hi - own.lo <= floor_height && own.hi <= lowest) {
            cloth->floor = p;
            lowest = own.lo;
        }
    }
}

// The end ----------------------------------------------------------------

/// The i-th of directions that are spread evenly over the sphere.
static tf_vector direction_of(int i)
{
    double up = 1 - (2 * i + 1.0) / FIG_CLOTH_REACH, out = sqrt(1 - up * up);
    double turn = 2.399963229728653 * i;
    return (tf_vector){{out * cos(turn), out * sin(turn), up}};
}

/// A place, and how far out it is in a direction.
typedef struct outpost {
    tf_vector at;
    double along;
} outpost;

/// Look for a place that is farther out, but for the floor's.
static void find_farther(const fig_cloth *cloth, tf_vector direction,
                         outpost *best)
{
    for (int f = 0, i = 0; f < cloth->frames; f++)
        for (int v = 0; v < cloth->shape.vertices; v++, i++) {
            double along = tf_vector_dot(cloth->at[i], direction);
            if (along > best->along && cloth->shape.part[v] != cloth->floor)
                *best = (outpost){cloth->at[i], along};
        }
}

/// The height of the lowest vertex, but for the floor's.  None of the directions
/// is straight down, so that no point of the reach may be as low.
static double lowest_of(const fig_cloth *cloth)
{
    double lowest = DBL_MAX;
    for (int f = 0, i = 0; f < cloth->frames; f++)
        for (int v = 0; v < cloth->shape.vertices; v++, i++)
            if (cloth->shape.part[v] != cloth->floor)
                lowest = fmin(lowest, cloth->at[i].x[2]);
    return lowest;
}

static void find_bottom(int count, fig_cloth *const cloth[])
{
    fig_cloth *first = cloth[0];
    first->bottom = DBL_MAX;
    for (int c = 0; c < count; c++)
        first->bottom = fmin(first->bottom, lowest_of(cloth[c]));
    if (first->floor >= 0)
        first->bottom = heights_of(first, first->floor).hi;
}

static void find_reach(int count, fig_cloth *const cloth[])
{
    fig_cloth *first = cloth[0];
    for (int i = 0; i < FIG_CLOTH_REACH; i++) {
        outpost best = {.along = -DBL_MAX};
        for (int c = 0; c < count; c++)
            find_farther(cloth[c], direction_of(i), &best);
        first->reach[i] = best.at;
    }
    tf_vector middle = fig_middle_of(FIG_CLOTH_REACH, first->reach);
    for (int i = 0; i < FIG_CLOTH_REACH; i++) {
        double out = fig_length(fig_difference(first->reach[i], middle));
        first->size = fmax(first->size, out);
    }
}

static bool begin_parts(fig_cloth *cloth)
{
    const fig_shape *shape = &cloth->shape;
    cloth->flat = cloth->flat && shape->triangles == 0;
    cloth->soft = calloc((size_t)shape->parts + 1, sizeof *cloth->soft);
    cloth->color = calloc((size_t)shape->parts + 1, sizeof *cloth->color);
    cloth->face = calloc((size_t)shape->triangles + 1, sizeof *cloth->face);
    cloth->hem = calloc((size_t)shape->triangles + 1, sizeof *cloth->hem);
    return cloth->soft && cloth->color && cloth->face && cloth->hem &&
           find_fronts(cloth);
}

bool fig_cloth_end(fig_cloth *cloth)
{
    TF_REQUIRE(cloth->frames > 0);
    fig_fit_points_alike(3, cloth->frames * cloth->shape.vertices, cloth->at);
    if (!begin_parts(cloth))
        return false;
    choose_colors(cloth);
    find_floor(cloth);
    find_reach(1, &cloth);
    find_bottom(1, &cloth);
    return fig_cloth_find_hems(cloth);
}

// Several films ----------------------------------------------------------

static int places_of(const fig_cloth *cloth)
{
    return cloth->frames * cloth->shape.vertices;
}

/// Fit the places of all into one box.
static bool fit_all(int count, fig_cloth *const cloth[])
{
    int all = 0;
    for (int c = 0; c < count; c++)
        all += places_of(cloth[c]);
    tf_vector *at = malloc(((size_t)all + 1) * sizeof *at), *next = at;
    for (int c = 0; c < count && at; next += places_of(cloth[c++]))
        memcpy(next, cloth[c]->at, (size_t)places_of(cloth[c]) * sizeof *at);
    if (at)
        fig_fit_points_alike(3, all, at);
    next = at;
    for (int c = 0; c < count && at; next += places_of(cloth[c++]))
        memcpy(cloth[c]->at, next, (size_t)places_of(cloth[c]) * sizeof *at);
    free(at);
    return at != NULL;
}

static void share_reach(fig_cloth *cloth, const fig_cloth *with)
{
    memcpy(cloth->reach, with->reach, sizeof cloth->reach);
    cloth->bottom = with->bottom;
    cloth->size = with->size;
}

bool fig_cloth_end_all(int count, fig_cloth *const cloth[])
{
    TF_REQUIRE(count > 0);
    if (!fit_all(count, cloth))
        return false;
    for (int c = 0; c < count; c++) {
        if (!begin_parts(cloth[c]))
            return false;
        memset(cloth[c]->soft, true,
               (size_t)cloth[c]->shape.parts * sizeof *cloth[c]->soft);
        cloth[c]->floor = -1;
    }
    find_reach(count, cloth);
    find_bottom(count, cloth);
    for (int c = 1; c < count; c++)
        share_reach(cloth[c], cloth[0]);
    return true;
}
