//: Include what the new search needs
#include "response/recheck.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

//: See whether candidates are still complete
/// Whether each vertex that has changed still ends within its box.
static bool are_complete(const tf_surface *surface, const tf_step *step)
{
    const tf_box *box = surface->boxes.data;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; step->changed[v] && k < step->axes; k++) {
            double x = step->end[(ptrdiff_t)step->axes * v + k];
            float at = tf_frame_coordinate(&surface->frame, k, x);
            if (!(box[v].low[k] <= at && at <= box[v].high[k]))
                return false;
        }
    return true;
}

//: Keep candidates
static bool keep(tf_buffer *list, size_t count, const tf_candidate pair[])
{
    if (!tf_buffer_reserve(list, count, sizeof *pair))
        return false;
    if (count > 0)
        memcpy(list->data, pair, count * sizeof *pair);
    return true;
}

static tf_status list_candidates(tf_recheck *recheck, tf_surface *surface,
                                 const tf_motion *motion,
                                 const tf_parallel *parallel)
{
    tf_candidates all;
    tf_flaw flaw;
    tf_status status = tf_surface_candidates_within(
        surface, motion, recheck->margin, parallel, &all, &flaw);
    if (status != TF_OK)
        return status;
    recheck->points = all.point_count;
    recheck->edges = all.edge_count;
    return keep(&recheck->point, all.point_count, all.points) &&
                   keep(&recheck->edge, all.edge_count, all.edges)
               ? TF_OK
               : TF_OUT_OF_MEMORY;
}

//: Choose the margin
/// The greatest distance, along any axis, of a changed vertex from its proposed
/// end.
static double farthest_move(const tf_step *step)
{
    double farthest = 0;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; step->changed[v] && k < step->axes; k++) {
            ptrdiff_t place = (ptrdiff_t)step->axes * v + k;
            farthest =
                fmax(farthest, fabs(step->end[place] - step->proposed[place]));
        }
    return farthest;
}

static const double margin_part = 0.2; // of the farthest move

/// Later rounds usually move vertices less than the first one.  If not, the
/// margin doubles.
static void choose_margin(tf_recheck *recheck, const tf_step *step,
                          int *rebuilds)
{
    if (recheck->listed) {
        recheck->margin *= 2;
        ++*rebuilds;
    } else {
        recheck->margin =
            fmin(recheck->margin, margin_part * farthest_move(step));
    }
    recheck->listed = true;
}

//: List candidates where they are not complete
static tf_status complete(tf_recheck *recheck, tf_surface *surface,
                          tf_step *step, const tf_motion *motion,
                          const tf_parallel *parallel, int *rebuilds)
{
    if (recheck->listed && are_complete(surface, step))
        return TF_OK;
    choose_margin(recheck, step, rebuilds);
    return list_candidates(recheck, surface, motion, parallel);
}

//: Mark what may have changed
enum {
    CHANGED = 1,
    MOVING = 2,
    TESTED = CHANGED | MOVING
};

static bool is_moving(const tf_step *step, int vertex)
{
    ptrdiff_t place = (ptrdiff_t)step->axes * vertex;
    for (int k = 0; k < step->axes; k++)
        if (step->start[place + k] != step->end[place + k])
            return true;
    return false;
}

static void mark_vertices(const tf_step *step, unsigned char mark[])
{
    for (int v = 0; v < step->vertices; v++)
        mark[v] = (unsigned char)((step->changed[v] ? CHANGED : 0) |
                                  (is_moving(step, v) ? MOVING : 0));
}

/// An element has the marks of all its vertices.
static void mark_elements(const tf_elements *list, const unsigned char vertex[],
                          unsigned char mark[])
{
    for (int i = 0; i < list->count; i++) {
        mark[i] = 0;
        for (int c = 0; c < list->corners; c++)
            mark[i] |= vertex[list->corner[(ptrdiff_t)list->corners * i + c]];
    }
}

static bool mark(tf_recheck *recheck, const tf_surface *surface,
                 const tf_step *step)
{
    if (!tf_buffer_reserve(&recheck->vertex_marks, (size_t)step->vertices, 1) ||
        !tf_buffer_reserve(&recheck->edge_marks, (size_t)surface->edges.count,
                           1) ||
        !tf_buffer_reserve(&recheck->triangle_marks,
                           (size_t)surface->triangles.count, 1))
        return false;
    mark_vertices(step, recheck->vertex_marks.data);
    mark_elements(&surface->edges, recheck->vertex_marks.data,
                  recheck->edge_marks.data);
    mark_elements(&surface->triangles, recheck->vertex_marks.data,
                  recheck->triangle_marks.data);
    return true;
}

//: Put boxes around what elements sweep now
static void box_elements(const tf_elements *list, const tf_box vertex[],
                         tf_box box[])
{
    for (int i = 0; i < list->count; i++) {
        const int *corner = list->corner + (ptrdiff_t)list->corners * i;
        box[i] = vertex[corner[0]];
        for (int c = 1; c < list->corners; c++)
            box[i] = tf_box_union(box[i], vertex[corner[c]]);
    }
}

static bool box(tf_recheck *recheck, const tf_surface *surface,
                const tf_motion *motion, const tf_parallel *parallel)
{
    if (!tf_buffer_reserve(&recheck->vertex_boxes, (size_t)surface->vertices,
                           sizeof(tf_box)) ||
        !tf_buffer_reserve(&recheck->edge_boxes, (size_t)surface->edges.count,
                           sizeof(tf_box)) ||
        !tf_buffer_reserve(&recheck->triangle_boxes,
                           (size_t)surface->triangles.count, sizeof(tf_box)))
        return false;
    tf_vertex_boxes(&surface->frame, motion, 0, parallel,
                    recheck->vertex_boxes.data);
    box_elements(&surface->edges, recheck->vertex_boxes.data,
                 recheck->edge_boxes.data);
    box_elements(&surface->triangles, recheck->vertex_boxes.data,
                 recheck->triangle_boxes.data);
    return true;
}

//: Choose the pairs that may have changed
/// What is known about the elements of one kind.
typedef struct known {
    const unsigned char *mark;
    const tf_box *box;
} known;

static inline bool overlap(const tf_box *a, const tf_box *b)
{
    return (a->low[0] <= b->high[0]) & (b->low[0] <= a->high[0]) &
           (a->low[1] <= b->high[1]) & (b->low[1] <= a->high[1]) &
           (a->low[2] <= b->high[2]) & (b->low[2] <= a->high[2]);
}

/// Chooses the candidates whose elements together have both marks and whose
/// boxes overlap, and returns how many there are.  Both loops copy each pair and
/// then count it or not, because a branch would be mispredicted too often.
static size_t choose(const tf_buffer *list, size_t count, known first,
                     known second, tf_candidate chosen[])
{
    const tf_candidate *pair = list->data;
    size_t marked = 0, near = 0;
    for (size_t i = 0; i < count; i++) {
        chosen[marked] = pair[i];
        marked +=
            (first.mark[pair[i].first] | second.mark[pair[i].second]) == TESTED;
    }
    for (size_t i = 0; i < marked; i++) {
        tf_candidate own = chosen[i];
        chosen[near] = own;
        near += overlap(&first.box[own.first], &second.box[own.second]);
    }
    return near;
}

//: Decide the pairs that are chosen
typedef struct redeciding {
    tf_workers *workers;
    const tf_candidate *pair;
    size_t count;
} redeciding;

static void decide_part(void *argument, int task, int number)
{
    const redeciding *of = argument;
    tf_worker *worker = of->workers->worker[number];
    size_t begin = (size_t)task * TF_BATCH, rest = of->count - begin;
    if (worker->status == TF_OK)
        tf_pairs_take(&worker->sink, rest < TF_BATCH ? (int)rest : TF_BATCH,
                      of->pair + begin);
}

static void decide(tf_surface *surface, const tf_buffer *chosen, size_t count,
                   const tf_parallel *parallel)
{
    redeciding of = {&surface->workers, chosen->data, count};
    int tasks = (int)(count / TF_BATCH + (count % TF_BATCH != 0));
    tf_parallel_for_each(parallel, tasks, decide_part, &of);
}

//: Choose and decide
static tf_status decide_all(tf_recheck *recheck, tf_surface *surface,
                            tf_deciding *of, const tf_parallel *parallel)
{
    size_t most =
        recheck->points > recheck->edges ? recheck->points : recheck->edges;
    if (!tf_buffer_reserve(&recheck->chosen, most + 1, sizeof(tf_candidate)) ||
        !tf_pairs_begin(surface, parallel, of))
        return TF_OUT_OF_MEMORY;
    known vertex = {recheck->vertex_marks.data, recheck->vertex_boxes.data};
    known edge = {recheck->edge_marks.data, recheck->edge_boxes.data};
    known triangle = {recheck->triangle_marks.data,
                      recheck->triangle_boxes.data};
    bool plane = surface->axes == 2;
    of->kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    size_t chosen = choose(&recheck->point, recheck->points, vertex,
                           plane ? edge : triangle, recheck->chosen.data);
    decide(surface, &recheck->chosen, chosen, parallel);
    if (!plane) {
        of->kind = TF_EDGE_EDGE;
        chosen = choose(&recheck->edge, recheck->edges, edge, edge,
                        recheck->chosen.data);
        decide(surface, &recheck->chosen, chosen, parallel);
    }
    return tf_workers_status(&surface->workers);
}

//: Look for contacts again
void tf_recheck_begin(tf_recheck *recheck, double margin)
{
    recheck->margin = margin;
    recheck->listed = false;
}

tf_status tf_recheck_find(tf_recheck *recheck, tf_surface *surface,
                          tf_step *step, tf_deciding *of,
                          const tf_parallel *parallel, tf_contacts *found,
                          int *rebuilds)
{
    tf_status status =
        complete(recheck, surface, step, of->motion, parallel, rebuilds);
    if (status != TF_OK)
        return status;
    if (!mark(recheck, surface, step) ||
        !box(recheck, surface, of->motion, parallel))
        return TF_OUT_OF_MEMORY;
    status = decide_all(recheck, surface, of, parallel);
    if (status != TF_OK)
        return status;
    *found = (tf_contacts){0};
    if (!tf_pairs_gather(surface, of->extent, found))
        return TF_OUT_OF_MEMORY;
    memset(step->changed, 0, (size_t)step->vertices * sizeof *step->changed);
    return TF_OK;
}

//: Account for the memory of the search
size_t tf_recheck_memory(const tf_recheck *recheck)
{
    return recheck->point.bytes + recheck->edge.bytes + recheck->chosen.bytes +
           recheck->vertex_marks.bytes + recheck->edge_marks.bytes +
           recheck->triangle_marks.bytes + recheck->vertex_boxes.bytes +
           recheck->edge_boxes.bytes + recheck->triangle_boxes.bytes;
}

void tf_recheck_free(tf_recheck *recheck)
{
    tf_buffer_free(&recheck->point);
    tf_buffer_free(&recheck->edge);
    tf_buffer_free(&recheck->chosen);
    tf_buffer_free(&recheck->vertex_marks);
    tf_buffer_free(&recheck->edge_marks);
    tf_buffer_free(&recheck->triangle_marks);
    tf_buffer_free(&recheck->vertex_boxes);
    tf_buffer_free(&recheck->edge_boxes);
    tf_buffer_free(&recheck->triangle_boxes);
}
