//: Include what looking for contacts needs
#include "response/recheck.h"

#include "arithmetic/exact.h"
#include "fast/estimate.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

//: Choose how pairs are decided
static tf_motion motion_of(const tf_step *step)
{
    return (tf_motion){step->vertices, step->start, step->end};
}

static tf_pair_job deciding(const tf_surface *surface, const tf_motion *motion,
                            const tf_narrow_phase *narrow_phase)
{
    return (tf_pair_job){.surface = surface,
                         .motion = motion,
                         .arithmetic = &tf_exact,
                         .narrow_phase = narrow_phase,
                         .estimate = tf_contact_estimate};
}

static void note_ends(tf_step *step)
{
    size_t numbers = (size_t)step->axes * (size_t)step->vertices;
    memcpy(step->looked, step->end, sizeof *step->end * numbers);
}

//: Hold how far everything has moved
/// How far each vertex has moved since the last look, and how far each vertex,
/// edge and triangle has since pairs were kept: the sum, over all looks, of the
/// most that one of its vertices moved, where a movement by (dx, dy, dz) counts
/// as |dx| + |dy| + |dz|.
typedef struct movements {
    double *last, *vertex, *edge, *triangle;
} movements;

static movements movements_of(const tf_surface *surface)
{
    double *last = surface->moved.data, *vertex = last + surface->vertices;
    double *edge = vertex + surface->vertices;
    return (movements){last, vertex, edge, edge + surface->edges.count};
}

/// False if there is no memory.
static bool begin_movements(tf_surface *surface)
{
    size_t count = 2 * (size_t)surface->vertices +
                   (size_t)surface->edges.count +
                   (size_t)surface->triangles.count;
    if (!tf_buffer_reserve(&surface->moved, count, sizeof(double)))
        return false;
    memset(surface->moved.data, 0, sizeof(double) * count);
    return true;
}

//: Look for contacts from the beginning
tf_status tf_check_all(tf_surface *surface, tf_step *step,
                       const tf_narrow_phase *narrow_phase,
                       const tf_parallel *parallel, tf_contacts *found,
                       tf_flaw *flaw)
{
    tf_motion motion = motion_of(step);
    tf_status status = tf_surface_move(surface, &motion, parallel, flaw);
    if (status != TF_OK)
        return status;
    tf_pair_job how = deciding(surface, &motion, narrow_phase);
    how.keeps = true;
    if (!begin_movements(surface))
        return TF_OUT_OF_MEMORY;
    note_ends(step);
    return tf_pairs_find(surface, &how, parallel, found);
}

//: Add up movements
static void move_vertices(const tf_step *step, const movements *moved)
{
    const double *from = step->looked, *to = step->end;
    for (int v = 0; v < step->vertices; v++) {
        double sum = 0;
        for (int k = 0; k < step->axes; k++)
            sum += fabs(*to++ - *from++);
        moved->last[v] = sum;
        moved->vertex[v] += sum;
    }
}

static void move_elements(const tf_elements *elements, int corners,
                          const double last[], double moved[])
{
    const int *corner = elements->corner;
    for (int i = 0; i < elements->count; i++, corner += corners) {
        double most = last[corner[0]];
        for (int c = 1; c < corners; c++)
            most = last[corner[c]] > most ? last[corner[c]] : most;
        moved[i] += most;
    }
}

/// Adds the movements since the last look.
static movements add_movements(const tf_surface *surface, tf_step *step)
{
    movements moved = movements_of(surface);
    move_vertices(step, &moved);
    move_elements(&surface->edges, 2, moved.last, moved.edge);
    move_elements(&surface->triangles, 3, moved.last, moved.triangle);
    note_ends(step);
    return moved;
}

//: Hold what is looked at again
typedef struct rechecking {
    tf_workers *workers;
    bool of_edges; ///< the pairs of two edges, not those with a vertex
    const double *first, *second; ///< how far elements have moved
} rechecking;

static tf_pair_list *list_of(const rechecking *of, int worker)
{
    tf_worker *keeper = of->workers->worker[worker];
    return of->of_edges ? &keeper->edges : &keeper->points;
}

/// Each batch of a list is a task.
static int tasks_of(const tf_pair_list *list)
{
    return (int)((list->count + TF_BATCH - 1) / TF_BATCH);
}

//: Select the pairs that have moved too far
/// How far the elements of a pair have moved, in all.
static double movement_of(const rechecking *of, tf_candidate pair)
{
    return of->first[pair.first] + of->second[pair.second];
}

/// Some pairs of a list.
typedef struct selection {
    int count;
    const tf_candidate *pair;
    double *limit;       ///< how far each may move
    int place[TF_BATCH]; ///< of those that have moved farther
} selection;

/// Writes the pairs that have moved too far to `to`; returns how many.
static int select_moved(const rechecking *of, selection *some,
                        tf_candidate to[])
{
    int moved = 0;
    for (int i = 0; i < some->count; i++) {
        to[moved] = some->pair[i];
        some->place[moved] = i;
        moved += movement_of(of, some->pair[i]) > some->limit[i];
    }
    return moved;
}

//: Limit how far a pair may move
/// How far a pair that has moved so far may move until it must be looked at
/// again; less than 0: it must be, moved or not.  What is taken off is more
/// than the roundings of all sums, for thousands of looks.  Where that is more
/// than the clearance, the limit is what it has moved by now.
static double limit_of(double moved, double clearance)
{
    double limit = (moved + clearance) * (1 - 0x1p-40);
    if (clearance < 0 || !isfinite(limit))
        return -1;
    return limit > moved ? limit : moved;
}

static void set_limits(const rechecking *of, const selection *some, int count,
                       const tf_candidate pair[], const double clearance[])
{
    for (int i = 0; i < count; i++)
        some->limit[some->place[i]] =
            limit_of(movement_of(of, pair[i]), clearance[i]);
}

//: Look at a batch of pairs again
static void recheck_batch(void *argument, int task, int number)
{
    const rechecking *of = argument;
    int keeper = 0;
    for (; task >= tasks_of(list_of(of, keeper)); keeper++)
        task -= tasks_of(list_of(of, keeper));
    const tf_pair_list *list = list_of(of, keeper);
    size_t begin = (size_t)task * TF_BATCH, rest = list->count - begin;
    selection some = {.count = rest < TF_BATCH ? (int)rest : TF_BATCH,
                      .pair = (const tf_candidate *)list->pair.data + begin,
                      .limit = (double *)list->limit.data + begin};
    tf_worker *worker = of->workers->worker[number];
    tf_pair_sink *sink = &worker->sink;
    sink->take = tf_pairs_take;
    int count = select_moved(of, &some, sink->pair);
    sink->count = count;
    tf_pair_sink_hand_on(sink);
    set_limits(of, &some, count, sink->pair, worker->clearance);
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

static tf_status recheck_kinds(tf_surface *surface, const movements *moved,
                               tf_pair_job *how, const tf_parallel *parallel)
{
    bool plane = surface->axes == 2;
    rechecking of = {.workers = &surface->workers,
                     .first = moved->vertex,
                     .second = plane ? moved->edge : moved->triangle};
    how->kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    tf_status status = recheck_kind(parallel, &of);
    if (status != TF_OK)
        return status;
    of.of_edges = true;
    of.first = of.second = moved->edge;
    how->kind = TF_EDGE_EDGE;
    return recheck_kind(parallel, &of);
}

//: Look again
tf_status tf_recheck(tf_surface *surface, tf_step *step,
                     const tf_narrow_phase *narrow_phase,
                     const tf_parallel *parallel, tf_contacts *found)
{
    tf_motion motion = motion_of(step);
    tf_pair_job how = deciding(surface, &motion, narrow_phase);
    how.measures = true;
    if (!tf_pairs_begin(surface, parallel, &how))
        return TF_OUT_OF_MEMORY;
    movements moved = add_movements(surface, step);
    tf_status status = recheck_kinds(surface, &moved, &how, parallel);
    *found = (tf_contacts){0};
    if (status == TF_OK && !tf_pairs_gather(surface, how.selection, found))
        status = TF_OUT_OF_MEMORY;
    return status;
}
