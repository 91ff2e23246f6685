//: Include what pairs need
#include "intersect/pair.h"

#include "base/require.h"

#include <string.h>

//: Pair two swept simplices
/// Adds the events of a simplex at time t to n others; returns how many there
/// are then.
static inline int add_events(tf_pair *pair, int n, const tf_simplex *simplex,
                             int operand, int t)
{
    int first = t == 0 ? 0 : simplex->pivot + 1;
    int end = t == 0 ? simplex->pivot + 1 : simplex->count;
    for (int i = first; i < end; i++) {
        pair->event[n] = simplex->event[i];
        pair->operand[n++] = operand;
    }
    return n;
}

void tf_pair_set(tf_pair *pair, const tf_simplex *s, const tf_simplex *r,
                 int axes)
{
    TF_REQUIRE(s->count + r->count == axes + 3);
    pair->axes = axes;
    for (int k = 0; k < TF_AXES; k++)
        pair->axis[k] = k;
    int n = add_events(pair, 0, s, +1, 0);
    n = add_events(pair, n, r, -1, 0);
    pair->start_count = n;
    n = add_events(pair, n, s, +1, 1);
    pair->count = add_events(pair, n, r, -1, 1);
}

tf_pair tf_pair_of(const tf_simplex *s, const tf_simplex *r, int axes)
{
    tf_pair pair;
    tf_pair_set(&pair, s, r, axes);
    return pair;
}

//: Take differences within each time
/// Adds the differences of the events begin..end-1 to the first of them to n
/// rows; returns how many rows there are then.
static inline int add_differences(const tf_pair *pair, int without, int begin,
                                  int end, int n, tf_differences *differences)
{
    int first = begin == without ? begin + 1 : begin;
    for (int i = first + 1; i < end; i++) {
        if (i == without)
            continue;
        differences->to[n] = pair->event[i];
        differences->from[n++] = pair->event[first];
    }
    return n;
}

void tf_pair_differences(const tf_pair *pair, int without,
                         tf_differences *differences)
{
    int start = pair->start_count;
    int n = add_differences(pair, without, 0, start, 0, differences);
    differences->n =
        add_differences(pair, without, start, pair->count, n, differences);
    memcpy(differences->axis, pair->axis, sizeof differences->axis);
}
