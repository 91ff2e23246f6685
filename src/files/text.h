//: Declare texts
#pragma once

#include "files/fault.h"

#include <stddef.h>

/// A text that is being read.
typedef struct tf_text {
    const char *name; ///< of its file; borrowed
    const char *at;   ///< what comes next; a zero ends the text
    long line;        ///< where that is, from 1
    tf_fault *fault;  ///< to be set
} tf_text;

/// Sets a fault of the line, as printf; false, for the caller to return.
__attribute__((format(printf, 2, 3))) bool
tf_text_fault(const tf_text *text, const char *format, ...);

/// Sets the fault that the text holds a zero.
bool tf_text_fault_in_nul(const tf_text *text);

/// Sets the fault that so many letters of the line are what the verdict says;
/// if there are none, that it holds a zero.
bool tf_text_fault_in_word(const tf_text *text, const char *word, size_t length,
                           const char *verdict);

//: Declare how to read words
/// What is said of words that are not read as numbers.
#define TF_NO_NUMBER_VERDICT                                                   \
    "not a finite number; write a decimal or a hexadecimal float"
#define TF_COMMA_VERDICT                                                       \
    "not a finite number; write a point in place of the comma"
#define TF_TOO_LARGE_VERDICT "beyond the largest double; scale the scene down"

/// The beginning of a text, behind the mark of UTF-8, if it has that.
const char *tf_text_begin(const char *text);

/// Steps over blanks and tabs, and over what ends a line of Windows.
void tf_text_skip_blanks(tf_text *text);

/// Reads a finite number; one of `ends`, or a zero, follows it.  False: there is
/// a fault, which quotes the word up to a blank.
bool tf_text_read_number(tf_text *text, const char *ends, double *number);

/// Whether a character is one of `ends`, or a zero.
bool tf_ends_word(char c, const char *ends);
