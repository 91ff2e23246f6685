// What mistakes of callers must lead to, for tests that include tanglefree.h
// alone: this header includes nothing of the library.
#ifndef SUPPORT_MISUSE_H
#define SUPPORT_MISUSE_H

#include "support/support.h"

struct tf_error;

/// Expects a status of a call, and that the error is about that and has a
/// sentence.
void expect_error(const char *call, unsigned status, unsigned expected,
                  const struct tf_error *error);

/// A pointer of a call, but NULL if it is the i-th one, and that one is to be
/// null.
#define GIVEN(i, pointer) (null == (i) ? NULL : (pointer))

/// Calls a function whose pointers are GIVEN.
typedef struct null_call {
    void (*call)(int null);
    int pointers; ///< how many may not be null
} null_call;

/// Adds a test for each pointer that may not be null: that it breaks the
/// contract if it is.
/// @param calls the functions, up to one without a call; in static storage
void add_null_calls(TCase *c, const null_call calls[]);

#endif
