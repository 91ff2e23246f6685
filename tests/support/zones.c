#include "support/zones.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (!memory)
        abort();
    return memory;
}

static size_t numbers(const some_zone *of)
{
    return (size_t)of->zone.axes * (size_t)of->zone.vertices;
}

some_zone zone_new(int axes, int vertices, int most_constraints)
{
    some_zone of = {.zone = {.axes = axes, .vertices = vertices},
                    .most_constraints = most_constraints};
    of.proposal = allocate(numbers(&of), sizeof *of.proposal);
    of.displacement = allocate(numbers(&of), sizeof *of.displacement);
    of.inverse_mass = allocate((size_t)vertices, sizeof *of.inverse_mass);
    of.constraint = allocate((size_t)most_constraints, sizeof *of.constraint);
    of.zone.displacement = of.displacement;
    of.zone.inverse_mass = of.inverse_mass;
    of.zone.constraint = of.constraint;
    return of;
}

void zone_free(some_zone *of)
{
    free(of->proposal);
    free(of->displacement);
    free(of->inverse_mass);
    free(of->constraint);
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

some_zone zone_random(generator *random, int axes, int vertices,
                      int constraints, int most_constraints)
{
    some_zone of = zone_new(axes, vertices, most_constraints);
    for (int v = 0; v < vertices; v++)
        of.inverse_mass[v] =
            v % 2 && below(random, 4) == 0 ? 0 : uniform(random, 0.5, 2);
    for (size_t i = 0; i < numbers(&of); i++)
        of.proposal[i] = uniform(random, -1, 1);
    for (int i = 0; i < constraints; i++)
        of.constraint[i] = random_constraint(random, axes, vertices);
    of.zone.constraints = constraints;
    return of;
}

void zone_duplicate(some_zone *of, int constraint, double part)
{
    if (of->zone.constraints == of->most_constraints)
        abort();
    tf_constraint *copy = &of->constraint[of->zone.constraints++];
    *copy = of->constraint[constraint];
    copy->bound *= part;
}

// Solutions -------------------------------------------------------------------

int zone_solve_again(some_zone *of, const tf_zone_solver *solver, int sweeps)
{
    tf_zone *zone = &of->zone;
    size_t workspace =
        solver->workspace(zone->axes, zone->vertices, zone->constraints);
    double *taken = allocate(workspace, sizeof *taken);
    memcpy(of->displacement, of->proposal, numbers(of) * sizeof *of->proposal);
    zone->workspace = taken;
    zone->sweeps = sweeps;
    int iterations = solver->solve(zone);
    zone->workspace = NULL;
    free(taken);
    return iterations;
}

int zone_solve(some_zone *of, const tf_zone_solver *solver, int sweeps)
{
    for (int i = 0; i < of->zone.constraints; i++)
        of->zone.constraint[i].impulse = 0;
    return zone_solve_again(of, solver, sweeps);
}

/// The entry of a constraint at a coordinate, in units in which all masses
/// are 1.
static long double entry(const some_zone *of, const tf_constraint *constraint,
                         int coordinate)
{
    int axes = of->zone.axes, vertex = coordinate / axes;
    long double sum = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        if (constraint->vertex[i] == vertex)
            sum += (long double)constraint->coefficient[i];
    return sum * (long double)constraint->normal[coordinate % axes] *
           sqrtl((long double)of->inverse_mass[vertex]);
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
static void take_constraint(const some_zone *of,
                            const tf_constraint *constraint, equation *taken)
{
    taken->right = (long double)constraint->bound;
    for (int i = 0; i < taken->count; i++)
        taken->entry[i] = entry(of, constraint, i);
    for (int v = 0; v < 4 && constraint->vertex[v] >= 0; v++)
        for (int k = 0; k < of->zone.axes; k++) {
            int i = of->zone.axes * constraint->vertex[v] + k;
            taken->right -= (long double)constraint->coefficient[v] *
                            (long double)constraint->normal[k] *
                            (long double)of->proposal[i];
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

void zone_least_change(const some_zone *of, double displacement[])
{
    int count = (int)numbers(of), kept = 0;
    equation *all = allocate((size_t)of->zone.constraints, sizeof *all);
    for (int i = 0; i < of->zone.constraints; i++) {
        if (!all[kept].entry)
            all[kept] = (equation){
                count, allocate((size_t)count, sizeof *all->entry), 0};
        take_constraint(of, &of->constraint[i], &all[kept]);
        orthogonalize(&all[kept], kept, all);
        kept += normalize(&all[kept]);
    }
    for (int i = 0; i < count; i++) {
        long double change = 0;
        for (int j = 0; j < kept; j++)
            change += all[j].right * all[j].entry[i];
        double inverse_mass = of->inverse_mass[i / of->zone.axes];
        displacement[i] = (double)((long double)of->proposal[i] +
                                   change * sqrtl((long double)inverse_mass));
    }
    for (int i = 0; i < of->zone.constraints; i++)
        free(all[i].entry);
    free(all);
}

// Errors ----------------------------------------------------------------------

double zone_distance(const some_zone *of, const double a[], const double b[])
{
    double most = 0;
    for (size_t i = 0; i < numbers(of); i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

/// How far a constraint is from its bound, and its compliance.
static double shortage(const some_zone *of, const tf_constraint *constraint,
                       const double displacement[], double *compliance)
{
    double sum = constraint->bound;
    *compliance = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        int v = constraint->vertex[i];
        double c = constraint->coefficient[i];
        *compliance += of->inverse_mass[v] * c * c;
        for (int k = 0; k < of->zone.axes; k++)
            sum -=
                c * constraint->normal[k] * displacement[of->zone.axes * v + k];
    }
    return sum;
}

static double residual(const some_zone *of, const double displacement[])
{
    double square = 0;
    for (int i = 0; i < of->zone.constraints; i++) {
        double compliance;
        double is = shortage(of, &of->constraint[i], displacement, &compliance);
        square += is * is / compliance;
    }
    return sqrt(square);
}

double zone_residual(const some_zone *of)
{
    return residual(of, of->displacement) / residual(of, of->proposal);
}

static double violation(const some_zone *of, const double displacement[])
{
    double most = 0;
    for (int i = 0; i < of->zone.constraints; i++) {
        double compliance;
        most = fmax(
            most, shortage(of, &of->constraint[i], displacement, &compliance));
    }
    return most;
}

double zone_violation(const some_zone *of)
{
    return violation(of, of->displacement) / violation(of, of->proposal);
}
