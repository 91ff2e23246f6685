//: Include what perturbation needs
#include "arithmetic/perturbed.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/six.h"
#include "base/require.h"

//: Rank an event
/// The place of an event among all of a mesh: an event of higher rank moves
/// less.
static int64_t rank_of(const tf_event *event)
{
    TF_REQUIRE(event->vertex >= 0);
    return 2 * (int64_t)event->vertex + event->t;
}

//: Hold a determinant and its events
enum {
    MOST_EVENTS = 2 * TF_AXES
};

/// A determinant and its events by rank; to[i] and from[i] are indices of
/// `event`.
typedef struct ranked_determinant {
    int n, axis[TF_AXES], to[TF_AXES], from[TF_AXES];
    int count;
    const tf_event *event[MOST_EVENTS];
} ranked_determinant;

//: Rank the events of a determinant
/// The first index whose event does not rank below `event`.
static int index_of(const ranked_determinant *r, const tf_event *event)
{
    int index = 0;
    while (index < r->count && rank_of(r->event[index]) < rank_of(event))
        index++;
    return index;
}

static bool vertex_has_its_own_index(const ranked_determinant *r, int index,
                                     const tf_event *event)
{
    return index == r->count || rank_of(r->event[index]) != rank_of(event);
}

static void add_event(ranked_determinant *r, const tf_event *event)
{
    int index = index_of(r, event);
    if (index < r->count && r->event[index] == event)
        return;
    TF_REQUIRE(vertex_has_its_own_index(r, index, event));
    for (int i = r->count++; i > index; i--)
        r->event[i] = r->event[i - 1];
    r->event[index] = event;
}

static ranked_determinant rank_events(const tf_differences *differences)
{
    ranked_determinant r = {.n = differences->n};
    for (int i = 0; i < r.n; i++) {
        add_event(&r, differences->to[i]);
        add_event(&r, differences->from[i]);
    }
    for (int i = 0; i < r.n; i++) {
        r.axis[i] = differences->axis[i];
        r.to[i] = index_of(&r, differences->to[i]);
        r.from[i] = index_of(&r, differences->from[i]);
    }
    return r;
}

//: Hold a term
/// A term of the determinant, a polynomial in the infinitesimals: on each axis
/// the index of the event whose infinitesimal is a factor, or STAYS.
typedef struct term {
    int moved[TF_AXES];
} term;

enum {
    STAYS = -1
};

//: Differentiate a determinant
/// The determinant that multiplies the infinitesimals of a term.  On an axis
/// along which an event moves it has the coordinate 1 for that event and 0 for
/// all others.  Refers to `event`.
static tf_differences coefficient(const ranked_determinant *r, const term *t,
                                  tf_event event[MOST_EVENTS])
{
    for (int e = 0; e < r->count; e++) {
        event[e] = *r->event[e];
        for (int k = 0; k < TF_AXES; k++)
            if (t->moved[k] != STAYS)
                event[e].x[k] = t->moved[k] == e;
    }
    tf_differences d = {.n = r->n};
    for (int i = 0; i < r->n; i++) {
        d.axis[i] = r->axis[i];
        d.to[i] = &event[r->to[i]];
        d.from[i] = &event[r->from[i]];
    }
    return d;
}

//: Find the leading term
static bool has_axis(const ranked_determinant *r, int axis)
{
    for (int j = 0; j < r->n; j++)
        if (r->axis[j] == axis)
            return true;
    return false;
}

static bool moves_nothing(const term *t)
{
    for (int axis = 0; axis < TF_AXES; axis++)
        if (t->moved[axis] != STAYS)
            return false;
    return true;
}

/// The sign of the part of the determinant in which the events of t have moved
/// and, of the others, only the first `count` may move.  The determinant
/// without moves is known to be zero.  If the sign is not zero, *t becomes the
/// leading term.
static tf_sign find_leading(const ranked_determinant *r, int count, term *t)
{
    //: Let no more events move
    if (count == 0) {
        if (moves_nothing(t))
            return TF_ZERO;
        tf_event event[MOST_EVENTS];
        tf_differences d = coefficient(r, t, event);
        return tf_exact.sign(&d);
    }

    //: Move the last event less than all before it
    tf_sign sign = find_leading(r, count - 1, t);
    for (int axis = 0; axis < TF_AXES && sign == TF_ZERO; axis++) {
        if (t->moved[axis] != STAYS || !has_axis(r, axis))
            continue;
        t->moved[axis] = count - 1;
        sign = find_leading(r, count - 1, t);
        if (sign == TF_ZERO)
            t->moved[axis] = STAYS;
    }
    return sign;
}

/// The leading term of a determinant that is zero where nothing moves, and its
/// sign.
static tf_sign leading_term(const ranked_determinant *r, term *t)
{
    *t = (term){.moved = {STAYS, STAYS, STAYS}};
    tf_sign sign = find_leading(r, r->count, t);
    TF_REQUIRE(sign != TF_ZERO);
    return sign;
}

//: Order a term among all
/// Lists the infinitesimals of a term, the smallest first, as numbers from 1.
static void order_term(const ranked_determinant *r, const term *t,
                       int64_t order[TF_AXES])
{
    int count = 0;
    for (int index = r->count - 1; index >= 0; index--)
        for (int axis = 0; axis < TF_AXES; axis++)
            if (t->moved[axis] == index)
                order[count++] = TF_AXES * rank_of(r->event[index]) + axis + 1;
}

//: Find a perturbed sign
static tf_sign perturbed_sign(const tf_differences *differences)
{
    tf_sign sign = tf_exact.sign(differences);
    if (sign != TF_ZERO)
        return sign;
    ranked_determinant r = rank_events(differences);
    term t;
    return leading_term(&r, &t);
}

//: Find a perturbed value
static tf_value perturbed_value(const tf_differences *differences)
{
    tf_value value = tf_exact.value(differences);
    if (value.number != 0)
        return value;
    ranked_determinant r = rank_events(differences);
    term t;
    leading_term(&r, &t);
    tf_event event[MOST_EVENTS];
    tf_differences d = coefficient(&r, &t, event);
    value = tf_exact.value(&d);
    order_term(&r, &t, value.order);
    return value;
}

//: Name the perturbed arithmetic
const tf_arithmetic tf_perturbed = {
    .name = "perturbed",
    .needs_indices = true,
    .sign = perturbed_sign,
    .value = perturbed_value,
    .six_estimates = tf_estimate_six,
};
