//: Include what the new search needs
#include "response/recheck.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

//: Put boxes around the paths that have changed
static void box_changed(tf_surface *surface, const tf_motion *motion,
                        const bool changed[])
{
    tf_box *box = surface->boxes.data;
    for (int v = 0; v < surface->vertices; v++)
        if (changed[v])
            box[v] = tf_vertex_box(&surface->frame, motion, v);
}

//: Hold what is refitted
typedef struct refitting {
    tf_tree *tree;
    const tf_box *box; ///< of each vertex
    const bool *changed;
    int level; ///< whose packs are being refitted
} refitting;

//: Refit a leaf
static bool has_changed(const refitting *of, int leaf, int lane)
{
    int corners = of->tree->corners;
    bool any = false;
    for (int c = 0; c < corners; c++)
        any |= of->changed[of->tree->corner[leaf * corners + c][lane]];
    return any;
}

static tf_box box_around(const refitting *of, int leaf, int lane)
{
    int corners = of->tree->corners;
    tf_box box = tf_box_empty;
    for (int c = 0; c < corners; c++) {
        int vertex = of->tree->corner[leaf * corners + c][lane];
        box = tf_box_union(box, of->box[vertex]);
    }
    return box;
}

/// Sets the boxes of the elements that have changed; returns their lanes.
static uint32_t refit_leaf(const refitting *of, int leaf)
{
    uint32_t lanes = 0;
    for (int i = 0; i < TF_LANES && of->tree->element[leaf][i] >= 0; i++) {
        if (!has_changed(of, leaf, i))
            continue;
        tf_box box = box_around(of, leaf, i);
        tf_pack_set_box(&of->tree->level[0][leaf], i, &box);
        lanes |= UINT32_C(1) << i;
    }
    return lanes;
}

//: Refit a pack
/// Sets the boxes of the packs below that have changed; returns their lanes.
static uint32_t refit_pack(const refitting *of, int pack)
{
    const tf_tree *tree = of->tree;
    int below = of->level - 1;
    uint32_t lanes = 0;
    for (int i = 0; i < TF_LANES; i++) {
        int child = pack * TF_LANES + i;
        if (child >= tree->packs[below] || !tree->marked[below][child])
            continue;
        tf_box box = tf_pack_union(&tree->level[below][child]);
        tf_pack_set_box(&tree->level[of->level][pack], i, &box);
        lanes |= UINT32_C(1) << i;
    }
    return lanes;
}

//: Refit a tree
enum {
    PACKS = 1024 // a task
};

static void refit_part(void *argument, int task, int worker)
{
    const refitting *of = argument;
    uint32_t *marked = of->tree->marked[of->level];
    tf_range part = tf_range_part(of->tree->packs[of->level], PACKS, task);
    (void)worker;
    for (int i = part.begin; i < part.end; i++)
        marked[i] = of->level == 0 ? refit_leaf(of, i) : refit_pack(of, i);
}

static void refit(const tf_surface *surface, tf_tree *tree,
                  const bool changed[], const tf_parallel *parallel)
{
    refitting of = {tree, surface->boxes.data, changed, 0};
    for (; of.level < tree->levels; of.level++)
        tf_parallel_for_each(parallel,
                             tf_range_parts(tree->packs[of.level], PACKS),
                             refit_part, &of);
}

//: Look for contacts again
tf_status tf_recheck(tf_surface *surface, tf_step *step, tf_deciding *of,
                     const tf_parallel *parallel, tf_contacts *found)
{
    box_changed(surface, of->motion, step->changed);
    refit(surface, &surface->vertex_tree, step->changed, parallel);
    refit(surface, &surface->edge_tree, step->changed, parallel);
    refit(surface, &surface->triangle_tree, step->changed, parallel);
    tf_status status = tf_pairs_find(surface, of, parallel, found);
    if (status == TF_OK)
        memset(step->changed, 0,
               (size_t)step->vertices * sizeof *step->changed);
    return status;
}
