//: Include what the dynamic tree needs
#include "surgery/dynamic_tree.h"

#include <stddef.h>
#include <string.h>

//: Hold a branch
enum {
    NOTHING = -1, ///< a child below it is the element -2 - child
    ABOVE_ROOT = 0
};

typedef struct branch {
    tf_aabb box[2]; ///< of the children
    int child[2];
    int parent; ///< or the next free branch
} branch;

static branch *branches_of(const tf_dynamic_tree *tree)
{
    return tree->branch.data;
}

static bool is_element(int child)
{
    return child < NOTHING;
}

static int child_of_element(int element)
{
    return -2 - element;
}

//: Make room in the dynamic tree
bool tf_dynamic_tree_reserve(tf_dynamic_tree *tree, int elements)
{
    size_t count = (size_t)elements + 1;
    bool first = tree->branches == 0;
    if (!tf_buffer_extend(&tree->branch, count, sizeof(branch)) ||
        !tf_buffer_extend(&tree->parent, count, sizeof(int)) ||
        !tf_buffer_extend(&tree->stack, count, sizeof(int)))
        return false;
    if (first)
        tf_dynamic_tree_build(tree, NULL, NULL, 0, NULL);
    return true;
}

void tf_dynamic_tree_free(tf_dynamic_tree *tree)
{
    tf_buffer_free(&tree->branch);
    tf_buffer_free(&tree->parent);
    tf_buffer_free(&tree->stack);
}

//: Copy a dynamic tree
void tf_dynamic_tree_copy(tf_dynamic_tree *to, const tf_dynamic_tree *from,
                          int elements)
{
    to->branches = from->branches;
    to->free_branch = from->free_branch;
    memcpy(to->branch.data, from->branch.data,
           sizeof(branch) * (size_t)from->branches);
    if (elements > 0)
        memcpy(to->parent.data, from->parent.data,
               sizeof(int) * (size_t)elements);
}

//: Link a child to its branch
static void set_parent(tf_dynamic_tree *tree, int child, int parent)
{
    if (is_element(child))
        ((int *)tree->parent.data)[-2 - child] = parent;
    else if (child != NOTHING)
        branches_of(tree)[child].parent = parent;
}

static void set_child(tf_dynamic_tree *tree, int at, int lane, int child,
                      tf_aabb box)
{
    branch *b = &branches_of(tree)[at];
    b->child[lane] = child;
    b->box[lane] = box;
    set_parent(tree, child, at);
}

static int lane_of_child(const tf_dynamic_tree *tree, int at, int child)
{
    return branches_of(tree)[at].child[1] == child;
}

//: Take and free a branch
static int take_branch(tf_dynamic_tree *tree)
{
    int taken = tree->free_branch;
    if (taken < 0)
        return tree->branches++;
    tree->free_branch = branches_of(tree)[taken].parent;
    return taken;
}

static void free_branch(tf_dynamic_tree *tree, int at)
{
    branches_of(tree)[at].parent = tree->free_branch;
    tree->free_branch = at;
}

//: Choose where a box goes
/// In the unit that a scale makes, where products neither over- nor underflow.
static double half_area(const tf_aabb *box, double scale)
{
    double side[3];
    for (int k = 0; k < 3; k++)
        side[k] = scale * (box->high[k] - box->low[k]);
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
}

/// The child whose area grows least.
static int lane_for(const branch *b, const tf_aabb *box, double scale)
{
    double growth[2];
    for (int i = 0; i < 2; i++) {
        tf_aabb both = tf_aabb_union(b->box[i], box);
        growth[i] = half_area(&both, scale) - half_area(&b->box[i], scale);
    }
    return growth[1] < growth[0];
}

//: Insert an element
void tf_dynamic_tree_insert(tf_dynamic_tree *tree, int element, tf_aabb box)
{
    int at = ABOVE_ROOT, lane = 0;
    tf_aabb whole = tf_aabb_union(branches_of(tree)[at].box[0], &box);
    double scale = tf_aabb_scale(&whole);
    while (branches_of(tree)[at].child[lane] > NOTHING) {
        branch *b = &branches_of(tree)[at];
        b->box[lane] = tf_aabb_union(b->box[lane], &box);
        at = b->child[lane];
        lane = lane_for(&branches_of(tree)[at], &box, scale);
    }
    branch above = branches_of(tree)[at];
    if (above.child[lane] == NOTHING) {
        set_child(tree, at, lane, child_of_element(element), box);
        return;
    }
    int made = take_branch(tree);
    set_child(tree, made, 0, above.child[lane], above.box[lane]);
    set_child(tree, made, 1, child_of_element(element), box);
    set_child(tree, at, lane, made, tf_aabb_union(above.box[lane], &box));
}

//: Fit the boxes above a branch
static bool same_box(const tf_aabb *a, const tf_aabb *b)
{
    for (int k = 0; k < 3; k++)
        if (a->low[k] != b->low[k] || a->high[k] != b->high[k])
            return false;
    return true;
}

static void fit_above(tf_dynamic_tree *tree, int at)
{
    while (at != ABOVE_ROOT) {
        const branch *b = &branches_of(tree)[at];
        tf_aabb whole = tf_aabb_union(b->box[0], &b->box[1]);
        int lane = lane_of_child(tree, b->parent, at);
        tf_aabb *box = &branches_of(tree)[b->parent].box[lane];
        if (same_box(box, &whole))
            return;
        *box = whole;
        at = b->parent;
    }
}

//: Remove an element
void tf_dynamic_tree_remove(tf_dynamic_tree *tree, int element)
{
    int child = child_of_element(element);
    int at = ((const int *)tree->parent.data)[element];
    if (at == ABOVE_ROOT) {
        set_child(tree, at, 0, NOTHING, tf_aabb_empty());
        return;
    }
    branch gone = branches_of(tree)[at];
    int other = !lane_of_child(tree, at, child);
    int lane = lane_of_child(tree, gone.parent, at);
    set_child(tree, gone.parent, lane, gone.child[other], gone.box[other]);
    free_branch(tree, at);
    fit_above(tree, gone.parent);
}

//: Change a box
void tf_dynamic_tree_change(tf_dynamic_tree *tree, int element, tf_aabb box)
{
    int at = ((const int *)tree->parent.data)[element];
    int lane = lane_of_child(tree, at, child_of_element(element));
    branches_of(tree)[at].box[lane] = box;
    fit_above(tree, at);
}

//: Find what overlaps a box
int tf_dynamic_tree_find(tf_dynamic_tree *tree, const tf_aabb *box, int found[])
{
    int count = 0, left = 0, *stack = tree->stack.data;
    stack[left++] = ABOVE_ROOT;
    while (left > 0) {
        const branch *b = &branches_of(tree)[stack[--left]];
        for (int i = 0; i < 2; i++) {
            if (!tf_aabbs_overlap(&b->box[i], box))
                continue;
            if (is_element(b->child[i]))
                found[count++] = -2 - b->child[i];
            else if (b->child[i] != NOTHING) // an infinite box overlaps it
                stack[left++] = b->child[i];
        }
    }
    return count;
}

//: Find the distance from a box
/// The square of the distance of a point from a box, 0 inside.
static double squared_from(const tf_aabb *box, const double x[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double low = box->low[k] - x[k], high = x[k] - box->high[k];
        double out = low > 0 ? low : high > 0 ? high : 0;
        sum += out * out;
    }
    return sum;
}

//: Find the nearest element
int tf_dynamic_tree_nearest(tf_dynamic_tree *tree, const double x[3],
                            double (*squared)(void *context, int element),
                            void *context, double *least)
{
    int nearest = -1, left = 0, *stack = tree->stack.data;
    *least = INFINITY;
    if (isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]))
        stack[left++] = ABOVE_ROOT;
    while (left > 0) {
        const branch *b = &branches_of(tree)[stack[--left]];
        double far[2] = {squared_from(&b->box[0], x),
                         squared_from(&b->box[1], x)};
        // What is nearer is looked at first, so it goes upon the stack last.
        for (int i = 0; i < 2; i++) {
            int lane = (far[0] < far[1]) == (i == 0);
            if (!(far[lane] < *least)) // as in a place that is empty
                continue;
            if (!is_element(b->child[lane])) {
                stack[left++] = b->child[lane];
                continue;
            }
            double own = squared(context, -2 - b->child[lane]);
            if (own < *least) {
                *least = own;
                nearest = -2 - b->child[lane];
            }
        }
    }
    return nearest;
}

//: Order elements along an axis
static double middle_of(const tf_aabb *box, int axis)
{
    return box->low[axis] / 2 + box->high[axis] / 2;
}

static int widest_axis(const tf_aabb box[], const int order[], int count)
{
    tf_aabb middles = tf_aabb_empty();
    for (int i = 0; i < count; i++) {
        double middle[3];
        for (int k = 0; k < 3; k++)
            middle[k] = middle_of(&box[order[i]], k);
        tf_aabb_add(&middles, middle);
    }
    int widest = 0;
    for (int k = 1; k < 3; k++)
        if (middles.high[k] - middles.low[k] >
            middles.high[widest] - middles.low[widest])
            widest = k;
    return widest;
}

//: Part elements at their median
/// Hoare's quickselect: afterwards no element before order[half] is beyond one
/// at or after it.
static void part_at(const tf_aabb box[], int axis, int order[], int count,
                    int half)
{
    int low = 0, high = count - 1;
    while (low < high) {
        double pivot = middle_of(&box[order[low + (high - low) / 2]], axis);
        int i = low, j = high;
        while (i <= j) {
            while (middle_of(&box[order[i]], axis) < pivot)
                i++;
            while (middle_of(&box[order[j]], axis) > pivot)
                j--;
            if (i > j)
                break;
            int swap = order[i];
            order[i++] = order[j];
            order[j--] = swap;
        }
        if (half <= j)
            high = j;
        else if (half >= i)
            low = i;
        else
            return;
    }
}

//: Build a subtree
enum {
    WATCHED = 500 ///< elements of a subtree whose building is watched
};

/// Builds the tree of some elements below a branch.
static bool build_part(tf_dynamic_tree *tree, int at, int lane,
                       const tf_aabb box[], int order[], int count,
                       tf_watch *watch)
{
    if (count == 1) {
        set_child(tree, at, lane, child_of_element(*order), box[*order]);
        return true;
    }
    if (count >= WATCHED && !tf_watch_done(watch, 0))
        return false;
    int half = count / 2, made = take_branch(tree);
    part_at(box, widest_axis(box, order, count), order, count, half);
    if (!build_part(tree, made, 0, box, order, half, watch) ||
        !build_part(tree, made, 1, box, order + half, count - half, watch))
        return false;
    const branch *b = &branches_of(tree)[made];
    set_child(tree, at, lane, made, tf_aabb_union(b->box[0], &b->box[1]));
    return true;
}

//: Build a dynamic tree
bool tf_dynamic_tree_build(tf_dynamic_tree *tree, const tf_aabb box[],
                           int order[], int count, tf_watch *watch)
{
    tree->branches = 1;
    tree->free_branch = -1;
    for (int i = 0; i < 2; i++)
        set_child(tree, ABOVE_ROOT, i, NOTHING, tf_aabb_empty());
    return count == 0 ||
           build_part(tree, ABOVE_ROOT, 0, box, order, count, watch);
}
