#include "support/counting_arithmetic.h"

#include "arithmetic/functions.h"

#include <stddef.h>

static const tf_arithmetic *counted_one;
static evaluations so_far;

static tf_sign count_sign(const tf_differences *differences)
{
    so_far.signs++;
    return counted_one->sign(differences);
}

static tf_value count_value(const tf_differences *differences)
{
    so_far.values++;
    return counted_one->value(differences);
}

static bool count_six(int start_count, const tf_event *const event[TF_SIX],
                      tf_value value[TF_SIX])
{
    bool found = counted_one->six(start_count, event, value);
    so_far.values += found ? TF_SIX : 0;
    return found;
}

static bool count_cross(const tf_differences *rows, tf_value component[TF_AXES])
{
    bool found = counted_one->cross(rows, component);
    so_far.values += found ? TF_AXES : 0;
    return found;
}

tf_arithmetic counting(const tf_arithmetic *arithmetic)
{
    counted_one = arithmetic;
    so_far = (evaluations){0, 0};
    tf_arithmetic counts = *arithmetic;
    counts.sign = count_sign;
    counts.value = count_value;
    // Found one by one, so that as few are counted as are needed.
    counts.six_signs = NULL;
    counts.six_estimates = NULL;
    counts.six = arithmetic->six ? count_six : NULL;
    counts.cross = arithmetic->cross ? count_cross : NULL;
    return counts;
}

evaluations counted(void)
{
    return so_far;
}
