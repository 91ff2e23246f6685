//: Round the differences
#include "arithmetic/differences.h"

#include "base/require.h"

void tf_differences_round(const tf_differences *differences,
                          double entry[TF_AXES][TF_AXES])
{
    const tf_differences *d = differences;
    TF_REQUIRE(d->n >= 1 && d->n <= TF_AXES);
    for (int j = 0; j < d->n; j++) {
        int k = d->axis[j];
        for (int i = 0; i < d->n; i++)
            entry[i][j] = d->to[i]->x[k] - d->from[i]->x[k];
    }
}
