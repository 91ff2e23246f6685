//: Include what the join needs
#include "surface/join.h"

#include "base/always_inline.h"
#include "base/simd.h"

#include <stddef.h>
#include <stdint.h>

enum {
    PAIRS_ENOUGH = 3,    ///< not to look at times
    CHILDREN_ENOUGH = 7, ///< likewise
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

//: Find the lanes that no axis separates from a box
static const uint32_t bit[TF_LANES] = {
    1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
    1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15,
};

/// Whether a lane of a pack is on one side of a box at the start and at the end.
/// What holds the start as well need only be looked at at the end.
#define BEYOND(k)                                                              \
    ((pack->low[TF_AXES + (k)][i] > own->high[TF_AXES + (k)][lane]) &          \
     (swept | (pack->low[k][i] > own->high[k][lane])))
#define BEFORE(k)                                                              \
    ((pack->high[TF_AXES + (k)][i] < own->low[TF_AXES + (k)][lane]) &          \
     (swept | (pack->high[k][i] < own->low[k][lane])))

/// The lanes of a pack whose boxes may meet that of one lane of another, a bit
/// each: those that are not on the same side of it, along some axis, at the start
/// and at the end.
TF_ALWAYS_INLINE uint32_t overlaps(const tf_pack *pack, const tf_pack *own,
                                   int lane, const bool swept)
{
    uint32_t lanes = 0;
    TF_LANE_LOOP
    for (int i = 0; i < TF_LANES; i++) {
        bool apart = BEYOND(0) | BEFORE(0) | BEYOND(1) | BEFORE(1) | BEYOND(2) |
                     BEFORE(2);
        lanes |= apart ? 0 : bit[i];
    }
    return lanes;
}

//: Find when two sides do not separate
/// The times at which a linear distance, from `start` to `end`, is not negative;
/// none of these if `begin` exceeds `end`.
typedef struct period {
    float begin, end;
} period;

/// More than what the coordinates of a distance, the distance and the time err by
/// together.
#define SLACK 0x1p-20f

TF_ALWAYS_INLINE period period_of(float start, float end)
{
    start += SLACK;
    end += SLACK;
    float zero = start / (start - end);
    return (period){start >= 0 ? 0
                    : end >= 0 ? zero
                               : 2,
                    ((start < 0) | (end >= 0)) ? 1 : zero};
}

TF_ALWAYS_INLINE period common(period a, period b)
{
    return (period){a.begin > b.begin ? a.begin : b.begin,
                    a.end < b.end ? a.end : b.end};
}

//: Find the lanes that meet a box at one time
/// The lanes of a pack whose boxes may meet that of one lane of another at one
/// time on all axes.
TF_SIMD_256 TF_NO_TRAPS static uint32_t meeting(const tf_pack *pack,
                                                const tf_pack *own, int lane)
{
    uint32_t lanes = 0;
    TF_LANE_LOOP
    for (int i = 0; i < TF_LANES; i++) {
        period all = {0, 1};
        for (int k = 0; k < TF_AXES; k++) {
            int l = TF_AXES + k;
            all = common(all, period_of(own->high[k][lane] - pack->low[k][i],
                                        own->high[l][lane] - pack->low[l][i]));
            all = common(all, period_of(pack->high[k][i] - own->low[k][lane],
                                        pack->high[l][i] - own->low[l][lane]));
        }
        lanes |= all.begin > all.end + SLACK ? 0 : bit[i];
    }
    return lanes;
}

/// Whether there are more lanes than some number.
TF_ALWAYS_INLINE bool are_more(uint32_t lanes, int number)
{
    for (; number > 0; number--)
        lanes &= lanes - 1;
    return lanes != 0;
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
/// The pack that has the box of a leaf, in the lane of the leaf's number modulo
/// TF_LANES.
TF_ALWAYS_INLINE const tf_pack *parent_of(const tf_tree *tree, int leaf)
{
    return &tree->level[1][leaf / TF_LANES];
}

TF_ALWAYS_INLINE void join_leaves(const tf_tree *s, int a, const tf_tree *t,
                                  int b, tf_pair_sink *sink, const bool swept)
{
    const tf_pack *one = &s->level[0][a], *two = &t->level[0][b];
    uint32_t near = overlaps(one, parent_of(t, b), b % TF_LANES, swept);
    if (near == 0 || overlaps(two, parent_of(s, a), a % TF_LANES, swept) == 0)
        return;
    const int *element = s->element[a], *other = t->element[b];
    tf_candidate *pair = sink->pair + sink->count;
    for (; near; near &= near - 1) {
        int i = first_lane(near);
        uint32_t lanes = overlaps(two, one, i, swept);
        if (s == t && a == b)
            lanes &= ~UINT32_C(1) << i;
        if (lanes)
            lanes &= ~lanes_that_share(s, a, i, t, b);
        if (!swept && are_more(lanes, PAIRS_ENOUGH))
            lanes &= meeting(two, one, i);
        for (; lanes; lanes &= lanes - 1)
            *pair++ = (tf_candidate){element[i], other[first_lane(lanes)]};
    }
    sink->count = (int)(pair - sink->pair);
}

//: Hold a visit
/// A pack that may meet.
typedef struct visit {
    int level, pack;
} visit;

/// Whether all leaves below a pack come before a leaf.
TF_ALWAYS_INLINE bool is_before(int level, int pack, int leaf)
{
    return ((int64_t)pack + 1) << (4 * level) <= leaf;
}

//: Visit the children of a pack
/// Puts those children of a pack on the stack that may meet leaf a; returns the
/// stack's new height.
TF_ALWAYS_INLINE int visit_children(const tf_tree *s, int a, const tf_tree *t,
                                    const visit *from, visit stack[], int top,
                                    const bool swept)
{
    const tf_pack *pack = &t->level[from->level][from->pack];
    const tf_pack *parent = parent_of(s, a);
    uint32_t near = overlaps(pack, parent, a % TF_LANES, swept);
    if (!swept && are_more(near, CHILDREN_ENOUGH))
        near &= meeting(pack, parent, a % TF_LANES);
    for (; near; near &= near - 1) {
        int child = from->pack * TF_LANES + first_lane(near);
        // Of the same tree's pairs, each once: not those with earlier leaves.
        if (s != t || !is_before(from->level - 1, child, a))
            stack[top++] = (visit){from->level - 1, child};
    }
    return top;
}

//: Join a leaf with a tree
TF_ALWAYS_INLINE void join_leaf(const tf_tree *s, int a, const tf_tree *t,
                                tf_pair_sink *sink, const bool swept)
{
    visit stack[STACK];
    int top = 0;
    stack[top++] = (visit){t->levels - 1, 0};
    while (top > 0 && !sink->stopped) {
        visit at = stack[--top];
        if (at.level > 0) {
            top = visit_children(s, a, t, &at, stack, top, swept);
            continue;
        }
        if (sink->count > TF_BATCH - TF_LANES * TF_LANES)
            tf_pair_sink_hand_on(sink);
        join_leaves(s, a, t, at.pack, sink, swept);
    }
}

TF_SIMD_256 static void join_swept(const tf_tree *s, int a, const tf_tree *t,
                                   tf_pair_sink *sink)
{
    join_leaf(s, a, t, sink, true);
}

TF_SIMD_256 static void join_moving(const tf_tree *s, int a, const tf_tree *t,
                                    tf_pair_sink *sink)
{
    join_leaf(s, a, t, sink, false);
}

//: Join leaves with a tree
void tf_tree_join(const tf_tree *s, const tf_tree *t, tf_range leaves,
                  tf_pair_sink *sink)
{
    if (t->count == 0)
        return;
    for (int leaf = leaves.begin; leaf < leaves.end && !sink->stopped; leaf++)
        (s->swept ? join_swept : join_moving)(s, leaf, t, sink);
    tf_pair_sink_hand_on(sink);
}
