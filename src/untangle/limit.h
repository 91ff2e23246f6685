//: Declare how a round is limited
#pragma once

#include "untangle/scope.h"

/// Shortens the moves of a round until no pair outside of the scope's zones meets
/// on the way from x, and sets `to` to where the vertices end.  Fixed vertices
/// stay.  Returns TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED, or what else
/// tf_surface_detect does.
tf_status tf_limit_moves(const tf_tangle *tangle, const tf_scope *scope,
                         const double x[], tf_vector move[], double to[]);
