// Surfaces that flow, and the volumes that they enclose, exactly.
#ifndef SUPPORT_FLOWS_H
#define SUPPORT_FLOWS_H

#include "flow/flow_state.h"

#include <gmp.h>

/// A sphere of 8 n^2 triangles around a center.
tf_adaptive_surface *adaptive_sphere(int n, const double center[3],
                                     double radius);

/// One around the origin, of radius 1, whose vertices are off by up to `bump` in
/// each coordinate.
tf_adaptive_surface *adaptive_bumpy_sphere(int n, double bump, uint64_t stream);

/// Begins a step in which that surface flows, which it then owns, with edges of
/// that length; some operations may be careless.
tf_flow_state *flow_begin(tf_adaptive_surface *surface, double edge,
                          unsigned careless);
void flow_end(tf_flow_state *flow);

/// 6 times the volume that a surface encloses.
void exact_volume(const tf_adaptive_surface *surface, mpq_t volume);

/// How much more a surface encloses than 1/6 of `before`, rounded.
double volume_gained(const tf_adaptive_surface *surface, const mpq_t before);

/// Expects that a pass does something, and that the volume is kept up to
/// rounding, or else that it is not.
void expect_kept_volume(tf_flow_state *flow, tf_operation operation,
                        tf_status pass(tf_flow_state *flow), bool kept);

/// Expects that a surface does not meet itself, and closes its gaps.
void expect_embedded(tf_adaptive_surface *surface);

#endif
