//: Declare the fields of a contact
#pragma once

#include "files/record.h"
#include "query/contact.h"

/// What is written of a contact.  Without one no number is a number, nor is nz
/// in the plane.
typedef struct tf_contact_values {
    double toi_lo, toi_hi, normal[3], normal_velocity;
    const char *name; ///< of its case; NULL: there is no contact
} tf_contact_values;

tf_contact_values tf_contact_values_of(const tf_contact *contact, int axes);

/// The fields of the values that are a member of a record.
#define TF_CONTACT_FIELDS(record, member)                                      \
    TF_FIELD("toi_lo", record, member.toi_lo),                                 \
        TF_FIELD("toi_hi", record, member.toi_hi),                             \
        TF_FIELD("nx", record, member.normal[0]),                              \
        TF_FIELD("ny", record, member.normal[1]),                              \
        TF_FIELD("nz", record, member.normal[2]),                              \
        TF_FIELD("normal_velocity", record, member.normal_velocity),           \
        TF_FIELD("case", record, member.name)
