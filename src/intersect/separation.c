//: Include what separation needs
#include "intersect/separation.h"

//: Measure one operand along an axis
typedef struct range {
    double low, high;
} range;

/// The range of the coordinates of the events begin..end-1 on an axis.
static range event_range(const tf_pair *pair, int axis, int begin, int end)
{
    double x = pair->event[begin]->x[axis];
    range r = {x, x};
    for (int i = begin + 1; i < end; i++) {
        x = pair->event[i]->x[axis];
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

/// The first event of R from `begin` on.
static int first_of_r(const tf_pair *pair, int begin)
{
    int i = begin;
    while (pair->operand[i] > 0)
        i++;
    return i;
}

bool tf_pair_separated(const tf_pair *pair)
{
    int end = pair->start_count, middle = first_of_r(pair, 0);
    bool moving = end < pair->count;
    int end_middle = moving ? first_of_r(pair, end) : end;
    for (int k = 0; k < pair->axes; k++) {
        int axis = pair->axis[k];
        int larger = larger_operand(pair, axis, 0, middle, end);
        if (larger != 0 &&
            (!moving || larger == larger_operand(pair, axis, end, end_middle,
                                                 pair->count)))
            return true;
    }
    return false;
}

//: Separate two elements by an axis
static range element_range(int vertices, const tf_worldline element[], int t,
                           int axis)
{
    range r = {element->at[t].x[axis], element->at[t].x[axis]};
    for (int i = 1; i < vertices; i++) {
        double x = element[i].at[t].x[axis];
        r.low = x < r.low ? x : r.low;
        r.high = x > r.high ? x : r.high;
    }
    return r;
}

bool tf_elements_separated(int axes, int vertices, const tf_worldline first[],
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
