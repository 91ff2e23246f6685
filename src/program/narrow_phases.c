//: Include what the names of narrow phases need
#include "program/narrow_phases.h"

#include "fast/vectorized.h"

#include <string.h>

//: Find a narrow phase by its name
static const tf_narrow_phase *const narrow_phases[] = {&tf_reference,
                                                       &tf_vectorized};

const tf_narrow_phase *tf_narrow_phase_named(const char *name)
{
    for (size_t i = 0; i < sizeof narrow_phases / sizeof *narrow_phases; i++)
        if (strcmp(name, narrow_phases[i]->name) == 0)
            return narrow_phases[i];
    return NULL;
}
