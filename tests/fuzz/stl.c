// Any bytes as STL: as text, as the whole of a file, or as what follows a header
// that tells their number.
#include "support/arbitrary_mesh.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const beginning beginnings[] = {
    BEGINNING(""),
    BEGINNING("solid\n"),
    BEGINNING("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
              "vertex 0 1 0\nendloop\nendfacet\n"),
};

/// Of so many facets as there are bytes for.
static void try_binary(const uint8_t *bytes, size_t size)
{
    size_t facets = size / 50;
    char *file = calloc(84 + 50 * facets, 1);
    if (!file)
        abort();
    for (int i = 0; i < 4; i++)
        file[80 + i] = (char)(facets >> 8 * i);
    memcpy(file + 84, bytes, 50 * facets);
    try_arbitrary_mesh(file, 84 + 50 * facets);
    free(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size > 0 && bytes[0] % 4 == 3)
        try_binary(bytes + 1, size - 1);
    else
        try_begun_mesh(3, beginnings, bytes, size);
    return 0;
}
