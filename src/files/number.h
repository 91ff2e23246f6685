//: Declare how to read a number
#pragma once

#include <stdbool.h>

/// Read the decimal number or hexadecimal float that starts at *text, as the
/// nearest double (ties to even; infinite where it overflows), and step *text
/// behind it.
///
/// Returns false, with nothing changed, if no number starts there: the words
/// "nan" and "inf" and leading blanks are none.
bool tf_number_read(const char **text, double *number);
