//: Include what polygons need
#include "formats/polygon.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

//: Take the corners of a polygon
static bool make_corner_room(tf_polygon *polygon, int count)
{
    if (count <= polygon->room)
        return true;
    tf_corner *moved = realloc(polygon->corner, sizeof *moved * (size_t)count);
    if (moved)
        *polygon = (tf_polygon){.corner = moved, .room = count};
    return moved;
}

/// The corner of the least index.
static int find_first(int count, const int vertex[])
{
    int first = 0;
    for (int i = 1; i < count; i++)
        if (vertex[i] < vertex[first])
            first = i;
    return first;
}

static void link_corners(tf_polygon *polygon, int count, const int vertex[])
{
    int first = find_first(count, vertex);
    polygon->count = count;
    for (int i = 0; i < count; i++) {
        int at = first + i < count ? first + i : first + i - count;
        polygon->corner[i] = (tf_corner){.vertex = vertex[at],
                                         .before = i > 0 ? i - 1 : count - 1,
                                         .next = i < count - 1 ? i + 1 : 0};
    }
}

//: Place the corners of a polygon
/// A power of two by which all coordinates are so large, or so small, that
/// products neither overflow nor vanish, whatever the unit.
static double find_scale(const tf_polygon *polygon, const double position[])
{
    double largest = 0;
    for (int i = 0; i < polygon->count; i++)
        for (int k = 0; k < 3; k++)
            largest = fmax(largest,
                           fabs(position[3 * polygon->corner[i].vertex + k]));
    int exponent;
    frexp(largest, &exponent);
    return ldexp(1, -(exponent < -1000  ? -1000
                      : exponent > 1000 ? 1000
                                        : exponent));
}

static void place_corners(const tf_polygon *polygon, const double position[])
{
    double scale = find_scale(polygon, position);
    const double *origin = position + (ptrdiff_t)3 * polygon->corner[0].vertex;
    for (int i = 0; i < polygon->count; i++) {
        tf_corner *corner = &polygon->corner[i];
        const double *x = position + (ptrdiff_t)3 * corner->vertex;
        for (int k = 0; k < 3; k++)
            corner->x[k] = scale * x[k] - scale * origin[k];
    }
}

//: Choose the plane of a polygon
/// Twice the area of the projection along an axis.
static double projected_area(const tf_polygon *polygon, int axis)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double sum = 0;
    for (int i = 1; i < polygon->count - 1; i++) {
        const double *p = polygon->corner[i].x, *q = polygon->corner[i + 1].x;
        sum += p[u] * q[v] - p[v] * q[u];
    }
    return sum;
}

static void choose_plane(tf_polygon *polygon)
{
    double largest = projected_area(polygon, 0);
    int chosen = 0;
    for (int k = 1; k < 3; k++) {
        double area = projected_area(polygon, k);
        if (fabs(area) > fabs(largest)) {
            largest = area;
            chosen = k;
        }
    }
    bool turned = largest < 0;
    polygon->axis[turned] = (chosen + 1) % 3;
    polygon->axis[!turned] = (chosen + 2) % 3;
}

//: Find out how corners turn
/// Twice the area of the triangle of three corners, above 0 if it turns as the
/// polygon does.
static double area_of(const tf_polygon *polygon, int i, int j, int k)
{
    int u = polygon->axis[0], v = polygon->axis[1];
    const double *a = polygon->corner[i].x, *b = polygon->corner[j].x;
    const double *c = polygon->corner[k].x;
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

static bool fan_is_good(const tf_polygon *polygon)
{
    bool good = true;
    for (int i = 1; i < polygon->count - 1 && good; i++)
        good = area_of(polygon, 0, i, i + 1) > 0;
    return good;
}

//: Find ears
/// Whether a triangle holds a corner, perhaps on its boundary.
static bool holds(const tf_polygon *polygon, int i, int j, int k, int corner)
{
    return area_of(polygon, i, j, corner) >= 0 &&
           area_of(polygon, j, k, corner) >= 0 &&
           area_of(polygon, k, i, corner) >= 0;
}

/// If a triangle holds corners, one of them is not convex.
static bool is_free(const tf_polygon *polygon, int i, int j, int k)
{
    bool is_free = true;
    for (int other = polygon->corner[k].next; other != i && is_free;
         other = polygon->corner[other].next)
        is_free =
            polygon->corner[other].is_convex || !holds(polygon, i, j, k, other);
    return is_free;
}

static void mark_turn(const tf_polygon *polygon, int i)
{
    tf_corner *corner = &polygon->corner[i];
    corner->is_convex = area_of(polygon, corner->before, i, corner->next) > 0;
}

static void mark_ear(const tf_polygon *polygon, int i)
{
    tf_corner *corner = &polygon->corner[i];
    corner->is_ear =
        corner->is_convex && is_free(polygon, corner->before, i, corner->next);
}

static void mark_corners(const tf_polygon *polygon)
{
    for (int i = 0; i < polygon->count; i++)
        mark_turn(polygon, i);
    for (int i = 0; i < polygon->count; i++)
        mark_ear(polygon, i);
}

//: Cut off an ear
static int *put_triangle(const tf_polygon *polygon, int i, int j, int k,
                         int triangle[])
{
    triangle[0] = polygon->corner[i].vertex;
    triangle[1] = polygon->corner[j].vertex;
    triangle[2] = polygon->corner[k].vertex;
    return triangle + 3;
}

/// Afterward its neighbors may be ears.  No other corner becomes one: of those
/// that keep it from that, one stays that is not convex.
static void cut_off(const tf_polygon *polygon, int ear)
{
    int before = polygon->corner[ear].before, next = polygon->corner[ear].next;
    polygon->corner[before].next = next;
    polygon->corner[next].before = before;
    mark_turn(polygon, before);
    mark_turn(polygon, next);
    mark_ear(polygon, before);
    mark_ear(polygon, next);
}

//: Cut off all ears
/// The first corner that is left, from `first` on, which moves if it is cut off.
static int find_ear(const tf_polygon *polygon, int first)
{
    int at = first;
    while (!polygon->corner[at].is_ear) {
        at = polygon->corner[at].next;
        if (at == first)
            return -1;
    }
    return at;
}

/// Cuts ears until a triangle is left, or no ear; returns the first corner that
/// is left.
static int cut_ears(const tf_polygon *polygon, int **triangle)
{
    int first = 0;
    mark_corners(polygon);
    for (int left = polygon->count; left > 3; left--) {
        int ear = find_ear(polygon, first);
        if (ear < 0)
            break;
        const tf_corner *corner = &polygon->corner[ear];
        *triangle =
            put_triangle(polygon, corner->before, ear, corner->next, *triangle);
        first = ear == first ? corner->next : first;
        cut_off(polygon, ear);
    }
    return first;
}

//: Divide a polygon
static void put_fan(const tf_polygon *polygon, int first, int triangle[])
{
    const tf_corner *corner = polygon->corner;
    for (int i = corner[first].next; corner[i].next != first;
         i = corner[i].next)
        triangle = put_triangle(polygon, first, i, corner[i].next, triangle);
}

bool tf_polygon_divide(tf_polygon *polygon, const double position[], int count,
                       const int vertex[], int triangle[])
{
    if (!make_corner_room(polygon, count))
        return false;
    link_corners(polygon, count, vertex);
    place_corners(polygon, position);
    choose_plane(polygon);
    int first = fan_is_good(polygon) ? 0 : cut_ears(polygon, &triangle);
    put_fan(polygon, first, triangle);
    return true;
}

void tf_polygon_free(tf_polygon *polygon)
{
    free(polygon->corner);
    *polygon = (tf_polygon){0};
}
