// Boxes at both ends, one at a time, for those who look at what a tree has.
#ifndef SUPPORT_BOXES_H
#define SUPPORT_BOXES_H

#include "surface/tree.h"

static inline tf_box box_union(tf_box a, tf_box b)
{
    for (int k = 0; k < TF_SIDES; k++) {
        a.low[k] = b.low[k] < a.low[k] ? b.low[k] : a.low[k];
        a.high[k] = b.high[k] > a.high[k] ? b.high[k] : a.high[k];
    }
    return a;
}

/// The box that one lane of a pack has.
static inline tf_box pack_box(const tf_pack *pack, int lane)
{
    tf_box box;
    for (int k = 0; k < TF_SIDES; k++) {
        box.low[k] = pack->low[k][lane];
        box.high[k] = pack->high[k][lane];
    }
    return box;
}

#endif
