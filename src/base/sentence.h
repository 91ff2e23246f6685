//: Declare sentences about errors
#pragma once

#include "base/error.h"

/// Like tf_describe, but numbers vertices from `first` on.
size_t tf_sentence_write(const tf_error *error, int first, char buffer[],
                         size_t size);
