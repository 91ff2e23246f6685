#include "soft_light.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum {
    SIDE = 320, ///< of a map, cells
    LAMP = 56,  ///< directions
    SKY = 104
};

/// The radius of the lamp as seen from one unit away.
static const double lamp_radius = 0.16;

static const double golden_angle = 2.399963229728653;

/// How far a point is moved off its surface, and how far what darkens it must
/// be above it, in cells: less, and a surface would darken itself.
static const float off_surface = 1.6F, above = 0.3F;

/// The triangles as seen from a direction: for each cell how high the highest
/// one is.
typedef struct map {
    float across[3], along[3], toward[3]; ///< cells per unit of length
    float origin[2];
    float height[SIDE][SIDE];
} map;

/// What the triangles are inside of.
typedef struct ball {
    float middle[3], radius;
} ball;

// Directions -------------------------------------------------------------

/// The i-th direction of the sky: they are spread evenly.
static tf_vector sky_direction(int i)
{
    double up = (i + 0.5) / SKY, out = sqrt(1 - up * up);
    return (tf_vector){
        {out * cos(golden_angle * i), out * sin(golden_angle * i), up}};
}

/// Two directions at right angles to each other and to one of length 1.
static void complete(tf_vector toward, tf_vector *across, tf_vector *along)
{
    tf_vector least = {{0}};
    least.x[fabs(toward.x[0]) < 0.5 ? 0 : 1] = 1;
    *across = fig_normalized(fig_cross(toward, least));
    *along = fig_cross(toward, *across);
}

static tf_vector lamp_direction(tf_vector lamp, int i)
{
    tf_vector across, along, middle = fig_normalized(lamp);
    complete(middle, &across, &along);
    double out = lamp_radius * sqrt((i + 0.5) / LAMP), turn = golden_angle * i;
    middle = fig_combination(middle, out * cos(turn), across);
    middle = fig_combination(middle, out * sin(turn), along);
    return fig_normalized(middle);
}

// Maps -------------------------------------------------------------------

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static ball ball_around(int casters, const fig_caster caster[])
{
    float lo[3] = {FLT_MAX, FLT_MAX, FLT_MAX};
    float hi[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    for (int i = 0; i < casters; i++)
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) {
                lo[k] = fminf(lo[k], caster[i].at[c][k]);
                hi[k] = fmaxf(hi[k], caster[i].at[c][k]);
            }
    ball all = {.radius = FLT_MIN};
    for (int k = 0; k < 3 && casters > 0; k++) {
        all.middle[k] = (lo[k] + hi[k]) / 2;
        all.radius = hypotf(all.radius, (hi[k] - lo[k]) / 2);
    }
    return all;
}

static void aim(map *m, const ball *all, tf_vector toward)
{
    tf_vector across, along;
    complete(toward, &across, &along);
    float cells = (SIDE - 2) / (2 * all->radius);
    for (int k = 0; k < 3; k++) {
        m->across[k] = cells * (float)across.x[k];
        m->along[k] = cells * (float)along.x[k];
        m->toward[k] = cells * (float)toward.x[k];
    }
    m->origin[0] = SIDE / 2.0F - dot(m->across, all->middle);
    m->origin[1] = SIDE / 2.0F - dot(m->along, all->middle);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            m->height[y][x] = -FLT_MAX;
}

/// Where a point is on a map, in cells: across, along and its height.
static void place_on(const map *m, const float at[3], float place[3])
{
    place[0] = dot(m->across, at) + m->origin[0];
    place[1] = dot(m->along, at) + m->origin[1];
    place[2] = dot(m->toward, at);
}

/// Twice the area of a triangle of the map, its sign by the way around.
static float area(const float a[3], const float b[3], const float c[3])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Raise the cells whose middles are in a triangle.
static void cover_cells(map *m, float corner[3][3])
{
    float whole = area(corner[0], corner[1], corner[2]);
    if (whole == 0)
        return;
    float lo[2], hi[2];
    for (int k = 0; k < 2; k++) {
        lo[k] = fminf(corner[0][k], fminf(corner[1][k], corner[2][k]));
        hi[k] = fmaxf(corner[0][k], fmaxf(corner[1][k], corner[2][k]));
    }
    for (int y = (int)(lo[1] + 0.5F); (float)y + 0.5F <= hi[1]; y++)
        for (int x = (int)(lo[0] + 0.5F); (float)x + 0.5F <= hi[0]; x++) {
            const float p[3] = {(float)x + 0.5F, (float)y + 0.5F, 0};
            float a = area(p, corner[1], corner[2]) / whole;
            float b = area(corner[0], p, corner[2]) / whole;
            float c = 1 - a - b;
            if (a >= 0 && b >= 0 && c >= 0)
                m->height[y][x] =
                    fmaxf(m->height[y][x], a * corner[0][2] + b * corner[1][2] +
                                               c * corner[2][2]);
        }
}

static void draw_map(map *m, const ball *all, tf_vector toward, int casters,
                     const fig_caster caster[])
{
    aim(m, all, toward);
    for (int i = 0; i < casters; i++) {
        float corner[3][3];
        for (int c = 0; c < 3; c++)
            place_on(m, caster[i].at[c], corner[c]);
        cover_cells(m, corner);
    }
}

static bool in_the_dark(const map *m, const fig_lit *point)
{
    float place[3], off = off_surface / sqrtf(dot(m->toward, m->toward));
    const float at[3] = {point->at[0] + off * point->normal[0],
                         point->at[1] + off * point->normal[1],
                         point->at[2] + off * point->normal[2]};
    place_on(m, at, place);
    bool inside =
        place[0] >= 0 && place[0] < SIDE && place[1] >= 0 && place[1] < SIDE;
    return inside && m->height[(int)place[1]][(int)place[0]] > place[2] + above;
}

// Light ------------------------------------------------------------------

/// How much of the light from a map's direction falls on a point, 0 to 1.
static float light_from(const map *m, const fig_lit *point)
{
    float facing = dot(m->toward, point->normal);
    if (facing <= 0 || in_the_dark(m, point))
        return 0;
    return facing / sqrtf(dot(m->toward, m->toward));
}

bool fig_light_softly(int count, fig_lit lit[], int casters,
                      const fig_caster caster[], tf_vector lamp)
{
    map *m = malloc(sizeof *m);
    if (!m)
        return false;
    for (int i = 0; i < count; i++)
        lit[i].lamp = lit[i].sky = 0;
    ball all = ball_around(casters, caster);
    for (int i = 0; i < LAMP; i++) {
        draw_map(m, &all, lamp_direction(lamp, i), casters, caster);
        for (int k = 0; k < count; k++)
            lit[k].lamp += light_from(m, &lit[k]) / LAMP;
    }
    for (int i = 0; i < SKY; i++) {
        draw_map(m, &all, sky_direction(i), casters, caster);
        for (int k = 0; k < count; k++)
            lit[k].sky += 2 * light_from(m, &lit[k]) / SKY;
    }
    free(m);
    return true;
}
