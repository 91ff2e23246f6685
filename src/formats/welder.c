//: Include what welding needs
#include "formats/welder.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

//: Hash a position
/// -0 and 0 have one hash.
static size_t hash_of(const double x[3])
{
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        double coordinate = x[k] + 0.0;
        uint64_t bits;
        memcpy(&bits, &coordinate, sizeof bits);
        hash = (hash ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
        hash ^= hash >> 32;
    }
    return (size_t)hash;
}

//: Find a slot
static size_t first_slot(const tf_welder *welder, const double x[3])
{
    return hash_of(x) & (welder->slots - 1);
}

void tf_welder_expect(const tf_welder *welder, const double x[3])
{
    if (welder->slot)
        __builtin_prefetch(&welder->slot[first_slot(welder, x)]);
}

static bool is_at(const tf_mesh_file *file, int vertex, const double x[3])
{
    const double *y = file->position.item + 3 * (ptrdiff_t)vertex;
    return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}

/// That of the vertex at a position, or else an empty one.
static int *find_slot(const tf_welder *welder, const tf_mesh_file *file,
                      const double x[3])
{
    size_t at = first_slot(welder, x);
    while (welder->slot[at] > 0 && !is_at(file, welder->slot[at] - 1, x))
        at = (at + 1) & (welder->slots - 1);
    return &welder->slot[at];
}

//: Make the table of a welder larger
/// At most half of it is in use.
static bool grow_table(tf_welder *welder, const tf_mesh_file *file)
{
    size_t slots = welder->slots ? 2 * welder->slots : 1024;
    int *slot = calloc(slots, sizeof *slot);
    if (!slot)
        return tf_mesh_file_fault_in_memory(file);
    free(welder->slot);
    *welder = (tf_welder){slot, slots};
    for (int v = 0; v < tf_mesh_file_vertices(file); v++)
        *find_slot(welder, file, file->position.item + 3 * (ptrdiff_t)v) =
            v + 1;
    return true;
}

//: Weld a corner
bool tf_welder_find(tf_welder *welder, tf_mesh_file *file, const double x[3],
                    long place, int *vertex)
{
    size_t vertices = (size_t)tf_mesh_file_vertices(file);
    if (2 * vertices >= welder->slots && !grow_table(welder, file))
        return false;
    int *slot = find_slot(welder, file, x);
    if (*slot == 0) {
        if (!tf_mesh_file_add_vertex(file, x, place))
            return false;
        *slot = (int)vertices + 1;
    }
    *vertex = *slot - 1;
    return true;
}

void tf_welder_free(tf_welder *welder)
{
    free(welder->slot);
    *welder = (tf_welder){0};
}
