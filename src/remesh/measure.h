//: Declare what is measured of triangles
#pragma once

#include "base/error.h"
#include "geometry/vector.h"
#include "surgery/adaptive_surface.h"

#include <math.h>

// All of this is rounded: it decides what is wanted, never what is safe.  It is
// in the surface's own unit, its scale times that of the coordinates.

static inline tf_vector tf_position_of(const tf_adaptive_surface *surface,
                                       int vertex)
{
    return tf_vector_scaled(
        surface->scale,
        tf_vector_at(tf_vertex_coordinates(surface, vertex), 0));
}

/// The coordinates of a measured position.
static inline tf_vector tf_coordinates_of(const tf_adaptive_surface *surface,
                                          tf_vector position)
{
    return tf_vector_scaled(1 / surface->scale, position);
}

double tf_length_of(const tf_adaptive_surface *surface, int a, int b);

/// The point in the middle between two vertices.
tf_vector tf_middle_of(const tf_adaptive_surface *surface, int a, int b);

//: Declare what is measured of a triangle
/// The corners of a triangle.
typedef struct tf_shape {
    tf_vector corner[3];
} tf_shape;

tf_shape tf_shape_of(const tf_adaptive_surface *surface, int triangle);

/// The normal, as long as twice the area.
tf_vector tf_shape_normal(const tf_shape *shape);

/// From 0, for a triangle without area, to 1, for an equilateral one: the area
/// over the sum of the squares of its sides, scaled.
double tf_shape_quality(const tf_shape *shape);

/// The quality of the worse of two triangles.
double tf_worse_quality(const tf_shape pair[2]);

/// Whether the angle between two normals has at least this cosine.
bool tf_normals_agree(tf_vector a, tf_vector b, double cosine);

//: Declare what is measured of a star
/// The mean of the middles of the triangles at a vertex, weighted by their
/// areas.
tf_vector tf_star_middle(const tf_adaptive_surface *surface, int vertex);

/// Whether the triangles at a vertex, but for those at `other` too, would be
/// good if it were at a position: not turned over, and no worse than the worst
/// that there is now or a fair triangle.
bool tf_star_stays_good(const tf_adaptive_surface *surface, int vertex,
                        int other, tf_vector position);

//: Declare what can be measured
/// Sets the scale of a surface to the power of two, from 2^-1000 to 2^1000, by
/// which its greatest coordinate gets nearest below 1.
void tf_choose_scale(tf_adaptive_surface *surface);

/// The largest coordinates in the user's unit, in absolute value.
#define TF_MOST_FOR_LENGTHS 0x1p1000 ///< if lengths are reported in that unit
#define TF_MOST_FOR_VOLUMES 0x1p250  ///< if volumes are, or contacts resolved

/// Checks that no vertex of a triangle has a coordinate above `most` in absolute
/// value.  Sets the error to what it returns, TF_OK or TF_OUT_OF_RANGE.
tf_status tf_check_coordinates(const tf_adaptive_surface *surface, double most,
                               tf_error *error);

/// Checks that the length of edges is above 0 and finite, and not so short that
/// there would be more triangles than numbers for their corners.  Sets the error
/// to what it returns, TF_OK or TF_BAD_OPTION.
tf_status tf_check_target(const tf_adaptive_surface *surface, double edge,
                          tf_error *error);
