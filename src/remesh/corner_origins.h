//: Declare the origins of corners
#pragma once

#include "base/status.h"
#include "remesh/remesher.h"

/// Finds for each corner of a remeshed surface where its vertex comes from, on
/// its side of sharp edges: see tf_adaptive_corner_origins.  Returns TF_OK,
/// TF_OUT_OF_MEMORY or TF_CANCELLED.
/// @param remesher with a trace; its surface and original have no gaps
/// @param[out] origin tf_origin of each corner; to be freed in any case
tf_status tf_corner_origins_find(const tf_remesher *remesher,
                                 tf_buffer *origin);
