// Minimal residuals, as all solvers of equations.
#include "response/minres.h"

#include "support/equation_solvers.h"

static void use(void)
{
    equation_solver_use(&tf_minres);
}

Suite *suite(void)
{
    return equation_solver_suite("response/minres", use);
}
