//: Declare the usual choices
#pragma once

#include "base/error.h"
#include "geometry/step.h"
#include "response/options.h"

/// Reads the options of a caller of any version, see tf_options_read, and
/// chooses the narrow phase.
tf_status tf_response_options_read(tf_response_options *to,
                                   const tf_response_options *from,
                                   tf_error *error);

/// Checks that the options are in their ranges; else TF_BAD_OPTION.
tf_status tf_response_options_check(const tf_response_options *options,
                                    tf_error *error);

/// Makes the usual choices where an option is zero.
void tf_response_options_choose(tf_response_options *options,
                                const tf_surface *surface, const tf_step *step);
