//: Include what the cascade needs
#include "spacetime/meet.h"

#include "contract.h"

#include <math.h>
#include <string.h>

//: Choose the earlier meeting
tf_meeting tf_meeting_earlier(const tf_meeting *a, const tf_meeting *b)
{
    if (a->verdict == TF_APART || b->verdict == TF_APART)
        return a->verdict == TF_APART ? *b : *a;

    tf_meeting earlier = b->toi_lo < a->toi_lo ? *b : *a;

    // A meeting that is not certain cannot bound the time from above.
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
    smaller.early -= dropped < pair->early;
    for (int i = 0; i < pair->count; i++) {
        if (i == dropped)
            continue;
        smaller.event[smaller.count] = pair->event[i];
        smaller.side[smaller.count++] = pair->side[i];
    }
    return smaller;
}

/// Give the event that was left out the weight 0.
static void restore_event(tf_meeting *meeting, int dropped)
{
    for (int i = TF_PAIR_EVENTS - 1; i > dropped; i--)
        meeting->weight[i] = meeting->weight[i - 1];
    meeting->weight[dropped] = 0;
}

//: Tell which events may be dropped
/// Whether the simplex of event i has another event at the same time.
static bool may_drop(const tf_pair *pair, int i)
{
    bool late = i >= pair->early;
    for (int j = 0; j < pair->count; j++)
        if (j != i && pair->side[j] == pair->side[i] &&
            (j >= pair->early) == late)
            return true;
    return false;
}

//: Project along an axis
static tf_pair along_axis(const tf_pair *pair, int k)
{
    tf_pair shadow = *pair;
    shadow.axes--;
    for (int j = k; j < shadow.axes; j++)
        shadow.axis[j] = pair->axis[j + 1];
    return shadow;
}

//: Measure how well weights fit
/// How far apart the weights leave the points of S and R, all axes added.
static double gap(const tf_pair *pair, const tf_meeting *meeting)
{
    double sum = 0;
    for (int k = 0; k < pair->axes; k++) {
        double difference = 0;
        for (int i = 0; i < pair->count; i++)
            difference += pair->side[i] * meeting->weight[i] *
                          pair->event[i]->x[pair->axis[k]];
        sum += fabs(difference);
    }
    return sum;
}

//: Meet in every shadow
typedef tf_meeting meet_function(const tf_arithmetic *arithmetic,
                                 const tf_pair *pair);

/// The meeting of a pair that does not fill its space.  At least one of its
/// shadows along the axes is one-to-one and decides; the others cannot be apart
/// where the pair meets, nor meet later.
static tf_meeting meet_in_shadows(const tf_arithmetic *arithmetic,
                                  const tf_pair *pair, meet_function *meet)
{
    tf_meeting latest = {.verdict = TF_HIT};
    double smallest_gap = INFINITY;
    for (int k = 0; k < pair->axes; k++) {
        tf_pair shadow = along_axis(pair, k);
        tf_meeting own = meet(arithmetic, &shadow);
        if (own.verdict == TF_APART)
            return own;

        // A unique meeting fills its shadow, which then is one-to-one.
        if (latest.unique)
            continue;
        if (own.unique) {
            latest = own;
            continue;
        }

        //: Keep the latest time and the weights that fit best
        if (own.verdict == TF_UNDECIDED)
            latest.verdict = TF_UNDECIDED;
        latest.toi_lo = fmax(latest.toi_lo, own.toi_lo);
        latest.toi_hi = fmax(latest.toi_hi, own.toi_hi);
        double own_gap = gap(pair, &own);
        if (k == 0 || own_gap < smallest_gap) {
            smallest_gap = own_gap;
            memcpy(latest.weight, own.weight, sizeof latest.weight);
        }
    }
    return latest;
}

//: Meet in some face
/// The earliest meeting of the pairs that are left when one event is dropped
/// and both simplices still have the times they had.
static tf_meeting meet_in_faces(const tf_arithmetic *arithmetic,
                                const tf_pair *pair, meet_function *meet)
{
    tf_meeting earliest = tf_meeting_apart;
    for (int i = 0; i < pair->count; i++) {
        if (!may_drop(pair, i))
            continue;
        tf_pair face = without_event(pair, i);
        tf_meeting own = meet(arithmetic, &face);
        restore_event(&own, i);
        earliest = tf_meeting_earlier(&earliest, &own);
        if (earliest.verdict == TF_HIT && earliest.toi_hi == 0)
            break;
    }
    return earliest;
}

//: Meet in a space without axes
/// The only two points of a space without axes coincide.
static tf_meeting meet_without_axes(const tf_pair *pair)
{
    tf_meeting meeting = {.verdict = TF_HIT};
    bool taken[2] = {false, false};
    for (int i = 0; i < pair->count; i++) {
        int s = pair->side[i] > 0;
        meeting.weight[i] = taken[s] ? 0 : 1;
        taken[s] = true;
    }
    return meeting;
}

//: Measure a static volume
/// The sign of the volume that axes + 1 events of one time span; fewer span
/// none.
static tf_sign volume_sign(const tf_arithmetic *arithmetic, const tf_pair *pair)
{
    if (pair->count <= pair->axes)
        return TF_ZERO;
    tf_differences all = tf_pair_differences(pair, -1);
    return arithmetic->sign(&all);
}

//: Meet at one time
/// The meeting of two simplices at one time, of at most axes + 2 events.
static tf_meeting meet_at_once(const tf_arithmetic *arithmetic,
                               const tf_pair *pair)
{
    if (pair->axes == 0)
        return meet_without_axes(pair);

    //: Decide a static pair that fills its space
    tf_meeting meeting;
    bool complementary = pair->count == pair->axes + 2;
    if (complementary && tf_complementary_meet(arithmetic, pair, &meeting))
        return meeting;
    tf_sign volume = complementary ? TF_ZERO : volume_sign(arithmetic, pair);
    if (volume == TF_POSITIVE || volume == TF_NEGATIVE)
        return tf_meeting_apart;

    //: Decide a static pair in a hyperplane
    meeting = complementary ? meet_in_faces(arithmetic, pair, meet_at_once)
                            : meet_in_shadows(arithmetic, pair, meet_at_once);
    if (volume == TF_UNKNOWN && meeting.verdict == TF_HIT)
        meeting.verdict = TF_UNDECIDED;
    meeting.unique = false;
    return meeting;
}

/// The meeting of the slices at t = 0.
static tf_meeting meet_at_start(const tf_arithmetic *arithmetic,
                                const tf_pair *pair)
{
    tf_pair start = *pair;
    start.count = start.early;
    return meet_at_once(arithmetic, &start);
}

//: Meet in a hyperplane
static tf_meeting meet_in_hyperplane(const tf_arithmetic *arithmetic,
                                     const tf_pair *pair)
{
    return meet_in_shadows(arithmetic, pair, tf_meet);
}

//: Meet in space-time
tf_meeting tf_meet(const tf_arithmetic *arithmetic, const tf_pair *pair)
{
    TF_REQUIRE(pair->count == pair->axes + 3);
    tf_meeting meeting;
    if (tf_complementary_meet(arithmetic, pair, &meeting))
        return meeting;

    // The faces tell whether the pair meets; on a line it has none and coincides.
    meeting = meet_in_faces(arithmetic, pair, meet_in_hyperplane);
    if (meeting.verdict == TF_APART && pair->axes > 1)
        return meeting;

    // A pair that meets later than t = 0 has a face that meets then; one that
    // meets at t = 0 may have none that does: the slices tell.
    tf_meeting start = meet_at_start(arithmetic, pair);
    meeting =
        start.verdict == TF_HIT ? start : tf_meeting_earlier(&start, &meeting);
    meeting.decision = TF_DEGENERATE;
    meeting.unique = false;
    return meeting;
}
