//: Declare how numbers are spelled
#pragma once

#include <stdint.h>

enum {
    TF_DECIMAL_ROOM = 32 ///< bytes of any number
};

/// Spells a double with 15 digits, or 16 or 17 if it takes these to read it back
/// as it is, as printf does by "%.15g" and so on, but several times as fast where
/// it has an ordinary size.  Zeros at the end of a fraction are left out.
/// Returns the end, without a zero there.
char *tf_decimal_double(char text[TF_DECIMAL_ROOM], double number);

/// Spells an integer, in the same way.
char *tf_decimal_integer(char text[TF_DECIMAL_ROOM], int64_t number);
