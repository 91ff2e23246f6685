//: Declare how to read a number
#pragma once

#include <stdbool.h>
#include <stdint.h>

/// Read the decimal number or hexadecimal float that starts at *text, as the
/// nearest double (ties to even; infinite where it overflows), and step *text
/// behind it.
///
/// Returns false, with nothing changed, if no number starts there: the words
/// "nan" and "inf" and leading blanks are none.
bool tf_number_read(const char **text, double *number);

/// Reads the integer, signed or not, that starts at *text, and steps *text behind
/// it.  One that no int holds is read as any other that none does.  Returns
/// false, with nothing changed, if no integer starts there.
bool tf_integer_read(const char **text, int64_t *integer);
