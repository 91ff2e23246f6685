// The curves along which a surface of space intersects itself.
#ifndef FIG_CURVE_PIECES_H
#define FIG_CURVE_PIECES_H

#include "kit/facets.h"
#include "renderer/scene.h"
#include "surface/check.h"

/// A piece of a curve: where two triangles intersect.
typedef struct fig_curve_piece {
    tf_vector at[2];
    int end[2];    ///< what is there: that crossing, or behind all crossings
                   ///< that vertex
    int vertex[2]; ///< one of each triangle
} fig_curve_piece;

typedef struct fig_curve_pieces {
    int count;
    fig_curve_piece *piece;
    int curves; ///< in how many connected curves the pieces are
} fig_curve_pieces;

/// Find the pieces of a surface whose vertices are at these places, where the
/// static check has found these crossings.  Of what only touches there is none.
/// False if there is no memory; they are to be freed in any case.
bool fig_curve_pieces_find(fig_curve_pieces *pieces, const fig_shape *shape,
                           const tf_vector at[], const tf_crossings *found);
void fig_curve_pieces_free(fig_curve_pieces *pieces);

/// Draw them as red tubes.
void fig_curve_pieces_draw(fig_scene *scene, const fig_curve_pieces *pieces,
                           double width);

#endif
