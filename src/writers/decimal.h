//: Declare how numbers are spelled
#pragma once

#include <stdint.h>

enum {
    TF_DECIMAL_ROOM = 32 ///< bytes of any number
};

/// Spells a double with 17 digits, which determine it, as printf does by "%.17g",
/// but several times as fast where it has an ordinary size.  Returns the end,
/// without a zero there.
char *tf_decimal_double(char text[TF_DECIMAL_ROOM], double number);

/// Spells an integer, in the same way.
char *tf_decimal_integer(char text[TF_DECIMAL_ROOM], int64_t number);
