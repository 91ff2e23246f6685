// The solvers of zones side by side, on zones that came up while cloth was
// twisted and stacked (tests/bench/zones.txt, by tests/bench/collect_zones.c):
//
//     solvers FILE
//
// Constraints are equations but for Gauss-Seidel, which takes them for
// inequalities; each solver has as many iterations as four times the
// constraints and 100 more. Prints a line a solver: its iterations, median and
// most; what it leaves of the residual (Gauss-Seidel: of the largest
// violation), relative to what the proposal has, median and worst; the same
// after a fifth of the constraints were added once more, exactly ("dup") or
// asking for up to a tenth more or less ("dup10"); by how much it changes the
// proposal, masses counted, relative to the least change that satisfies the
// equations; and the processor time for all zones in milliseconds.
#include "bench/measuring.h"
#include "response/conjugate_residuals.h"
#include "response/equations.h"
#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "response/normal_residuals.h"
#include "support/memory.h"
#include "support/zone_files.h"

#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_ZONES = 200,
    MOST_DUPLICATES = 5 // one for each so many constraints
};

// The singular value decomposition --------------------------------------------

static size_t dense_workspace(int axes, int vertices, int constraints)
{
    return tf_equations_workspace(axes, vertices, constraints, 3) +
           (size_t)constraints * (size_t)constraints;
}

/// The matrix column by column.
static void fill(const tf_equations *equations, double unit[], double matrix[])
{
    memset(unit, 0, sizeof *unit * (size_t)equations->count);
    for (int i = 0; i < equations->count; i++) {
        unit[i] = 1;
        tf_equations_multiply(equations, unit,
                              matrix + (ptrdiff_t)i * equations->count);
        unit[i] = 0;
    }
}

/// The least impulses of the least squares, singular values below 10^-10 of the
/// largest taken for zero.
static int solve_densely(tf_zone *zone)
{
    double *vector[3];
    tf_equations equations = tf_equations_of(zone, 3, vector);
    double *matrix =
        zone->workspace + tf_equations_workspace(zone->axes, zone->vertices,
                                                 zone->constraints, 3);
    double *x = vector[0], *right = vector[1], *value = vector[2];
    lapack_int n = zone->constraints, rank;
    tf_equations_start(&equations, x, right);
    fill(&equations, x, matrix);
    if (LAPACKE_dgelsd(LAPACK_COL_MAJOR, n, n, 1, matrix, n, right, n, value,
                       1e-10, &rank) != 0)
        abort();
    tf_equations_finish(&equations, right);
    return 0;
}

static const tf_zone_solver tf_dense = {"SVD (LAPACK dgelsd)", dense_workspace,
                                        solve_densely};

// Conjugate gradients ---------------------------------------------------------

static size_t gradients_workspace(int axes, int vertices, int constraints)
{
    return tf_equations_workspace(axes, vertices, constraints, 4);
}

/// Needs a matrix that is definite, or equations that agree: else it diverges.
static int solve_by_gradients(tf_zone *zone)
{
    double *vector[4];
    tf_equations e = tf_equations_of(zone, 4, vector);
    double *x = vector[0], *residual = vector[1], *direction = vector[2];
    double *image = vector[3];
    double enough = tf_equations_start(&e, x, residual);
    tf_equations_add(&e, residual, 0, residual, direction);
    double square = tf_equations_dot(&e, residual, residual);
    int iterations = 0;
    while (iterations < zone->sweeps && sqrt(square) > enough) {
        tf_equations_multiply(&e, direction, image);
        double length = square / tf_equations_dot(&e, direction, image);
        tf_equations_add(&e, x, length, direction, x);
        tf_equations_add(&e, residual, -length, image, residual);
        double before = square;
        square = tf_equations_dot(&e, residual, residual);
        tf_equations_add(&e, residual, square / before, direction, direction);
        iterations++;
    }
    tf_equations_finish(&e, x);
    return iterations;
}

static const tf_zone_solver tf_gradients = {
    "conjugate-gradients", gradients_workspace, solve_by_gradients};

// Zones -----------------------------------------------------------------------

/// Each zone as it is, with constraints added again, and with such that
/// disagree.
typedef enum variant {
    PLAIN,
    DUP,
    DUP10,
    VARIANTS
} variant;

static zone_case zones[VARIANTS][MOST_ZONES];
static double *least_change[MOST_ZONES]; ///< the displacements
static int count;

/// What the constraint asks of impulses: its bound, and how far the proposal is
/// from separation its elements.
static double right_side(const zone_case *z, const tf_constraint *constraint)
{
    double sum = constraint->bound;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        for (int k = 0; k < z->zone.axes; k++)
            sum -= constraint->coefficient[i] * constraint->normal[k] *
                   z->proposal[z->zone.axes * constraint->vertex[i] + k];
    return sum;
}

static void add_constraints(generator *random, double difference, zone_case *z)
{
    int constraints = z->zone.constraints;
    for (int added = 0; added < constraints / MOST_DUPLICATES; added++) {
        int constraint = below(random, constraints);
        double part = uniform(random, -difference, difference);
        zone_duplicate(z, constraint, 1);
        z->constraint[z->zone.constraints - 1].bound +=
            part * right_side(z, &z->constraint[constraint]);
    }
}

static void read_zones(const char *name, variant which)
{
    generator random = generator_new(1);
    FILE *file = fopen(name, "r");
    if (!file) {
        perror(name);
        exit(EXIT_FAILURE);
    }
    count = 0;
    while (count < MOST_ZONES &&
           zone_read(file, 1.0 / MOST_DUPLICATES, &zones[which][count])) {
        if (which != PLAIN)
            add_constraints(&random, which == DUP10 ? 0.1 : 0,
                            &zones[which][count]);
        count++;
    }
    fclose(file);
    if (count == 0) {
        fprintf(stderr, "%s: no zones\n", name);
        exit(EXIT_FAILURE);
    }
}

static void find_least_changes(void)
{
    for (int i = 0; i < count; i++) {
        const zone_case *z = &zones[PLAIN][i];
        least_change[i] =
            allocate((size_t)(z->zone.axes * z->zone.vertices), sizeof(double));
        zone_least_change(z, least_change[i]);
    }
}

// Measurements ----------------------------------------------------------------

/// The change of the proposal, masses counted.
static double change(const zone_case *z, const double displacement[])
{
    double square = 0;
    for (int i = 0; i < z->zone.axes * z->zone.vertices; i++) {
        double inverse_mass = z->inverse_mass[i / z->zone.axes];
        double d = displacement[i] - z->proposal[i];
        square += inverse_mass > 0 ? d * d / inverse_mass : 0;
    }
    return sqrt(square);
}

static int compare_numbers(const void *a, const void *b)
{
    double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/// Sorts them.
static double median(double number[])
{
    qsort(number, (size_t)count, sizeof *number, compare_numbers);
    return number[count / 2];
}

typedef struct results {
    double iterations[MOST_ZONES], residual[MOST_ZONES], part[MOST_ZONES];
    double time;
} results;

static void solve_all(const tf_zone_solver *solver, variant which,
                      results *found)
{
    found->time = 0;
    for (int i = 0; i < count; i++) {
        zone_case *z = &zones[which][i];
        double begin = processor_seconds();
        found->iterations[i] =
            zone_solve(z, solver, 4 * z->zone.constraints + 100);
        found->time += 1e3 * (processor_seconds() - begin);
        found->residual[i] =
            solver == &tf_gauss_seidel ? zone_violation(z) : zone_residual(z);
        if (!isfinite(found->residual[i]))
            found->residual[i] = DBL_MAX;
        found->part[i] =
            change(z, z->displacement) / change(z, least_change[i]);
    }
}

static void show_solver(const tf_zone_solver *solver)
{
    static results found;
    printf("%-20s", solver->name);
    solve_all(solver, PLAIN, &found);
    double time = found.time, part = median(found.part);
    double middle = median(found.iterations);
    printf(" %6.0f %6.0f", middle, found.iterations[count - 1]);
    for (int which = PLAIN; which < VARIANTS; which++) {
        solve_all(solver, (variant)which, &found);
        middle = median(found.residual);
        printf("  %8.1e %8.1e", middle, found.residual[count - 1]);
    }
    printf("  %5.2f %8.1f\n", part, time);
}

static void show_zones(void)
{
    double constraints[MOST_ZONES] = {0};
    for (int i = 0; i < count; i++)
        constraints[i] = zones[PLAIN][i].zone.constraints;
    double middle = median(constraints);
    printf("%d zones of %.0f to %.0f constraints, median %.0f\n", count,
           constraints[0], constraints[count - 1], middle);
}

int main(int argc, char *argv[])
{
    static const tf_zone_solver *const solvers[] = {
        &tf_dense,  &tf_gradients,        &tf_conjugate_residuals,
        &tf_minres, &tf_normal_residuals, &tf_gauss_seidel};
    if (argc != 2) {
        fprintf(stderr, "usage: solvers FILE\n");
        return EXIT_FAILURE;
    }
    for (int which = PLAIN; which < VARIANTS; which++)
        read_zones(argv[1], (variant)which);
    find_least_changes();
    show_zones();
    printf("%-20s %13s  %17s  %17s  %17s  %5s %8s\n", "", "iterations",
           "residual", "dup", "dup10", "", "");
    printf("%-20s %6s %6s", "solver", "median", "most");
    for (int which = PLAIN; which < VARIANTS; which++)
        printf("  %8s %8s", "median", "worst");
    printf("  %5s %8s\n", "part", "ms");
    for (size_t i = 0; i < sizeof solvers / sizeof *solvers; i++)
        show_solver(solvers[i]);
    for (int which = PLAIN; which < VARIANTS; which++)
        for (int i = 0; i < count; i++)
            zone_free(&zones[which][i]);
    for (int i = 0; i < count; i++)
        free(least_change[i]);
    return EXIT_SUCCESS;
}
