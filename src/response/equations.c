//: Include what the equations of a zone need
#include "response/equations.h"

#include "base/require.h"
#include "response/impulse.h"

#include <math.h>
#include <string.h>

//: Divide the room of a zone
size_t tf_equations_room(int axes, int vertices, int rows, int vectors)
{
    return (size_t)axes * (size_t)vertices +
           ((size_t)vectors + 2) * (size_t)rows;
}

/// Takes `count` numbers off the room that is left.
static double *take(double **left, size_t count)
{
    double *taken = *left;
    *left += count;
    return taken;
}

tf_equations tf_equations_of(const tf_zone *zone, int vectors, double *vector[])
{
    TF_REQUIRE(zone && zone->row && zone->inverse_mass && zone->displacement &&
               zone->room);
    double *left = zone->room;
    size_t rows = (size_t)zone->rows;
    tf_equations equations = {.zone = zone, .count = zone->rows};
    equations.scale = take(&left, rows);
    equations.impulse = take(&left, rows);
    for (int i = 0; i < vectors; i++)
        vector[i] = take(&left, rows);
    equations.displacement = left;
    return equations;
}

//: Scale the equations
static const double tolerance = 1e-8;

/// A row that moves nothing asks for nothing: scaled by 0 it reads 0 = 0.
static double scale_of(const tf_row *row, const double inverse_mass[])
{
    double compliance = tf_row_compliance(row, inverse_mass);
    return compliance > 0 ? 1 / sqrt(compliance) : 0;
}

double tf_equations_start(const tf_equations *equations, double x[],
                          double residual[])
{
    const tf_zone *zone = equations->zone;
    for (int i = 0; i < equations->count; i++) {
        const tf_row *row = &zone->row[i];
        double scale = scale_of(row, zone->inverse_mass);
        equations->scale[i] = scale;
        x[i] = scale > 0 ? row->impulse / scale : 0;
    }
    tf_equations_multiply(equations, x, residual);
    tf_zone_partings(zone, zone->displacement, equations->impulse);
    double square = 0;
    for (int i = 0; i < equations->count; i++) {
        double wanted = zone->row[i].bound - equations->impulse[i];
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
    for (int i = 0; i < equations->count; i++) {
        zone->row[i].impulse = equations->impulse[i];
        memset(zone->row[i].friction, 0, sizeof zone->row[i].friction);
    }
    tf_zone_push(zone, equations->impulse, zone->displacement);
}

//: Add vectors
double tf_equations_dot(const tf_equations *equations, const double a[],
                        const double b[])
{
    double sum = 0;
    for (int i = 0; i < equations->count; i++)
        sum += a[i] * b[i];
    return sum;
}

void tf_equations_add(const tf_equations *equations, const double a[],
                      double factor, const double b[], double sum[])
{
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
