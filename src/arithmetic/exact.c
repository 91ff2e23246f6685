//: Include what exact signs need
#include "arithmetic/exact.h"

#include "arithmetic/accumulated.h"
#include "arithmetic/filter.h"
#include "arithmetic/fixed.h"
#include "arithmetic/functions.h"
#include "arithmetic/six.h"

#include <math.h>

//: Compare the rows
static bool at_one_place(const tf_differences *d, const tf_event *a,
                         const tf_event *b)
{
    for (int j = 0; j < d->n; j++)
        if (a->x[d->axis[j]] != b->x[d->axis[j]])
            return false;
    return true;
}

/// Whether two rows are differences of the same coordinates.
static bool some_row_repeats(const tf_differences *d)
{
    for (int i = 1; i < d->n; i++)
        for (int j = 0; j < i; j++)
            if (at_one_place(d, d->to[i], d->to[j]) &&
                at_one_place(d, d->from[i], d->from[j]))
                return true;
    return false;
}

//: Find an exact sign
static tf_sign exact_sign(const tf_differences *differences)
{
    //: Try the estimate
    tf_estimate estimate = tf_differences_estimate(differences);
    if (fabs(estimate.number) > estimate.bound)
        return estimate.number > 0 ? TF_POSITIVE : TF_NEGATIVE;
    if (estimate.bound == 0)
        return TF_ZERO;

    //: Recognize a repeated row
    if (some_row_repeats(differences))
        return TF_ZERO;

    //: Try the grid, then accumulate
    tf_sign sign;
    bool on_grid = tf_fixed_sign(differences, &sign);
    return on_grid ? sign : tf_accumulated_sign(differences);
}

//: Find an exact value
static tf_value exact_value(const tf_differences *differences)
{
    tf_value value;
    bool on_grid = tf_fixed_value(differences, &value);
    return on_grid ? value : tf_accumulated_value(differences);
}

//: Name the exact arithmetic
const tf_arithmetic tf_exact = {
    .name = "exact",
    .sign = exact_sign,
    .value = exact_value,
    .six = tf_fixed_six,
    .six_signs = tf_fixed_six_signs,
    .six_estimates = tf_estimate_six,
    .cross = tf_fixed_cross,
};
