//: Include what looking for contacts needs
#include "response/recheck.h"

#include "arithmetic/exact.h"

#include <stddef.h>
#include <string.h>

//: Choose how pairs are decided
static tf_motion motion_of(const tf_step *step)
{
    return (tf_motion){step->vertices, step->start, step->end};
}

static tf_deciding deciding(const tf_surface *surface, const tf_motion *motion,
                            const tf_narrow_phase *narrow_phase, bool keeps)
{
    return (tf_deciding){.surface = surface,
                         .motion = motion,
                         .arithmetic = &tf_exact,
                         .narrow_phase = narrow_phase,
                         .keeps = keeps};
}

//: Look for contacts from the beginning
tf_status tf_check_all(tf_surface *surface, const tf_step *step,
                       const tf_narrow_phase *narrow_phase,
                       const tf_parallel *parallel, tf_contacts *found,
                       tf_flaw *flaw)
{
    tf_motion motion = motion_of(step);
    tf_status status = tf_surface_move(surface, &motion, parallel, flaw);
    if (status != TF_OK)
        return status;
    tf_deciding of = deciding(surface, &motion, narrow_phase, true);
    return tf_pairs_find(surface, &of, parallel, found);
}

//: Mark the elements that have changed
/// Those that have a changed vertex.
static void mark_elements(const tf_elements *elements, int corners,
                          const bool changed[], bool mark[])
{
    const int *corner = elements->corner;
    for (int i = 0; i < elements->count; i++, corner += corners) {
        mark[i] = false;
        for (int c = 0; c < corners; c++)
            mark[i] |= changed[corner[c]];
    }
}

//: Hold what is looked at again
typedef struct rechecking {
    tf_workers *workers;
    bool of_edges; ///< the pairs of two edges, not those with a vertex
    const bool *first, *second; ///< whether an element has changed
} rechecking;

static const tf_pair_list *list_of(const rechecking *of, int worker)
{
    const tf_worker *keeper = of->workers->worker[worker];
    return of->of_edges ? &keeper->edges : &keeper->points;
}

/// Each batch of a list is a task.
static int tasks_of(const tf_pair_list *list)
{
    return (int)((list->count + TF_BATCH - 1) / TF_BATCH);
}

//: Look at a batch of pairs again
/// Writes those of some pairs that have changed to `to`; returns how many.
static int select_changed(const rechecking *of, size_t count,
                          const tf_candidate pair[], tf_candidate to[])
{
    int changed = 0;
    for (size_t i = 0; i < count; i++) {
        to[changed] = pair[i];
        changed += of->first[pair[i].first] | of->second[pair[i].second];
    }
    return changed;
}

static void recheck_batch(void *argument, int task, int number)
{
    const rechecking *of = argument;
    int keeper = 0;
    for (; task >= tasks_of(list_of(of, keeper)); keeper++)
        task -= tasks_of(list_of(of, keeper));
    const tf_pair_list *list = list_of(of, keeper);
    size_t begin = (size_t)task * TF_BATCH, rest = list->count - begin;
    const tf_candidate *pair = list->pair.data;
    tf_pair_sink *sink = &of->workers->worker[number]->sink;
    sink->take = tf_pairs_take;
    sink->count = select_changed(of, rest < TF_BATCH ? rest : TF_BATCH,
                                 pair + begin, sink->pair);
    tf_pair_sink_hand_on(sink);
}

//: Look at all pairs of a kind again
static tf_status recheck_kind(const tf_parallel *parallel, rechecking *of)
{
    int tasks = 0;
    for (int i = 0; i < of->workers->count; i++)
        tasks += tasks_of(list_of(of, i));
    tf_parallel_for_each(parallel, tasks, recheck_batch, of);
    return tf_workers_status(of->workers);
}

static tf_status recheck_kinds(tf_surface *surface, const tf_step *step,
                               tf_deciding *how, const tf_parallel *parallel)
{
    bool plane = surface->axes == 2;
    bool *edge = surface->changed.data, *triangle = edge + surface->edges.count;
    mark_elements(&surface->edges, 2, step->changed, edge);
    mark_elements(&surface->triangles, 3, step->changed, triangle);
    rechecking of = {.workers = &surface->workers,
                     .first = step->changed,
                     .second = plane ? edge : triangle};
    how->kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    tf_status status = recheck_kind(parallel, &of);
    if (status != TF_OK)
        return status;
    of.of_edges = true;
    of.first = of.second = edge;
    how->kind = TF_EDGE_EDGE;
    return recheck_kind(parallel, &of);
}

//: Look at what has changed again
tf_status tf_recheck(tf_surface *surface, tf_step *step,
                     const tf_narrow_phase *narrow_phase,
                     const tf_parallel *parallel, tf_contacts *found)
{
    tf_motion motion = motion_of(step);
    tf_deciding how = deciding(surface, &motion, narrow_phase, false);
    size_t elements =
        (size_t)surface->edges.count + (size_t)surface->triangles.count;
    if (!tf_buffer_reserve(&surface->changed, elements, sizeof(bool)) ||
        !tf_pairs_begin(surface, parallel, &how))
        return TF_OUT_OF_MEMORY;
    tf_status status = recheck_kinds(surface, step, &how, parallel);
    *found = (tf_contacts){0};
    if (status == TF_OK && !tf_pairs_gather(surface, how.extent, found))
        status = TF_OUT_OF_MEMORY;
    memset(step->changed, 0, (size_t)step->vertices * sizeof *step->changed);
    return status;
}
