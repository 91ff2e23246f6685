// The normal equations, as all solvers of equations.
#include "response/normal_residuals.h"

#include "support/equation_solvers.h"

static void use(void)
{
    equation_solver_use(&tf_normal_residuals);
}

Suite *suite(void)
{
    return equation_solver_suite("response/normal_residuals", use);
}
