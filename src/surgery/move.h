//: Declare how a vertex is put elsewhere
#pragma once

#include "surgery/state.h"

/// Puts a vertex elsewhere, untested.
void tf_vertex_put(tf_adaptive_surface *surface, int vertex,
                   const double place[3]);
