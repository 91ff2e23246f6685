//: Include what the normal equations need
#include "response/normal_residuals.h"

#include "response/equations.h"

//: Name the vectors of the normal equations
enum {
    SOLUTION,
    RESIDUAL,
    GRADIENT, // the residual's product with the matrix
    DIRECTION,
    DIRECTION_PRODUCT,
    VECTORS
};

static size_t workspace_of_normal_residuals(int axes, int vertices,
                                            int constraints)
{
    return tf_equations_workspace(axes, vertices, constraints, VECTORS);
}

//: Step along conjugate directions
/// `steepness` is the square of the gradient's length, before and after.
static void step(const tf_equations *equations, double *vector[],
                 double *steepness)
{
    double *residual = vector[RESIDUAL], *gradient = vector[GRADIENT];
    double *direction = vector[DIRECTION], *image = vector[DIRECTION_PRODUCT];
    tf_equations_multiply(equations, direction, image);
    double length = *steepness / tf_equations_dot(equations, image, image);
    tf_equations_add(equations, vector[SOLUTION], length, direction,
                     vector[SOLUTION]);
    tf_equations_add(equations, residual, -length, image, residual);
    tf_equations_multiply(equations, residual, gradient);
    double before = *steepness;
    *steepness = tf_equations_dot(equations, gradient, gradient);
    tf_equations_add(equations, gradient, *steepness / before, direction,
                     direction);
}

//: Iterate on the normal equations
static int solve_by_normal_residuals(tf_zone *zone)
{
    double *vector[VECTORS];
    tf_equations equations = tf_equations_of(zone, VECTORS, vector);
    double *residual = vector[RESIDUAL], *gradient = vector[GRADIENT];
    double enough = tf_equations_start(&equations, vector[SOLUTION], residual);
    tf_equations_multiply(&equations, residual, gradient);
    tf_equations_add(&equations, gradient, 0, gradient, vector[DIRECTION]);
    double steepness = tf_equations_dot(&equations, gradient, gradient);
    int iterations = 0;
    while (tf_zone_goes_on(zone, 0) && iterations < zone->sweeps &&
           !tf_equations_are_solved(&equations, residual, gradient, enough)) {
        step(&equations, vector, &steepness);
        iterations++;
    }
    tf_equations_finish(&equations, vector[SOLUTION]);
    return iterations;
}

//: Offer conjugate gradients on the normal equations
const tf_zone_solver tf_normal_residuals = {.name = "normal-residuals",
                                            .workspace =
                                                workspace_of_normal_residuals,
                                            .solve = solve_by_normal_residuals};
