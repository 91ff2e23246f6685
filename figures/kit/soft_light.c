#include "kit/soft_light.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 256, ///< of a map, cells
    LAMP = 64,  ///< directions
    SKY = 60
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
    float across[3], along[3]; ///< cells per unit of length
    float toward[3];           ///< the direction, of length 1
    float middle[3];           ///< what is seen in the middle of the map
    float cell;                ///< its side, in units of length
    float height[SIDE][SIDE];
} map;

/// What the triangles are inside of, so that all of them are on a map.
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
    ball all = {.radius = 1e-30F}; // whose inverse is a float, too
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
        m->toward[k] = (float)toward.x[k];
    }
    m->cell = 1 / cells;
    memcpy(m->middle, all->middle, sizeof m->middle);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            m->height[y][x] = -FLT_MAX;
}

/// Where a point is on a map: across and along, in cells, and its height.
static void place_on(const map *m, const float at[3], float place[3])
{
    const float off[3] = {at[0] - m->middle[0], at[1] - m->middle[1],
                          at[2] - m->middle[2]};
    place[0] = dot(m->across, off) + SIDE / 2.0F;
    place[1] = dot(m->along, off) + SIDE / 2.0F;
    place[2] = dot(m->toward, off);
}

/// Twice the area of a triangle of the map, its sign by the way around.
static float area(const float a[3], const float b[3], const float c[3])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Raise the cells of a row, from x to `end`, whose middles are in a triangle.
/// The shares that its first two corners have in a point grow evenly.
static void cover_row(map *m, int y, int x, int end, const float *const at[3],
                      float whole)
{
    const float p[3] = {(float)x + 0.5F, (float)y + 0.5F, 0};
    float a = area(p, at[1], at[2]) / whole, b = area(at[0], p, at[2]) / whole;
    float a_step = (at[1][1] - at[2][1]) / whole;
    float b_step = (at[2][1] - at[0][1]) / whole;
    float a_rise = at[0][2] - at[2][2], b_rise = at[1][2] - at[2][2];
    for (float *cell = m->height[y] + x; x < end; x++, cell++) {
        float height = at[2][2] + a * a_rise + b * b_rise;
        if (a >= 0 && b >= 0 && a + b <= 1 && height > *cell)
            *cell = height;
        a += a_step;
        b += b_step;
    }
}

static float least(float a, float b, float c)
{
    return fminf(a, fminf(b, c));
}

/// Raise the cells whose middles are in a triangle.
static void cover_cells(map *m, const float *const at[3])
{
    float whole = area(at[0], at[1], at[2]);
    int begin[2], end[2];
    for (int k = 0; k < 2; k++) {
        begin[k] = (int)(least(at[0][k], at[1][k], at[2][k]) + 0.5F);
        end[k] = (int)(0.5F - least(-at[0][k], -at[1][k], -at[2][k]));
    }
    for (int y = begin[1]; y < end[1] && whole != 0; y++)
        cover_row(m, y, begin[0], end[0], at, whole);
}

static void draw_map(map *m, const ball *all, tf_vector toward, int casters,
                     const fig_caster caster[])
{
    aim(m, all, toward);
    for (int i = 0; i < casters; i++) {
        float corner[3][3];
        for (int c = 0; c < 3; c++)
            place_on(m, caster[i].at[c], corner[c]);
        cover_cells(m, (const float *const[]){corner[0], corner[1], corner[2]});
    }
}

static bool in_the_dark(const map *m, const fig_lit *point)
{
    float place[3], off = off_surface * m->cell;
    const float at[3] = {point->at[0] + off * point->normal[0],
                         point->at[1] + off * point->normal[1],
                         point->at[2] + off * point->normal[2]};
    place_on(m, at, place);
    bool inside =
        place[0] >= 0 && place[0] < SIDE && place[1] >= 0 && place[1] < SIDE;
    return inside &&
           m->height[(int)place[1]][(int)place[0]] > place[2] + above * m->cell;
}

// Light ------------------------------------------------------------------

/// How much of the light from a map's direction falls on a point, 0 to 1.
static float light_from(const map *m, const fig_lit *point)
{
    float facing = dot(m->toward, point->normal);
    return facing <= 0 || in_the_dark(m, point) ? 0 : facing;
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
