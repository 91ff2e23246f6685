//: Include what the decision of pairs needs
#include "surface/pairs.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/published.h"
#include "query/apart.h"
#include "query/edge_edge.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"
#include "surface/filtered_join.h"
#include "surface/pair_vertices.h"

#include <stddef.h>
#include <string.h>

//: Hold a batch of pairs
enum {
    CONTACT_WORK = 64, ///< units of work that a contact takes, at most
    VERDICT_WORK = 32, ///< a verdict that is more than rounded numbers
    PAIRS_AT_ONCE = 64 ///< pairs that get such verdicts
};

typedef struct batch {
    int vertex[4 * TF_BATCH];
    tf_verdict verdict[TF_BATCH];
    int open[TF_BATCH]; ///< the pairs that the filter leaves undecided
    int open_vertex[4 * TF_BATCH];
    tf_verdict open_verdict[TF_BATCH];
    tf_detect_statistics statistics;
} batch;

//: List the vertices of a pair by its kind
/// How many vertices the two elements of a pair have.
static int vertex_count(tf_kind kind)
{
    return kind == TF_POINT_EDGE ? 3 : 4;
}

static void list_vertices(const tf_pair_job *job, tf_candidate pair,
                          int vertex[])
{
    switch (job->kind) {
    case TF_EDGE_EDGE:
        tf_pair_vertices(job->surface, 2, 2, pair, vertex);
        return;
    case TF_POINT_TRIANGLE:
        tf_pair_vertices(job->surface, 1, 3, pair, vertex);
        return;
    default:
        tf_pair_vertices(job->surface, 1, 2, pair, vertex);
    }
}

//: Describe a contact of a surface
static tf_status describe(const tf_pair_job *job, const int vertex[],
                          tf_contact *contact)
{
    if (job->estimate && job->estimate(job->kind, job->motion, vertex, contact))
        return TF_OK;
    switch (job->kind) {
    case TF_EDGE_EDGE:
        return tf_edge_edge(job->arithmetic, job->motion, vertex, vertex + 2,
                            contact);
    case TF_POINT_TRIANGLE:
        return tf_point_triangle(job->arithmetic, job->motion, vertex[0],
                                 vertex + 1, contact);
    default:
        return tf_point_edge(job->arithmetic, job->motion, vertex[0],
                             vertex + 1, contact);
    }
}

//: Add a contact
/// Adds a contact to what a worker has found; false if that fails.
static bool add_contact(tf_worker *worker, const int vertex[])
{
    const tf_pair_job *job = worker->job;
    if (!tf_worker_works(worker, job->surface->workers.watch, CONTACT_WORK))
        return false;
    tf_surface_contact *row = tf_worker_add(worker, sizeof *row);
    if (!row)
        return false;
    row->kind = job->kind;
    row->vertex[3] = -1;
    memcpy(row->vertex, vertex,
           sizeof *vertex * (size_t)vertex_count(job->kind));
    worker->status = describe(job, row->vertex, &row->contact);
    return worker->status == TF_OK;
}

//: Distinguish the arithmetics
/// Whether the verdicts of an arithmetic are those of the exact one, so that a
/// certain verdict of the filter is one of its own.
static bool is_exact(const tf_arithmetic *arithmetic)
{
    return arithmetic == &tf_exact || arithmetic == &tf_integer64 ||
           arithmetic == &tf_integer128;
}

static bool is_rounded(const tf_arithmetic *arithmetic)
{
    return arithmetic == &tf_clamped || arithmetic == &tf_published;
}

//: Decide pairs by one arithmetic
/// Sets clearances as well, unless they are NULL: to 0 if the narrow phase does
/// not measure, or if the job wants no more.
static tf_status decide_some(const tf_arithmetic *arithmetic,
                             const tf_pair_job *job, const tf_queries *queries,
                             tf_verdict verdict[], size_t *separated,
                             double clearance[])
{
    const tf_narrow_phase *narrow_phase = job->narrow_phase;
    if (clearance && job->measures && narrow_phase->measure)
        return narrow_phase->measure(narrow_phase->context, arithmetic, queries,
                                     verdict, separated, clearance);
    if (clearance)
        memset(clearance, 0, sizeof *clearance * queries->count);
    return narrow_phase->decide(narrow_phase->context, arithmetic, queries,
                                verdict, separated);
}

//: Decide the pairs of a batch by one arithmetic
/// Where verdicts take long, only some pairs at a time.
static tf_status decide_by(const tf_arithmetic *arithmetic,
                           const tf_pair_job *job, int count,
                           const int vertex[], tf_verdict verdict[],
                           size_t *separated, double clearance[])
{
    bool fast = is_rounded(arithmetic) || arithmetic == &tf_certain;
    int most = fast ? TF_BATCH : PAIRS_AT_ONCE;
    for (int begin = 0; begin < count; begin += most) {
        int some = count - begin < most ? count - begin : most;
        tf_queries queries = {.kind = job->kind,
                              .motion = job->motion,
                              .count = (size_t)some,
                              .vertices = vertex + (ptrdiff_t)begin *
                                                       vertex_count(job->kind)};
        if (!tf_watch_work(job->surface->workers.watch,
                           (size_t)some * (fast ? 1 : VERDICT_WORK)))
            return TF_CANCELLED;
        tf_status status =
            decide_some(arithmetic, job, &queries, verdict + begin, separated,
                        clearance ? clearance + begin : NULL);
        if (status != TF_OK)
            return status;
    }
    return TF_OK;
}

//: Decide what the filter leaves open
/// Decides by the arithmetic the pairs that the filter leaves undecided;
/// returns how many there are.
static size_t decide_open(const tf_pair_job *job, int count, batch *b,
                          tf_status *status)
{
    int vertices = vertex_count(job->kind), open = 0;
    for (int i = 0; i < count; i++) {
        if (b->verdict[i] != TF_UNDECIDED)
            continue;
        memcpy(b->open_vertex + (ptrdiff_t)open * vertices,
               b->vertex + (ptrdiff_t)i * vertices,
               sizeof(int) * (size_t)vertices);
        b->open[open++] = i;
    }
    size_t separated = 0;
    *status = decide_by(job->arithmetic, job, open, b->open_vertex,
                        b->open_verdict, &separated, NULL);
    for (int i = 0; i < open; i++)
        b->verdict[b->open[i]] = b->open_verdict[i];
    return (size_t)open;
}

//: Decide a batch of pairs
/// Decides by a filter first, if the arithmetic allows one.
static tf_status decide_batch(const tf_pair_job *job, int count,
                              const tf_candidate pair[], batch *b,
                              double clearance[])
{
    int vertices = vertex_count(job->kind);
    for (int i = 0; i < count; i++)
        list_vertices(job, pair[i], b->vertex + (ptrdiff_t)i * vertices);

    bool filtered = is_exact(job->arithmetic);
    size_t separated = 0;
    tf_status status =
        decide_by(filtered ? &tf_certain : job->arithmetic, job, count,
                  b->vertex, b->verdict, &separated, clearance);
    size_t decided = (size_t)count - separated, open = 0;
    if (status == TF_OK && filtered)
        open = decide_open(job, count, b, &status);
    else if (!is_rounded(job->arithmetic))
        open = decided;
    b->statistics.candidates += (size_t)count;
    b->statistics.by_axis += separated;
    b->statistics.by_filter += decided - open;
    b->statistics.by_signs += open;
    return status;
}

//: Mark pairs in contact
static void mark_contacts(const batch *b, int count, double mark[])
{
    for (int i = 0; i < count; i++)
        mark[i] = b->verdict[i] == TF_APART ? mark[i] : -1;
}

//: Take a batch of pairs
/// Has the pairs kept, if the job wants that; false if there is no memory.
static bool keep_batch(tf_worker *worker, int count, const tf_candidate pair[])
{
    const tf_pair_job *job = worker->job;
    if (job->keep && !job->keep(job->keeper, worker, count, pair))
        worker->status = TF_OUT_OF_MEMORY;
    return worker->status == TF_OK;
}

/// Adds the contacts of a batch; false if no more pairs are wanted.
static bool add_contacts(tf_worker *worker, int count)
{
    const tf_pair_job *job = worker->job;
    const batch *b = worker->batch.data;
    for (int i = 0; i < count; i++) {
        if (b->verdict[i] == TF_APART)
            continue;
        if (!add_contact(worker,
                         b->vertex + (ptrdiff_t)i * vertex_count(job->kind)) ||
            job->selection == TF_ANY_CONTACT)
            return false;
    }
    return true;
}

bool tf_pairs_take(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    tf_worker *worker = (tf_worker *)sink;
    const tf_pair_job *job = worker->job;
    batch *b = worker->batch.data;
    double *clearance = job->keep || job->measures ? worker->clearance : NULL;
    if (!tf_worker_goes_on(worker, job->surface->workers.watch, 0))
        return false;
    worker->status = decide_batch(job, count, pair, b, clearance);
    if (worker->status != TF_OK)
        return false;
    if (clearance)
        mark_contacts(b, count, clearance);
    return keep_batch(worker, count, pair) && add_contacts(worker, count);
}

//: Compare contacts
static bool comes_first(const void *first, const void *second)
{
    const tf_surface_contact *a = first, *b = second;
    if (a->kind != b->kind)
        return a->kind < b->kind;
    for (int i = 0; i < 4; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
}

static bool is_earlier(const void *first, const void *second)
{
    const tf_surface_contact *a = first, *b = second;
    if (a->contact.toi_lo != b->contact.toi_lo)
        return a->contact.toi_lo < b->contact.toi_lo;
    return comes_first(a, b);
}

//: Add up the statistics
void tf_detect_statistics_add(tf_detect_statistics *all,
                              const tf_detect_statistics *own)
{
    all->candidates += own->candidates;
    all->by_axis += own->by_axis;
    all->by_filter += own->by_filter;
    all->by_signs += own->by_signs;
}

//: Gather the contacts of all workers
/// Adds up what all workers took.
static void add_up_statistics(const tf_workers *workers,
                              tf_detect_statistics *all)
{
    for (int i = 0; i < workers->count; i++) {
        const batch *b = workers->worker[i]->batch.data;
        tf_detect_statistics_add(all, &b->statistics);
    }
}

bool tf_pairs_gather(tf_surface *surface, tf_contact_selection selection,
                     tf_contacts *found)
{
    tf_workers *workers = &surface->workers;
    size_t rows = tf_workers_rows(workers);
    tf_watch_stage(workers->watch, "contacts", rows);
    add_up_statistics(workers, &found->statistics);
    tf_status status = tf_workers_gather(
        workers, sizeof(tf_surface_contact),
        selection == TF_FIRST_CONTACT ? is_earlier : comes_first,
        &surface->sorting, &surface->found);
    found->any = rows > 0;
    found->contact = surface->found.data;
    found->count = selection == TF_ALL_CONTACTS
                       ? rows
                       : selection == TF_FIRST_CONTACT && rows > 0;
    return status == TF_OK;
}

//: Ready the workers
bool tf_pairs_begin(tf_surface *surface, const tf_parallel *parallel,
                    const tf_pair_job *job)
{
    if (!tf_workers_begin(&surface->workers, tf_parallel_workers(parallel),
                          job))
        return false;
    for (int i = 0; i < surface->workers.count; i++) {
        tf_worker *worker = surface->workers.worker[i];
        if (!tf_buffer_reserve(&worker->batch, 1, sizeof(batch)))
            return false;
        ((batch *)worker->batch.data)->statistics = (tf_detect_statistics){0};
    }
    return true;
}

//: Join and decide
/// Joins the elements of so many corners.
static tf_status join_kind(tf_surface *surface, int corners, int others,
                           const tf_parallel *parallel)
{
    tf_surface_join(surface, corners, others, tf_pairs_take, NULL, parallel);
    return tf_workers_status(&surface->workers);
}

static tf_status join_all(tf_surface *surface, tf_pair_job *job,
                          const tf_parallel *parallel)
{
    bool plane = surface->axes == 2;
    job->kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    tf_status status = join_kind(surface, 1, surface->axes, parallel);
    bool enough = job->selection == TF_ANY_CONTACT &&
                  tf_workers_rows(&surface->workers) > 0;
    if (status != TF_OK || plane || enough)
        return status;
    job->kind = TF_EDGE_EDGE;
    return join_kind(surface, 2, 2, parallel);
}

//: Find the pairs in contact
tf_status tf_pairs_find(tf_surface *surface, tf_pair_job *job,
                        const tf_parallel *parallel, tf_contacts *found)
{
    if (!tf_pairs_begin(surface, parallel, job))
        return TF_OUT_OF_MEMORY;
    tf_status status = join_all(surface, job, parallel);
    tf_contacts all = {0};
    if (status == TF_OK && !tf_pairs_gather(surface, job->selection, &all))
        status = tf_watch_failure(surface->workers.watch);
    if (status == TF_OK)
        *found = all;
    return status;
}
