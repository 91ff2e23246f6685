//: Include what batches need
#include "fast/batch.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "base/environment.h"
#include "base/fail.h"
#include "base/require.h"
#include "fast/vectorized.h"
#include "query/query.h"
#include "query/shape.h"
#include "surface/tasks.h"

#include <math.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

//: Hold a batch of queries
enum {
    QUERIES_AT_ONCE = 1024,
    MOST_TASKS = 1 << 20
};

typedef struct query_job {
    const tf_arithmetic *arithmetic;
    const tf_queries *queries;
    const tf_query_shape *shape;
    tf_contact *contact;
    size_t part;             ///< how many queries a task has
    atomic_size_t first_bad; ///< the first that is known to be bad
    atomic_bool misrounds;   ///< a worker's environment is bad
} query_job;

static const int *vertices_of_query(const query_job *job, size_t i)
{
    return job->queries->vertices +
           i * (size_t)(job->shape->vertices + job->shape->others);
}

//: Decide some queries of a batch
/// Whether vectors decide more quickly than a query answers.
static bool has_vectors(const query_job *job)
{
    int axes = job->shape->axes;
    return axes == 3 && tf_arithmetic_bits(job->arithmetic, axes) == 0;
}

static tf_status decide_part(const query_job *job, size_t begin, size_t count,
                             tf_verdict verdict[])
{
    tf_queries part = {job->queries->kind, job->queries->motion, count,
                       vertices_of_query(job, begin)};
    size_t separated = 0;
    return tf_vectorized.decide(NULL, job->arithmetic, &part, verdict,
                                &separated);
}

//: Answer some queries of a batch
static tf_status answer_query(const query_job *job, size_t i)
{
    const tf_query_shape *s = job->shape;
    const int *vertex = vertices_of_query(job, i);
    return tf_query_motion(job->arithmetic, s->axes, job->queries->motion,
                           s->vertices, vertex, s->others, vertex + s->vertices,
                           &job->contact[i]);
}

static tf_status answer_part(const query_job *job, size_t begin, size_t count)
{
    static const tf_contact apart = {.verdict = TF_APART};
    tf_verdict verdict[QUERIES_AT_ONCE] = {TF_UNDECIDED};
    tf_status status = TF_OK;
    if (has_vectors(job))
        status = decide_part(job, begin, count, verdict);
    for (size_t i = 0; i < count && status == TF_OK; i++) {
        if (verdict[i] == TF_APART)
            job->contact[begin + i] = apart;
        else
            status = answer_query(job, begin + i);
    }
    return status;
}

//: Name a bad index
/// Fails if an index of the query names no vertex or is there twice.
static tf_status check_indices(const query_job *job, size_t i, tf_error *error)
{
    const int *vertex = vertices_of_query(job, i);
    int count = job->shape->vertices + job->shape->others;
    int vertices = job->queries->motion->vertices;
    for (int v = 0; v < count; v++)
        if (vertex[v] < 0 || vertex[v] >= vertices)
            return tf_fail_index(error, TF_BATCH_QUERY, i, vertex[v], vertices);
    for (int v = 1; v < count; v++)
        for (int other = 0; other < v; other++)
            if (vertex[other] == vertex[v])
                return tf_fail_index(error, TF_BATCH_QUERY, i, vertex[v],
                                     vertices);
    return TF_OK;
}

//: Name a bad coordinate
static tf_status check_number(const query_job *job, double x)
{
    int axes = job->shape->axes;
    bool limited = tf_arithmetic_bits(job->arithmetic, axes) != 0;
    if (!isfinite(x))
        return TF_NOT_FINITE;
    return limited && !tf_arithmetic_holds(job->arithmetic, axes, x)
               ? TF_OUT_OF_RANGE
               : TF_OK;
}

static tf_status check_vertex(const query_job *job, size_t i, int vertex,
                              tf_error *error)
{
    const tf_motion *motion = job->queries->motion;
    int axes = job->shape->axes;
    for (int k = 0; k < axes; k++)
        for (int t = 0; t < 2; t++) {
            const double *x = t ? motion->end : motion->start;
            tf_status status =
                check_number(job, x[(ptrdiff_t)axes * vertex + k]);
            if (status != TF_OK)
                return tf_fail_query(error, status, i, vertex, t);
        }
    return TF_OK;
}

static tf_status check_query_of(const query_job *job, size_t i, tf_error *error)
{
    const int *vertex = vertices_of_query(job, i);
    int count = job->shape->vertices + job->shape->others;
    tf_status status = check_indices(job, i, error);
    for (int v = 0; v < count && status == TF_OK; v++)
        status = check_vertex(job, i, vertex[v], error);
    return status;
}

//: Note the first bad query
static size_t find_bad(const query_job *job, size_t begin, size_t end)
{
    while (begin < end && check_query_of(job, begin, NULL) == TF_OK)
        begin++;
    return begin;
}

static void note_bad(query_job *job, size_t bad)
{
    size_t known = atomic_load(&job->first_bad);
    while (bad < known)
        // If this fails, `known` is what another worker has found meanwhile.
        if (atomic_compare_exchange_weak(&job->first_bad, &known, bad))
            return;
}

//: Answer the queries of a task
/// Those behind one that is bad do not matter.
static void answer_task(void *argument, int task, int worker)
{
    query_job *job = argument;
    size_t begin = job->part * (size_t)task, rest = job->queries->count - begin;
    size_t end = begin + (rest < job->part ? rest : job->part);
    tf_status status = TF_OK;
    (void)worker;
    while (begin < end && begin < atomic_load(&job->first_bad)) {
        rest = end - begin;
        size_t next = begin + (rest < QUERIES_AT_ONCE ? rest : QUERIES_AT_ONCE);
        status = answer_part(job, begin, next - begin);
        if (status == TF_BAD_ENVIRONMENT)
            atomic_store(&job->misrounds, true);
        else if (status != TF_OK)
            note_bad(job, find_bad(job, begin, next));
        begin = status == TF_OK ? next : end;
    }
}

//: Check a batch of queries
/// About what is wrong with all of them.
static tf_status check_batch(const tf_queries *queries,
                             const tf_query_shape *shape,
                             const tf_parallel *parallel, tf_error *error)
{
    size_t most = PTRDIFF_MAX / sizeof(tf_contact);
    if (!shape)
        return tf_fail_option(error, "kind", "one of its enumeration",
                              queries->kind);
    tf_status status = tf_parallel_check(parallel, error);
    if (status != TF_OK)
        return status;
    if (queries->count == 0)
        return tf_fail(error, TF_OK);
    if (queries->count > most || !queries->vertices)
        return tf_fail(error, TF_BAD_COUNT);
    TF_REQUIRE(queries->motion);
    status = tf_motion_check(queries->motion, shape->axes);
    if (status == TF_OK && !tf_environment_is_ieee())
        status = TF_BAD_ENVIRONMENT;
    return tf_fail(error, status);
}

//: Answer many queries
/// Tasks of many queries each, if there are very many.
static size_t part_of(size_t count)
{
    size_t part = QUERIES_AT_ONCE;
    while (count / part >= MOST_TASKS)
        part *= 2;
    return part;
}

static tf_status answer_all(query_job *job, const tf_parallel *parallel,
                            tf_error *error)
{
    size_t count = job->queries->count, tasks = (count - 1) / job->part + 1;
    atomic_init(&job->first_bad, count);
    atomic_init(&job->misrounds, false);
    tf_parallel_for_each(parallel, (int)tasks, answer_task, job);
    if (atomic_load(&job->misrounds))
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    size_t bad = atomic_load(&job->first_bad);
    return bad < count ? check_query_of(job, bad, error)
                       : tf_fail(error, TF_OK);
}

tf_status tf_query_batch(const tf_arithmetic *arithmetic,
                         const tf_queries *queries, const tf_parallel *parallel,
                         tf_contact contact[], tf_error *error)
{
    TF_REQUIRE(queries);
    query_job job = {.arithmetic = arithmetic ? arithmetic : &tf_exact,
                     .queries = queries,
                     .shape = tf_query_shape_of(queries->kind),
                     .contact = contact,
                     .part = part_of(queries->count)};
    tf_status status = check_batch(queries, job.shape, parallel, error);
    if (status != TF_OK || queries->count == 0)
        return status;
    TF_REQUIRE(contact);
    return answer_all(&job, parallel, error);
}
