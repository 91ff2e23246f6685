// The bytes of a fuzzer, as small numbers.
#ifndef SUPPORT_FUZZ_INPUT_H
#define SUPPORT_FUZZ_INPUT_H

#include "support/generator.h"

#include <stddef.h>
#include <stdint.h>

/// What is left of the bytes; after their end, always the same random ones.
typedef struct fuzz_input {
    const uint8_t *byte;
    size_t left;
    generator more;
} fuzz_input;

/// The next byte, from 0 to 255.
int next_byte(fuzz_input *bytes);

/// x, up to three units in the last place off: as many as bits 4 and 5 of the
/// byte say, up if bit 6 is set.
double nudged_by_byte(double x, int byte);

#endif
