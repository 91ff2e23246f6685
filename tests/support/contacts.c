#include "support/contacts.h"

#include <math.h>

static bool same_numbers(int count, const double a[], const double b[])
{
    for (int i = 0; i < count; i++)
        if (a[i] != b[i] && !(isnan(a[i]) && isnan(b[i])))
            return false;
    return true;
}

bool contacts_are_same(const tf_contact *a, const tf_contact *b)
{
    return a->verdict == b->verdict && a->classification == b->classification &&
           same_numbers(1, &a->toi_lo, &b->toi_lo) &&
           same_numbers(1, &a->toi_hi, &b->toi_hi) &&
           same_numbers(3, a->barycentric[0], b->barycentric[0]) &&
           same_numbers(3, a->barycentric[1], b->barycentric[1]) &&
           same_numbers(3, a->normal, b->normal) &&
           same_numbers(3, a->velocity, b->velocity) &&
           same_numbers(1, &a->normal_velocity, &b->normal_velocity);
}

bool contacts_share_time(const tf_contact *a, const tf_contact *b)
{
    return a->toi_lo <= b->toi_hi && b->toi_lo <= a->toi_hi;
}
