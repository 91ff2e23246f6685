//: Declare how numbers are encoded
#pragma once

#include "formats/columns.h"

#include <stdint.h>
#include <stdio.h>

/// How numbers are written: as text, or in binary of a byte order.
typedef struct tf_encoder {
    FILE *stream;
    bool is_text;
    bool is_big_endian; ///< in binary
} tf_encoder;

/// Writes a double: in text with 15 digits, or 16 or 17 if only these determine
/// it.
void tf_encode_double(const tf_encoder *to, double number);

/// Writes doubles, in text with blanks between them; and the three coordinates of
/// a position, of which the third is 0 in the plane.
void tf_encode_doubles(const tf_encoder *to, const double number[], int count);
void tf_encode_position(const tf_encoder *to, const double x[], int axes);

/// Writes a number of a type: in text with as many digits as determine one of
/// that type.  Integers beyond the type become its least or greatest one, and
/// what is no number becomes 0.
void tf_encode(const tf_encoder *to, tf_number_type type, double number);

/// Writes an integer: in binary, its lowest bytes, so many.
void tf_encode_integer(const tf_encoder *to, int64_t number, int bytes);

/// In text, a blank or the end of a line.
void tf_encode_blank(const tf_encoder *to);
void tf_encode_line_end(const tf_encoder *to);

/// Whether a type holds a number exactly.
bool tf_number_fits(tf_number_type type, double number);

/// How many bytes a number of a type has.
int tf_number_bytes(tf_number_type type);
