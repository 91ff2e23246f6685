//: Declare the way home
#pragma once

#include "response/resolver.h"
#include "untangle/tangle.h"

/// Room for the way home.
typedef struct tf_way_home {
    double *end;  ///< where a step ends
    double *mass; ///< of each vertex: its inverse mass, 0 if it is fixed
    bool *meets;  ///< of each vertex: whether it meets something on the way
    int steps;    ///< how many steps were taken
    tf_buffer storage;
} tf_way_home;

/// Brings vertices from a clear state x back towards `in`, by steps in which
/// nothing meets, and each of which lowers the sum of the squares of the
/// distances from `in`.  At last, those that meet nothing are sent to `in`
/// itself, bit for bit.  Fixed vertices stay.  The surface is that of the tangle.
/// @return TF_OK, or what else tf_step_resolve and tf_surface_detect return;
///     after all of these, x is where the last step has ended
tf_status tf_way_home_take(tf_way_home *way, tf_resolver *resolver,
                           const tf_tangle *tangle, double x[]);

void tf_way_home_free(tf_way_home *way);
