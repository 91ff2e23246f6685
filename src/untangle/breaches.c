//: Include what breaches need
#include "untangle/breaches.h"

//: Find the wrong end of an edge
int tf_wrong_end(const tf_regions *regions, const tf_neighbors *all,
                 const tf_curve_point *point)
{
    const int *end = all->edge + 2 * (ptrdiff_t)point->edge;
    int a = regions->region[end[0]], b = regions->region[end[1]];
    if (a == b)
        return -1;
    if (!tf_is_wrong(regions, all, a))
        return 1;
    if (!tf_is_wrong(regions, all, b))
        return 0;
    return regions->size[a] < regions->size[b] ? 0 : 1;
}

//: Describe a breach
static tf_breach breach_of(const tf_regions *regions, const tf_neighbors *all,
                           const double x[], const tf_curve_point *point,
                           int wrong)
{
    const int *end = all->edge + 2 * (ptrdiff_t)point->edge;
    bool up = wrong == 0 ? point->rise > 0 : point->rise < 0;
    return (tf_breach){
        .region = regions->region[end[wrong]],
        .facet = point->facet,
        .sheet = all->sheet[point->facet],
        .side = up ? 1 : -1,
        .place = point->place,
        .inward = tf_vector_difference(tf_place(all, x, end[wrong]),
                                       tf_place(all, x, end[1 - wrong]))};
}

static bool breach_precedes(const void *first, const void *second)
{
    const tf_breach *a = first, *b = second;
    return a->region != b->region ? a->region < b->region : a->sheet < b->sheet;
}

//: List breaches
static bool list_breaches(tf_breaches *breaches, const tf_tangle *tangle,
                          const tf_curves *curves, const tf_regions *regions,
                          const double x[])
{
    const tf_neighbors *all = &tangle->near;
    if (!tf_buffer_extend(&breaches->storage, curves->count + 1,
                          sizeof(tf_breach)))
        return false;
    tf_breach *to = breaches->storage.data;
    size_t count = 0;
    for (size_t i = 0; i < curves->count; i++) {
        int wrong = tf_wrong_end(regions, all, &curves->point[i]);
        if (wrong >= 0)
            to[count++] = breach_of(regions, all, x, &curves->point[i], wrong);
    }
    breaches->count = count;
    return tf_list_sort(&breaches->storage, count, sizeof(tf_breach),
                        breach_precedes, &breaches->sorting, tangle->watch);
}

//: Vote on pairs of regions
static tf_region_pair vote(const tf_regions *regions, const tf_neighbors *all,
                           const double x[], const tf_breach *breach,
                           int vertex)
{
    tf_vector out =
        tf_vector_difference(tf_place(all, x, vertex), breach->place);
    return (tf_region_pair){.region = breach->region,
                            .other = regions->region[vertex],
                            .near =
                                tf_vector_dot(out, breach->inward) > 0 ? 1 : -1,
                            .all = 1};
}

static bool pair_precedes(const void *first, const void *second)
{
    const tf_region_pair *a = first, *b = second;
    return a->region != b->region ? a->region < b->region : a->other < b->other;
}

//: Add up the votes of equal pairs
static size_t add_votes(size_t count, tf_region_pair pair[])
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        tf_region_pair *last = kept > 0 ? &pair[kept - 1] : NULL;
        if (last && last->region == pair[i].region &&
            last->other == pair[i].other) {
            last->near += pair[i].near;
            last->all++;
        } else {
            pair[kept++] = pair[i];
        }
    }
    return kept;
}

//: List pairs of regions
static bool list_pairs(tf_breaches *breaches, const tf_tangle *tangle,
                       const tf_regions *regions, const double x[])
{
    const tf_neighbors *all = &tangle->near;
    size_t count = 0, corners = (size_t)all->axes;
    const tf_breach *breach = breaches->storage.data;
    if (!tf_buffer_extend(&breaches->pair_storage,
                          corners * breaches->count + 1,
                          sizeof(tf_region_pair)))
        return false;
    tf_region_pair *pair = breaches->pair_storage.data;
    for (size_t i = 0; i < breaches->count; i++)
        for (int c = 0; c < all->axes; c++) {
            ptrdiff_t place = (ptrdiff_t)all->axes * breach[i].facet + c;
            pair[count++] =
                vote(regions, all, x, &breach[i], all->facet[place]);
        }
    if (!tf_list_sort(&breaches->pair_storage, count, sizeof *pair,
                      pair_precedes, &breaches->sorting, tangle->watch))
        return false;
    breaches->pair = breaches->pair_storage.data;
    breaches->pairs = add_votes(count, breaches->pair_storage.data);
    return true;
}

//: Add up the sides of breaches
static bool list_sides(tf_breaches *breaches)
{
    if (!tf_buffer_extend(&breaches->side_storage, breaches->count + 1,
                          sizeof(tf_region_side)))
        return false;
    tf_region_side *side = breaches->side_storage.data;
    size_t kept = 0;
    for (size_t i = 0; i < breaches->count; i++) {
        const tf_breach *own = &breaches->breach[i];
        if (kept == 0 || side[kept - 1].region != own->region ||
            side[kept - 1].sheet != own->sheet)
            side[kept++] = (tf_region_side){own->region, own->sheet, 0, 0, i};
        side[kept - 1].sum += own->side;
        side[kept - 1].all++;
    }
    breaches->side = side;
    breaches->sides = kept;
    return true;
}

//: Find breaches
bool tf_breaches_find(tf_breaches *breaches, const tf_tangle *tangle,
                      const tf_curves *curves, const tf_regions *regions,
                      const double x[])
{
    if (!list_breaches(breaches, tangle, curves, regions, x))
        return false;
    breaches->breach = breaches->storage.data;
    return list_pairs(breaches, tangle, regions, x) && list_sides(breaches);
}

void tf_breaches_free(tf_breaches *breaches)
{
    tf_buffer_free(&breaches->storage);
    tf_buffer_free(&breaches->pair_storage);
    tf_buffer_free(&breaches->side_storage);
    tf_sort_memory_free(&breaches->sorting);
}
