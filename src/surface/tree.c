//: Include what the tree needs
#include "surface/tree.h"

#include "base/always_inline.h"
#include "base/prefetch.h"
#include "base/simd.h"

#include <stddef.h>
#include <string.h>

enum {
    ELEMENTS = 16384 // a task, a multiple of TF_LANES
};

//: Unite the boxes of a pack
TF_ALWAYS_INLINE float lower(float a, float b)
{
    return a < b ? a : b;
}

TF_ALWAYS_INLINE float higher(float a, float b)
{
    return a > b ? a : b;
}

/// Unites the second half of the lanes with the first.
TF_ALWAYS_INLINE void unite_halves(const float from_low[],
                                   const float from_high[], float low[],
                                   float high[])
{
    TF_LANE_LOOP
    for (int i = 0; i < TF_LANES / 2; i++) {
        low[i] = lower(from_low[i], from_low[i + TF_LANES / 2]);
        high[i] = higher(from_high[i], from_high[i + TF_LANES / 2]);
    }
}

TF_NO_TRAPS tf_box tf_pack_union(const tf_pack *pack)
{
    tf_box all;
    for (int k = 0; k < TF_SIDES; k++) {
        float low[TF_LANES / 2], high[TF_LANES / 2];
        unite_halves(pack->low[k], pack->high[k], low, high);
        for (int half = TF_LANES / 4; half > 0; half /= 2)
            for (int i = 0; i < half; i++) {
                low[i] = lower(low[i], low[i + half]);
                high[i] = higher(high[i], high[i + half]);
            }
        all.low[k] = low[0];
        all.high[k] = high[0];
    }
    return all;
}

//: Find the box of an element
TF_ALWAYS_INLINE const int *corners_of(const tf_tree_elements *elements,
                                       const int *i)
{
    return elements->corner
               ? elements->corner + (ptrdiff_t)elements->corners * *i
               : i;
}

TF_ALWAYS_INLINE tf_box element_box_of(const tf_tree_elements *elements, int i)
{
    const int *corner = corners_of(elements, &i);
    tf_path low = elements->vertex[corner[0]], high = low;
    for (int c = 1; c < elements->corners; c++) {
        const float *at = elements->vertex[corner[c]].at;
        TF_LANE_LOOP
        for (int k = 0; k < TF_PATH_ROOM; k++) {
            low.at[k] = lower(at[k], low.at[k]);
            high.at[k] = higher(at[k], high.at[k]);
        }
    }
    tf_box box;
    memcpy(box.low, low.at, sizeof box.low);
    memcpy(box.high, high.at, sizeof box.high);
    for (int k = TF_AXES; elements->swept && k < TF_SIDES; k++) {
        box.low[k] = lower(box.low[k], box.low[k - TF_AXES]);
        box.high[k] = higher(box.high[k], box.high[k - TF_AXES]);
    }
    return box;
}

//: Add up the paths of an element
TF_ALWAYS_INLINE tf_path path_sum_of(const tf_tree_elements *elements, int i)
{
    const int *corner = corners_of(elements, &i);
    tf_path sum = elements->vertex[corner[0]];
    for (int c = 1; c < elements->corners; c++)
        for (int k = 0; k < TF_AXES + 1; k++)
            sum.at[k] += elements->vertex[corner[c]].at[k];
    return sum;
}

//: Hold the build of a tree
typedef struct build_job {
    tf_tree *tree;
    const tf_tree_elements *elements;
    tf_keyed *keys;
    const tf_keyed *sorted;
    int level; ///< whose packs are being filled
} build_job;

//: Find the keys of a part
TF_NO_TRAPS static void find_keys(void *argument, int task, int worker)
{
    const build_job *job = argument;
    tf_range part = tf_range_part(job->elements->count, ELEMENTS, task);
    tf_morton_grid grid =
        tf_morton_grid_of(job->elements->whole, job->elements->corners);
    (void)worker;
    for (int i = part.begin; i < part.end; i++) {
        tf_path sum = path_sum_of(job->elements, i);
        job->keys[i] = (tf_keyed){tf_morton_key(&sum, &grid), i};
    }
}

//: Fill a lane
TF_ALWAYS_INLINE void fill_lane(const build_job *job, int leaf, int lane,
                                int element)
{
    int corners = job->elements->corners;
    const int *corner = corners_of(job->elements, &element);
    tf_box box = element_box_of(job->elements, element);
    tf_pack_set_box(&job->tree->level[0][leaf], lane, &box);
    job->tree->element[leaf][lane] = element;
    for (int c = 0; c < corners; c++)
        job->tree->corner[leaf * corners + c][lane] = corner[c];
}

static void clear_lane(const build_job *job, int leaf, int lane)
{
    int corners = job->elements->corners;
    tf_pack_set_box(&job->tree->level[0][leaf], lane, &tf_box_empty);
    job->tree->element[leaf][lane] = -1;
    for (int c = 0; c < corners; c++)
        job->tree->corner[leaf * corners + c][lane] = -1;
}

//: Prefetch the boxes of an element
enum {
    CORNERS_AHEAD = 24, ///< elements
    BOXES_AHEAD = 12
};

/// Asks for what will be needed to fill the lanes that come after number i.
TF_ALWAYS_INLINE void prefetch_boxes(const build_job *job, int i, int end)
{
    const tf_tree_elements *elements = job->elements;
    const tf_keyed *sorted = job->sorted + i;
    if (end - i > CORNERS_AHEAD)
        tf_prefetch(corners_of(elements, &sorted[CORNERS_AHEAD].element));
    if (end - i <= BOXES_AHEAD)
        return;
    const int *corner = corners_of(elements, &sorted[BOXES_AHEAD].element);
    for (int c = 0; c < elements->corners; c++)
        tf_prefetch(elements->vertex + corner[c]);
}

//: Fill the leaves of a part
TF_NO_TRAPS static void fill_leaves(void *argument, int task, int worker)
{
    const build_job *job = argument;
    tf_range part = tf_range_part(job->elements->count, ELEMENTS, task);
    (void)worker;
    for (int i = part.begin; i < part.end; i++) {
        prefetch_boxes(job, i, part.end);
        fill_lane(job, i / TF_LANES, i % TF_LANES, job->sorted[i].element);
    }
    for (int i = part.end; i % TF_LANES != 0; i++)
        clear_lane(job, i / TF_LANES, i % TF_LANES);
}

//: Fill the packs of a level
static void fill_packs(void *argument, int task, int worker)
{
    const build_job *job = argument;
    const tf_tree *tree = job->tree;
    tf_range part = tf_range_part(tree->packs[job->level - 1], ELEMENTS, task);
    const tf_pack *below = tree->level[job->level - 1];
    tf_pack *level = tree->level[job->level];
    (void)worker;
    for (int i = part.begin; i < part.end; i++) {
        tf_box box = tf_pack_union(&below[i]);
        tf_pack_set_box(&level[i / TF_LANES], i % TF_LANES, &box);
    }
    for (int i = part.end; i % TF_LANES != 0; i++)
        tf_pack_set_box(&level[i / TF_LANES], i % TF_LANES, &tf_box_empty);
}

//: Count the packs of all levels
/// Sets the sizes of the levels; returns how many packs there are in all.
static size_t count_packs(tf_tree *tree)
{
    size_t all = 0;
    int packs = tree->count;
    tree->levels = 0;
    do {
        packs = tf_range_parts(packs, TF_LANES);
        tree->packs[tree->levels++] = packs;
        all += (size_t)packs;
    } while (packs > 1 || tree->levels < 2);
    return all;
}

//: Make room for a tree
static bool make_room(tf_tree *tree, tf_tree_workspace *workspace)
{
    size_t packs = count_packs(tree);
    size_t leaves = (size_t)tree->packs[0];
    size_t corners = leaves * (size_t)tree->corners;
    size_t count = (size_t)tree->count;
    if (!tf_buffer_reserve(&tree->pack_storage, packs, sizeof(tf_pack)) ||
        !tf_buffer_reserve(&tree->element_storage, leaves,
                           sizeof *tree->element) ||
        !tf_buffer_reserve(&tree->corner_storage, corners,
                           sizeof *tree->corner) ||
        !tf_buffer_reserve(&workspace->keys, count, sizeof(tf_keyed)) ||
        !tf_buffer_reserve(&workspace->sorted, count, sizeof(tf_keyed)) ||
        !tf_buffer_reserve(&workspace->counts, TF_SORT_PARTS,
                           sizeof(tf_digit_counts)))
        return false;
    tree->level[0] = tree->pack_storage.data;
    for (int i = 1; i < tree->levels; i++)
        tree->level[i] = tree->level[i - 1] + tree->packs[i - 1];
    tree->element = tree->element_storage.data;
    tree->corner = tree->corner_storage.data;
    return true;
}

//: Build a tree
bool tf_tree_build(tf_tree *tree, const tf_tree_elements *elements,
                   tf_tree_workspace *workspace, const tf_parallel *parallel)
{
    tree->count = elements->count;
    tree->corners = elements->corners;
    tree->swept = elements->swept;
    tree->levels = 0;
    if (tree->count == 0)
        return true;
    if (!make_room(tree, workspace))
        return false;

    build_job job = {
        .tree = tree, .elements = elements, .keys = workspace->keys.data};
    int tasks = tf_range_parts(tree->count, ELEMENTS);
    tf_parallel_for_each(parallel, tasks, find_keys, &job);
    job.sorted = tf_morton_sort(tree->count, job.keys, workspace->sorted.data,
                                workspace->counts.data, parallel);
    tf_parallel_for_each(parallel, tasks, fill_leaves, &job);
    for (job.level = 1; job.level < tree->levels; job.level++)
        tf_parallel_for_each(
            parallel, tf_range_parts(tree->packs[job.level - 1], ELEMENTS),
            fill_packs, &job);
    return true;
}

//: Free a tree
void tf_tree_free(tf_tree *tree)
{
    tf_buffer_free(&tree->pack_storage);
    tf_buffer_free(&tree->element_storage);
    tf_buffer_free(&tree->corner_storage);
}

void tf_tree_workspace_free(tf_tree_workspace *workspace)
{
    tf_buffer_free(&workspace->keys);
    tf_buffer_free(&workspace->sorted);
    tf_buffer_free(&workspace->counts);
}
