// Where a surface at rest intersects itself, as it is drawn.
#ifndef FIG_DRAW_SURFACE_TANGLE_H
#define FIG_DRAW_SURFACE_TANGLE_H

#include "kit/curve_pieces.h"

/// The curves of a surface of space, and the zones around its intersections.
typedef struct fig_tangled {
    fig_curve_pieces curves; ///< in the plane none
    bool *touches; ///< of each crossing: it is a point alone, of no curve
    int zones;
    int *
        zone; ///< of each triangle, in the plane of each edge: the zone that it
              ///< is in, numbered from 0; -1: none
} fig_tangled;

/// Find the intersections of a surface at rest, which is drawn as `shape`, their
/// curves, and the zones of tf_surface_zones with a ring.  Returns what that
/// does; they are to be freed in any case.
tf_status fig_tangled_find(fig_tangled *tangled, tf_surface *surface,
                           const fig_shape *shape, const double position[],
                           const tf_check_options *options, tf_crossings *found,
                           tf_error *error);
void fig_tangled_free(fig_tangled *tangled);

#endif
