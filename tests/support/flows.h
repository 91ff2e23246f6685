// Spheres of triangles, and the volumes that surfaces enclose, exactly.
#ifndef SUPPORT_FLOWS_H
#define SUPPORT_FLOWS_H

#include "surgery/adaptive.h"

#include <gmp.h>
#include <stdint.h>

/// A sphere of 8 n^2 triangles around a center.
tf_adaptive_surface *adaptive_sphere(int n, const double center[3],
                                     double radius);

/// One around the origin, of radius 1, whose vertices are off by up to `bump` in
/// each coordinate.
tf_adaptive_surface *adaptive_bumpy_sphere(int n, double bump, uint64_t stream);

/// 6 times the volume that a surface encloses.
void exact_volume(const tf_adaptive_surface *surface, mpq_t volume);

/// How much more a surface encloses than 1/6 of `before`, rounded.
double volume_gained(const tf_adaptive_surface *surface, const mpq_t before);

/// Expects that a surface does not meet itself, and closes its gaps.
void expect_embedded(tf_adaptive_surface *surface);

#endif
