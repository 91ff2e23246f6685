//: Include what moving parts apart needs
#include "untangle/apart.h"

#include "base/memory.h"
#include "distance/tree_nearest.h"
#include "surface/crossing.h"
#include "surface/sort.h"

#include <string.h>

enum {
    MOST_TRIALS = 4000, ///< lengths of translations: up to 160000 mean edges
    HALVINGS = 3,       ///< of the last length
    STACK = 128         ///< each level of two trees adds one pair to a stack
};

//: Hold the parts of a surface
/// A part, with a tree of its elements: its facets, and edges of no facet as
/// triangles without an area.
typedef struct part {
    int number, vertices;
    bool stays;       ///< has fixed vertices
    bool meets;       ///< intersects, or touches, one of those before it
    int turn;         ///< when it finds its place
    tf_vector offset; ///< by which it moves
    int begin, count; ///< of its elements
    tf_nearest_tree tree;
} part;

typedef struct part_list {
    const tf_tangle *tangle;
    const double *x;
    int count;
    part *part;   ///< by their numbers
    part **order; ///< in which they find their places
    int *corner;  ///< of the elements, part by part, `axes` each
    tf_buffer corners, own;
} part_list;

//: List the elements of parts
static bool is_loose(const tf_neighbors *near, int edge)
{
    return near->axes == 3 && tf_list_length(&near->sides, edge) == 0;
}

static void add_element(part_list *all, int count, const int corner[])
{
    int axes = all->tangle->near.axes;
    part *own = &all->part[all->tangle->near.part[corner[0]]];
    int *to = all->corner + (ptrdiff_t)axes * (own->begin + own->count++);
    for (int c = 0; c < axes; c++)
        to[c] = corner[c < count ? c : count - 1];
}

static void list_elements(part_list *all)
{
    const tf_neighbors *near = &all->tangle->near;
    for (int f = 0; f < near->facets; f++)
        all->part[near->part[near->facet[(ptrdiff_t)near->axes * f]]].count++;
    for (int e = 0; e < near->edges; e++)
        if (is_loose(near, e))
            all->part[near->part[near->edge[2 * (ptrdiff_t)e]]].count++;
    for (int p = 0, begin = 0; p < all->count; p++) {
        all->part[p].begin = begin;
        begin += all->part[p].count;
        all->part[p].count = 0;
    }
    for (int f = 0; f < near->facets; f++)
        add_element(all, near->axes, near->facet + (ptrdiff_t)near->axes * f);
    for (int e = 0; e < near->edges; e++)
        if (is_loose(near, e))
            add_element(all, 2, near->edge + 2 * (ptrdiff_t)e);
}

//: Sort parts
/// Those with fixed vertices before the others, then the larger ones, then
/// those with lower numbers.
static bool precedes(const void *a, const void *b)
{
    const part *first = *(part *const *)a, *second = *(part *const *)b;
    if (first->stays != second->stays)
        return first->stays;
    if (first->vertices != second->vertices)
        return first->vertices > second->vertices;
    return first->number < second->number;
}

static bool sort_parts(part_list *all)
{
    const tf_neighbors *near = &all->tangle->near;
    for (int v = 0; v < near->vertices; v++) {
        if (near->part[v] < 0)
            continue;
        part *own = &all->part[near->part[v]];
        own->vertices++;
        own->stays = own->stays || all->tangle->fixed[v];
    }
    size_t count = (size_t)all->count;
    if (!tf_buffer_extend(&all->own, count, sizeof *all->order))
        return false;
    all->order = all->own.data;
    for (int p = 0; p < all->count; p++) {
        all->part[p].number = p;
        all->order[p] = &all->part[p];
    }
    tf_sort_memory memory = {.pointers = {0}};
    bool sorted = tf_list_sort(&all->own, count, sizeof *all->order, precedes,
                               &memory, all->tangle->watch);
    tf_sort_memory_free(&memory);
    all->order = all->own.data;
    return sorted;
}

//: Note which parts meet
/// Those that only touch have to move, too: they may lie upon each other.
static void note_meetings(part_list *all)
{
    const tf_crossings *crossings = &all->tangle->crossings;
    const int *part_of = all->tangle->near.part;
    for (int i = 0; i < all->count; i++)
        all->order[i]->turn = i;
    for (size_t i = 0; i < crossings->count; i++) {
        const tf_crossing *own = &crossings->crossing[i];
        int a = part_of[own->vertex[0]];
        int b = part_of[own->vertex[tf_crossing_corners(own) - 1]];
        if (a < 0 || b < 0 || a == b)
            continue;
        part *one = &all->part[a], *other = &all->part[b];
        (one->turn > other->turn ? one : other)->meets = true;
    }
}

//: Begin to move parts apart
static bool begin(part_list *all)
{
    const tf_neighbors *near = &all->tangle->near;
    size_t elements = (size_t)near->facets + (size_t)near->edges;
    all->part = tf_allocate_zeroed((size_t)all->count * sizeof *all->part);
    if (!all->part ||
        !tf_buffer_reserve(&all->corners, (size_t)near->axes * elements,
                           sizeof(int)))
        return false;
    all->corner = all->corners.data;
    list_elements(all);
    for (int p = 0; p < all->count; p++) {
        part *own = &all->part[p];
        tf_chosen_facets facets = {
            .axes = near->axes,
            .count = own->count,
            .corner = all->corner + (ptrdiff_t)near->axes * own->begin,
            .x = all->x,
        };
        if (!tf_nearest_tree_build(&own->tree, &facets) ||
            !tf_watch_work(all->tangle->watch, (size_t)own->count))
            return false;
        tf_nearest_tree_trim(&own->tree);
    }
    if (!sort_parts(all))
        return false;
    note_meetings(all);
    return true;
}

static void end(part_list *all)
{
    for (int p = 0; all->part && p < all->count; p++)
        tf_nearest_tree_free(&all->part[p].tree);
    tf_release(all->part, (size_t)all->count * sizeof *all->part);
    tf_buffer_free(&all->corners);
    tf_buffer_free(&all->own);
}

//: Compare boxes of two parts
/// Whether boxes overlap after the parts' translations.  Sums round the same
/// way for vertices and for boxes, so no overlap is missed.
static bool overlap(const part *a, int node, const part *b, int other)
{
    const tf_tree_box *first = &a->tree.box[node];
    const tf_tree_box *second = &b->tree.box[other];
    for (int k = 0; k < TF_AXES; k++)
        if (first->low[k] + a->offset.x[k] > second->high[k] + b->offset.x[k] ||
            second->low[k] + b->offset.x[k] > first->high[k] + a->offset.x[k])
            return false;
    return true;
}

//: Decide whether two elements cross
static bool triangles_cross(double a[3][3], double b[3][3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        if (tf_edge_crosses_triangle(a[i], a[j], b[0], b[1], b[2]) ||
            tf_edge_crosses_triangle(b[i], b[j], a[0], a[1], a[2]))
            return true;
    }
    return false;
}

static void place_corners(const part *own, int place, double corner[3][3])
{
    const tf_chosen_facets *facets = &own->tree.facets;
    const int *index = facets->corner + (ptrdiff_t)facets->axes * place;
    for (int c = 0; c < facets->axes; c++)
        for (int k = 0; k < facets->axes; k++)
            corner[c][k] = facets->x[(ptrdiff_t)facets->axes * index[c] + k] +
                           own->offset.x[k];
}

static bool elements_cross(const part *a, int place, const part *b, int other)
{
    double first[3][3], second[3][3];
    place_corners(a, place, first);
    place_corners(b, other, second);
    if (a->tree.facets.axes == 2)
        return tf_edges_cross(first[0], first[1], second[0], second[1]);
    return triangles_cross(first, second);
}

//: Compare two leaves
static bool leaves_cross(const part *a, int leaf, const part *b, int other)
{
    int first, first_end, second, second_end;
    tf_nearest_tree_leaf(&a->tree, leaf, &first, &first_end);
    tf_nearest_tree_leaf(&b->tree, other, &second, &second_end);
    for (int i = first; i < first_end; i++)
        for (int j = second; j < second_end; j++)
            if (elements_cross(a, a->tree.place[i], b, b->tree.place[j]))
                return true;
    return false;
}

//: Decide whether two parts cross
/// Goes down two trees at once, in the one that has the larger part left.
static bool parts_cross(const part *a, const part *b)
{
    int stack[STACK][2] = {{1, 1}}, height = 1;
    while (height > 0) {
        int node = stack[--height][0], other = stack[height][1];
        bool is_leaf = node >= a->tree.leaves;
        bool is_other_leaf = other >= b->tree.leaves;
        if (!overlap(a, node, b, other))
            continue;
        if (is_leaf && is_other_leaf) {
            if (leaves_cross(a, node, b, other))
                return true;
            continue;
        }
        bool first = is_other_leaf || (!is_leaf && node <= other);
        for (int i = 0; i < 2; i++, height++) {
            stack[height][0] = first ? 2 * node + i : node;
            stack[height][1] = first ? other : 2 * other + i;
        }
    }
    return false;
}

//: Try a translation
/// Whether a part, the one at `turn` in the order, is free of those before it.
/// The one that was in the way last is tried first.
static bool is_free(const part_list *all, int turn, tf_vector offset, int *last)
{
    part *own = all->order[turn];
    own->offset = offset;
    if (*last < turn && parts_cross(own, all->order[*last]))
        return false;
    for (int i = 0; i < turn; i++)
        if (i != *last && parts_cross(own, all->order[i])) {
            *last = i;
            return false;
        }
    return true;
}

//: List the directions
/// To the neighbors of a cell of a grid, a little off the axes, so that what is
/// flat does not slide along itself.
static int list_directions(int axes, tf_vector direction[])
{
    int count = 0, deep = axes == 3;
    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++)
            for (int k = -deep; k <= deep; k++)
                if (i != 0 || j != 0 || k != 0) {
                    tf_vector way = {
                        {i + 0x1p-6, j - 0x1p-7, deep ? k + 0x1p-8 : 0}};
                    direction[count++] = tf_vector_unit(way);
                }
    return count;
}

/// How long the translations of a trial are, half a mean edge more from one to
/// the next at first, and then more and more.
static double trial_length(const part_list *all, double trial)
{
    return trial * (1 + trial / 50) * all->tangle->edge / 2;
}

//: Shorten a translation
/// Halves the step from the last trial, in which the part was not free, to this
/// one; returns how long the translation then is.
static double shorten(const part_list *all, int turn, tf_vector direction,
                      int trial, int *last)
{
    double low = trial_length(all, trial - 1), high = trial_length(all, trial);
    for (int i = 0; i < HALVINGS; i++) {
        double middle = low + (high - low) / 2;
        if (is_free(all, turn, tf_vector_scaled(middle, direction), last))
            high = middle;
        else
            low = middle;
    }
    return high;
}

//: Try all directions
/// Finds the least translation of a trial that frees a part, in `offset`; its
/// length, 0 if there is none, or -1 if the caller cancels.
static double try_directions(const part_list *all, int turn, int trial,
                             tf_vector *offset, int *last)
{
    tf_vector direction[26];
    int count = list_directions(all->tangle->near.axes, direction);
    double least = 0, most = trial_length(all, trial);
    for (int i = 0; i < count; i++) {
        if (!tf_watch_work(all->tangle->watch, 64 + (size_t)turn))
            return -1;
        if (!is_free(all, turn, tf_vector_scaled(most, direction[i]), last))
            continue;
        double length = shorten(all, turn, direction[i], trial, last);
        if (least > 0 && least <= length)
            continue;
        least = length;
        *offset = tf_vector_scaled(length, direction[i]);
    }
    return least;
}

//: Find the place of a part
static bool find_place(part_list *all, int turn)
{
    tf_vector none = {{0, 0, 0}}, offset = none;
    int last = turn;
    double length = 0;
    part *own = all->order[turn];
    if (own->stays || (!own->meets && is_free(all, turn, none, &last)))
        return true;
    for (int trial = 1; trial < MOST_TRIALS && length == 0; trial++)
        length = try_directions(all, turn, trial, &offset, &last);
    own->offset = offset;
    return length >= 0;
}

//: Move parts apart
static bool move(part_list *all, double x[], bool *moved)
{
    const tf_neighbors *near = &all->tangle->near;
    for (int i = 0; i < all->count; i++)
        if (!find_place(all, i))
            return false;
    for (int v = 0; v < near->vertices; v++) {
        if (near->part[v] < 0 || all->part[near->part[v]].stays)
            continue;
        tf_vector offset = all->part[near->part[v]].offset;
        tf_vector place = tf_place(near, x, v);
        tf_vector next = tf_vector_sum(place, 1, offset);
        *moved = *moved || !tf_vector_equals(place, next);
        tf_put(near, x, v, next);
    }
    return true;
}

bool tf_move_apart(const tf_tangle *tangle, double x[], bool *moved)
{
    part_list all = {.tangle = tangle, .x = x, .count = tangle->near.parts};
    *moved = false;
    if (all.count < 2)
        return true;
    bool done = begin(&all) && move(&all, x, moved);
    end(&all);
    return done;
}
