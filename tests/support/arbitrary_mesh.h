// What holds for any bytes that are read as a mesh file.
#ifndef SUPPORT_ARBITRARY_MESH_H
#define SUPPORT_ARBITRARY_MESH_H

#include <stddef.h>

/// Reads bytes, which must turn out to be a mesh of finite coordinates, or to
/// have a fault at a place among them.  A surface that is small is then detected
/// at rest, and checked.  Aborts where anything is amiss.
void try_arbitrary_mesh(const void *bytes, size_t size);

/// How a file may begin.
typedef struct beginning {
    const char *bytes;
    size_t size;
} beginning;

#define BEGINNING(text)                                                        \
    {                                                                          \
        text, sizeof(text) - 1                                                 \
    }

/// The same, of a file whose beginning the first byte chooses; the others are
/// what follows.
void try_begun_mesh(int count, const beginning beginnings[], const void *bytes,
                    size_t size);

#endif
