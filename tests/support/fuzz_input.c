#include "support/fuzz_input.h"

#include <math.h>

int next_byte(fuzz_input *bytes)
{
    if (bytes->left == 0)
        return below(&bytes->more, 256);
    bytes->left--;
    return *bytes->byte++;
}

double nudged_by_byte(double x, int byte)
{
    for (int steps = byte >> 4 & 3; steps > 0; steps--)
        x = nextafter(x, byte & 64 ? INFINITY : -INFINITY);
    return x;
}
