//: Declare the attempts of an untangling
#pragma once

#include "untangle/limit.h"
#include "untangle/options.h"
#include "untangle/push.h"

/// What an untangling works with, from attempt to attempt.
typedef struct tf_attempts {
    tf_tangle tangle;
    const tf_untangle_options *options;
    bool extends; ///< an attempt has as many rounds again whenever it has
                  ///< halved its crossings
    tf_push push;
    tf_change change;
    tf_scope scope;
    double *x;         ///< where the vertices are
    double *next;      ///< where they go
    double *best;      ///< where they had the fewest crossings
    size_t fewest;     ///< so many
    size_t beyond;     ///< crossings of fixed vertices alone
    size_t few;        ///< the fewest of this attempt
    int idle;          ///< rounds since then
    int rings;         ///< around crossings that are smoothed next
    int rounds, rungs; ///< of the report
} tf_attempts;

/// Looks for a clear state by all rungs before TF_RUNG_RETURN, and leaves the
/// state of fewest crossings in `best`; x, best and the tangle's `in` are the
/// same before. The memory of `tangle`, x, next and best is the caller's.
tf_status tf_attempt(tf_attempts *all);

void tf_attempts_free(tf_attempts *all);
