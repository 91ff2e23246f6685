/* Exercise 19.4.  Does a pair keep the rule of the thickness?
 *
 * A point and an edge in the plane have integers for coordinates, of at most
 * 10,000 in absolute value.  Part one: is_nearer() returns whether the point is
 * nearer to the edge than `thickness`, an integer from 1 to 20,000.  The answer
 * must be exact, also for an edge whose ends lie in one place.
 *
 * Part two: keeps_rule() returns whether the pair keeps the rule of the section
 * in a step, given the positions at its start and at its end: first the point,
 * then the ends of the edge.
 *
 * Section: At a distance.
 *
 * Hint 1: The features of the edge are its inside and its two ends.  Is any of
 *     them too near?
 * Hint 2: Don't divide and don't take a root.  Compare squares, multiplied by
 *     what you would have to divide by.
 * Hint 3: The rule has a condition about the start.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

static int64_t dot(const int64_t a[2], const int64_t b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/// Whether the point, which is `from` away from the first end of the edge `along`,
/// is beside the inside of the edge.
static bool is_beside(const int64_t from[2], const int64_t along[2])
{
#if defined TF_WRONG_1 // takes the line for the edge
    return dot(along, along) > 0 && dot(from, from) >= 0;
#else
    int64_t part = dot(from, along);
    return part > 0 && part < dot(along, along);
#endif
}

/// Whether such a point is nearer to the line of the edge.
static bool is_nearer_to_line(const int64_t from[2], const int64_t along[2],
                              int64_t thickness)
{
    int64_t square = thickness * thickness;
#if defined TF_WRONG_5 // rounds
    double length = sqrt((double)dot(along, along));
    double x = (double)along[0] / length, y = (double)along[1] / length;
    double height = x * (double)from[1] - y * (double)from[0];
    return fabs(height) < sqrt((double)square);
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    int64_t cross = along[0] * from[1] - along[1] * from[0];
    return cross * cross < square * dot(along, along);
#elif defined TF_WRONG_3 || defined TF_WRONG_4
    int64_t cross = along[0] * from[1] - along[1] * from[0];
    return cross * cross < square * dot(along, along);
#else
    // Your turn, part one: how near is the line?
    return dot(along, along) < square;
#endif
}

bool is_nearer(const int64_t point[2], const int64_t a[2], const int64_t b[2],
               int64_t thickness)
{
    int64_t along[2] = {b[0] - a[0], b[1] - a[1]};
    int64_t from[2] = {point[0] - a[0], point[1] - a[1]};
    int64_t beyond[2] = {point[0] - b[0], point[1] - b[1]};
    int64_t square = thickness * thickness;
    int64_t to_a = dot(from, from), to_b = dot(beyond, beyond);
    if (is_beside(from, along) && is_nearer_to_line(from, along, thickness))
        return true;
#if defined TF_WRONG_2 // takes what is at the least distance for nearer
    return to_a <= square || to_b <= square;
#elif defined TF_WRONG_3 // wants both ends to be near
    return to_a < square && to_b < square;
#else
    return to_a < square || to_b < square;
#endif
}

bool keeps_rule(const int64_t start[3][2], const int64_t end[3][2],
                int64_t thickness)
{
    bool before = is_nearer(start[0], start[1], start[2], thickness);
    bool after = is_nearer(end[0], end[1], end[2], thickness);
#if defined TF_WRONG_4 // takes the start and the end for each other
    return after || !before;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    return before || !after;
#elif defined TF_WRONG_3 || defined TF_WRONG_5
    return before || !after;
#else
    // Your turn, part two: what may end near?
    return before == after;
#endif
}
