//: Include what a tree of facets needs
#include "distance/tree_nearest.h"

#include "surface/morton.h"

#include <stdint.h>

enum {
    LEAF_FACETS = 4,
    STACK = 64 ///< each level of the tree adds one node to a stack
};

//: Find the corners of a facet
static const int *corners_of_facet(const tf_chosen_facets *facets, int place)
{
    int facet = facets->chosen ? facets->chosen[place] : place;
    return facets->corner + (ptrdiff_t)facets->axes * facet;
}

static tf_vector place_of(const tf_chosen_facets *facets, int vertex)
{
    const double *x = facets->x + (ptrdiff_t)facets->axes * vertex;
    return (tf_vector){{x[0], x[1], facets->axes == 3 ? x[2] : 0}};
}

//: Find the foot of a point on an edge or a triangle
/// How far along from a to b is nearest to p, from 0 to 1.
static double along(tf_vector p, tf_vector a, tf_vector b)
{
    tf_vector way = tf_vector_difference(b, a);
    double square = tf_vector_dot(way, way);
    double at = tf_vector_dot(tf_vector_difference(p, a), way);
    return at <= 0 || square == 0 ? 0 : at >= square ? 1 : at / square;
}

/// Barycentric coordinates of the foot of p in the plane of a triangle; false
/// unless it is inside.
static bool find_foot(tf_vector p, const tf_vector corner[], double weight[3])
{
    tf_vector b = tf_vector_difference(corner[1], corner[0]);
    tf_vector c = tf_vector_difference(corner[2], corner[0]);
    tf_vector out = tf_vector_difference(p, corner[0]);
    tf_vector up = tf_vector_cross(b, c);
    double square = tf_vector_dot(up, up);
    weight[1] = tf_vector_dot(tf_vector_cross(out, c), up);
    weight[2] = tf_vector_dot(tf_vector_cross(b, out), up);
    weight[0] = square - weight[1] - weight[2];
    if (square <= 0 || weight[0] < 0 || weight[1] < 0 || weight[2] < 0)
        return false;
    for (int i = 0; i < 3; i++)
        weight[i] /= square;
    return true;
}

//: Find where a point is nearest to a facet
static void measure(tf_landing *own, tf_vector p, const tf_vector corner[])
{
    for (int i = 0; i < 3; i++)
        p = tf_vector_sum(p, -own->weight[i], corner[i]);
    own->out = p;
    own->distance = tf_vector_length(p);
}

tf_landing tf_land(const tf_chosen_facets *facets, tf_vector point, int place)
{
    const int *index = corners_of_facet(facets, place);
    tf_vector corner[3] = {{{0, 0, 0}}};
    int facet = (int)((index - facets->corner) / facets->axes);
    tf_landing best = {place, facet, .distance = INFINITY};
    for (int c = 0; c < facets->axes; c++)
        corner[c] = place_of(facets, index[c]);
    if (facets->axes == 3 && find_foot(point, corner, best.weight)) {
        measure(&best, point, corner);
        return best;
    }
    for (int i = 0; i < (facets->axes == 3 ? 3 : 1); i++) {
        tf_landing own = {place, facet, .distance = INFINITY};
        int j = (i + 1) % 3;
        own.weight[j] = along(point, corner[i], corner[j]);
        own.weight[i] = 1 - own.weight[j];
        measure(&own, point, corner);
        if (own.distance < best.distance)
            best = own;
    }
    return best;
}

//: Unite boxes
static const tf_tree_box nothing = {{INFINITY, INFINITY, INFINITY},
                                    {-INFINITY, -INFINITY, -INFINITY}};

static void add_box(tf_tree_box *box, const tf_tree_box *other)
{
    for (int k = 0; k < TF_AXES; k++) {
        box->low[k] = fmin(box->low[k], other->low[k]);
        box->high[k] = fmax(box->high[k], other->high[k]);
    }
}

static tf_tree_box box_of(const tf_chosen_facets *facets, int place)
{
    tf_tree_box box = nothing;
    const int *corner = corners_of_facet(facets, place);
    for (int c = 0; c < facets->axes; c++) {
        tf_vector at = place_of(facets, corner[c]);
        tf_tree_box point;
        for (int k = 0; k < TF_AXES; k++)
            point.low[k] = point.high[k] = at.x[k];
        add_box(&box, &point);
    }
    return box;
}

//: Make room for a tree of facets
static bool reserve(tf_nearest_tree *tree)
{
    size_t count = (size_t)tree->facets.count;
    size_t leaves = (count + LEAF_FACETS - 1) / LEAF_FACETS, power = 1;
    while (power < leaves)
        power *= 2;
    tree->leaves = (int)power;
    if (!tf_buffer_reserve(&tree->keys, count, sizeof(tf_keyed)) ||
        !tf_buffer_reserve(&tree->sorted, count, sizeof(tf_keyed)) ||
        !tf_buffer_reserve(&tree->places, count, sizeof(int)) ||
        !tf_buffer_reserve(&tree->boxes, 2 * power, sizeof(tf_tree_box)) ||
        !tf_buffer_reserve(&tree->counts, TF_SORT_PARTS,
                           sizeof(tf_digit_counts)))
        return false;
    tree->place = tree->places.data;
    tree->box = tree->boxes.data;
    return true;
}

//: Sort facets along the Morton curve
/// The middle of a facet's box, in coordinates from 0 to 1 in the box of all.
static tf_path middle_of(const tf_tree_box *own, const tf_tree_box *whole)
{
    tf_path path = {{0}};
    for (int k = 0; k < TF_AXES; k++) {
        double size = whole->high[k] - whole->low[k];
        double middle = own->low[k] / 2 + own->high[k] / 2 - whole->low[k];
        path.at[k] = size > 0 ? (float)(middle / size) : 0;
    }
    return path;
}

static void sort_facets(tf_nearest_tree *tree, const tf_tree_box *whole)
{
    static const tf_box unit = {.high = {1, 1, 1}};
    tf_morton_grid grid = tf_morton_grid_of(&unit, 1);
    tf_keyed *keyed = tree->keys.data;
    for (int i = 0; i < tree->facets.count; i++) {
        tf_tree_box own = box_of(&tree->facets, i);
        tf_path path = middle_of(&own, whole);
        keyed[i] = (tf_keyed){tf_morton_key(&path, &grid), i};
    }
    keyed = tf_morton_sort(tree->facets.count, keyed, tree->sorted.data,
                           tree->counts.data, NULL);
    for (int i = 0; i < tree->facets.count; i++)
        tree->place[i] = keyed[i].element;
}

//: Build the boxes of a tree
static void build_boxes(tf_nearest_tree *tree)
{
    for (int i = 0; i < tree->leaves; i++)
        tree->box[tree->leaves + i] = nothing;
    for (int i = 0; i < tree->facets.count; i++) {
        tf_tree_box own = box_of(&tree->facets, tree->place[i]);
        add_box(&tree->box[tree->leaves + i / LEAF_FACETS], &own);
    }
    for (int i = tree->leaves - 1; i > 0; i--) {
        tree->box[i] = tree->box[2 * (ptrdiff_t)i];
        add_box(&tree->box[i], &tree->box[2 * (ptrdiff_t)i + 1]);
    }
}

//: Build a tree of facets
bool tf_nearest_tree_build(tf_nearest_tree *tree,
                           const tf_chosen_facets *facets)
{
    tree->facets = *facets;
    if (!reserve(tree))
        return false;
    tf_tree_box whole = nothing;
    for (int i = 0; i < facets->count; i++) {
        tf_tree_box own = box_of(facets, i);
        add_box(&whole, &own);
    }
    double size = 0;
    for (int k = 0; k < TF_AXES && facets->count > 0; k++)
        size = fmax(size, fmax(fabs(whole.low[k]), fabs(whole.high[k])));
    tree->slack = 0x1p-45 * size;
    sort_facets(tree, &whole);
    build_boxes(tree);
    return true;
}

//: Free a tree of facets
void tf_nearest_tree_trim(tf_nearest_tree *tree)
{
    tf_buffer_free(&tree->keys);
    tf_buffer_free(&tree->sorted);
    tf_buffer_free(&tree->counts);
}

void tf_nearest_tree_free(tf_nearest_tree *tree)
{
    tf_nearest_tree_trim(tree);
    tf_buffer_free(&tree->places);
    tf_buffer_free(&tree->boxes);
}

//: Measure the distance of a box
/// The square of it; infinite if there is nothing in the box.
static double square_to(const tf_tree_box *box, tf_vector point)
{
    double square = 0;
    for (int k = 0; k < TF_AXES; k++) {
        double below = box->low[k] - point.x[k];
        double above = point.x[k] - box->high[k];
        double beyond = below > above ? below : above;
        square += beyond > 0 ? beyond * beyond : 0;
    }
    return square;
}

//: Find the facets of a leaf
void tf_nearest_tree_leaf(const tf_nearest_tree *tree, int leaf, int *begin,
                          int *end)
{
    int count = tree->facets.count;
    *begin = LEAF_FACETS * (leaf - tree->leaves);
    *end = *begin + LEAF_FACETS < count ? *begin + LEAF_FACETS : count;
}

//: Search a tree
typedef struct search {
    const tf_nearest_tree *tree;
    tf_vector point;
    int without;
    tf_landing best;
    double limit; ///< what has a larger square is not looked at
} search;

static bool has_corner(const tf_chosen_facets *facets, int place, int vertex)
{
    const int *corner = corners_of_facet(facets, place);
    for (int c = 0; c < facets->axes; c++)
        if (corner[c] == vertex)
            return true;
    return false;
}

static void search_leaf(search *own, int leaf)
{
    const tf_nearest_tree *tree = own->tree;
    int begin = 0, end = 0;
    tf_nearest_tree_leaf(tree, leaf, &begin, &end);
    for (int i = begin; i < end; i++) {
        if (has_corner(&tree->facets, tree->place[i], own->without))
            continue;
        tf_landing next = tf_land(&tree->facets, own->point, tree->place[i]);
        if (next.distance < own->best.distance ||
            (next.distance == own->best.distance &&
             next.place < own->best.place))
            own->best = next;
    }
    // The computed distances of facets and boxes are rounded.
    double most = (1 + 0x1p-45) * own->best.distance + tree->slack;
    own->limit = most * most;
}

//: Find the nearest facet
/// Goes down to the nearer box first.
tf_landing tf_nearest_landing(const tf_nearest_tree *tree, tf_vector point,
                              int without)
{
    search own = {tree, point, without,
                  .best = {.place = -1, .facet = -1, .distance = INFINITY},
                  .limit = INFINITY};
    int stack[STACK], height = 0;
    double square[STACK];
    square[height] = square_to(&tree->box[1], point);
    stack[height++] = 1;
    while (height > 0) {
        int node = stack[--height];
        if (square[height] > own.limit || tree->facets.count == 0)
            continue;
        if (node >= tree->leaves) {
            search_leaf(&own, node);
            continue;
        }
        double left = square_to(&tree->box[2 * (ptrdiff_t)node], point);
        double right = square_to(&tree->box[2 * (ptrdiff_t)node + 1], point);
        int far = left <= right;
        square[height] = far ? right : left;
        stack[height++] = 2 * node + far;
        square[height] = far ? left : right;
        stack[height++] = 2 * node + !far;
    }
    return own.best;
}
