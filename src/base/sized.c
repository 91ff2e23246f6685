//: Read options of any version
#include "base/sized.h"

#include <stdbool.h>
#include <string.h>

enum {
    MOST = 4096 ///< more bytes than the options of any version have
};

/// Whether the bytes from `begin` to `end` are zero.
static bool are_zero(const unsigned char *bytes, size_t begin, size_t end)
{
    bool zero = true;
    for (size_t i = begin; i < end; i++)
        zero &= bytes[i] == 0;
    return zero;
}

tf_status tf_options_read(void *to, size_t known, const void *from,
                          size_t first, tf_error *error)
{
    memset(to, 0, known);
    if (!from)
        return TF_OK;
    size_t size;
    memcpy(&size, from, sizeof size);
    if (size != 0 && (size < first || size > MOST))
        return tf_fail_option(error, "size", "0 or that of the options",
                              (double)size);
    size = size ? size : first;
    if (!are_zero(from, known, size))
        return tf_fail_option(error, "size",
                              "that of the options in this version of the "
                              "library, as later members are set",
                              (double)size);
    memcpy(to, from, size < known ? size : known);
    return TF_OK;
}
