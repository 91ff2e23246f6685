// Any bytes as OBJ, or whatever else they look like.
#include "support/arbitrary_mesh.h"

#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    try_arbitrary_mesh(bytes, size);
    return 0;
}
