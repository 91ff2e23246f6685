//: Take numbers from bytes
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/// The unsigned number of up to 8 bytes.
static inline uint64_t tf_gather_bytes(const char *at, int bytes, bool big)
{
    uint64_t number = 0;
    for (int i = 0; i < bytes; i++)
        number |= (uint64_t)(unsigned char)at[i]
                  << 8 * (big ? bytes - 1 - i : i);
    return number;
}

static inline int32_t tf_gather_int(const char *at, bool big)
{
    return (int32_t)(uint32_t)tf_gather_bytes(at, 4, big);
}

/// The bits of a double, by which 0 and -0 differ.
static inline uint64_t tf_bits_of(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

static inline double tf_gather_double(const char *at, bool big)
{
    uint64_t bits = tf_gather_bytes(at, 8, big);
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static inline float tf_gather_float(const char *at, bool big)
{
    uint32_t bits = (uint32_t)tf_gather_bytes(at, 4, big);
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}
