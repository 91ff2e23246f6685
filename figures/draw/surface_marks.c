#include "draw/surface_marks.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

static float *never(int count)
{
    float *time = malloc(((size_t)count + 1) * sizeof *time);
    for (int i = 0; time && i < count; i++)
        time[i] = FIG_NEVER;
    return time;
}

static bool begin(fig_marks *marks, const fig_shape *shape, size_t count)
{
    *marks = (fig_marks){.count = (int)count, .toi_lo = FIG_NEVER};
    if (count >= INT_MAX)
        return false;
    marks->spot = malloc((count + 1) * sizeof *marks->spot);
    marks->edge = never(shape->edges);
    marks->triangle = never(shape->triangles);
    return marks->spot && marks->edge && marks->triangle;
}

void fig_marks_free(fig_marks *marks)
{
    free(marks->spot);
    free(marks->edge);
    free(marks->triangle);
    *marks = (fig_marks){0};
}

/// Mark an element from a time on; of a single vertex nothing but the spot is
/// seen.
static void mark_element(fig_marks *marks, const fig_shape *shape, int vertices,
                         const int vertex[], double toi)
{
    float *time = vertices == 2 ? &marks->edge[fig_shape_edge(shape, vertex)]
                  : vertices == 3
                      ? &marks->triangle[fig_shape_triangle(shape, vertex)]
                      : NULL;
    if (time)
        *time = fminf(*time, (float)toi);
}

// Contacts ---------------------------------------------------------------

/// How many vertices the elements of a pair have: `others` is the rest.
static int first_vertices(tf_kind kind)
{
    return kind == TF_EDGE_EDGE ? 2 : 1;
}

static void mark_contact(fig_marks *marks, const fig_shape *shape, int i,
                         const tf_surface_contact *found)
{
    const tf_contact *contact = &found->contact;
    int first = first_vertices(found->kind);
    int second = (found->vertex[3] < 0 ? 3 : 4) - first;
    double toi = (contact->toi_lo + contact->toi_hi) / 2;
    fig_spot *spot = &marks->spot[i];
    *spot = (fig_spot){.vertices = first, .toi = toi};
    for (int k = 0; k < first; k++) {
        spot->vertex[k] = found->vertex[k];
        spot->weight[k] = contact->barycentric[0][k];
    }
    mark_element(marks, shape, first, found->vertex, toi);
    mark_element(marks, shape, second, found->vertex + first, toi);
    if (contact->toi_lo < marks->toi_lo) {
        marks->toi_lo = contact->toi_lo;
        marks->toi_hi = contact->toi_hi;
    }
}

bool fig_marks_of_contacts(fig_marks *marks, const fig_shape *shape,
                           const tf_contacts *contacts)
{
    bool good = begin(marks, shape, contacts->count);
    for (int i = 0; good && i < marks->count; i++)
        mark_contact(marks, shape, i, &contacts->contact[i]);
    return good;
}

// Intersections ----------------------------------------------------------

/// Of the vector from the origin and the plane of two others.
static double triple(tf_vector a, tf_vector b, tf_vector c)
{
    return tf_vector_dot(a, fig_cross(b, c));
}

/// How far along a segment whose ends have these distances, to either side of
/// something, it meets that.
static double along(double start, double end)
{
    double all = start - end;
    return all == 0 ? 0.5 : fmax(0, fmin(start / all, 1));
}

/// Where an edge passes through the plane of a triangle.
static double pierce(const tf_vector edge[2], const tf_vector corner[3])
{
    tf_vector u = fig_difference(corner[1], corner[0]);
    tf_vector v = fig_difference(corner[2], corner[0]);
    return along(triple(fig_difference(edge[0], corner[0]), u, v),
                 triple(fig_difference(edge[1], corner[0]), u, v));
}

/// Where an edge passes the other one, as seen along the normal of both.
static double pass(const tf_vector edge[2], const tf_vector other[2])
{
    tf_vector v = fig_difference(other[1], other[0]);
    tf_vector n = fig_cross(fig_difference(edge[1], edge[0]), v);
    return along(triple(fig_difference(edge[0], other[0]), v, n),
                 triple(fig_difference(edge[1], other[0]), v, n));
}

/// How many vertices the first element of an intersection has, and the second.
static void count_vertices(tf_crossing_kind kind, int count[2])
{
    count[0] = kind == TF_POINT_ON_TRIANGLE ? 1 : 2;
    count[1] = kind == TF_EDGE_ON_EDGE ? 2 : 3;
}

static void mark_crossing(fig_marks *marks, const fig_shape *shape, int i,
                          const tf_crossing *found)
{
    int count[2];
    count_vertices(found->kind, count);
    tf_vector place[5];
    for (int k = 0; k < count[0] + count[1]; k++)
        place[k] = shape->at[0][found->vertex[k]];
    double weight = found->kind == TF_POINT_ON_TRIANGLE ? 0
                    : found->kind == TF_EDGE_ON_EDGE    ? pass(place, place + 2)
                                                     : pierce(place, place + 2);
    marks->spot[i] = (fig_spot){.vertices = count[0],
                                .vertex = {found->vertex[0], found->vertex[1]},
                                .weight = {1 - weight, weight}};
    mark_element(marks, shape, count[0], found->vertex, 0);
    mark_element(marks, shape, count[1], found->vertex + count[0], 0);
}

bool fig_marks_of_crossings(fig_marks *marks, const fig_shape *shape,
                            const tf_crossings *crossings)
{
    bool good = begin(marks, shape, crossings->count);
    marks->at_rest = true;
    for (int i = 0; good && i < marks->count; i++)
        mark_crossing(marks, shape, i, &crossings->crossing[i]);
    return good;
}
