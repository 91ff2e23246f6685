//: Include what dynamics need
#include "simulate/dynamics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <suitesparse/cholmod.h>

//: Hold the dynamics
struct tf_dynamics {
    const tf_body *body;
    double step_squared;
    int unknowns; ///< vertices that are not scripted
    int *column;  ///< of each vertex in the matrix; -1: it is scripted
    cholmod_common common;
    cholmod_factor *factor;
    cholmod_dense *inertia; ///< what does not change in a step
    cholmod_dense *right;   ///< right sides, a column for each axis
    cholmod_dense *solution, *scratch[2]; ///< CHOLMOD's, kept for the next time
};

static int number_columns(const tf_body *body, int column[])
{
    int unknowns = 0;
    for (int v = 0; v < body->vertices; v++)
        column[v] = body->mass[v] > 0 ? unknowns++ : -1;
    return unknowns;
}

//: Add up the matrix
/// Each element adds the products of its weights.  Of the symmetric matrix only
/// the upper triangle is listed; CHOLMOD adds up what is listed twice.
static void list_entry(cholmod_triplet *list, int row, int column, double value)
{
    if (row < 0 || column < 0)
        return;
    ((int *)list->i)[list->nnz] = row < column ? row : column;
    ((int *)list->j)[list->nnz] = row < column ? column : row;
    ((double *)list->x)[list->nnz++] = value;
}

static void list_elastic(const tf_dynamics *d, const tf_elastic *elastic,
                         cholmod_triplet *list)
{
    double scale = d->step_squared * elastic->stiffness;
    for (int i = 0; i < elastic->count; i++)
        for (int j = 0; j <= i; j++)
            list_entry(list, d->column[elastic->vertex[i]],
                       d->column[elastic->vertex[j]],
                       scale * elastic->weight[i] * elastic->weight[j]);
}

static cholmod_sparse *make_matrix(tf_dynamics *d)
{
    const tf_body *body = d->body;
    size_t size = (size_t)d->unknowns;
    size_t entries = size + 10 * (size_t)body->elastics;
    cholmod_triplet *list = cholmod_allocate_triplet(size, size, entries, 1,
                                                     CHOLMOD_REAL, &d->common);
    if (!list)
        return NULL;
    for (int v = 0; v < body->vertices; v++)
        list_entry(list, d->column[v], d->column[v], body->mass[v]);
    for (int i = 0; i < body->elastics; i++)
        list_elastic(d, &body->elastic[i], list);
    cholmod_sparse *matrix =
        cholmod_triplet_to_sparse(list, entries, &d->common);
    cholmod_free_triplet(&list, &d->common);
    return matrix;
}

//: Factorize the matrix
/// Column by column, without the parallel kernels of other libraries, so that
/// the answer does not depend on those or on the number of threads.
static void prefer_same_bits(cholmod_common *common)
{
    common->print = 0;
    common->supernodal = CHOLMOD_SIMPLICIAL;
    common->nmethods = 1;
    common->method[0].ordering = CHOLMOD_AMD;
}

static bool factorize(tf_dynamics *d)
{
    cholmod_sparse *matrix = make_matrix(d);
    if (!matrix)
        return false;
    d->factor = cholmod_analyze(matrix, &d->common);
    bool good = d->factor && cholmod_factorize(matrix, d->factor, &d->common);
    cholmod_free_sparse(&matrix, &d->common);
    return good;
}

//: Make and free dynamics
static bool prepare(tf_dynamics *d)
{
    size_t vertices = (size_t)d->body->vertices;
    size_t axes = (size_t)d->body->axes;
    d->column = malloc(sizeof *d->column * (vertices + 1));
    if (!d->column)
        return false;
    d->unknowns = number_columns(d->body, d->column);
    size_t rows = (size_t)d->unknowns;
    d->inertia = cholmod_zeros(rows, axes, CHOLMOD_REAL, &d->common);
    d->right = cholmod_zeros(rows, axes, CHOLMOD_REAL, &d->common);
    return d->inertia && d->right && factorize(d);
}

tf_status tf_dynamics_create(const tf_body *body, double step,
                             tf_dynamics **dynamics)
{
    tf_dynamics *d = calloc(1, sizeof *d);
    if (!d)
        return TF_OUT_OF_MEMORY;
    d->body = body;
    d->step_squared = step * step;
    cholmod_start(&d->common);
    prefer_same_bits(&d->common);
    if (!prepare(d)) {
        tf_dynamics_free(d);
        return TF_OUT_OF_MEMORY;
    }
    *dynamics = d;
    return TF_OK;
}

void tf_dynamics_free(tf_dynamics *dynamics)
{
    if (!dynamics)
        return;
    cholmod_common *common = &dynamics->common;
    cholmod_free_factor(&dynamics->factor, common);
    cholmod_free_dense(&dynamics->inertia, common);
    cholmod_free_dense(&dynamics->right, common);
    cholmod_free_dense(&dynamics->solution, common);
    cholmod_free_dense(&dynamics->scratch[0], common);
    cholmod_free_dense(&dynamics->scratch[1], common);
    cholmod_finish(common);
    free(dynamics->column);
    free(dynamics);
}

//: Find what does not change in a step
/// The place of an axis of a vertex in the columns.
static double *entry(const tf_dynamics *d, cholmod_dense *in, int v, int axis)
{
    return (double *)in->x + (size_t)axis * (size_t)d->unknowns + d->column[v];
}

/// Adds the share of each vertex that an element pulls by a force.
static void add_shares(const tf_dynamics *d, cholmod_dense *to,
                       const tf_elastic *elastic, double scale,
                       const double force[3])
{
    for (int i = 0; i < elastic->count; i++)
        if (d->column[elastic->vertex[i]] >= 0)
            for (int k = 0; k < d->body->axes; k++)
                *entry(d, to, elastic->vertex[i], k) +=
                    scale * elastic->weight[i] * force[k];
}

/// Moves what scripted vertices add to an element's sum to the right side.
static void subtract_scripted(const tf_dynamics *d, const tf_elastic *elastic,
                              const double end[])
{
    tf_elastic scripted = {.count = 0};
    for (int i = 0; i < elastic->count; i++)
        if (d->column[elastic->vertex[i]] < 0) {
            scripted.vertex[scripted.count] = elastic->vertex[i];
            scripted.weight[scripted.count++] = elastic->weight[i];
        }
    if (scripted.count == 0)
        return;
    double sum[3];
    tf_elastic_sum(&scripted, d->body->axes, end, sum);
    add_shares(d, d->inertia, elastic, -d->step_squared * elastic->stiffness,
               sum);
}

static void find_inertia(const tf_dynamics *d, const double end[])
{
    const tf_body *body = d->body;
    for (int v = 0; v < body->vertices; v++)
        if (d->column[v] >= 0)
            for (int k = 0; k < body->axes; k++)
                *entry(d, d->inertia, v, k) =
                    body->mass[v] * end[body->axes * v + k];
    for (int i = 0; i < body->elastics; i++)
        subtract_scripted(d, &body->elastic[i], end);
}

//: Find the target sum of each element
static void pull(const tf_dynamics *d, const tf_elastic *elastic,
                 const double end[])
{
    double sum[3], square = 0;
    tf_elastic_sum(elastic, d->body->axes, end, sum);
    for (int k = 0; k < d->body->axes; k++)
        square += sum[k] * sum[k];
    if (square != 0)
        add_shares(d, d->right, elastic,
                   d->step_squared * elastic->stiffness * elastic->rest /
                       sqrt(square),
                   sum);
}

static void find_right_sides(const tf_dynamics *d, const double end[])
{
    size_t size = sizeof(double) * (size_t)d->unknowns;
    memcpy(d->right->x, d->inertia->x, size * (size_t)d->body->axes);
    for (int i = 0; i < d->body->elastics; i++)
        if (d->body->elastic[i].rest > 0)
            pull(d, &d->body->elastic[i], end);
}

//: Find the positions that fit those sums best
static bool fit(tf_dynamics *d, double end[])
{
    const tf_body *body = d->body;
    if (!cholmod_solve2(CHOLMOD_A, d->factor, d->right, NULL, &d->solution,
                        NULL, &d->scratch[0], &d->scratch[1], &d->common))
        return false;
    for (int v = 0; v < body->vertices; v++)
        if (d->column[v] >= 0)
            for (int k = 0; k < body->axes; k++)
                end[body->axes * v + k] = *entry(d, d->solution, v, k);
    return true;
}

//: Step the dynamics
tf_status tf_dynamics_step(tf_dynamics *dynamics, double end[], int iterations)
{
    find_inertia(dynamics, end);
    for (int i = 0; i < iterations; i++) {
        find_right_sides(dynamics, end);
        if (!fit(dynamics, end))
            return TF_OUT_OF_MEMORY;
    }
    return TF_OK;
}
