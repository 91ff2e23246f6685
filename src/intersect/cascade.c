//: Include what the cascade needs
#include "intersect/cascade.h"

#include "arithmetic/functions.h"
#include "base/require.h"

#include <math.h>
#include <string.h>

//: Choose the earlier intersection
tf_intersection tf_intersection_earlier(const tf_intersection *a,
                                        const tf_intersection *b)
{
    if (a->verdict == TF_APART || b->verdict == TF_APART)
        return a->verdict == TF_APART ? *b : *a;

    tf_intersection earlier = b->toi_lo < a->toi_lo ? *b : *a;

    // An intersection that is not certain cannot bound the time from above.
    bool certain = a->verdict == TF_HIT || b->verdict == TF_HIT;
    if (a->verdict == b->verdict)
        earlier.toi_hi =
            certain ? fmin(a->toi_hi, b->toi_hi) : fmax(a->toi_hi, b->toi_hi);
    else
        earlier.toi_hi = a->verdict == TF_HIT ? a->toi_hi : b->toi_hi;
    earlier.verdict = certain ? TF_HIT : TF_UNDECIDED;
    return earlier;
}

//: Drop an event
static tf_pair without_event(const tf_pair *pair, int dropped)
{
    tf_pair smaller = *pair;
    smaller.count = 0;
    smaller.start_count -= dropped < pair->start_count;
    for (int i = 0; i < pair->count; i++) {
        if (i == dropped)
            continue;
        smaller.event[smaller.count] = pair->event[i];
        smaller.operand[smaller.count++] = pair->operand[i];
    }
    return smaller;
}

/// Gives the event that was left out the coordinate 0.
static void restore_event(tf_intersection *found, int dropped)
{
    for (int i = TF_PAIR_EVENTS - 1; i > dropped; i--)
        found->barycentric[i] = found->barycentric[i - 1];
    found->barycentric[dropped] = 0;
}

//: Find the events that may be dropped
/// Whether the simplex of event i has another event at the same time.
static bool may_drop(const tf_pair *pair, int i)
{
    bool at_end = i >= pair->start_count;
    for (int j = 0; j < pair->count; j++)
        if (j != i && pair->operand[j] == pair->operand[i] &&
            (j >= pair->start_count) == at_end)
            return true;
    return false;
}

//: Project along an axis
static tf_pair along_axis(const tf_pair *pair, int k)
{
    tf_pair projection = *pair;
    projection.axes--;
    for (int j = k; j < projection.axes; j++)
        projection.axis[j] = pair->axis[j + 1];
    return projection;
}

//: Measure how well coordinates fit
/// How far apart the barycentric coordinates leave the points of S and R, all
/// axes added.
static double residual(const tf_pair *pair, const tf_intersection *found)
{
    double sum = 0;
    for (int k = 0; k < pair->axes; k++) {
        double difference = 0;
        for (int i = 0; i < pair->count; i++)
            difference += pair->operand[i] * found->barycentric[i] *
                          pair->event[i]->x[pair->axis[k]];
        sum += fabs(difference);
    }
    return sum;
}

//: Find a flat axis
/// Whether the events of one time, begin..end-1, agree along an axis.
static bool agree(const tf_pair *pair, int axis, int begin, int end)
{
    for (int i = begin + 1; i < end; i++)
        if (pair->event[i]->x[axis] != pair->event[begin]->x[axis])
            return false;
    return true;
}

/// The place among the axes of a pair of one along which all its events agree
/// at the start, and all at the end; -1: there is none.
static int flat_axis(const tf_pair *pair)
{
    for (int k = 0; k < pair->axes; k++)
        if (agree(pair, pair->axis[k], 0, pair->start_count) &&
            agree(pair, pair->axis[k], pair->start_count, pair->count))
            return k;
    return -1;
}

//: Intersect every projection
typedef tf_intersection intersect_function(const tf_arithmetic *arithmetic,
                                           const tf_pair *pair,
                                           tf_detail detail);

/// Whether a pair has a flat axis and is apart in the projection along it.
static bool is_apart_along_flat_axis(const tf_arithmetic *arithmetic,
                                     const tf_pair *pair,
                                     intersect_function *intersect)
{
    int flat = flat_axis(pair);
    if (flat < 0)
        return false;
    tf_pair projection = along_axis(pair, flat);
    return intersect(arithmetic, &projection, TF_ONLY_VERDICT).verdict ==
           TF_APART;
}

/// The intersection of a pair that does not fill its space.  At least one of
/// its projections along the axes is one-to-one and decides; the others cannot
/// be apart where the pair intersects, nor intersect later.
static tf_intersection intersect_projections(const tf_arithmetic *arithmetic,
                                             const tf_pair *pair,
                                             tf_detail detail,
                                             intersect_function *intersect)
{
    if (is_apart_along_flat_axis(arithmetic, pair, intersect))
        return tf_intersection_apart;
    tf_intersection latest = {.verdict = TF_HIT};
    double smallest_residual = INFINITY;
    for (int k = 0; k < pair->axes; k++) {
        tf_pair projection = along_axis(pair, k);
        tf_intersection own = intersect(arithmetic, &projection, detail);
        if (own.verdict == TF_APART)
            return own;

        // Where the intersection is unique, the events fill the projection,
        // which is then one-to-one.
        if (latest.unique)
            continue;
        if (own.unique) {
            latest = own;
            continue;
        }

        //: Keep the latest time and the coordinates that fit best
        if (own.verdict == TF_UNDECIDED)
            latest.verdict = TF_UNDECIDED;
        latest.toi_lo = fmax(latest.toi_lo, own.toi_lo);
        latest.toi_hi = fmax(latest.toi_hi, own.toi_hi);
        double own_residual =
            detail == TF_WITH_POINT ? residual(pair, &own) : 0;
        if (k == 0 || own_residual < smallest_residual) {
            smallest_residual = own_residual;
            memcpy(latest.barycentric, own.barycentric,
                   sizeof latest.barycentric);
        }
    }
    return latest;
}

//: Intersect some face
/// Whether a certain intersection leaves nothing to look for.
static bool is_enough(const tf_intersection *found, tf_detail detail)
{
    return found->verdict == TF_HIT &&
           (detail == TF_ONLY_VERDICT || found->toi_hi == 0);
}

/// The earliest intersection of the pairs that remain when one event is dropped
/// such that both simplices keep their times.
static tf_intersection intersect_faces(const tf_arithmetic *arithmetic,
                                       const tf_pair *pair, tf_detail detail,
                                       intersect_function *intersect)
{
    tf_intersection earliest = tf_intersection_apart;
    for (int i = 0; i < pair->count && !is_enough(&earliest, detail); i++) {
        if (!may_drop(pair, i))
            continue;
        tf_pair face = without_event(pair, i);
        tf_intersection own = intersect(arithmetic, &face, detail);
        if (own.verdict == TF_APART)
            continue;
        restore_event(&own, i);
        earliest = tf_intersection_earlier(&earliest, &own);
    }
    return earliest;
}

//: Measure a static volume
/// The sign of the volume that axes + 1 events of one time span; fewer span
/// none.
static tf_sign volume_sign(const tf_arithmetic *arithmetic, const tf_pair *pair)
{
    if (pair->count <= pair->axes)
        return TF_ZERO;
    tf_differences all;
    tf_pair_differences(pair, -1, &all);
    return arithmetic->sign(&all);
}

//: Intersect at one time
/// The intersection of two simplices at one time, of at most axes + 2 events.
static tf_intersection intersect_at_once(const tf_arithmetic *arithmetic,
                                         const tf_pair *pair, tf_detail detail)
{
    if (pair->axes == 0)
        return (tf_intersection){.verdict = TF_HIT, .barycentric = {1, 1}};

    //: Decide a static pair that fills its space
    tf_intersection found;
    bool complementary = pair->count == pair->axes + 2;
    if (complementary &&
        tf_complementary_intersect(arithmetic, pair, detail, &found))
        return found;
    tf_sign volume = complementary ? TF_ZERO : volume_sign(arithmetic, pair);
    if (volume == TF_POSITIVE || volume == TF_NEGATIVE)
        return tf_intersection_apart;

    //: Decide a static pair in a hyperplane
    found = complementary
                ? intersect_faces(arithmetic, pair, detail, intersect_at_once)
                : intersect_projections(arithmetic, pair, detail,
                                        intersect_at_once);
    if (volume == TF_UNKNOWN && found.verdict == TF_HIT)
        found.verdict = TF_UNDECIDED;
    found.unique = false;
    return found;
}

/// The intersection of the slices at t = 0.
static tf_intersection intersect_at_start(const tf_arithmetic *arithmetic,
                                          const tf_pair *pair, tf_detail detail)
{
    tf_pair start = *pair;
    start.count = start.start_count;
    return intersect_at_once(arithmetic, &start, detail);
}

//: Intersect in a hyperplane
static tf_intersection intersect_in_hyperplane(const tf_arithmetic *arithmetic,
                                               const tf_pair *pair,
                                               tf_detail detail)
{
    return intersect_projections(arithmetic, pair, detail, tf_intersect);
}

//: Intersect in space-time
tf_intersection tf_intersect(const tf_arithmetic *arithmetic,
                             const tf_pair *pair, tf_detail detail)
{
    TF_REQUIRE(pair->count == pair->axes + 3);
    tf_intersection found;
    if (tf_complementary_intersect(arithmetic, pair, detail, &found))
        return found;

    // The faces decide whether the pair intersects; on a line it has none and
    // coincides.
    found = intersect_faces(arithmetic, pair, detail, intersect_in_hyperplane);
    if (found.verdict == TF_APART && pair->axes > 1)
        return found;

    // A pair that first intersects later than t = 0 has a face that does so
    // then; one that intersects at t = 0 has a face that intersects, but
    // perhaps later: the slices decide when.
    if (!is_enough(&found, detail)) {
        tf_intersection start = intersect_at_start(arithmetic, pair, detail);
        found = start.verdict == TF_HIT
                    ? start
                    : tf_intersection_earlier(&start, &found);
    }
    found.classification = TF_DEGENERATE;
    found.unique = false;
    return found;
}

//: Describe an intersection
void tf_intersection_describe(const tf_arithmetic *arithmetic,
                              const tf_pair *pair, tf_detail detail,
                              tf_intersection *found)
{
    if (found->classification == TF_DEGENERATE)
        *found = tf_intersect(arithmetic, pair, detail);
    else
        tf_complementary_describe(arithmetic, pair, detail, found);
}
