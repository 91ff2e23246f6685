// Binary files that are built number by number.
#ifndef SUPPORT_BYTES_H
#define SUPPORT_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Bytes that are appended to.
typedef struct bytes {
    char at[8000];
    size_t count;
    bool big; ///< the order of the bytes of a number
} bytes;

/// Append numbers, of so many bytes, or letters.
void put_int(bytes *to, int size, int64_t number);
void put_float(bytes *to, float x);
void put_double(bytes *to, double x);
void put_text(bytes *to, const char *text);

#endif
