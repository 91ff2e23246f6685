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

/// Find the curves and zones of a surface, in its first position, where the
/// static check has found these crossings.  In a zone are the facets at both
/// elements of crossings, and those beside them; those that share a vertex or a
/// crossing are in the same zone.  False if there is no memory; they are to be
/// freed in any case.
bool fig_tangled_find(fig_tangled *tangled, const fig_shape *shape,
                      const tf_crossings *found);
void fig_tangled_free(fig_tangled *tangled);

#endif
