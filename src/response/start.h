//: Declare what a start has to be
#pragma once

#include "base/error.h"
#include "base/watch.h"
#include "response/options.h"

/// Checks that no elements of a surface intersect at the start of a step.
/// Returns TF_OK; TF_START_NOT_CLEAR, and sets the error to the first pair
/// that does; or another status of tf_surface_check.
tf_status tf_start_check(tf_surface *surface, const tf_motion *motion,
                         const tf_parallel *parallel, tf_error *error);

/// Checks that none of the contacts of a step is there at the start already.
/// `contacts` are all of them.  Returns TF_OK; TF_START_NOT_CLEAR, and sets the
/// error to the first contact that is; TF_CANCELLED; or another status of the
/// query.
tf_status tf_start_check_contacts(const tf_motion *motion,
                                  const tf_contacts *contacts, tf_watch *watch,
                                  tf_error *error);
