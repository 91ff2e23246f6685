#include "support/query_changes.h"

#include <math.h>

void query_turn_axes(query *q, int first, bool backward)
{
    query before = *q;
    for (int i = 0; i < query_size(q); i += q->axes)
        for (int k = 0; k < q->axes; k++) {
            int from = first + (backward ? q->axes - k : k);
            *query_coordinate(q, i + k) =
                *query_coordinate(&before, i + from % q->axes);
        }
}

void query_mirror(query *q, int axis)
{
    for (int i = axis; i < query_size(q); i += q->axes)
        *query_coordinate(q, i) = -*query_coordinate(q, i);
}

void query_swap_elements(query *q)
{
    if (q->vertices != q->others)
        return;
    query before = *q;
    for (int i = 0; i < q->others; i++) {
        q->vertex[i] = before.vertex[q->vertices + i];
        q->vertex[q->vertices + i] = before.vertex[i];
    }
}

static void reverse(int vertices, const tf_worldline before[],
                    tf_worldline after[])
{
    for (int i = 0; i < vertices; i++)
        for (int t = 0; t < 2; t++)
            for (int k = 0; k < TF_AXES; k++)
                after[i].at[t].x[k] = before[vertices - 1 - i].at[1 - t].x[k];
}

query query_reversed(const query *q)
{
    query reversed = *q;
    reverse(q->vertices, q->vertex, reversed.vertex);
    reverse(q->others, query_const_others(q), query_others(&reversed));
    return reversed;
}

bool query_change_unit(query *q, int exponent)
{
    query scaled = *q;
    for (int i = 0; i < query_size(q); i++) {
        double *x = query_coordinate(&scaled, i), before = *x;
        *x = ldexp(before, exponent);
        if (ldexp(*x, -exponent) != before)
            return false;
    }
    *q = scaled;
    return true;
}
