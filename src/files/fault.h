//: Declare faults
#pragma once

#include "files/visible.h"

#include <stdarg.h>
#include <stdbool.h>

enum {
    TF_FAULT_ROOM = TF_VISIBLE_ROOM + 512 ///< a fault may name another file
};

/// What is wrong with a file.
typedef struct tf_fault {
    const char *file;  ///< its name; borrowed
    long place;        ///< a line from 1, or a byte from 0; below 0: none
    bool counts_bytes; ///< whether it is a byte
    char text[TF_FAULT_ROOM]; ///< what is wrong; how to mend it; "": nothing is
} tf_fault;

/// Sets what is wrong with a file at a line, as printf; false, for the caller to
/// return.
__attribute__((format(printf, 4, 5))) bool
tf_fault_set(tf_fault *fault, const char *file, long place, const char *format,
             ...);
bool tf_fault_set_list(tf_fault *fault, const char *file, long place,
                       const char *format, va_list arguments);

/// Set that a file cannot be written, opened or read, for a reason of errno;
/// false.
bool tf_fault_set_unwritten(tf_fault *fault, const char *file, int reason);
bool tf_fault_set_unopened(tf_fault *fault, const char *file, int reason);
bool tf_fault_set_unread(tf_fault *fault, const char *file, long place,
                         int reason);

/// Prints "PROGRAM: FILE:PLACE: TEXT" on standard error, if there is a fault.
void tf_fault_print(const tf_fault *fault, const char *program);
