// Conjugate residuals, as all solvers of equations.
#include "response/conjugate_residuals.h"

#include "support/equation_solvers.h"

static void use(void)
{
    equation_solver_use(&tf_conjugate_residuals);
}

Suite *suite(void)
{
    return equation_solver_suite("response/conjugate_residuals", use);
}
