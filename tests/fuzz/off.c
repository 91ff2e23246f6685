// Any bytes as OFF: the first tells how the file begins, and the others are what
// follows.
#include "support/arbitrary_mesh.h"

#include <stdint.h>

static const beginning beginnings[] = {
    BEGINNING(""),
    BEGINNING("OFF\n"),
    BEGINNING("COFF\n"),
    BEGINNING("OFF\n4 3 0\n"),
    BEGINNING("OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n"),
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    try_begun_mesh(5, beginnings, bytes, size);
    return 0;
}
