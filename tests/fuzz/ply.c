// Any bytes as PLY: the first tells how the header begins, and the others are
// what follows.
#include "support/arbitrary_mesh.h"

#include <stdint.h>

#define BODY                                                                   \
    "element vertex 6\nproperty float x\nproperty float y\n"                   \
    "property float z\nelement face 2\n"                                       \
    "property list uchar uchar vertex_index\nelement edge 1\n"                 \
    "property uchar vertex1\nproperty uchar vertex2\nend_header\n"
#define STRIPS                                                                 \
    "element vertex 5\nproperty char x\nproperty char y\nproperty char z\n"    \
    "element tristrips 2\nproperty list char char vertex_indices\n"            \
    "end_header\n"

static const beginning beginnings[] = {
    BEGINNING(""),
    BEGINNING("ply\n"),
    BEGINNING("ply\nformat ascii 1.0\n"),
    BEGINNING("ply\nformat binary_little_endian 1.0\n"),
    BEGINNING("ply\nformat binary_big_endian 1.0\n"),
    BEGINNING("ply\nformat ascii 1.0\n" BODY),
    BEGINNING("ply\nformat binary_little_endian 1.0\n" BODY),
    BEGINNING("ply\nformat binary_big_endian 1.0\n" BODY),
    BEGINNING("ply\nformat ascii 1.0\n" STRIPS),
    BEGINNING("ply\nformat binary_little_endian 1.0\n" STRIPS),
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    try_begun_mesh(10, beginnings, bytes, size);
    return 0;
}
