//: Find an arithmetic by its name
#include "arithmetic/named.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "base/require.h"

#include <stddef.h>
#include <string.h>

const tf_arithmetic *tf_arithmetic_named(const char *name)
{
    static const tf_arithmetic *const all[] = {
        &tf_exact,     &tf_clamped,   &tf_published,
        &tf_perturbed, &tf_integer64, &tf_integer128,
    };
    TF_REQUIRE(name);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (strcmp(tf_arithmetic_name(all[i]), name) == 0)
            return all[i];
    return NULL;
}
