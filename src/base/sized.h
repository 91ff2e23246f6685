//: Declare how options are read
#pragma once

#include "base/fail.h"

/// Reads options that begin with their size, from a caller that may have been
/// compiled with an older or a newer version: fills `to`, of `known` bytes, with
/// the members that the caller has, and zeros.  A size of 0 stands for `first`
/// bytes, those of version 1.0; without options all is zero.  Returns TF_OK or
/// TF_BAD_OPTION: the size is too small for 1.0, or too large for any version,
/// as one that was never set may be, or the caller sets an option that this
/// version does not have.
tf_status tf_options_read(void *to, size_t known, const void *from,
                          size_t first, tf_error *error);
