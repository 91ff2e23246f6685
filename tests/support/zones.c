#include "support/zones.h"

#include "support/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t numbers(const zone_case *z)
{
    return (size_t)z->zone.axes * (size_t)z->zone.vertices;
}

zone_case zone_new(int axes, int vertices, int most_constraints)
{
    zone_case z = {.zone = {.axes = axes, .vertices = vertices},
                   .most_constraints = most_constraints};
    z.proposal = allocate(numbers(&z), sizeof *z.proposal);
    z.displacement = allocate(numbers(&z), sizeof *z.displacement);
    z.inverse_mass = allocate((size_t)vertices, sizeof *z.inverse_mass);
    z.constraint = allocate((size_t)most_constraints, sizeof *z.constraint);
    z.zone.displacement = z.displacement;
    z.zone.inverse_mass = z.inverse_mass;
    z.zone.constraint = z.constraint;
    return z;
}

void zone_free(zone_case *z)
{
    free(z->proposal);
    free(z->displacement);
    free(z->inverse_mass);
    free(z->constraint);
}

// Random zones ----------------------------------------------------------------

static void random_normal(generator *random, int axes, double normal[3])
{
    double square = 0;
    for (int k = 0; k < axes; k++) {
        normal[k] = uniform(random, -1, 1);
        square += normal[k] * normal[k];
    }
    for (int k = 0; k < axes; k++)
        normal[k] /= sqrt(square);
}

/// Different vertices, as many as an element pair has.
static void random_vertices(generator *random, int count, int vertices,
                            int vertex[4])
{
    for (int i = 0; i < count; i++) {
        bool again;
        do {
            vertex[i] = below(random, vertices);
            again = false;
            for (int j = 0; j < i; j++)
                again |= vertex[j] == vertex[i];
        } while (again);
    }
}

/// A point and an edge or a triangle.  The point, an even number, is not
/// scripted.
static tf_constraint random_constraint(generator *random, int axes,
                                       int vertices)
{
    tf_constraint constraint = {.vertex = {-1, -1, -1, -1}, .coefficient = {1}};
    random_vertices(random, axes + 1, vertices, constraint.vertex);
    constraint.vertex[0] -= constraint.vertex[0] % 2;
    for (int i = 1; i <= axes; i++)
        while (constraint.vertex[i] == constraint.vertex[0])
            constraint.vertex[i] = below(random, vertices);
    double sum = 0, part[3] = {0};
    for (int i = 0; i < axes; i++)
        sum += part[i] = uniform(random, 0.1, 1);
    for (int i = 0; i < axes; i++)
        constraint.coefficient[1 + i] = -part[i] / sum;
    random_normal(random, axes, constraint.normal);
    constraint.bound = uniform(random, 0, 0.1);
    return constraint;
}

zone_case zone_random(generator *random, int axes, int vertices,
                      int constraints, int most_constraints)
{
    zone_case z = zone_new(axes, vertices, most_constraints);
    for (int v = 0; v < vertices; v++)
        z.inverse_mass[v] =
            v % 2 && below(random, 4) == 0 ? 0 : uniform(random, 0.5, 2);
    for (size_t i = 0; i < numbers(&z); i++)
        z.proposal[i] = uniform(random, -1, 1);
    for (int i = 0; i < constraints; i++)
        z.constraint[i] = random_constraint(random, axes, vertices);
    z.zone.constraints = constraints;
    return z;
}

void zone_duplicate(zone_case *z, int constraint, double part)
{
    if (z->zone.constraints == z->most_constraints)
        abort();
    tf_constraint *copy = &z->constraint[z->zone.constraints++];
    *copy = z->constraint[constraint];
    copy->bound *= part;
}

// Solutions -------------------------------------------------------------------

int zone_solve_again(zone_case *z, const tf_zone_solver *solver, int sweeps)
{
    tf_zone *zone = &z->zone;
    size_t workspace =
        solver->workspace(zone->axes, zone->vertices, zone->constraints);
    double *taken = allocate(workspace, sizeof *taken);
    memcpy(z->displacement, z->proposal, numbers(z) * sizeof *z->proposal);
    zone->workspace = taken;
    zone->sweeps = sweeps;
    int iterations = solver->solve(zone);
    zone->workspace = NULL;
    free(taken);
    return iterations;
}

int zone_solve(zone_case *z, const tf_zone_solver *solver, int sweeps)
{
    for (int i = 0; i < z->zone.constraints; i++)
        z->zone.constraint[i].impulse = 0;
    return zone_solve_again(z, solver, sweeps);
}

/// The entry of a constraint at a coordinate, in units in which all masses
/// are 1.
static long double entry(const zone_case *z, const tf_constraint *constraint,
                         int coordinate)
{
    int axes = z->zone.axes, vertex = coordinate / axes;
    long double sum = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        if (constraint->vertex[i] == vertex)
            sum += (long double)constraint->coefficient[i];
    return sum * (long double)constraint->normal[coordinate % axes] *
           sqrtl((long double)z->inverse_mass[vertex]);
}

/// An equation between the coordinates; those kept are orthonormal.
typedef struct equation {
    int count;
    long double *entry, right;
} equation;

static long double dot(const equation *a, const equation *b)
{
    long double sum = 0;
    for (int i = 0; i < a->count; i++)
        sum += a->entry[i] * b->entry[i];
    return sum;
}

/// What the constraint asks of the change of the proposal.
static void take_constraint(const zone_case *z, const tf_constraint *constraint,
                            equation *taken)
{
    taken->right = (long double)constraint->bound;
    for (int i = 0; i < taken->count; i++)
        taken->entry[i] = entry(z, constraint, i);
    for (int v = 0; v < 4 && constraint->vertex[v] >= 0; v++)
        for (int k = 0; k < z->zone.axes; k++) {
            int i = z->zone.axes * constraint->vertex[v] + k;
            taken->right -= (long double)constraint->coefficient[v] *
                            (long double)constraint->normal[k] *
                            (long double)z->proposal[i];
        }
}

/// Twice, for rounding.
static void orthogonalize(equation *taken, int kept, const equation from[])
{
    for (int i = 0; i < 2 * kept; i++) {
        const equation *other = &from[i % kept];
        long double part = dot(taken, other);
        for (int j = 0; j < taken->count; j++)
            taken->entry[j] -= part * other->entry[j];
        taken->right -= part * other->right;
    }
}

/// To length 1; false if nothing is left of it.
static bool normalize(equation *taken)
{
    long double length = sqrtl(dot(taken, taken));
    if (length < 1e-12L)
        return false;
    for (int i = 0; i < taken->count; i++)
        taken->entry[i] /= length;
    taken->right /= length;
    return true;
}

void zone_least_change(const zone_case *z, double displacement[])
{
    int count = (int)numbers(z), kept = 0;
    equation *all = allocate((size_t)z->zone.constraints, sizeof *all);
    for (int i = 0; i < z->zone.constraints; i++) {
        if (!all[kept].entry)
            all[kept] = (equation){
                count, allocate((size_t)count, sizeof *all->entry), 0};
        take_constraint(z, &z->constraint[i], &all[kept]);
        orthogonalize(&all[kept], kept, all);
        kept += normalize(&all[kept]);
    }
    for (int i = 0; i < count; i++) {
        long double change = 0;
        for (int j = 0; j < kept; j++)
            change += all[j].right * all[j].entry[i];
        double inverse_mass = z->inverse_mass[i / z->zone.axes];
        displacement[i] = (double)((long double)z->proposal[i] +
                                   change * sqrtl((long double)inverse_mass));
    }
    for (int i = 0; i < z->zone.constraints; i++)
        free(all[i].entry);
    free(all);
}

// Errors ----------------------------------------------------------------------

double zone_distance(const zone_case *z, const double a[], const double b[])
{
    double most = 0;
    for (size_t i = 0; i < numbers(z); i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

/// How far a constraint is from its bound, and its compliance.
static double shortage(const zone_case *z, const tf_constraint *constraint,
                       const double displacement[], double *compliance)
{
    double sum = constraint->bound;
    *compliance = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        int v = constraint->vertex[i];
        double c = constraint->coefficient[i];
        *compliance += z->inverse_mass[v] * c * c;
        for (int k = 0; k < z->zone.axes; k++)
            sum -=
                c * constraint->normal[k] * displacement[z->zone.axes * v + k];
    }
    return sum;
}

static double residual(const zone_case *z, const double displacement[])
{
    double square = 0;
    for (int i = 0; i < z->zone.constraints; i++) {
        double compliance;
        double is = shortage(z, &z->constraint[i], displacement, &compliance);
        square += is * is / compliance;
    }
    return sqrt(square);
}

double zone_residual(const zone_case *z)
{
    return residual(z, z->displacement) / residual(z, z->proposal);
}

static double violation(const zone_case *z, const double displacement[])
{
    double most = 0;
    for (int i = 0; i < z->zone.constraints; i++) {
        double compliance;
        most = fmax(most,
                    shortage(z, &z->constraint[i], displacement, &compliance));
    }
    return most;
}

double zone_violation(const zone_case *z)
{
    return violation(z, z->displacement) / violation(z, z->proposal);
}
