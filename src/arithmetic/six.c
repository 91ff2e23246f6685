//: Include what six signs need
#include "arithmetic/six.h"

#include "base/always_inline.h"

#include <math.h>

//: Round four rows
/// The differences of four of six events to the first of their time.
typedef struct rounded_rows {
    double row[4][TF_AXES];
    int event[4]; ///< which event has the row
} rounded_rows;

TF_ALWAYS_INLINE void round_rows(int start_count,
                                 const tf_event *const event[TF_SIX],
                                 rounded_rows *rows)
{
    int count = 0;
    for (int i = 1; i < TF_SIX; i++) {
        if (i == start_count)
            continue;
        const tf_event *first = event[i < start_count ? 0 : start_count];
        for (int k = 0; k < TF_AXES; k++)
            rows->row[count][k] = event[i]->x[k] - first->x[k];
        rows->event[count++] = i;
    }
}

//: Bound six determinants
// Of the product of the largest differences on the three axes; proved in
// tests/proofs/six.gappa.
#define SHARE_SIX (192 * 0x1p-53)

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/// Whether no product of this size overflows, and underflow doesn't matter.
static inline bool is_safe(double product)
{
    return product >= 0x1p-900 && product <= 0x1p1000;
}

/// Infinite where something may overflow or underflow.
TF_ALWAYS_INLINE double bound_of(const rounded_rows *rows)
{
    double reach[TF_AXES] = {0, 0, 0};
    for (int k = 0; k < TF_AXES; k++)
        for (int j = 0; j < 4; j++)
            reach[k] = larger(reach[k], fabs(rows->row[j][k]));
    double xy = reach[0] * reach[1], yz = reach[1] * reach[2];
    double zx = reach[2] * reach[0], volume = xy * reach[2];
    bool safe = is_safe(xy) && is_safe(yz) && is_safe(zx) && is_safe(volume);
    return safe ? SHARE_SIX * volume : INFINITY;
}

//: Multiply rounded rows
static inline tf_vector cross_rounded(const double a[TF_AXES],
                                      const double b[TF_AXES])
{
    return (tf_vector){{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                        a[0] * b[1] - a[1] * b[0]}};
}

static inline double dot_rounded(const double a[TF_AXES], tf_vector b)
{
    return a[0] * b.x[0] + a[1] * b.x[1] + a[2] * b.x[2];
}

//: Estimate six determinants
TF_ALWAYS_INLINE void multiply_rows(int start_count, const rounded_rows *rows,
                                    double without[TF_SIX])
{
    const int *event = rows->event;
    tf_vector first = cross_rounded(rows->row[0], rows->row[1]);
    tf_vector last = cross_rounded(rows->row[2], rows->row[3]);
    without[event[0]] = dot_rounded(rows->row[1], last);
    without[event[1]] = dot_rounded(rows->row[0], last);
    without[event[2]] = dot_rounded(rows->row[3], first);
    without[event[3]] = dot_rounded(rows->row[2], first);
    without[0] = without[start_count] = 0;
    for (int j = 0; j < 4; j++) {
        int base = event[j] < start_count ? 0 : start_count;
        double own = without[event[j]];
        without[base] += (event[j] - base) % 2 != 0 ? own : -own;
    }
}

//: Find the signs that are certain
TF_ALWAYS_INLINE void estimate_six(int start_count,
                                   const tf_event *const event[TF_SIX],
                                   tf_sign sign[TF_SIX])
{
    rounded_rows rows;
    double without[TF_SIX];
    round_rows(start_count, event, &rows);
    multiply_rows(start_count, &rows, without);
    double bound = bound_of(&rows);
    for (int i = 0; i < TF_SIX; i++)
        sign[i] = without[i] > bound    ? TF_POSITIVE
                  : without[i] < -bound ? TF_NEGATIVE
                                        : TF_UNKNOWN;
}

void tf_estimate_six(int start_count, const tf_event *const event[TF_SIX],
                     tf_sign sign[TF_SIX])
{
    if (start_count == 2)
        estimate_six(2, event, sign);
    else if (start_count == 3)
        estimate_six(3, event, sign);
    else
        estimate_six(4, event, sign);
}
