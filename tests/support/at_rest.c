#include "support/at_rest.h"

#include "support/oracle.h"

#include <string.h>

bool meet_at_rest(int axes, int count, double a[][3], int others, double b[][3])
{
    tf_event event[2 * ORACLE_EVENTS];
    oracle_simplex s = {.count = count}, r = {.count = others};
    for (int i = 0; i < count + others; i++) {
        const double *x = i < count ? a[i] : b[i - count];
        event[i] = (tf_event){.vertex = TF_NO_INDEX};
        memcpy(event[i].x, x, sizeof event[i].x);
        *(i < count ? &s.event[i] : &r.event[i - count]) = &event[i];
    }
    return oracle_slices_meet(axes, &s, &r);
}

void place_on_lattice(generator *random, int count, int n, double x[][3])
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            x[i][k] = below(random, n);
}
