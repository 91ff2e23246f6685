// Any bytes as operations on an adaptive surface: the first two choose a scene,
// and eight more each operation, with places that share coordinates with
// vertices, or nearly so.  What they leave is judged exactly.
#include "support/fuzz_input.h"
#include "support/hash.h"
#include "support/surgery_runs.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

/// All but DUST, which takes longer to make than all operations.
static const adaptive_scene_kind kinds[] = {NESTED_SPHERES, SLABS, LINKED_TORI,
                                            SHEETS};

enum {
    KINDS = sizeof kinds / sizeof *kinds,
    BYTES = 8 ///< of an operation
};

static int next_index(fuzz_input *bytes, int count)
{
    int high = next_byte(bytes);
    return (256 * high + next_byte(bytes)) % count;
}

/// A corner of a triangle that exists: the next one there is.
static int next_corner(fuzz_input *bytes, const tf_mesh *mesh)
{
    int corner = next_index(bytes, 3 * mesh->triangles);
    while (mesh->triangle[corner / 3 * 3] < 0)
        corner = (corner + 3) % (3 * mesh->triangles);
    return corner;
}

/// A coordinate of a vertex, or off it by quarters of a unit, and by units in
/// the last place.
static double next_coordinate(fuzz_input *bytes, const surgery_run *run,
                              int near, int axis)
{
    static const double offsets[] = {0, 0, 0, 0, 0.25, -0.25, 0.5,   -0.5,
                                     1, 1, 1, 2, -1,   -1,    0.125, -0.125};
    int byte = next_byte(bytes);
    double x = tf_adaptive_positions(run->surface)[3 * near + axis];
    return nudged_by_byte(x + offsets[byte & 15] * run->scene.unit, byte);
}

static surgery_choice next_operation(fuzz_input *bytes, const surgery_run *run)
{
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    int corner = next_corner(bytes, &mesh);
    int near[] = {mesh.triangle[corner],
                  mesh.triangle[next_corner(bytes, &mesh)]};
    int after = corner % 3 == 2 ? corner - 2 : corner + 1;
    int first = next_byte(bytes);
    surgery_choice made = {.what = (operation)(first % OPERATIONS),
                           .a = near[0],
                           .b = mesh.triangle[after]};
    for (int k = 0; k < 3; k++)
        made.position[k] =
            next_coordinate(bytes, run, near[first >> (5 + k) & 1], k);
    return made;
}

/// Judges the parts that have been operated on.
static void judge(surgery_run *run, const bool changed[])
{
    for (int part = 0; part < run->scene.parts; part++) {
        run->changed = part;
        const char *fault = changed[part] ? surgery_run_fault(run) : NULL;
        if (fault) {
            fprintf(stderr, "%s\n", fault);
            abort();
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static surgery_run run;
    static surgery_counts counts;
    bool changed[SCENE_PARTS] = {false};
    fuzz_input bytes = {data, size, {hash_bytes(HASH_OF_NOTHING, data, size)}};
    adaptive_scene_kind kind = kinds[next_byte(&bytes) % KINDS];
    generator random = generator_new((uint64_t)next_byte(&bytes));
    surgery_run_begin(&run, random, kind, &counts);
    while (bytes.left >= BYTES) {
        surgery_choice request = next_operation(&bytes, &run);
        if (operate(&run, &request) == TF_COMMITTED)
            changed[run.changed] = true;
    }
    judge(&run, changed);
    surgery_run_end(&run);
    return 0;
}
