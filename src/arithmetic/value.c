//: Include what values need
#include "arithmetic/value.h"

#include "arithmetic/bits.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

//: Compare two values by size
/// The exponent of the largest number that the value may represent; INT_MIN if
/// that is zero or not finite.
static int magnitude(const tf_value *value)
{
    double largest = fabs(value->number) + value->radius;
    if (largest == 0 || !isfinite(largest))
        return INT_MIN;
    int biased = tf_biased_exponent(largest);
    return value->exponent + (biased > 0 ? biased - 1023 : ilogb(largest));
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

//: Find the largest value
/// The largest of the values that are finite and not certainly zero, by the
/// magnitude, and this magnitude; NULL if there is none.
static const tf_value *find_largest(int count, const tf_value value[],
                                    int *size)
{
    const tf_value *largest = NULL;
    for (int i = 0; i < count; i++) {
        int own = magnitude(&value[i]);
        if (own == INT_MIN)
            continue;
        int order = largest ? compare_orders(&value[i], largest) : -1;
        if (order < 0 || (order == 0 && own > *size)) {
            largest = &value[i];
            *size = own;
        }
    }
    return largest;
}

//: Scale values to the largest
/// x 2^shift
static double scale_number(double x, int shift)
{
    return shift >= -1022 && shift <= 1023 ? x * tf_power_of_two(shift)
                                           : ldexp(x, shift);
}

static void scale(tf_value *value, const tf_value *largest, int size)
{
    bool known = isfinite(value->number + value->radius);
    if (known && compare_orders(value, largest) != 0) {
        *value = (tf_value){.number = 0};
        return;
    }
    int shift = value->exponent - size;
    double lost = shift < 0 && value->radius > 0 ? DBL_TRUE_MIN : 0;
    *value = (tf_value){.number = scale_number(value->number, shift),
                        .radius = scale_number(value->radius, shift) + lost};
}

void tf_values_scale(int count, tf_value value[])
{
    int size = INT_MIN;
    const tf_value *found = find_largest(count, value, &size);
    if (!found)
        return;
    tf_value largest = *found;
    for (int i = 0; i < count; i++)
        scale(&value[i], &largest, size);
}
