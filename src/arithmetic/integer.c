//: Include what integers need
#include "arithmetic/integer.h"

#include "arithmetic/functions.h"
#include "arithmetic/int128.h"

#include <stdint.h>

//: Expand a determinant of integers
// Entries are differences of integers below 2^b, so at most m < 2^(b+1).  A 2x2
// determinant of entries up to m is at most 2 m^2 and a 3x3 one 4 m^3, in
// absolute value, and so is every intermediate result.  With the sign that is
// 2b + 4 and 3b + 6 bits: 64 hold b = 30 and 19, 128 hold 62 and 40.
#define DETERMINANT(n, e)                                                      \
    ((n) == 1   ? e[0][0]                                                      \
     : (n) == 2 ? e[0][0] * e[1][1] - e[0][1] * e[1][0]                        \
                : e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +          \
                      e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +      \
                      e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]))

//: Take differences of integers
/// The entries as integers.  Each fits: coordinates have at most 53 bits.
static void integer_entries(const tf_differences *d,
                            int64_t entry[TF_AXES][TF_AXES])
{
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < d->n; j++)
            entry[i][j] = (int64_t)d->to[i]->x[d->axis[j]] -
                          (int64_t)d->from[i]->x[d->axis[j]];
}

//: Evaluate a determinant in 64 bits
static int64_t determinant64(const tf_differences *differences)
{
    int64_t entry[TF_AXES][TF_AXES];
    integer_entries(differences, entry);
    return DETERMINANT(differences->n, entry);
}

static tf_sign sign64(const tf_differences *differences)
{
    int64_t d = determinant64(differences);
    return (tf_sign)((d > 0) - (d < 0));
}

static tf_value value64(const tf_differences *differences)
{
    return (tf_value){.number = (double)determinant64(differences)};
}

//: Evaluate a determinant in 128 bits
static tf_int128 determinant128(const tf_differences *differences)
{
    int64_t narrow[TF_AXES][TF_AXES];
    tf_int128 entry[TF_AXES][TF_AXES];
    integer_entries(differences, narrow);
    for (int i = 0; i < differences->n; i++)
        for (int j = 0; j < differences->n; j++)
            entry[i][j] = narrow[i][j];
    return DETERMINANT(differences->n, entry);
}

static tf_sign sign128(const tf_differences *differences)
{
    tf_int128 d = determinant128(differences);
    return (tf_sign)((d > 0) - (d < 0));
}

static tf_value value128(const tf_differences *differences)
{
    return (tf_value){.number = (double)determinant128(differences)};
}

//: Name the two integer arithmetics
const tf_arithmetic tf_integer64 = {
    .name = "integer64",
    .bits = {[2] = 30, [3] = 19},
    .sign = sign64,
    .value = value64,
};

// In the plane 62 bits would fit, but a double has no more than 53.
const tf_arithmetic tf_integer128 = {
    .name = "integer128",
    .bits = {[2] = 53, [3] = 40},
    .sign = sign128,
    .value = value128,
};
