//: Include what conjugate residuals need
#include "response/conjugate_residuals.h"

#include "response/equations.h"

//: Name the vectors of conjugate residuals
enum {
    SOLUTION,
    RESIDUAL,
    RESIDUAL_PRODUCT, // by the matrix
    DIRECTION,
    DIRECTION_PRODUCT,
    VECTORS
};

static size_t workspace_of_conjugate_residuals(int axes, int vertices,
                                               int constraints)
{
    return tf_equations_workspace(axes, vertices, constraints, VECTORS);
}

//: Step along directions whose products are orthogonal
/// Steps to where the residual is least, and makes the next direction of it.
/// `energy`, which is not the kinetic one, is the residual times its product,
/// before and after.
static void step(const tf_equations *equations, double *vector[],
                 double *energy)
{
    double *residual = vector[RESIDUAL], *product = vector[RESIDUAL_PRODUCT];
    double *direction = vector[DIRECTION], *image = vector[DIRECTION_PRODUCT];
    double length = *energy / tf_equations_dot(equations, image, image);
    tf_equations_add(equations, vector[SOLUTION], length, direction,
                     vector[SOLUTION]);
    tf_equations_add(equations, residual, -length, image, residual);
    tf_equations_multiply(equations, residual, product);
    double before = *energy;
    *energy = tf_equations_dot(equations, residual, product);
    double part = *energy / before;
    tf_equations_add(equations, residual, part, direction, direction);
    tf_equations_add(equations, product, part, image, image);
}

//: Iterate conjugate residuals
static int solve_by_conjugate_residuals(tf_zone *zone)
{
    double *vector[VECTORS];
    tf_equations equations = tf_equations_of(zone, VECTORS, vector);
    double *residual = vector[RESIDUAL], *product = vector[RESIDUAL_PRODUCT];
    double enough = tf_equations_start(&equations, vector[SOLUTION], residual);
    tf_equations_multiply(&equations, residual, product);
    tf_equations_add(&equations, residual, 0, residual, vector[DIRECTION]);
    tf_equations_add(&equations, product, 0, product,
                     vector[DIRECTION_PRODUCT]);
    double energy = tf_equations_dot(&equations, residual, product);
    int iterations = 0;
    while (tf_zone_goes_on(zone, 0) && iterations < zone->sweeps &&
           !tf_equations_are_solved(&equations, residual, product, enough)) {
        step(&equations, vector, &energy);
        iterations++;
    }
    tf_equations_finish(&equations, vector[SOLUTION]);
    return iterations;
}

//: Offer conjugate residuals
const tf_zone_solver tf_conjugate_residuals = {
    .name = "conjugate-residuals",
    .workspace = workspace_of_conjugate_residuals,
    .solve = solve_by_conjugate_residuals};
