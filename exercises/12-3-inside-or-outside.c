/* Exercise 12.3.  Inside or outside of a closed surface?
 *
 * A closed surface is made of triangles: of boxes, say.  Is the point p inside?
 * The point `far` is outside, and perhaps badly chosen: the segment from p to
 * it may pass through corners, along edges, within triangles.  Count with
 * perturbed signs how many triangles the segment intersects.  A point on the
 * surface is inside or outside once it is moved; return that answer.
 *
 * Everything is at one time, t = 0.  Each event has an index, in its member
 * `vertex`: a corner has the same one in every triangle that it belongs to, and
 * p and `far` have indices of their own.
 *
 * Section: Parity without exception.
 *
 * Hint 1: The moved segment starts inside and ends outside if it goes through
 *     an odd number of moved triangles.
 * Hint 2: tf_complementary_intersect with tf_perturbed decides whether a
 *     segment and a triangle intersect, given a pair of five events at one
 *     time: `start_count` is 5, as is `count`; `axes` is 3.
 * Hint 3: In a pair the events of one operand come first, with operand +1, then
 *     those of the other with operand -1.  tf_complementary_intersect can
 *     always decide here, so it returns true; the verdict is in the
 *     intersection.
 */
#include "arithmetic/perturbed.h"
#include "intersect/complementary.h"
#if defined TF_WRONG_1
#include "arithmetic/exact.h"
#endif

/// Whether the moved segment from p to `far` intersects a triangle.
static bool meet(const tf_event *p, const tf_event *far,
                 const tf_event corner[3])
{
    tf_pair pair = {.axes = 3, .axis = {0, 1, 2}};
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    const tf_event *event[] = {p, far, &corner[0], &corner[1], &corner[2]};
    for (int i = 0; i < 5; i++) {
        pair.event[i] = event[i];
        pair.operand[i] = i < 2 ? +1 : -1;
    }
    pair.count = pair.start_count = 5;
#elif defined TF_WRONG_3 // numbers the vertices anew for each triangle
    tf_event copy[] = {*p, *far, corner[0], corner[1], corner[2]};
    for (int i = 0; i < 5; i++) {
        copy[i].vertex = i;
        pair.event[i] = &copy[i];
        pair.operand[i] = i < 2 ? +1 : -1;
    }
    pair.count = pair.start_count = 5;
#else
    // Your turn: there are no events in the pair yet.
#endif
    const tf_arithmetic *arithmetic = &tf_perturbed;
#if defined TF_WRONG_1 // counts touching
    arithmetic = &tf_exact;
#endif
    tf_intersection meeting;
    tf_complementary_intersect(arithmetic, &pair, TF_WITH_POINT, &meeting);
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
    // Your turn: what does the count mean?
    return count == 1;
#endif
}
