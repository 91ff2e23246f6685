// Light from a wide lamp and from the sky, with the shadows they cast.
//
// The lamp and the sky are many directions.  For each of them the triangles are
// drawn into a map, seen from there: what lies below the map is in the dark.
#ifndef FIG_SOFT_LIGHT_H
#define FIG_SOFT_LIGHT_H

#include "renderer/vector.h"

#include <stdbool.h>

/// A triangle that casts shadows.
typedef struct fig_caster {
    float at[3][3];
} fig_caster;

/// A point that is lit, on the side of a surface that its normal points to.
typedef struct fig_lit {
    float at[3], normal[3]; ///< the latter of length 1, or zero
    float lamp;             ///< from the lamp, 1: all of it, at a right angle
    float sky;              ///< from the sky, 1: all of it, on level ground
} fig_lit;

/// Find the light on `count` points among `casters` triangles; the third axis
/// is up, and `lamp` points to the middle of the lamp.  False if there is no
/// memory.
bool fig_light_softly(int count, fig_lit lit[], int casters,
                      const fig_caster caster[], tf_vector lamp);

#endif
