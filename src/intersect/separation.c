//: Include what separation needs
#include "intersect/separation.h"

#include <math.h>

//: Measure one operand along an axis
typedef struct range {
    double low, high;
} range;

/// The range of the coordinates of the events begin..end-1 on an axis.
static range event_range(const tf_pair *pair, int axis, int begin, int end)
{
    range r = {INFINITY, -INFINITY};
    for (int i = begin; i < end; i++) {
        double x = pair->event[i]->x[axis];
        r.low = x < r.low ? x : r.low;
        r.high = x > r.high ? x : r.high;
    }
    return r;
}

//: Compare two ranges
/// +1 if all of s is larger than all of r, -1 the reverse, 0 neither.
static int compare_ranges(range s, range r)
{
    return (s.low > r.high) - (s.high < r.low);
}

//: Separate a pair by an axis
/// Which operand has the larger coordinates on an axis among the events
/// begin..end-1, of which those from `middle` on are of R; as compare_ranges.
static int larger_operand(const tf_pair *pair, int axis, int begin, int middle,
                          int end)
{
    return compare_ranges(event_range(pair, axis, begin, middle),
                          event_range(pair, axis, middle, end));
}

/// The first event of R among begin..end-1.
static int first_of_r(const tf_pair *pair, int begin, int end)
{
    int i = begin;
    while (i < end && pair->operand[i] > 0)
        i++;
    return i;
}

bool tf_pair_separated(const tf_pair *pair)
{
    int start = pair->start_count, end = pair->count;
    int r_at_start = first_of_r(pair, 0, start);
    int r_at_end = first_of_r(pair, start, end);
    for (int k = 0; k < pair->axes; k++) {
        int axis = pair->axis[k];
        int larger = larger_operand(pair, axis, 0, r_at_start, start);
        if (larger != 0 &&
            (start == end ||
             larger == larger_operand(pair, axis, start, r_at_end, end)))
            return true;
    }
    return false;
}

//: Separate two elements by an axis
static inline range element_range(int vertices, const tf_worldline element[],
                                  int t, int axis)
{
    range r = {element->at[t].x[axis], element->at[t].x[axis]};
    for (int i = 1; i < vertices; i++) {
        double x = element[i].at[t].x[axis];
        r.low = x < r.low ? x : r.low;
        r.high = x > r.high ? x : r.high;
    }
    return r;
}

static inline bool separate(int axes, int vertices, const tf_worldline first[],
                            int others, const tf_worldline second[])
{
    for (int axis = 0; axis < axes; axis++) {
        int larger[2];
        for (int t = 0; t < 2; t++)
            larger[t] = compare_ranges(element_range(vertices, first, t, axis),
                                       element_range(others, second, t, axis));
        if (larger[0] != 0 && larger[0] == larger[1])
            return true;
    }
    return false;
}

bool tf_elements_separated(int axes, int vertices, const tf_worldline first[],
                           int others, const tf_worldline second[])
{
    // With constants the compiler unrolls every loop.
    if (axes == 3 && vertices == 1 && others == 3)
        return separate(3, 1, first, 3, second);
    if (axes == 3 && vertices == 2 && others == 2)
        return separate(3, 2, first, 2, second);
    return separate(axes, vertices, first, others, second);
}
