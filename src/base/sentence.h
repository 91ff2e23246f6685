//: Declare sentences about errors
#pragma once

#include "base/error.h"

#include <stdbool.h>

/// Like tf_describe, but numbers vertices from `first` on.  About a line of a
/// file, which is named before the sentence, it names no place in a list.
size_t tf_sentence_write(const tf_error *error, int first, bool in_file,
                         char buffer[], size_t size);
