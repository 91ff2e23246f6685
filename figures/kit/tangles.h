// Surfaces that intersect themselves, made to be untangled.
#ifndef FIG_TANGLES_H
#define FIG_TANGLES_H

#include "kit/meshes.h"
#include "renderer/camera.h"

#include <stdbool.h>

/// A surface, and which of its vertices have to stay.
typedef struct fig_tangle {
    fig_some_mesh mesh;
    bool *fixed;       ///< of each vertex; NULL: none has to
    fig_camera camera; ///< that shows it well
} fig_tangle;

/// The name of the i-th of them, from 0 on; NULL beyond the last one.
const char *fig_tangle_name(int i);

/// Make the one of that name, which must be among them.
fig_tangle fig_tangle_make(const char *name);
void fig_tangle_free(fig_tangle *tangle);

#endif
