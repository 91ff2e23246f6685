/* Exercise 11.3.  Inside or outside?
 *
 * A closed surface is made of triangles: of boxes, say.  Is the point p inside?
 * The point `far` is outside, and perhaps badly chosen: the segment from p to
 * it may pass through corners, along edges, within triangles.  Count with
 * perturbed signs how many triangles the segment meets.  A point on the surface
 * is inside or outside once it is moved; give that answer.
 *
 * Everything is at one time, t = 0.  All vertices have indices, which are those
 * of their `vertex`: a corner has the same index in each of its triangles, and
 * p and `far` have others.
 *
 * Section: Parity without exception.
 *
 * Hint 1: The moved segment starts inside and ends outside if it goes through
 *     an odd number of moved triangles.
 * Hint 2: tf_complementary_meet with tf_perturbed tells whether a segment and a
 *     triangle meet, given a pair of five events at one time: `early` is 5, as
 *     `count`; `axes` is 3.
 * Hint 3: In a pair the events of one side come first, with side +1, then those
 *     of the other with side -1.  tf_complementary_meet never returns false
 *     here; the verdict is in the meeting.
 */
#include "arithmetic/perturbed.h"
#include "spacetime/complementary.h"
#if defined TF_WRONG_1
#include "arithmetic/exact.h"
#endif

/// Whether the segment from p to `far` meets a triangle, once moved.
static bool meet(const tf_event *p, const tf_event *far,
                 const tf_event corner[3])
{
    tf_pair pair = {.axes = 3, .axis = {0, 1, 2}};
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    const tf_event *event[] = {p, far, &corner[0], &corner[1], &corner[2]};
    for (int i = 0; i < 5; i++) {
        pair.event[i] = event[i];
        pair.side[i] = i < 2 ? +1 : -1;
    }
    pair.count = pair.early = 5;
#elif defined TF_WRONG_3 // numbers the vertices anew for each triangle
    tf_event copy[] = {*p, *far, corner[0], corner[1], corner[2]};
    for (int i = 0; i < 5; i++) {
        copy[i].vertex = i;
        pair.event[i] = &copy[i];
        pair.side[i] = i < 2 ? +1 : -1;
    }
    pair.count = pair.early = 5;
#else
    // Your turn: there are no events in the pair yet.
#endif
    const tf_arithmetic *arithmetic = &tf_perturbed;
#if defined TF_WRONG_1 // counts with touching
    arithmetic = &tf_exact;
#endif
    tf_meeting meeting;
    tf_complementary_meet(arithmetic, &pair, &meeting);
    return meeting.verdict == TF_HIT;
}

bool is_inside(const tf_event *p, const tf_event *far, int triangles,
               const tf_event triangle[][3])
{
    int count = 0;
    for (int i = 0; i < triangles; i++)
        count += meet(p, far, triangle[i]);
#if defined TF_WRONG_2 // believes that one triangle is enough
    return count > 0;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_3
    return count % 2 == 1;
#else
    // Your turn: what does the count tell?
    return count == 1;
#endif
}
