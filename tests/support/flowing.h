// Surfaces that flow, and the volumes that they enclose, exactly.
#ifndef SUPPORT_FLOWING_H
#define SUPPORT_FLOWING_H

#include "flow/flowing.h"

#include <gmp.h>

/// A sphere of 8 n^2 triangles around a center.
tf_adaptive *adaptive_sphere(int n, const double center[3], double radius);

/// One around the origin, of radius 1, whose vertices are off by up to `bump` in
/// each coordinate.
tf_adaptive *adaptive_bumpy_sphere(int n, double bump, uint64_t stream);

/// Begins a step in which that surface flows, which it then owns, with edges of
/// that length; some operations may be careless.
tf_flowing *flowing_begin(tf_adaptive *surface, double edge, unsigned careless);
void flowing_end(tf_flowing *of);

/// 6 times the volume that a surface encloses.
void exact_volume(const tf_adaptive *surface, mpq_t volume);

/// How much more a surface encloses than 1/6 of `before`, rounded.
double volume_gained(const tf_adaptive *surface, const mpq_t before);

/// Expects that a pass does something, and that the volume is kept up to
/// rounding, or else that it is not.
void expect_kept_volume(tf_flowing *of, tf_operation operation,
                        tf_status pass(tf_flowing *of), bool kept);

/// Expects that a surface does not meet itself, and closes its gaps.
void expect_embedded(tf_adaptive *surface);

#endif
