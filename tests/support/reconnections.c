#include "support/reconnections.h"

#include "experiments/leave_out.h"
#include "surgery/adaptive_surface.h"
#include "surgery/star.h"
#include "topology/drop.h"
#include "topology/merge.h"
#include "topology/pinch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Judging ---------------------------------------------------------------------

/// The parts before and after an operation.
typedef struct comparison {
    int parts;
    int nesting[SCENE_PARTS][SCENE_PARTS], sign[SCENE_PARTS];
    int was[SCENE_PARTS]; ///< of each part now: a part before
    bool done;            ///< whether there was one
} comparison;

static void remember(const surgery_run *run, comparison *before)
{
    before->parts = run->scene.parts;
    memcpy(before->nesting, run->nesting, sizeof run->nesting);
    memcpy(before->sign, run->sign, sizeof run->sign);
}

/// Labels the parts anew; `was` becomes the part that each comes from.
static void relabel(surgery_run *run, comparison *before)
{
    static int now[LABELLED];
    int vertices = tf_adaptive_mesh(run->surface)->vertices;
    run->scene.parts = label_parts(run->surface, now);
    if (run->scene.parts > SCENE_PARTS)
        abort();
    for (int v = 0; v < vertices; v++)
        if (now[v] >= 0) {
            before->was[now[v]] = run->part[v];
            run->part[v] = now[v];
        }
    if (run->scene.kind != SHEETS)
        surgery_run_note(run);
}

/// The surface itself, at all parts.
static const char *surface_fault(surgery_run *run)
{
    const char *found = NULL;
    for (int part = 0; part < run->scene.parts && !found; part++) {
        run->changed = part;
        found = surgery_run_fault(run);
    }
    return found;
}

/// What concerns parts now, other than `a` and `b`, each of which was one part.
static const char *others_fault(const surgery_run *run,
                                const comparison *before, int a, int b)
{
    for (int i = 0; i < run->scene.parts; i++) {
        if (i == a || i == b)
            continue;
        if (run->sign[i] != before->sign[before->was[i]])
            return "another part is inside out";
        for (int j = 0; j < run->scene.parts; j++)
            if (j != i && j != a && j != b &&
                run->nesting[i][j] !=
                    before->nesting[before->was[i]][before->was[j]])
                return "other parts have changed sides";
    }
    return NULL;
}

// Merging ---------------------------------------------------------------------

/// The sign of two parts in one: that of the outer one.
static int joined_sign(const comparison *before, int a, int b)
{
    if (before->nesting[a][b] == 0 && before->nesting[b][a] == 0 &&
        before->sign[a] != before->sign[b])
        return 2;
    return before->sign[before->nesting[b][a] ? b : a];
}

/// After a merge of the parts a and b, which are now one.
static const char *merge_fault(const surgery_run *run, const comparison *before,
                               int a, int b)
{
    int both = 0;
    while (before->was[both] != a && before->was[both] != b)
        both++;
    const char *found = others_fault(run, before, both, both);
    if (found)
        return found;
    if (run->sign[both] != joined_sign(before, a, b))
        return "the parts together are inside out";
    for (int i = 0; i < run->scene.parts; i++) {
        int other = before->was[i];
        if (i == both)
            continue;
        if (run->nesting[both][i] !=
            before->nesting[a][other] +
                (a == b ? 0 : before->nesting[b][other]))
            return "a part has changed sides of those that merged";
        if (run->nesting[i][both] != before->nesting[other][a] ||
            run->nesting[i][both] != before->nesting[other][b])
            return "parts merged that another one separates";
    }
    return NULL;
}

static bool is_neighbor(const tf_adaptive_surface *surface, int a, int b)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    for (int c = tf_first_corner(surface, a); c >= 0;
         c = tf_next_corner(surface, c))
        for (int i = 0; i < 3; i++)
            if (mesh.triangle[c / 3 * 3 + i] == b)
                return true;
    return false;
}

static double distance_of_edges(const surgery_run *run, const int a[2],
                                const int b[2])
{
    const double *x = tf_adaptive_positions(run->surface);
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double way = x[3 * a[0] + k] + x[3 * a[1] + k] - x[3 * b[0] + k] -
                     x[3 * b[1] + k];
        sum += way * way;
    }
    return sum;
}

static void edge_at(const surgery_run *run, int corner, int edge[2])
{
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    edge[0] = mesh.triangle[corner];
    edge[1] = mesh.triangle[corner % 3 == 2 ? corner - 2 : corner + 1];
}

/// Whether an edge has two triangles, without a second edge between these.
static bool is_good_edge(const tf_adaptive_surface *surface, const int edge[2])
{
    int forth = tf_find_edge(surface, edge[0], edge[1]);
    int back = tf_find_edge(surface, edge[1], edge[0]);
    return forth >= 0 && back >= 0 &&
           !is_neighbor(surface, tf_vertex_at(surface, tf_corner_before(forth)),
                        tf_vertex_at(surface, tf_corner_before(back)));
}

static void choose_edge(surgery_run *run, int edge[2])
{
    edge_at(run, surgery_run_corner(run), edge);
    for (int i = 0; i < 20 && !is_good_edge(run->surface, edge); i++)
        edge_at(run, surgery_run_corner(run), edge);
}

/// An edge that is near another one, of another part if possible.
static void choose_near(surgery_run *run, const int first[2], int second[2])
{
    double least = INFINITY;
    int edge[2], tries = 1 + below(&run->random, 200);
    for (int i = 0; i < tries; i++) {
        edge_at(run, surgery_run_corner(run), edge);
        double far = distance_of_edges(run, first, edge);
        if (edge[0] == first[0] || edge[0] == first[1] || edge[1] == first[0] ||
            edge[1] == first[1] || !is_good_edge(run->surface, edge))
            continue;
        if (run->part[edge[0]] == run->part[first[0]])
            far = 4 * far + run->scene.unit * run->scene.unit;
        if (far < least) {
            least = far;
            memcpy(second, edge, sizeof edge);
        }
    }
}

static const char *try_merging(surgery_run *run, comparison *before,
                               reconnection_counts *counts)
{
    int first[2], second[2];
    choose_edge(run, first);
    memcpy(second, first, sizeof first);
    choose_near(run, first, second);
    int a = run->part[first[0]], b = run->part[second[0]];
    tf_outcome outcome;
    if (tf_adaptive_merge(run->surface, first, second, &outcome) != TF_OK)
        abort();
    counts->count[TF_MERGE][outcome]++;
    before->done = outcome == TF_COMMITTED;
    if (!before->done)
        return NULL;
    relabel(run, before);
    counts->joined += a != b;
    if (run->scene.parts != before->parts - (a != b))
        return "a merge has changed the number of parts";
    return run->scene.kind == SHEETS ? NULL : merge_fault(run, before, a, b);
}

// Pinching --------------------------------------------------------------------

/// After a pinch of a part into the parts a and b, or a == b.
static const char *pinch_fault(const surgery_run *run, const comparison *before,
                               int a, int b)
{
    int whole = before->was[a];
    bool within = a != b && (run->nesting[a][b] || run->nesting[b][a]);
    const char *found = others_fault(run, before, a, b);
    if (found)
        return found;
    int inner = within && run->nesting[b][a] ? a : b;
    int outer = inner == a ? b : a;
    if (run->sign[outer] != before->sign[whole] ||
        run->sign[inner] != (within ? -1 : 1) * before->sign[whole])
        return "what was pinched is inside out";
    for (int i = 0; i < run->scene.parts; i++) {
        int other = before->was[i];
        if (i == a || i == b)
            continue;
        if (run->nesting[a][i] + (a == b ? 0 : run->nesting[b][i]) !=
            before->nesting[whole][other])
            return "a part has changed sides of those that were pinched";
        if (run->nesting[i][a] != before->nesting[other][whole] ||
            run->nesting[i][b] != before->nesting[other][whole])
            return "a part was pinched that another one went through";
    }
    return NULL;
}

static bool is_face(const tf_adaptive_surface *surface, const int v[3])
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    for (int c = tf_first_corner(surface, v[0]); c >= 0;
         c = tf_next_corner(surface, c)) {
        const int *t = mesh.triangle + c / 3 * 3;
        int common = 0;
        for (int i = 0; i < 9; i++)
            common += t[i / 3] == v[i % 3];
        if (common == 3)
            return true;
    }
    return false;
}

/// Three vertices with edges between them, mostly not those of a triangle.
static void choose_loop(surgery_run *run, int loop[3])
{
    for (int i = 0; i < 50; i++) {
        edge_at(run, surgery_run_corner(run), loop);
        int c = tf_first_corner(run->surface, loop[0]);
        for (; c >= 0; c = tf_next_corner(run->surface, c)) {
            loop[2] = tf_vertex_at(run->surface, tf_corner_after(c));
            if (loop[2] != loop[1] &&
                is_neighbor(run->surface, loop[1], loop[2]) &&
                !is_face(run->surface, loop))
                return;
        }
    }
}

/// The middle of the neighbors of a vertex that are to the left of the loop.
static void left_middle(const tf_adaptive_surface *surface, const int loop[3],
                        int i, double middle[3])
{
    const double *x = tf_adaptive_positions(surface);
    int count = 0, end = loop[(i + 1) % 3];
    for (int k = 0; k < 3; k++)
        middle[k] = 0;
    for (;;) {
        int c = tf_find_edge(surface, loop[i], end);
        end = c < 0 ? -1 : tf_vertex_at(surface, tf_corner_before(c));
        if (end < 0 || end == loop[(i + 2) % 3] || end == loop[(i + 1) % 3])
            break;
        count++;
        for (int k = 0; k < 3; k++)
            middle[k] += x[3 * end + k];
    }
    for (int k = 0; k < 3; k++)
        middle[k] = count ? middle[k] / count : x[3 * loop[i] + k];
}

/// Near the vertices of the loop, towards neighbors, or anywhere.
static void choose_positions(surgery_run *run, const int loop[3],
                             double position[9])
{
    const double *x = tf_adaptive_positions(run->surface);
    double part = pow(10, uniform(&run->random, -3, 0.2)), to[3];
    int way = below(&run->random, 4);
    for (int i = 0; i < 3; i++) {
        left_middle(run->surface, loop, i, to);
        if (way == 0)
            memcpy(to,
                   x + 3 * tf_adaptive_mesh(run->surface)
                               ->triangle[surgery_run_corner(run)],
                   sizeof to);
        for (int k = 0; k < 3; k++) {
            double from = x[3 * loop[i] + k];
            if (way == 1)
                to[k] = from + run->scene.unit * uniform(&run->random, -1, 1);
            position[3 * i + k] = from + part * (to[k] - from);
        }
    }
}

static const char *try_pinching(surgery_run *run, comparison *before,
                                reconnection_counts *counts)
{
    int loop[3], vertex[3];
    double position[9];
    choose_loop(run, loop);
    choose_positions(run, loop, position);
    int was = run->part[loop[0]];
    tf_outcome outcome;
    if (tf_adaptive_pinch(run->surface, loop, position, vertex, &outcome) !=
        TF_OK)
        abort();
    counts->count[TF_PINCH][outcome]++;
    before->done = outcome == TF_COMMITTED;
    if (!before->done)
        return NULL;
    for (int i = 0; i < 3; i++)
        run->part[vertex[i]] = was;
    relabel(run, before);
    int a = run->part[loop[0]], b = run->part[vertex[0]];
    counts->split += a != b;
    if (run->scene.parts != before->parts + (a != b))
        return "a pinch has changed the number of parts";
    return run->scene.kind == SHEETS ? NULL : pinch_fault(run, before, a, b);
}

// Dropping --------------------------------------------------------------------

/// The outcome that a drop must have.
static tf_outcome expected_drop(const surgery_run *run, int part)
{
    for (int i = 0; i < run->scene.parts; i++)
        if (i != part && run->nesting[part][i] != 0)
            return TF_PASSED_VERTEX;
    return TF_COMMITTED;
}

static const char *try_dropping(surgery_run *run, comparison *before,
                                reconnection_counts *counts)
{
    int edge[2];
    edge_at(run, surgery_run_corner(run), edge);
    int part = run->part[edge[0]];
    tf_outcome outcome, expected = expected_drop(run, part);
    if (tf_adaptive_drop(run->surface, edge[0], &outcome) != TF_OK)
        abort();
    counts->count[TF_DROP][outcome]++;
    if (run->scene.kind != SHEETS && outcome != expected)
        return "a drop does not end as it should";
    before->done = outcome == TF_COMMITTED;
    if (!before->done)
        return NULL;
    relabel(run, before);
    if (run->scene.parts != before->parts - 1)
        return "a drop has changed the number of parts";
    return run->scene.kind == SHEETS ? NULL : others_fault(run, before, -1, -1);
}

// Running ---------------------------------------------------------------------

/// Merges and pinches leave out tests.
static const char *reconnect(surgery_run *run, unsigned left_out,
                             comparison *before, reconnection_counts *counts)
{
    int way = below(&run->random, 20);
    remember(run, before);
    before->done = false;
    if (way == 0 && run->scene.parts > 1)
        return try_dropping(run, before, counts);
    leave_out(left_out);
    const char *found = way < 6 && run->scene.parts < SCENE_PARTS
                            ? try_pinching(run, before, counts)
                            : try_merging(run, before, counts);
    leave_out(0);
    return found;
}

static const char *step(surgery_run *run, unsigned left_out,
                        reconnection_counts *counts)
{
    static comparison before;
    uint64_t hash = surgery_run_hash(run);
    const char *found = NULL;
    if (below(&run->random, 2)) {
        surgery_choice request = surgery_run_choose(run);
        before.done = operate(run, &request) == TF_COMMITTED;
        if (before.done)
            found = surgery_run_fault(run);
    } else {
        found = reconnect(run, left_out, &before, counts);
        if (!found && before.done)
            found = surface_fault(run);
    }
    counts->others.judged += before.done;
    if (!found && !before.done && surgery_run_hash(run) != hash)
        found = "a refusal has changed the surface";
    return found;
}

const char *run_reconnections(generator random, adaptive_scene_kind kind,
                              int operations, unsigned left_out,
                              reconnection_counts *counts)
{
    static surgery_run run;
    const char *found = NULL;
    surgery_run_begin(&run, random, kind, &counts->others);
    for (int i = 0; i < operations && !found; i++) {
        found = step(&run, left_out, counts);
        if (i % 128 == 127)
            surgery_run_compact(&run);
    }
    surgery_run_end(&run);
    return found;
}

void reconnection_counts_print(const reconnection_counts *counts)
{
    static const char *const names[] = {"merge", "pinch", "drop"};
    printf("%-12s %8s %10s %9s %10s %9s\n", "", "done", "impossible",
           "flattened", "overlapped", "passed");
    for (int i = 0; i < 3; i++) {
        const long *c = counts->count[i];
        printf("%-12s %8ld %10ld %9ld %10ld %9ld V %9ld E\n", names[i],
               c[TF_COMMITTED], c[TF_IMPOSSIBLE], c[TF_FLATTENED],
               c[TF_OVERLAPPED], c[TF_PASSED_VERTEX], c[TF_PASSED_EDGE]);
    }
    printf("%ld merges joined two parts, %ld pinches made two\n",
           counts->joined, counts->split);
    surgery_counts_print(&counts->others);
}
