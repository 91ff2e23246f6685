//: Include what complementary simplices need
#include "spacetime/complementary.h"

#include "contract.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

//: Pair two swept simplices
static void add_events(tf_pair *pair, const tf_simplex *simplex, int side,
                       int t)
{
    int early = simplex->mover + 1;
    for (int i = t ? early : 0; i < (t ? simplex->count : early); i++) {
        pair->event[pair->count] = simplex->event[i];
        pair->side[pair->count++] = side;
    }
}

tf_pair tf_pair_of(const tf_simplex *s, const tf_simplex *r, int axes)
{
    TF_REQUIRE(s->count + r->count == axes + 3);
    tf_pair pair = {.axes = axes, .axis = {0, 1, 2}};
    add_events(&pair, s, +1, 0);
    add_events(&pair, r, -1, 0);
    pair.early = pair.count;
    add_events(&pair, s, +1, 1);
    add_events(&pair, r, -1, 1);
    return pair;
}

//: Take differences within each time
/// Add the differences of the events begin..end-1 to the first of them.
static void add_differences(const tf_pair *pair, int without, int begin,
                            int end, tf_differences *differences)
{
    int first = begin == without ? begin + 1 : begin;
    for (int i = first + 1; i < end; i++) {
        if (i == without)
            continue;
        differences->to[differences->n] = pair->event[i];
        differences->from[differences->n++] = pair->event[first];
    }
}

tf_differences tf_pair_differences(const tf_pair *pair, int without)
{
    tf_differences differences;
    differences.n = 0;
    memcpy(differences.axis, pair->axis, sizeof differences.axis);
    add_differences(pair, without, 0, pair->early, &differences);
    add_differences(pair, without, pair->early, pair->count, &differences);
    return differences;
}

//: Orient a barycentric coordinate
/// +1 or -1: what turns the determinant of the differences without event i into
/// a positive multiple of the event's barycentric coordinate, counted positive
/// on S and negative on R.  Sorting a determinant's rows by time, subtracting
/// the first of each time and expanding along the columns t and 1 leaves
/// (-1)^(number at t = 0) times the determinant of the differences, so beside
/// the (-1)^i of Cramer's rule only the late events change sign.
static int orientation(const tf_pair *pair, int i)
{
    int alternating = i % 2 == 0 ? 1 : -1;
    int late = i < pair->early ? 1 : -1;
    return alternating * late * pair->side[i];
}

//: Measure one side along an axis
typedef struct range {
    double low, high;
} range;

/// The range of one side's coordinates on an axis; starts at event *i and stops
/// where the side or the time ends.
static range side_range(const tf_pair *pair, int axis, int *i, int end)
{
    range r = {INFINITY, -INFINITY};
    for (int side = pair->side[*i]; *i < end && pair->side[*i] == side; ++*i) {
        double x = pair->event[*i]->x[axis];
        r.low = x < r.low ? x : r.low;
        r.high = x > r.high ? x : r.high;
    }
    return r;
}

//: Separate a pair by an axis
/// Which side has the larger coordinates on an axis at one time: +1 if all of S
/// are larger than all of R, -1 the reverse, 0 neither.
static int larger_side(const tf_pair *pair, int axis, int begin, int end)
{
    int i = begin;
    range s = side_range(pair, axis, &i, end);
    range r = side_range(pair, axis, &i, end);
    return (s.low > r.high) - (s.high < r.low);
}

/// Whether S keeps strictly to one side of R on an axis.  Then the shadows of
/// the two on the plane of that axis and time are apart.
static bool separated_by_an_axis(const tf_pair *pair)
{
    for (int k = 0; k < pair->axes; k++) {
        int axis = pair->axis[k];
        int side = larger_side(pair, axis, 0, pair->early);
        if (side == 0)
            continue;
        if (pair->early == pair->count ||
            side == larger_side(pair, axis, pair->early, pair->count))
            return true;
    }
    return false;
}

//: Collect the barycentric signs
/// Which signs occur among the barycentric coordinates, turned so that S and R
/// meet when all agree.
typedef struct signs {
    bool positive, negative, zero, unknown;
    tf_sign of[TF_PAIR_EVENTS];
} signs;

//: Stop at the first conflict
static signs collect_signs(const tf_arithmetic *arithmetic, const tf_pair *pair)
{
    signs found = {0};
    for (int i = 0; i < pair->count; i++) {
        tf_differences differences = tf_pair_differences(pair, i);
        tf_sign sign = arithmetic->sign(&differences);
        if (sign == TF_POSITIVE || sign == TF_NEGATIVE)
            sign = (tf_sign)(sign * orientation(pair, i));
        found.of[i] = sign;
        found.positive |= sign == TF_POSITIVE;
        found.negative |= sign == TF_NEGATIVE;
        found.zero |= sign == TF_ZERO;
        found.unknown |= sign == TF_UNKNOWN;
        if (found.positive && found.negative)
            break;
    }
    return found;
}

//: Compare two values by size
/// The exponent of the largest number that the value may stand for; INT_MIN if
/// that is zero or not known.
static int magnitude(const tf_value *value)
{
    double largest = fabs(value->number) + value->radius;
    return largest == 0 || !isfinite(largest)
               ? INT_MIN
               : value->exponent + ilogb(largest);
}

/// Less than 0 if the order of a is the earlier, so that a is infinitely
/// larger; 0 if it is the same; otherwise more.
static int compare_orders(const tf_value *a, const tf_value *b)
{
    for (int i = 0; i < TF_AXES; i++)
        if (a->order[i] != b->order[i])
            return a->order[i] < b->order[i] ? -1 : 1;
    return 0;
}

/// Whether a is known to be not zero, and larger than b.
static bool exceeds(const tf_value *a, const tf_value *b)
{
    if (magnitude(a) == INT_MIN || magnitude(b) == INT_MIN)
        return magnitude(a) != INT_MIN;
    int order = compare_orders(a, b);
    return order < 0 || (order == 0 && magnitude(a) > magnitude(b));
}

//: Scale values to the largest
static tf_value scale(const tf_value *value, const tf_value *largest)
{
    bool known = isfinite(value->number + value->radius);
    if (known && compare_orders(value, largest) != 0)
        return (tf_value){.number = 0};
    int shift = value->exponent - magnitude(largest);
    double lost = shift < 0 && value->radius > 0 ? DBL_TRUE_MIN : 0;
    return (tf_value){.number = ldexp(value->number, shift),
                      .radius = ldexp(value->radius, shift) + lost};
}

void tf_values_scale(int count, tf_value value[])
{
    tf_value largest = {.number = 0};
    for (int i = 0; i < count; i++)
        if (exceeds(&value[i], &largest))
            largest = value[i];
    if (largest.number == 0 && largest.radius == 0)
        return;
    for (int i = 0; i < count; i++)
        value[i] = scale(&value[i], &largest);
}

//: Enclose the barycentric coordinates
/// The barycentric coordinates up to one common factor, all >= 0: enclosed but
/// for the rounding that a value may hide, and zero where certainly so.
typedef struct coordinates {
    double low[TF_PAIR_EVENTS], high[TF_PAIR_EVENTS];
} coordinates;

static coordinates enclose_coordinates(const tf_arithmetic *arithmetic,
                                       const tf_pair *pair, const signs *found)
{
    //: Evaluate each coordinate
    tf_value value[TF_PAIR_EVENTS] = {{0}};
    for (int i = 0; i < pair->count; i++) {
        if (found->of[i] == TF_ZERO)
            continue;
        tf_differences differences = tf_pair_differences(pair, i);
        value[i] = arithmetic->value(&differences);
        value[i].number *= orientation(pair, i) * (found->negative ? -1 : 1);
    }
    tf_values_scale(pair->count, value);

    //: Put bounds to each coordinate
    coordinates c = {.low = {0}, .high = {0}};
    for (int i = 0; i < pair->count; i++) {
        if (found->of[i] == TF_ZERO)
            continue;
        bool known = isfinite(value[i].number + value[i].radius);
        c.low[i] = known ? fmax(value[i].number - value[i].radius, 0) : 0;

        // However small, what is not certainly zero stays so.
        c.high[i] = known
                        ? fmax(value[i].number + value[i].radius, DBL_TRUE_MIN)
                        : INFINITY;
    }
    return c;
}

//: Enclose the time of impact
/// The side with fewer events: at most three, at most two of them at one time.
static int smaller_side(const tf_pair *pair)
{
    int sum = 0;
    for (int i = 0; i < pair->count; i++)
        sum += pair->side[i];
    return sum <= 0 ? +1 : -1;
}

/// How far late / (early + late) may be from the true ratio t.  Each value
/// hides one rounding, at most one sum within a time, the sum of the times and
/// the quotient add one each: the first three change t by less than
/// 3 t (1 - t) u, the last two by 2 t u; one more t u covers the rounding of
/// the bounds themselves, and 2^-40 t u the second order.
static double ratio_margin(double t)
{
    return t * (6 + 0x1p-40 - 3 * t) * (DBL_EPSILON / 2) + 0x1p-1070;
}

static void enclose_time(const tf_pair *pair, const coordinates *c,
                         tf_meeting *meeting)
{
    //: Sum the coordinates of one side by time
    int side = smaller_side(pair);
    double low[2] = {0, 0}, high[2] = {0, 0};
    for (int i = 0; i < pair->count; i++) {
        if (pair->side[i] != side)
            continue;
        low[i >= pair->early] += c->low[i];
        high[i >= pair->early] += c->high[i];
    }

    //: Weigh the late events against the early
    double first = low[1] / (low[1] + high[0]);
    double last = high[1] / (high[1] + low[0]);
    bool early_only = high[0] > high[1] && high[1] == 0;
    bool late_only = high[1] > high[0] && high[0] == 0;
    meeting->toi_lo = late_only    ? 1
                      : first >= 0 ? fmax(first - ratio_margin(first), 0)
                                   : 0;
    meeting->toi_hi = early_only  ? 0
                      : last <= 1 ? fmin(last + ratio_margin(last), 1)
                                  : 1;
}

//: Normalize the weights
static void normalize_weights(const tf_pair *pair, const coordinates *c,
                              tf_meeting *meeting)
{
    for (int side = -1; side <= 1; side += 2) {
        double sum = 0, events = 0;
        for (int i = 0; i < pair->count; i++) {
            events += pair->side[i] == side;
            sum += pair->side[i] == side ? c->low[i] + c->high[i] : 0;
        }

        // Where the coordinates are not known at all the middle is as good.
        bool known = sum > 0 && isfinite(sum);
        for (int i = 0; i < pair->count; i++)
            if (pair->side[i] == side)
                meeting->weight[i] =
                    known ? (c->low[i] + c->high[i]) / sum : 1 / events;
    }
}

//: Decide by barycentric signs
const tf_meeting tf_meeting_apart = {.verdict = TF_APART, .unique = true};

bool tf_complementary_meet(const tf_arithmetic *arithmetic, const tf_pair *pair,
                           tf_meeting *meeting)
{
    *meeting = tf_meeting_apart;
    if (separated_by_an_axis(pair))
        return true;

    signs found = collect_signs(arithmetic, pair);
    bool unique = found.positive || found.negative;
    if (found.positive && found.negative)
        return true;
    if (!unique && !found.unknown)
        return false;

    //: Describe the common point
    coordinates c = enclose_coordinates(arithmetic, pair, &found);
    meeting->verdict = found.unknown ? TF_UNDECIDED : TF_HIT;
    meeting->decision = found.zero || found.unknown ? TF_TOUCHING : TF_GENERIC;
    meeting->unique = unique;
    if (unique)
        enclose_time(pair, &c, meeting);
    else
        meeting->toi_hi = pair->early == pair->count ? 0 : 1;
    normalize_weights(pair, &c, meeting);
    return true;
}
