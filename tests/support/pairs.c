#include "support/pairs.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void add_event(own_pair *own, int operand, int t)
{
    tf_pair *pair = &own->pair;
    tf_event *event = &own->event[pair->count];
    event->t = t;
    pair->event[pair->count] = event;
    pair->operand[pair->count++] = operand;
    pair->start_count += t == 0;
}

static void add_events(own_pair *own, int operand, int t, int count)
{
    for (int i = 0; i < count; i++)
        add_event(own, operand, t);
}

void shape_moving(own_pair *own, int shape)
{
    // Events of S and of R at t = 0, then at t = 1.
    static const int events[SHAPES][4] = {
        {1, 2, 1, 1}, {1, 1, 1, 2}, {1, 3, 1, 1},
        {1, 2, 1, 2}, {1, 1, 1, 3}, {2, 1, 1, 2},
    };
    own->pair = (tf_pair){.axes = shape < 2 ? 2 : 3, .axis = {0, 1, 2}};
    for (int t = 0; t < 2; t++) {
        add_events(own, +1, t, events[shape][2 * t]);
        add_events(own, -1, t, events[shape][2 * t + 1]);
    }
}

void shape_static(own_pair *own, int axes, int first, int second)
{
    own->pair = (tf_pair){.axes = axes, .axis = {0, 1, 2}};
    add_events(own, +1, 0, first);
    add_events(own, -1, 0, second);
}

void find_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                tf_signs *signs)
{
    if (!tf_pair_sure_signs(arithmetic, pair, signs))
        tf_pair_other_signs(arithmetic, pair, signs);
}

int pair_size(const own_pair *own)
{
    return own->pair.count * own->pair.axes;
}

double *pair_coordinate(own_pair *own, int i)
{
    return &own->event[i / own->pair.axes].x[i % own->pair.axes];
}

static oracle_simplex simplex_of(const own_pair *own, int operand)
{
    oracle_simplex simplex = {.count = 0};
    for (int i = 0; i < own->pair.count; i++)
        if (own->pair.operand[i] == operand)
            simplex.event[simplex.count++] = own->pair.event[i];
    return simplex;
}

/// What is wrong with the coordinates: those of each operand are not negative
/// and sum to 1, and if exact their two points are one.
static const char *coordinates_fault(const tf_pair *pair,
                                     const tf_intersection *found, bool exact)
{
    enum {
        TIME = TF_AXES,
        ONE
    };
    double sum[2][TF_AXES + 2] = {{0}}, size = 1;
    for (int i = 0; i < pair->count; i++) {
        double own = found->barycentric[i], *to = sum[pair->operand[i] > 0];
        if (!(own >= 0))
            return "a negative coordinate";
        for (int k = 0; k < pair->axes; k++) {
            to[k] += own * pair->event[i]->x[k];
            size = fmax(size, fabs(pair->event[i]->x[k]));
        }
        to[TIME] += own * pair->event[i]->t;
        to[ONE] += own;
    }
    if (fabs(sum[0][ONE] - 1) > 1e-12 || fabs(sum[1][ONE] - 1) > 1e-12)
        return "coordinates that do not sum to 1";
    if (!exact)
        return NULL;
    for (int k = 0; k <= TIME; k++)
        if (fabs(sum[0][k] - sum[1][k]) > 1e-9 * size)
            return "coordinates of two different points";
    return fabs(sum[0][TIME] - found->toi_lo) > 1e-9
               ? "coordinates of a later time"
               : NULL;
}

static const char *time_fault(const tf_intersection *found, bool exact,
                              const mpq_t toi)
{
    mpq_t bound;
    mpq_init(bound);
    mpq_set_d(bound, found->toi_lo);
    bool late = mpq_cmp(bound, toi) > 0;
    mpq_set_d(bound, found->toi_hi);
    bool early = mpq_cmp(bound, toi) < 0;
    mpq_clear(bound);
    if (late || early)
        return "times that do not enclose the true one";
    double width = found->toi_hi - found->toi_lo;
    return exact && width > 0x1p-50 ? "a wide enclosure" : NULL;
}

const char *intersection_fault(const own_pair *own,
                               const tf_intersection *found, bool exact)
{
    const tf_pair *pair = &own->pair;
    oracle_simplex s = simplex_of(own, +1), r = simplex_of(own, -1);
    bool moving = pair->start_count < pair->count;
    mpq_t toi;
    mpq_init(toi);
    bool hit = moving ? oracle_simplices_meet(pair->axes, &s, &r, toi)
                      : oracle_slices_meet(pair->axes, &s, &r);
    const char *fault = NULL;
    if (exact && found->verdict == TF_UNDECIDED)
        fault = "no verdict";
    else if (hit && found->verdict == TF_APART)
        fault = "a missed intersection";
    else if (!hit && found->verdict == TF_HIT)
        fault = "an intersection that is none";
    else if (hit && moving)
        fault = time_fault(found, exact, toi);
    if (hit && !fault)
        fault = coordinates_fault(pair, found, exact);
    mpq_clear(toi);
    return fault;
}

const char *pair_text(const own_pair *own)
{
    static char text[TF_PAIR_EVENTS * 120];
    size_t length = 0;
    for (int i = 0; i < own->pair.count; i++) {
        const tf_event *event = own->pair.event[i];
        int written = snprintf(text + length, sizeof text - length,
                               "%c t=%d (%a, %a, %a)\n",
                               own->pair.operand[i] > 0 ? 'S' : 'R', event->t,
                               event->x[0], event->x[1], event->x[2]);
        length += (size_t)written;
    }
    return text;
}
