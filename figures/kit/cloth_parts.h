// What a film of cloth is made of: its frames in cloth.c, its stripes in
// cloth_hems.c, its picture in cloth_picture.c.
#ifndef FIG_CLOTH_PARTS_H
#define FIG_CLOTH_PARTS_H

#include "kit/cloth.h"

enum {
    FIG_CLOTH_REACH = 96
};

struct fig_cloth {
    const tf_surface *surface;
    int axes; ///< of what is added
    fig_up up;
    bool flat;       ///< a curve of the plane
    fig_shape shape; ///< of the first frame
    tf_vector *at;   ///< of all vertices, frame by frame
    int frames, room;
    bool *obstacle; ///< of each part: it is one; NULL: they are not known
    bool *soft; ///< of each part: it is no obstacle or, if these are not known
                ///< or are all, it does not keep its shape or, if all do, its
                ///< place; if all do that, too, all parts are
    int *color; ///< of each part: counted among the soft ones
    int floor;  ///< a part; -1: there is none
    signed char *face; ///< of each triangle: 1 or -1, by which its normal is to
                       ///< the front of its part
    bool *hem;         ///< of each triangle: it is in a stripe along the border
    tf_vector reach[FIG_CLOTH_REACH]; ///< points as far out as any, but the
                                      ///< floor's
    double bottom; ///< the height of the floor or of the lowest point
    double size;   ///< from the middle of what is reached to the farthest point
};

/// Find the stripes along the borders of soft parts.  False if there is no
/// memory.
bool fig_cloth_find_hems(fig_cloth *cloth);

#endif
