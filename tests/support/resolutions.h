// Proposals resolved, and what may be wrong with how.
#ifndef SUPPORT_RESOLUTIONS_H
#define SUPPORT_RESOLUTIONS_H

#include "response/resolve.h"
#include "support/proposals.h"

/// How often what happened.
typedef struct resolution_counts {
    long tries;   ///< proposals from clear starts
    long met;     ///< of these, with contacts
    long rescued; ///< of these, such that the failsafe was needed
    long held;    ///< of these, such that it held back scripted vertices
    long rested;  ///< or put others to rest
    long exact;   ///< judged on the way, too, pair by pair
    long
        shortened; ///< of those held back, such that all went a part of the way
    int rounds;    ///< of the failsafe, most
} resolution_counts;

/// What is wrong with a proposal of this start, resolved with these options;
/// NULL if nothing is.  Static storage.  Replaces the end.
/// @param weighed whether the inverse masses count
/// @param exactly whether to judge pairs of elements on the way, too
const char *resolution_fault(proposal *made, bool weighed, bool exactly,
                             const tf_response_options *options,
                             tf_response_report *report);

/// Where the vertices of the proposal that was last resolved would end without
/// what pushes pairs apart.  Static storage.
const double *resolution_motion(void);

/// One line to standard output.
void resolution_counts_print(const resolution_counts *counts);

/// What is wrong with the proposal of a number, by seed, with options that
/// depend on it, too; NULL if nothing is.  Static storage.
const char *numbered_fault(long number, resolution_counts *counts);

#endif
