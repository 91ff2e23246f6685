// Any bytes as PLY: the first tells how the header begins, and the others are
// what follows.
#include "support/arbitrary_mesh.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define BODY                                                                   \
    "element vertex 6\nproperty float x\nproperty float y\n"                   \
    "property float z\nelement face 2\n"                                       \
    "property list uchar uchar vertex_index\nelement edge 1\n"                 \
    "property uchar vertex1\nproperty uchar vertex2\nend_header\n"

static const char *const beginnings[] = {
    "",
    "ply\n",
    "ply\nformat ascii 1.0\n",
    "ply\nformat binary_little_endian 1.0\n",
    "ply\nformat binary_big_endian 1.0\n",
    "ply\nformat ascii 1.0\n" BODY,
    "ply\nformat binary_little_endian 1.0\n" BODY,
    "ply\nformat binary_big_endian 1.0\n" BODY,
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size == 0)
        return 0;
    const char *beginning = beginnings[bytes[0] % 8];
    size_t length = strlen(beginning);
    char *text = malloc(length + size - 1);
    if (!text)
        abort();
    memcpy(text, beginning, length);
    memcpy(text + length, bytes + 1, size - 1);
    try_arbitrary_mesh(text, length + size - 1);
    free(text);
    return 0;
}
