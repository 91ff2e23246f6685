// What a resolver tells of the step that it has resolved, against the step.
#ifndef SUPPORT_ANSWERS_H
#define SUPPORT_ANSWERS_H

#include "response/resolve.h"

/// A step that was resolved.
typedef struct answered_step {
    int axes, vertices;
    const double *start, *proposed, *end, *inverse_mass;
    const tf_response_options *options; ///< NULL: all zero
    const tf_response_report *report;
} answered_step;

/// What is wrong with the contacts and flags that the resolver lends; NULL if
/// nothing is.  Static storage.
/// @param[out] pushed how many vertices only pushes have moved; may be NULL
const char *answers_fault(tf_resolver *resolver, const answered_step *given,
                          int *pushed);

#endif
