//: Declare detection by any narrow phase
#pragma once

#include "base/error.h"
#include "surface/contacts.h"
#include "surface/surface.h"

/// Reads the options of a caller of any version; see tf_options_read.
tf_status tf_detect_options_read(tf_detect_options *to,
                                 const tf_detect_options *from,
                                 tf_error *error);

/// What tf_surface_detect does, but with tf_reference if the options name no
/// narrow phase; and they are those of this version.
tf_status tf_detect(tf_surface *surface, const tf_motion *motion,
                    const tf_detect_options *options, tf_contacts *found,
                    tf_error *error);
