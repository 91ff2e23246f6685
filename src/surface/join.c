//: Include what the join needs
#include "surface/join.h"

#include "base/always_inline.h"
#include "base/simd.h"

#include <stddef.h>
#include <stdint.h>

enum {
    STACK = TF_TREE_LEVELS * TF_LANES
};

//: Hand on pairs
void tf_pair_sink_hand_on(tf_pair_sink *sink)
{
    if (sink->count > 0 && sink->filter && !sink->stopped)
        sink->filter(sink);
    if (sink->count > 0 && !sink->stopped)
        sink->stopped = !sink->take(sink, sink->count, sink->pair);
    sink->count = 0;
}

//: Find the lanes that overlap a box
static const uint32_t bit[TF_LANES] = {
    1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
    1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15,
};

/// The lanes of the pack whose boxes overlap the box, a bit each.
TF_ALWAYS_INLINE uint32_t overlaps(const tf_pack *pack, const tf_box *box)
{
    uint32_t lanes = 0;
    TF_LANE_LOOP
    for (int i = 0; i < TF_LANES; i++) {
        bool apart = (pack->low[0][i] > box->high[0]) |
                     (box->low[0] > pack->high[0][i]) |
                     (pack->low[1][i] > box->high[1]) |
                     (box->low[1] > pack->high[1][i]) |
                     (pack->low[2][i] > box->high[2]) |
                     (box->low[2] > pack->high[2][i]);
        lanes |= apart ? 0 : bit[i];
    }
    return lanes;
}

//: Find the lanes that share a vertex
/// The lanes of the elements that have one of two vertices.  With a constant for
/// the number of corners the inner loop is unrolled, and one loop is left.
TF_ALWAYS_INLINE uint32_t lanes_with(const int own[2], int corners,
                                     int (*corner)[TF_LANES])
{
    uint32_t lanes = 0;
    TF_LANE_LOOP
    for (int i = 0; i < TF_LANES; i++) {
        bool shares = false;
        for (int c = 0; c < corners; c++)
            shares |= (corner[c][i] == own[0]) | (corner[c][i] == own[1]);
        lanes |= shares ? bit[i] : 0;
    }
    return lanes;
}

/// The lanes of leaf b that share a vertex with an element of leaf a.
TF_ALWAYS_INLINE uint32_t lanes_that_share(const tf_tree *s, int a, int lane,
                                           const tf_tree *t, int b)
{
    int(*corner)[TF_LANES] = s->corner + (ptrdiff_t)a * s->corners;
    const int own[2] = {corner[0][lane], corner[s->corners - 1][lane]};
    corner = t->corner + (ptrdiff_t)b * t->corners;
    return t->corners == 3   ? lanes_with(own, 3, corner)
           : t->corners == 2 ? lanes_with(own, 2, corner)
                             : lanes_with(own, 1, corner);
}

//: Find the first lane
/// The lowest lane of a nonempty set.
TF_ALWAYS_INLINE int first_lane(uint32_t lanes)
{
#ifdef __GNUC__
    return __builtin_ctz(lanes);
#else
    int lane = 0;
    while (!(lanes >> lane & 1))
        lane++;
    return lane;
#endif
}

//: Join two leaves
TF_ALWAYS_INLINE void join_leaves(const tf_tree *s, int a,
                                  const tf_box *box_of_a, const tf_tree *t,
                                  int b, const tf_box *box_of_b,
                                  tf_pair_sink *sink)
{
    uint32_t near = overlaps(&s->level[0][a], box_of_b);
    if (near == 0 || overlaps(&t->level[0][b], box_of_a) == 0)
        return;
    const int *element = s->element[a], *other = t->element[b];
    tf_candidate *pair = sink->pair + sink->count;
    for (; near; near &= near - 1) {
        int i = first_lane(near);
        tf_box own = tf_pack_box(&s->level[0][a], i);
        uint32_t lanes = overlaps(&t->level[0][b], &own);
        if (s == t && a == b)
            lanes &= ~UINT32_C(1) << i;
        if (lanes)
            lanes &= ~lanes_that_share(s, a, i, t, b);
        for (; lanes; lanes &= lanes - 1)
            *pair++ = (tf_candidate){element[i], other[first_lane(lanes)]};
    }
    sink->count = (int)(pair - sink->pair);
}

//: Hold a visit
/// A pack that may overlap, with its box.
typedef struct visit {
    int level, pack;
    tf_box box;
} visit;

/// Whether all leaves below a pack come before a leaf.
TF_ALWAYS_INLINE bool is_before(int level, int pack, int leaf)
{
    return ((int64_t)pack + 1) << (4 * level) <= leaf;
}

//: Visit the children of a pack
/// Puts those children of a pack on the stack that overlap the box; returns the
/// stack's new height.
TF_ALWAYS_INLINE int visit_children(const tf_tree *s, int a, const tf_tree *t,
                                    const visit *from, const tf_box *box,
                                    visit stack[], int top)
{
    const tf_pack *pack = &t->level[from->level][from->pack];
    uint32_t near = overlaps(pack, box);
    for (; near; near &= near - 1) {
        int i = first_lane(near);
        int child = from->pack * TF_LANES + i;
        // Of the same tree's pairs, each once: not those with earlier leaves.
        if (s != t || !is_before(from->level - 1, child, a))
            stack[top++] =
                (visit){from->level - 1, child, tf_pack_box(pack, i)};
    }
    return top;
}

//: Join a leaf with a tree
TF_SIMD_256 static void join_leaf(const tf_tree *s, int a, const tf_tree *t,
                                  tf_pair_sink *sink)
{
    visit stack[STACK];
    tf_box box = tf_pack_union(&s->level[0][a]);
    int top = 0;
    stack[top++] = (visit){t->levels - 1, 0, box};
    while (top > 0 && !sink->stopped) {
        visit at = stack[--top];
        if (at.level > 0) {
            top = visit_children(s, a, t, &at, &box, stack, top);
            continue;
        }
        if (sink->count > TF_BATCH - TF_LANES * TF_LANES)
            tf_pair_sink_hand_on(sink);
        join_leaves(s, a, &box, t, at.pack, &at.box, sink);
    }
}

//: Join leaves with a tree
void tf_tree_join(const tf_tree *s, const tf_tree *t, tf_range leaves,
                  tf_pair_sink *sink)
{
    if (t->count == 0)
        return;
    for (int leaf = leaves.begin; leaf < leaves.end && !sink->stopped; leaf++)
        join_leaf(s, leaf, t, sink);
    tf_pair_sink_hand_on(sink);
}
