//: Declare the passes
#pragma once

#include "remesh/remesher.h"

/// Goes once through the surface with one operation: splits long edges, the
/// longest first; collapses short ones, the shortest first; flips edges, the
/// longest first; or smooths vertices.  Returns TF_OK or what went wrong.
tf_status tf_remesh_pass(tf_remesher *remesher, tf_operation operation);

/// Goes through all passes as the policy says: in its order, each until it does
/// nothing or for the last time.  Returns TF_OK or what went wrong.
tf_status tf_remesh_round(tf_remesher *remesher);
