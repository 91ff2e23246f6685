//: Include what minimal residuals need
#include "response/minres.h"

#include "response/equations.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

//: Keep the recurrences of minimal residuals
/// Lanczos makes orthonormal vectors in which the matrix is tridiagonal;
/// rotations take the entries below the diagonal to zero, column by column.
typedef struct recurrence {
    double *basis, *older_basis, *image;
    double *direction, *older_direction;
    double length; ///< of the basis vector, which is not scaled yet
    double cosine, older_cosine; ///< of the last two rotations
    double sine, older_sine;
    double residual; ///< its length, with a sign
} recurrence;

enum {
    VECTORS = 6
};

static size_t workspace_of_minres(int axes, int vertices, int constraints)
{
    return tf_equations_workspace(axes, vertices, constraints, VECTORS);
}

static void swap(double **a, double **b)
{
    double *swapped = *a;
    *a = *b;
    *b = swapped;
}

//: Find the next vector of the basis
/// Returns the entry on the diagonal, and that below it as the length of the
/// image, which becomes the next vector.
static double advance(const tf_equations *equations, recurrence *r,
                      double *below)
{
    for (int i = 0; i < equations->count; i++)
        r->basis[i] /= r->length;
    tf_equations_multiply(equations, r->basis, r->image);
    double diagonal = tf_equations_dot(equations, r->image, r->basis);
    tf_equations_add(equations, r->image, -diagonal, r->basis, r->image);
    tf_equations_add(equations, r->image, -r->length, r->older_basis, r->image);
    *below = sqrt(tf_equations_dot(equations, r->image, r->image));
    return diagonal;
}

//: Rotate the next column
/// One column: two entries above the diagonal, and the diagonal before and
/// after the entry below it is rotated away.
typedef struct column {
    double two_above, above, unrotated, diagonal;
} column;

static column rotate(const recurrence *r, double diagonal, double below)
{
    column c = {.two_above = r->older_sine * r->length};
    c.above = r->sine * diagonal + r->older_cosine * r->cosine * r->length;
    c.unrotated = r->cosine * diagonal - r->older_cosine * r->sine * r->length;
    c.diagonal = hypot(c.unrotated, below);
    return c;
}

//: Step along a direction of minimal residuals
static void step(const tf_equations *equations, recurrence *r, const column *c,
                 double below, double solution[])
{
    double *next = r->older_direction;
    for (int i = 0; i < equations->count; i++)
        next[i] = (r->basis[i] - c->two_above * next[i] -
                   c->above * r->direction[i]) /
                  c->diagonal;
    r->older_cosine = r->cosine;
    r->older_sine = r->sine;
    r->cosine = c->unrotated / c->diagonal;
    r->sine = below / c->diagonal;
    tf_equations_add(equations, solution, r->cosine * r->residual, next,
                     solution);
    r->residual *= -r->sine;
    r->length = below;
    swap(&r->direction, &r->older_direction);
    swap(&r->basis, &r->older_basis);
    swap(&r->basis, &r->image);
}

//: Start minimal residuals
/// From the impulses that the constraints have; returns the length of a
/// residual that is as good as none.
static double start(const tf_equations *equations, double *vector[VECTORS],
                    recurrence *r)
{
    double enough = tf_equations_start(equations, vector[0], vector[1]);
    for (int i = 2; i < VECTORS; i++)
        memset(vector[i], 0, (size_t)equations->count * sizeof *vector[i]);
    double length = sqrt(tf_equations_dot(equations, vector[1], vector[1]));
    *r = (recurrence){.basis = vector[1],
                      .older_basis = vector[2],
                      .image = vector[3],
                      .direction = vector[4],
                      .older_direction = vector[5],
                      .length = length,
                      .cosine = 1,
                      .older_cosine = 1,
                      .residual = length};
    return enough;
}

//: Iterate minimal residuals
/// One iteration; false if the residual's product with the matrix is so short
/// that no step helps.
static bool iterate(const tf_equations *equations, recurrence *r,
                    double solution[])
{
    double below, diagonal = advance(equations, r, &below);
    column c = rotate(r, diagonal, below);
    if (!(hypot(c.unrotated, r->cosine * below) > tf_equations_weakest))
        return false;
    step(equations, r, &c, below, solution);
    return true;
}

static int solve_by_minres(tf_zone *zone)
{
    double *vector[VECTORS];
    recurrence r;
    tf_equations equations = tf_equations_of(zone, VECTORS, vector);
    double enough = start(&equations, vector, &r);
    int iterations = 0;
    while (tf_zone_goes_on(zone, 0) && iterations < zone->sweeps &&
           fabs(r.residual) > enough && iterate(&equations, &r, vector[0]))
        iterations++;
    tf_equations_finish(&equations, vector[0]);
    return iterations;
}

//: Offer minimal residuals
const tf_zone_solver tf_minres = {.name = "minres",
                                  .workspace = workspace_of_minres,
                                  .solve = solve_by_minres};
