//: Include what regions need
#include "untangle/regions.h"

#include <string.h>

//: Make room for regions
static bool reserve(tf_regions *regions, const tf_neighbors *all, int **stack,
                    unsigned char **cut)
{
    size_t v = (size_t)all->vertices, e = (size_t)all->edges;
    size_t count = 5 * v + 2 + (size_t)all->parts;
    if (!tf_buffer_reserve(&regions->storage, count * sizeof(int) + e, 1))
        return false;
    regions->region = regions->storage.data;
    regions->size = regions->region + v;
    regions->members.start = regions->size + v;
    regions->members.item = regions->members.start + v + 2;
    *stack = regions->members.item + v;
    regions->right = *stack + v;
    *cut = (unsigned char *)(regions->right + all->parts);
    return true;
}

//: Note which edges are cut
/// An edge is cut if curves cross it an odd number of times: then its ends are on
/// different sides.
static void cut_edges(const tf_neighbors *all, const tf_curves *curves,
                      unsigned char cut[])
{
    memset(cut, 0, (size_t)all->edges);
    for (size_t i = 0; i < curves->count; i++)
        cut[curves->point[i].edge] ^= 1;
}

//: Flood a region
static int flood(tf_regions *regions, const tf_neighbors *all,
                 const unsigned char cut[], int first, int *stack)
{
    int height = 0, size = 0;
    regions->region[first] = regions->count;
    stack[height++] = first;
    for (; height > 0; size++) {
        int v = stack[--height];
        for (int i = all->around.start[v]; i < all->around.start[v + 1]; i++) {
            int other = all->around.item[i];
            if (cut[all->edges_at.item[i]] || regions->region[other] >= 0)
                continue;
            regions->region[other] = regions->count;
            stack[height++] = other;
        }
    }
    return size;
}

static void flood_all(tf_regions *regions, const tf_neighbors *all,
                      const unsigned char cut[], int *stack)
{
    regions->count = 0;
    memset(regions->region, -1, sizeof(int) * (size_t)all->vertices);
    for (int v = 0; v < all->vertices; v++)
        if (regions->region[v] < 0) {
            int size = flood(regions, all, cut, v, stack);
            regions->size[regions->count++] = size;
        }
}

//: List the members of regions
static void list_members(tf_regions *regions, int vertices)
{
    int *start = regions->members.start;
    start[0] = start[1] = 0;
    for (int r = 0; r + 1 < regions->count; r++)
        start[r + 2] = start[r + 1] + regions->size[r];
    for (int v = 0; v < vertices; v++)
        regions->members.item[start[regions->region[v] + 1]++] = v;
}

//: Choose the right region of each part
static void choose_right(tf_regions *regions, const tf_neighbors *all,
                         const int preferred[])
{
    for (int p = 0; p < all->parts; p++)
        regions->right[p] = -1;
    for (int r = 0; r < regions->count; r++) {
        int part = tf_region_part(regions, all, r);
        if (part >= 0 &&
            (regions->right[part] < 0 ||
             regions->size[r] > regions->size[regions->right[part]]))
            regions->right[part] = r;
    }
    for (int p = 0; p < all->parts; p++) {
        int own = preferred[p] < 0 ? -1 : regions->region[preferred[p]];
        if (own >= 0 &&
            regions->size[own] > regions->size[regions->right[p]] / 2)
            regions->right[p] = own;
    }
}

//: Find regions
bool tf_regions_find(tf_regions *regions, const tf_tangle *tangle,
                     const tf_curves *curves, const int preferred[])
{
    const tf_neighbors *all = &tangle->near;
    int *stack = NULL;
    unsigned char *cut = NULL;
    if (!reserve(regions, all, &stack, &cut))
        return false;
    cut_edges(all, curves, cut);
    flood_all(regions, all, cut, stack);
    list_members(regions, all->vertices);
    choose_right(regions, all, preferred);
    return true;
}

void tf_regions_free(tf_regions *regions)
{
    tf_buffer_free(&regions->storage);
}

//: Tell which regions are wrong
int tf_region_part(const tf_regions *regions, const tf_neighbors *all,
                   int region)
{
    return all->part[regions->members.item[regions->members.start[region]]];
}

bool tf_is_wrong(const tf_regions *regions, const tf_neighbors *all, int region)
{
    int part = tf_region_part(regions, all, region);
    return part >= 0 && regions->right[part] != region;
}
