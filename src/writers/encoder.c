//: Include what encoders need
#define _DEFAULT_SOURCE // fwrite_unlocked, fputc_unlocked
#include "writers/encoder.h"

#include "formats/binary.h"
#include "writers/decimal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

//: Write bytes
static void write_bytes(const tf_encoder *to, uint64_t bits, int count)
{
    unsigned char byte[8];
    for (int i = 0; i < count; i++)
        byte[to->is_big_endian ? count - 1 - i : i] =
            (unsigned char)(bits >> 8 * i);
    fwrite_unlocked(byte, 1, (size_t)count, to->stream);
}

//: Encode a floating-point number
static void write_text(const tf_encoder *to, const char *text, const char *end)
{
    fwrite_unlocked(text, 1, (size_t)(end - text), to->stream);
}

void tf_encode_double(const tf_encoder *to, double number)
{
    char text[TF_DECIMAL_ROOM];
    if (to->is_text)
        write_text(to, text, tf_decimal_double(text, number));
    else
        write_bytes(to, tf_bits_of(number), 8);
}

/// In text with 6 digits, or up to 9 if only these determine a float.
static void spell_float(FILE *stream, double value)
{
    enum {
        SURE = 6,
        MOST = 9
    };
    char text[TF_DECIMAL_ROOM];
    for (int digits = SURE; digits <= MOST; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtof(text, NULL) == (float)value)
            break;
    }
    fputs(text, stream);
}

static void encode_float(const tf_encoder *to, double value)
{
    float number = (float)value;
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    if (to->is_text)
        spell_float(to->stream, value);
    else
        write_bytes(to, bits, 4);
}

//: Encode an integer
int tf_number_bytes(tf_number_type type)
{
    static const int bytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return bytes[type];
}

void tf_encode_integer(const tf_encoder *to, int64_t number, int bytes)
{
    char text[TF_DECIMAL_ROOM];
    if (to->is_text)
        write_text(to, text, tf_decimal_integer(text, number));
    else
        write_bytes(to, (uint64_t)number, bytes);
}

static double limited(tf_number_type type, double value)
{
    static const double least[] = {INT8_MIN, 0, INT16_MIN, 0, INT32_MIN, 0};
    static const double most[] = {INT8_MAX,   UINT8_MAX, INT16_MAX,
                                  UINT16_MAX, INT32_MAX, UINT32_MAX};
    return isnan(value) ? 0 : fmin(fmax(value, least[type]), most[type]);
}

//: Encode a number of a type
void tf_encode(const tf_encoder *to, tf_number_type type, double number)
{
    if (type == TF_DOUBLE)
        tf_encode_double(to, number);
    else if (type == TF_FLOAT)
        encode_float(to, number);
    else
        tf_encode_integer(to, (int64_t)limited(type, number),
                          tf_number_bytes(type));
}

//: Find out whether a type holds a number
bool tf_number_fits(tf_number_type type, double number)
{
    double held = type == TF_DOUBLE  ? number
                  : type == TF_FLOAT ? (double)(float)number
                                     : (double)(int64_t)limited(type, number);
    return tf_bits_of(held) == tf_bits_of(number);
}

//: Write many numbers
void tf_encode_doubles(const tf_encoder *to, const double number[], int count)
{
    for (int i = 0; i < count; i++) {
        if (i > 0)
            tf_encode_blank(to);
        tf_encode_double(to, number[i]);
    }
}

void tf_encode_position(const tf_encoder *to, const double x[], int axes)
{
    const double whole[] = {x[0], x[1], axes == 3 ? x[2] : 0};
    tf_encode_doubles(to, whole, 3);
}

//: Separate numbers in text
void tf_encode_blank(const tf_encoder *to)
{
    if (to->is_text)
        fputc_unlocked(' ', to->stream);
}

void tf_encode_line_end(const tf_encoder *to)
{
    if (to->is_text)
        fputc_unlocked('\n', to->stream);
}
