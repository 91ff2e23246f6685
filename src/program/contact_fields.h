//: Declare the fields of a contact
#pragma once

#include "query/contact.h"

#include <stdio.h>

/// The names of the cases, from TF_GENERIC to TF_DEGENERATE.
extern const char *const tf_classification_names[];

/// Write the fields toi_lo, toi_hi, nx, ny, nz, normal_velocity and case to the
/// end of a row or object: their names, the numbers as %.17g, and nothing, or
/// null, where there is no contact or, in the plane, no nz.
void tf_contact_head_csv(FILE *stream);
void tf_contact_write_csv(FILE *stream, int axes, const tf_contact *contact);
void tf_contact_write_json(FILE *stream, int axes, const tf_contact *contact);
