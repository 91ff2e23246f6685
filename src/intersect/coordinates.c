//: Include what barycentric coordinates need
#include "intersect/coordinates.h"

#include "arithmetic/functions.h"
#include "arithmetic/value.h"

#include <math.h>

//: Put bounds on a coordinate
static void set_bounds(tf_coordinates *c, int i, const tf_value *value)
{
    double low = value->number - value->radius;
    double high = value->number + value->radius;
    bool known = isfinite(high);
    c->low[i] = known && low > 0 ? low : 0;

    // However small, what is not certainly zero must not become zero.
    c->high[i] = !known ? INFINITY : high > DBL_TRUE_MIN ? high : DBL_TRUE_MIN;
}

//: Find the values of coordinates
bool tf_pair_values(const tf_arithmetic *arithmetic, const tf_pair *pair,
                    tf_value value[TF_PAIR_EVENTS])
{
    return pair->count == TF_SIX && arithmetic->six &&
           arithmetic->six(pair->start_count, pair->event, value);
}

static tf_value value_of(const tf_arithmetic *arithmetic, const tf_pair *pair,
                         int i)
{
    tf_differences differences;
    tf_pair_differences(pair, i, &differences);
    return arithmetic->value(&differences);
}

//: Enclose the barycentric coordinates
void tf_pair_coordinates(const tf_arithmetic *arithmetic, const tf_pair *pair,
                         const tf_signs *signs, int operand,
                         const tf_value known[], tf_coordinates *coordinates)
{
    //: Evaluate each coordinate
    int turn = signs->negative ? -1 : 1;
    int count = 0, event[TF_PAIR_EVENTS];
    tf_value value[TF_PAIR_EVENTS];
    for (int i = 0; i < pair->count; i++) {
        coordinates->low[i] = coordinates->high[i] = 0;
        if (pair->operand[i] != operand || signs->sign[i] == TF_ZERO)
            continue;
        value[count] = known ? known[i] : value_of(arithmetic, pair, i);
        value[count].number *= tf_pair_orientation(pair, i) * turn;
        event[count++] = i;
    }
    tf_values_scale(count, value);

    //: Collect the bounds
    for (int i = 0; i < count; i++)
        set_bounds(coordinates, event[i], &value[i]);
}

//: Normalize barycentric coordinates
void tf_coordinates_normalize(const tf_coordinates *c, const tf_pair *pair,
                              int operand, double barycentric[TF_PAIR_EVENTS])
{
    double sum = 0, events = 0;
    for (int i = 0; i < pair->count; i++) {
        events += pair->operand[i] == operand;
        sum += c->low[i] + c->high[i];
    }
    bool known = sum > 0 && isfinite(sum);
    for (int i = 0; i < pair->count; i++)
        if (pair->operand[i] == operand)
            barycentric[i] =
                known ? (c->low[i] + c->high[i]) / sum : 1 / events;
}
