//: Declare formats that are not read
#pragma once

#include <stddef.h>

/// A format that is known by its content.
typedef struct tf_foreign {
    const char *name; ///< as in "this is NAME"
    const char *mend; ///< what to do instead
} tf_foreign;

/// What a file is that is no mesh as we read them; NULL: that is not known.  The
/// text ends with a zero.
const tf_foreign *tf_foreign_find(const char *text, size_t size);
