//: Include what the equations of a zone need
#include "response/equations.h"

#include "base/require.h"
#include "base/watch.h"
#include "response/impulse.h"

#include <math.h>
#include <string.h>

//: Divide the workspace of a zone
size_t tf_equations_workspace(int axes, int vertices, int constraints,
                              int vectors)
{
    return (size_t)axes * (size_t)vertices +
           ((size_t)vectors + 2) * (size_t)constraints;
}

/// Takes `count` numbers off the workspace that is left.
static double *take(double **left, size_t count)
{
    double *taken = *left;
    *left += count;
    return taken;
}

tf_equations tf_equations_of(const tf_zone *zone, int vectors, double *vector[])
{
    TF_REQUIRE(zone && zone->constraint && zone->inverse_mass &&
               zone->displacement && zone->workspace);
    double *left = zone->workspace;
    size_t constraints = (size_t)zone->constraints;
    tf_equations equations = {.zone = zone, .count = zone->constraints};
    equations.scale = take(&left, constraints);
    equations.impulse = take(&left, constraints);
    for (int i = 0; i < vectors; i++)
        vector[i] = take(&left, constraints);
    equations.displacement = left;
    return equations;
}

//: Scale the equations
static const double tolerance = 1e-8;

/// A constraint that moves nothing asks for nothing: scaled by 0 it reads 0 =
/// 0.
static double scale_of(const tf_constraint *constraint,
                       const double inverse_mass[])
{
    double compliance = tf_constraint_compliance(constraint, inverse_mass);
    return compliance > 0 ? 1 / sqrt(compliance) : 0;
}

double tf_equations_start(const tf_equations *equations, double x[],
                          double residual[])
{
    const tf_zone *zone = equations->zone;
    for (int i = 0; i < equations->count && tf_watch_work(zone->watch, 1);
         i++) {
        const tf_constraint *constraint = &zone->constraint[i];
        double scale = scale_of(constraint, zone->inverse_mass);
        equations->scale[i] = scale;
        x[i] = scale > 0 ? constraint->impulse / scale : 0;
    }
    tf_equations_multiply(equations, x, residual);
    tf_zone_gap_changes(zone, zone->displacement, equations->impulse);
    double square = 0;
    for (int i = 0; i < equations->count; i++) {
        double wanted = zone->constraint[i].bound - equations->impulse[i];
        double right = equations->scale[i] * wanted;
        square += right * right;
        residual[i] = right - residual[i];
    }
    return tolerance * sqrt(square);
}

//: Multiply by the matrix of the equations
static void scale_impulses(const tf_equations *equations, const double x[])
{
    for (int i = 0; i < equations->count; i++)
        equations->impulse[i] = equations->scale[i] * x[i];
}

void tf_equations_multiply(const tf_equations *equations, const double x[],
                           double product[])
{
    scale_impulses(equations, x);
    tf_zone_multiply(equations->zone, equations->impulse, product,
                     equations->displacement);
    for (int i = 0; i < equations->count; i++)
        product[i] *= equations->scale[i];
}

//: Apply what solves the equations
void tf_equations_finish(const tf_equations *equations, const double x[])
{
    const tf_zone *zone = equations->zone;
    scale_impulses(equations, x);
    for (int i = 0; i < equations->count && tf_watch_work(zone->watch, 1);
         i++) {
        zone->constraint[i].impulse = equations->impulse[i];
        memset(zone->constraint[i].friction, 0,
               sizeof zone->constraint[i].friction);
    }
    tf_zone_push(zone, equations->impulse, zone->displacement);
}

//: Add vectors
enum {
    NUMBERS = 64 ///< of vectors, that are added in the time of a visit
};

double tf_equations_dot(const tf_equations *equations, const double a[],
                        const double b[])
{
    tf_zone_goes_on(equations->zone, (size_t)equations->count / NUMBERS);
    double sum = 0;
    for (int i = 0; i < equations->count; i++)
        sum += a[i] * b[i];
    return sum;
}

void tf_equations_add(const tf_equations *equations, const double a[],
                      double factor, const double b[], double sum[])
{
    tf_zone_goes_on(equations->zone, (size_t)equations->count / NUMBERS);
    for (int i = 0; i < equations->count; i++)
        sum[i] = a[i] + factor * b[i];
}

//: See whether a residual is small
const double tf_equations_weakest = 1e-6;

bool tf_equations_are_solved(const tf_equations *equations,
                             const double residual[], const double product[],
                             double enough)
{
    double length = sqrt(tf_equations_dot(equations, residual, residual));
    double image = sqrt(tf_equations_dot(equations, product, product));
    return length <= enough || !(image > tf_equations_weakest * length);
}
