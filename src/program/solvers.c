//: Include what the names of solvers need
#include "program/solvers.h"

#include "response/conjugate_residuals.h"
#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "response/normal_residuals.h"

#include <string.h>

//: Find a solver by its name
static const tf_zone_solver *const solvers[] = {
    &tf_gauss_seidel,
    &tf_conjugate_residuals,
    &tf_minres,
    &tf_normal_residuals,
};

const tf_zone_solver *tf_solver_named(const char *name)
{
    for (size_t i = 0; i < sizeof solvers / sizeof *solvers; i++)
        if (strcmp(name, solvers[i]->name) == 0)
            return solvers[i];
    return NULL;
}
