// Any bytes as Gmsh's format: the first tells how the file begins, and the others
// are what follows.
#include "support/arbitrary_mesh.h"

#include <stdint.h>

#define TEXT(version) "$MeshFormat\n" version " 0 8\n$EndMeshFormat\n"
#define LITTLE(version)                                                        \
    "$MeshFormat\n" version " 1 8\n\1\0\0\0\n$EndMeshFormat\n"
#define BIG(version) "$MeshFormat\n" version " 1 8\n\0\0\0\1\n$EndMeshFormat\n"
#define NODES "$Nodes\n4\n1 0 0 0\n2 1 0 0\n4 0 1 0\n3 0 0 1\n$EndNodes\n"

static const beginning beginnings[] = {
    BEGINNING(""),
    BEGINNING("$MeshFormat\n"),
    BEGINNING(TEXT("2.2")),
    BEGINNING(TEXT("4.1")),
    BEGINNING(LITTLE("2.2")),
    BEGINNING(BIG("2.2")),
    BEGINNING(LITTLE("4.1")),
    BEGINNING(BIG("4.1")),
    BEGINNING(TEXT("2.2") NODES "$Elements\n"),
    BEGINNING(TEXT("2.2") NODES "$Elements\n3\n1 2 0 1 2 4\n"),
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    try_begun_mesh(10, beginnings, bytes, size);
    return 0;
}
