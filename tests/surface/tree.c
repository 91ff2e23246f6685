// The tree: every element in one leaf, every box inside the one above it.
#include "surface/tree.h"

#include "support/boxes.h"
#include "support/scrambled_workers.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST = 70000
};

static tf_path vertex[MOST];

static tf_box box_at(const tf_path *path)
{
    tf_box box;
    memcpy(box.low, path->at, sizeof box.low);
    memcpy(box.high, path->at, sizeof box.high);
    return box;
}

static tf_box random_vertices(generator *random, int count)
{
    tf_box whole = tf_box_empty;
    for (int i = 0; i < count; i++) {
        for (int side = 0; side < TF_SIDES; side++)
            vertex[i].at[side] = (float)uniform(random, -1, 1);
        whole = box_union(whole, box_at(&vertex[i]));
    }
    return whole;
}

static bool same_box(tf_box a, tf_box b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static tf_box box_of(const tf_tree_elements *elements, int i)
{
    tf_box box = tf_box_empty;
    for (int c = 0; c < elements->corners; c++) {
        int v =
            elements->corner ? elements->corner[elements->corners * i + c] : i;
        box = box_union(box, box_at(&vertex[v]));
    }
    for (int k = 0; elements->swept && k < TF_AXES; k++) {
        box.low[TF_AXES + k] = fminf(box.low[k], box.low[TF_AXES + k]);
        box.high[TF_AXES + k] = fmaxf(box.high[k], box.high[TF_AXES + k]);
    }
    return box;
}

static bool has_corners(const tf_tree *tree, const tf_tree_elements *elements,
                        int leaf, int lane)
{
    int corners = elements->corners, element = tree->element[leaf][lane];
    bool all = true;
    for (int c = 0; c < corners; c++)
        all &= tree->corner[leaf * corners + c][lane] ==
               (elements->corner ? elements->corner[corners * element + c]
                                 : element);
    return all;
}

/// Lanes are used in order.  An unused lane has an empty box, and so has the
/// union of unused lanes.
static bool is_right(const tf_tree *tree, const tf_tree_elements *elements,
                     int leaf, int lane)
{
    int element = tree->element[leaf][lane];
    tf_box box = pack_box(&tree->level[0][leaf], lane);
    if (leaf * TF_LANES + lane >= elements->count)
        return element < 0 && same_box(box, tf_box_empty);
    return element >= 0 && same_box(box, box_of(elements, element)) &&
           has_corners(tree, elements, leaf, lane);
}

// Check writes each assertion to a pipe, so there are few of them here.
static void check_leaves(const tf_tree *tree, const tf_tree_elements *elements)
{
    static bool seen[MOST];
    memset(seen, 0, sizeof seen);
    int wrong = 0;
    for (int i = 0; i < tree->packs[0] * TF_LANES; i++) {
        int leaf = i / TF_LANES, lane = i % TF_LANES;
        int element = tree->element[leaf][lane];
        wrong += !is_right(tree, elements, leaf, lane);
        if (element < 0)
            continue;
        wrong += seen[element];
        seen[element] = true;
    }
    ck_assert_int_eq(wrong, 0);
}

static void check_levels(const tf_tree *tree)
{
    ck_assert_int_eq(tree->packs[tree->levels - 1], 1);
    ck_assert_int_ge(tree->levels, 2);
    int wrong = 0;
    for (int level = 1; level < tree->levels; level++)
        for (int i = 0; i < tree->packs[level] * TF_LANES; i++) {
            tf_box box =
                pack_box(&tree->level[level][i / TF_LANES], i % TF_LANES);
            tf_box below = i < tree->packs[level - 1]
                               ? tf_pack_union(&tree->level[level - 1][i])
                               : tf_box_empty;
            wrong += !same_box(box, below);
        }
    ck_assert_int_eq(wrong, 0);
}

static void check_tree(tf_tree *tree, tf_tree_workspace *workspace, int count,
                       int corners, const tf_parallel *parallel)
{
    generator random = generator_new((uint64_t)count);
    tf_box whole = random_vertices(&random, count + 2);
    int *corner = malloc(sizeof *corner * (size_t)(count * corners + 1));
    for (int i = 0; i < count * corners; i++)
        corner[i] = below(&random, count + 2);
    tf_tree_elements elements = {.count = count,
                                 .corners = corners,
                                 .corner = corners == 1 ? NULL : corner,
                                 .vertex = vertex,
                                 .whole = &whole};
    for (int swept = 0; swept < 2; swept++) {
        elements.swept = swept;
        ck_assert(tf_tree_build(tree, &elements, workspace, parallel));
        ck_assert_int_eq(tree->swept, swept);
        check_leaves(tree, &elements);
        check_levels(tree);
    }
    free(corner);
}

START_TEST(every_element_is_in_one_leaf)
{
    static const int counts[] = {1,   2,   15,   16,    17,    255,  256,
                                 257, 400, 4097, 16384, 16385, 65537};
    tf_tree tree = {0};
    tf_tree_workspace workspace = {0};
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    for (int i = 0; i < 13; i++)
        for (int corners = 1; corners <= 3; corners++) {
            check_tree(&tree, &workspace, counts[i], corners, NULL);
            check_tree(&tree, &workspace, counts[i], corners, &parallel);
        }
    tf_tree_free(&tree);
    tf_tree_workspace_free(&workspace);
}
END_TEST

START_TEST(empty_boxes_change_nothing)
{
    tf_box box = {{-1, 2, 3, 0, 1, 2}, {4, 5, 6, 7, 8, 9}};
    for (int own = 0; own < TF_LANES; own++) {
        tf_pack pack;
        for (int lane = 0; lane < TF_LANES; lane++)
            tf_pack_set_box(&pack, lane, lane == own ? &box : &tf_box_empty);
        ck_assert(same_box(tf_pack_union(&pack), box));
    }
}
END_TEST

START_TEST(a_tree_of_nothing_is_empty)
{
    tf_tree tree = {0};
    tf_tree_workspace workspace = {0};
    tf_tree_elements none = {.corners = 3};
    ck_assert(tf_tree_build(&tree, &none, &workspace, NULL));
    ck_assert_int_eq(tree.count, 0);
    ck_assert_int_eq(tree.levels, 0);
    tf_tree_free(&tree);
    tf_tree_workspace_free(&workspace);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/tree");
    TCase *tcase = tcase_create("tree");
    tcase_add_test(tcase, every_element_is_in_one_leaf);
    tcase_add_test(tcase, empty_boxes_change_nothing);
    tcase_add_test(tcase, a_tree_of_nothing_is_empty);
    suite_add_tcase(suite, tcase);
    return suite;
}
