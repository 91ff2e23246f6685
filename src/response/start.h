//: Declare what a start has to be
#pragma once

#include "base/status.h"
#include "response/options.h"

/// Whether elements of a surface intersect at the start of a step: TF_OK;
/// TF_START_NOT_CLEAR, with the first of them; or another status of
/// tf_surface_check.
tf_status tf_start_check(tf_surface *surface, const tf_motion *motion,
                         const tf_parallel *parallel, tf_obstacle *obstacle);

/// Whether one of all contacts of a step is there already at the start: TF_OK or
/// TF_START_NOT_CLEAR, with the first such contact.
tf_status tf_start_check_contacts(const tf_motion *motion, int axes,
                                  const tf_contacts *contacts,
                                  tf_obstacle *obstacle);
