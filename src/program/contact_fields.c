//: Include what the fields of a contact need
#include "program/contact_fields.h"

#include <math.h>

//: Take the values of a contact
static const char *const classifications[] = {
    [TF_GENERIC] = "generic",
    [TF_TOUCHING] = "touching",
    [TF_DEGENERATE] = "degenerate",
};

tf_contact_values tf_contact_values_of(const tf_contact *contact, int axes)
{
    if (contact->verdict == TF_APART)
        return (tf_contact_values){NAN, NAN, {NAN, NAN, NAN}, NAN, NULL};
    const double *normal = contact->normal;
    return (tf_contact_values){
        .toi_lo = contact->toi_lo,
        .toi_hi = contact->toi_hi,
        .normal = {normal[0], normal[1], axes == 2 ? NAN : normal[2]},
        .normal_velocity = contact->normal_velocity,
        .name = classifications[contact->classification],
    };
}
