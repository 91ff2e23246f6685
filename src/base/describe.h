//: Declare the description of an error
#pragma once

#include "base/api.h"
#include "base/error.h"

/// @addtogroup trouble
/// @{

/// Writes one sentence that states what is wrong and how to fix it.  It has no
/// line break, and no period at its end.  Vertices and places in lists are
/// counted from 0.  Thread-safe.
/// @param error what a function has set
/// @param[out] buffer the sentence, followed by a zero, cut off if it is longer
///     than the buffer; may be NULL if `size` is 0
/// @param size how many bytes the buffer has; 160 are enough for most
/// @return how many bytes the whole sentence has, without the zero
TF_API size_t tf_describe(const tf_error *error, char buffer[], size_t size);

/// @}
