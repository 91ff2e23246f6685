// Six events of a pair in space, and the determinants without each of them.
#ifndef SUPPORT_SIX_H
#define SUPPORT_SIX_H

#include "arithmetic/functions.h"
#include "support/generator.h"

typedef struct six_events {
    int start_count; ///< the first 2, 3 or 4 are at t = 0
    tf_event event[TF_SIX];
} six_events;

/// Coordinates that are of one of several kinds on each axis: small integers, a
/// few large ones, or reals of about one size or of several.
six_events six_any(generator *random);

/// Six events in one plane but for rounding, or near it.
six_events six_flat(generator *random);

/// The events by their addresses, as the library wants them.
void six_list(const six_events *six, const tf_event *list[TF_SIX]);

/// The determinant without event i.
tf_differences six_without(const six_events *six, int i);

/// The coordinates in hexadecimal.  Static storage.
const char *six_text(const six_events *six);

#endif
