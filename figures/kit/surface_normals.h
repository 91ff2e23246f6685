// Normals to light a surface by: smooth where it is, hard at its creases.
#ifndef FIG_SURFACE_NORMALS_H
#define FIG_SURFACE_NORMALS_H

#include "kit/surface_shape.h"

/// The normals of a surface in one position.
typedef struct fig_normals {
    float (*triangle)[3]; ///< of each triangle, twice its area long
    float (*corner)[3];   ///< of its three corners, of length 1; where its area
                          ///< is 0, zero
    bool *crease; ///< of each edge: whether it is a border, or joins more
                  ///< than two triangles, or bends sharply
} fig_normals;

/// Find the normals of a shape with its vertices at the time t, moved in
/// straight lines.  In the parts for which `soft` is true no bend is sharp; NULL:
/// there are none.  Which of its two sides a triangle's normal points to is
/// arbitrary, and those of its corners do as it does.  False if there is no
/// memory; they are to be freed in any case.
bool fig_normals_find(fig_normals *normals, const fig_shape *shape, double t,
                      const bool soft[]);
void fig_normals_free(fig_normals *normals);

#endif
