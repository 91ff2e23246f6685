//: Include what the normal needs
#include "intersect/normal.h"

#include "arithmetic/functions.h"
#include "arithmetic/value.h"

#include <math.h>

//: Gather the horizontal edges
/// Adds the edges that a simplex has within t = 0 and within t = 1.
static void add_horizontal_edges(const tf_simplex *simplex,
                                 tf_differences *edges)
{
    for (int i = 1; i < simplex->count; i++) {
        if (i == simplex->pivot + 1)
            continue;
        int first = i <= simplex->pivot ? 0 : simplex->pivot + 1;
        edges->to[edges->n] = simplex->event[i];
        edges->from[edges->n++] = simplex->event[first];
    }
}

//: Find the components of the cross product
/// False if a component is not known.
static bool multiply_edges(const tf_arithmetic *arithmetic, int axes,
                           tf_differences *edges, tf_value component[TF_AXES])
{
    if (axes == 3 && arithmetic->cross && arithmetic->cross(edges, component))
        return true;
    for (int k = 0; k < axes; k++) {
        // In the order k + 1, k + 2 of space the minors need no sign; in the
        // plane the left normal of (x, y) is (-y, x).
        for (int j = 0; j < axes - 1; j++)
            edges->axis[j] = (k + 1 + j) % axes;
        component[k] = arithmetic->value(edges);
        if (axes == 2 && k == 0)
            component[k].number = -component[k].number;
        if (!isfinite(component[k].number + component[k].radius))
            return false;
        component[k].radius = 0; // the direction is that of the numbers
    }
    return true;
}

//: Scale the cross product to length 1
static tf_vector direction(tf_value component[TF_AXES])
{
    tf_vector v = {{0, 0, 0}};
    tf_values_scale(TF_AXES, component);
    for (int k = 0; k < TF_AXES; k++)
        v.x[k] = component[k].number;
    double length = tf_vector_length(v);
    for (int k = 0; k < TF_AXES && length > 0; k++)
        v.x[k] /= length;
    return v;
}

//: Multiply the horizontal edges
tf_vector tf_contact_normal(const tf_arithmetic *arithmetic, int axes,
                            const tf_simplex *s, const tf_simplex *r)
{
    tf_differences edges;
    edges.n = 0;
    add_horizontal_edges(s, &edges);
    add_horizontal_edges(r, &edges);
    tf_value component[TF_AXES];
    component[TF_AXES - 1] = (tf_value){.number = 0};
    if (!multiply_edges(arithmetic, axes, &edges, component))
        return (tf_vector){{0, 0, 0}};
    return direction(component);
}
