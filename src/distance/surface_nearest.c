//: Include what the nearest point of a surface needs
#include "distance/surface_nearest.h"

#include "base/environment.h"
#include "base/fail.h"
#include "base/require.h"
#include "distance/nearest.h"

#include <math.h>
#include <stddef.h>

//: Pass by elements that are too far
typedef struct nearest_search {
    int axes;
    const double *position, *point;
    tf_surface_point best;
} nearest_search;

static const double *place_of(const nearest_search *search, int vertex)
{
    return search->position + (ptrdiff_t)search->axes * vertex;
}

/// Whether a box around an element is certainly farther than the best point.
static bool is_farther(const nearest_search *search, int corners,
                       const int corner[])
{
    for (int k = 0; k < search->axes; k++) {
        double low = INFINITY, high = -INFINITY, x = search->point[k];
        for (int c = 0; c < corners; c++) {
            low = fmin(low, place_of(search, corner[c])[k]);
            high = fmax(high, place_of(search, corner[c])[k]);
        }
        // Rounding has lost less than this of a difference.
        if (fmax(low - x, x - high) * (1 - 0x1p-50) > search->best.upper)
            return true;
    }
    return false;
}

//: Measure the distance of an element
/// An element with fewer corners is a triangle, or in the plane an edge, that has
/// its last one more than once.
static tf_surface_point measure_element(const nearest_search *search,
                                        int corners, const int corner[])
{
    const double *x[4] = {search->point};
    for (int i = 0; i < search->axes; i++)
        x[1 + i] = place_of(search, corner[i < corners ? i : corners - 1]);
    tf_nearest found =
        tf_nearest_of(search->axes == 2 ? TF_POINT_EDGE : TF_POINT_TRIANGLE, x);
    tf_surface_point own = {.corners = corners,
                            .vertex = {-1, -1, -1},
                            .lower = found.lower,
                            .upper = found.upper};
    for (int i = 0; i < corners; i++)
        own.vertex[i] = corner[i];
    for (int i = 0; i < search->axes; i++)
        own.barycentric[i < corners ? i : corners - 1] +=
            found.barycentric[1][i];
    return own;
}

//: Visit all elements
static void visit_elements(nearest_search *search, int corners, int count,
                           const int *corner)
{
    for (int i = 0; i < count; i++) {
        const int *own = corner ? corner + (ptrdiff_t)corners * i : &i;
        if (is_farther(search, corners, own))
            continue;
        tf_surface_point found = measure_element(search, corners, own);
        if (found.upper < search->best.upper || search->best.corners == 0)
            search->best = found;
    }
}

//: Check the positions of a surface
static tf_status check_positions(const tf_surface *surface, int vertices,
                                 const double position[], const double point[],
                                 tf_error *error)
{
    int axes = tf_surface_axes(surface);
    if (vertices != tf_surface_vertices(surface))
        return tf_fail(error, TF_BAD_COUNT);
    if (!tf_environment_is_ieee())
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    for (int k = 0; k < axes; k++)
        if (!isfinite(point[k]))
            return tf_fail(error, TF_NOT_FINITE);
    for (ptrdiff_t i = 0; i < (ptrdiff_t)axes * vertices; i++)
        if (!isfinite(position[i]))
            return tf_fail_vertex(error, TF_NOT_FINITE, (int)(i / axes), -1);
    return tf_fail(error, TF_OK);
}

//: Find the nearest point of a surface
tf_status tf_surface_nearest(const tf_surface *surface, int vertices,
                             const double position[], const double point[],
                             tf_surface_point *nearest, tf_error *error)
{
    TF_REQUIRE(surface && position && point && nearest);
    tf_status status =
        check_positions(surface, vertices, position, point, error);
    if (status != TF_OK)
        return status;
    nearest_search search = {.axes = tf_surface_axes(surface),
                             .position = position,
                             .point = point,
                             .best = {.upper = INFINITY}};
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    visit_elements(&search, 3, triangles, triangle);
    visit_elements(&search, 2, edges, edge);
    visit_elements(&search, 1, vertices, NULL);
    *nearest = search.best;
    return TF_OK;
}
