// The judge of calls: what the header promises of every status.
#ifndef FUZZ_CALLS_JUDGE_H
#define FUZZ_CALLS_JUDGE_H

#include "support/generator.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <tanglefree.h>

/// Statuses, the bit 1 << status for each.
typedef uint32_t status_set;

/// A call, and what it may return.
typedef struct call {
    const char *name;
    status_set faults; ///< for what is wrong with its arguments: it must return
                       ///< one of these, or TF_OK if there are none
    status_set excuses; ///< what it may return in any case
} call;

/// Begins a call; `name` is printed if a fault is found, or the library aborts.
call call_begin(const char *name);

/// Notes that the call must fail with this status, or that of another fault.
void expect_fault(call *made, bool wrong, tf_status status);

/// Notes that the call may fail with this status.
void excuse(call *made, tf_status status);

/// Prints the call and what is wrong, and aborts, unless the condition is true.
void require(const call *made, bool condition, const char *what);

/// Judges a status; returns whether it is TF_OK.
bool judge_status(const call *made, tf_status status);

/// Judges what a call has set: an error is about its status and can be
/// described, in a buffer of any size.
void judge_error(const call *made, tf_status status, const tf_error *error,
                 generator *random);

/// Marks all bytes of an output before a call.
void mark(void *output, size_t size);

/// Requires that the call has left them marked.
void judge_unset(const call *made, const void *output, size_t size);

#endif
