//: Include what the push needs
#include "untangle/push.h"

#include "distance/nearest.h"
#include "untangle/gradient.h"

#include <stdlib.h>
#include <string.h>

//: Begin to push
bool tf_push_begin(tf_push *push, const tf_tangle *tangle)
{
    const tf_neighbors *all = &tangle->near;
    size_t count = (size_t)all->parts + 2 * (size_t)all->facets;
    if (!tf_buffer_reserve(&push->storage, count, sizeof(int)))
        return false;
    push->preferred = push->storage.data;
    push->stamp = push->preferred + all->parts;
    push->target = push->stamp + all->facets;
    memset(push->preferred, -1, sizeof(int) * (size_t)all->parts);
    return true;
}

void tf_push_free(tf_push *push)
{
    tf_curves_free(&push->curves);
    tf_regions_free(&push->regions);
    tf_breaches_free(&push->breaches);
    tf_buffer_free(&push->storage);
}

//: Prefer the other half of a part
/// Whether a pair shows that the halves of two parts are taken the wrong way
/// around: the other region is wrong, nearly as large as the right one of its
/// part, and on the side of the curve where the pair's region is not.
static bool is_other_half(const tf_push *push, const tf_neighbors *all,
                          const tf_region_pair *pair)
{
    const tf_regions *regions = &push->regions;
    int part = tf_region_part(regions, all, pair->other);
    return part != tf_region_part(regions, all, pair->region) &&
           pair->all >= 4 && 3 * pair->near <= -pair->all &&
           push->preferred[part] < 0 &&
           tf_is_wrong(regions, all, pair->other) &&
           regions->size[pair->other] >=
               0.7 * regions->size[regions->right[part]];
}

static bool prefer_other_half(tf_push *push, const tf_neighbors *all)
{
    for (size_t i = 0; i < push->breaches.pairs; i++) {
        const tf_region_pair *pair = &push->breaches.pair[i];
        if (!is_other_half(push, all, pair))
            continue;
        const tf_lists *members = &push->regions.members;
        int vertex = members->item[members->start[pair->other]];
        push->preferred[all->part[vertex]] = vertex;
        return true;
    }
    return false;
}

//: Find what is wrong
static bool find_wrong(tf_push *push, const tf_tangle *tangle, const double x[])
{
    if (!tf_curves_find(&push->curves, tangle, x))
        return false;
    do {
        if (!tf_regions_find(&push->regions, tangle, &push->curves,
                             push->preferred) ||
            !tf_breaches_find(&push->breaches, tangle, &push->curves,
                              &push->regions, x))
            return false;
    } while (push->acute && prefer_other_half(push, &tangle->near));
    return true;
}

//: Add targets
static void add_target(tf_push *push, int region, int facet)
{
    if (push->stamp[facet] == region)
        return;
    push->stamp[facet] = region;
    push->target[push->targets++] = facet;
}

static void add_targets_at(tf_push *push, const tf_neighbors *all, int region,
                           int vertex)
{
    const tf_lists *at = &all->facets_at;
    for (int i = at->start[vertex]; i < at->start[vertex + 1]; i++)
        add_target(push, region, at->item[i]);
}

//: Add the facets around the breaches of a region
/// The breaches and pairs of a region.
typedef struct range {
    int region;
    size_t breach, breaches, pair, pairs, side, sides;
} range;

static void add_breached(tf_push *push, const tf_neighbors *all,
                         const range *own)
{
    for (size_t i = own->breach; i < own->breaches; i++)
        add_target(push, own->region, push->breaches.breach[i].facet);
    int count = push->targets;
    for (int i = 0; i < count; i++)
        for (int c = 0; c < all->axes; c++) {
            ptrdiff_t place = (ptrdiff_t)all->axes * push->target[i] + c;
            add_targets_at(push, all, own->region, all->facet[place]);
        }
}

//: Add the facets of paired regions
/// But of none that is right.  Returns whether one of them is wrong, and not tiny.
static bool add_paired(tf_push *push, const tf_neighbors *all, const range *own)
{
    const tf_regions *regions = &push->regions;
    bool has_wrong = false;
    for (size_t i = own->pair; i < own->pairs; i++) {
        int other = push->breaches.pair[i].other;
        int part = tf_region_part(regions, all, other);
        if (other == own->region || part < 0)
            continue;
        if (tf_is_wrong(regions, all, other) &&
            regions->size[other] > 0.05 * regions->size[own->region])
            has_wrong = true;
        if (regions->size[other] >= regions->size[regions->right[part]])
            continue;
        const tf_lists *members = &regions->members;
        for (int j = members->start[other]; j < members->start[other + 1]; j++)
            add_targets_at(push, all, own->region, members->item[j]);
    }
    return has_wrong;
}

//: Drop the facets of the region itself
static bool has_corner_in(const tf_push *push, const tf_neighbors *all,
                          int facet, int region)
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * facet;
    for (int c = 0; c < all->axes; c++)
        if (push->regions.region[corner[c]] == region)
            return true;
    return false;
}

/// Unless these are all.
static void drop_own(tf_push *push, const tf_neighbors *all, int region)
{
    int kept = 0;
    for (int pass = 0; pass < 2 && (pass == 0 || kept > 0); pass++) {
        int count = 0;
        for (int i = 0; i < push->targets; i++)
            if (!has_corner_in(push, all, push->target[i], region)) {
                if (pass > 0)
                    push->target[count] = push->target[i];
                count++;
            }
        kept = count;
        if (pass > 0)
            push->targets = count;
    }
}

//: Add the facets on the acute side
/// The nearest of some breaches to a place, or -1.
static ptrdiff_t nearest_breach(const tf_push *push, size_t begin, size_t end,
                                tf_vector place)
{
    double least = INFINITY;
    ptrdiff_t nearest = -1;
    for (size_t i = begin; i < end; i++) {
        tf_vector way =
            tf_vector_difference(place, push->breaches.breach[i].place);
        double square = tf_vector_dot(way, way);
        if (square < least) {
            least = square;
            nearest = (ptrdiff_t)i;
        }
    }
    return nearest;
}

static tf_vector middle_of(const tf_neighbors *all, const double x[], int facet)
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * facet;
    tf_vector sum = {{0, 0, 0}};
    for (int c = 0; c < all->axes; c++)
        sum = tf_vector_sum(sum, 1, tf_place(all, x, corner[c]));
    return tf_vector_scaled(1.0 / all->axes, sum);
}

static bool is_paired(const tf_push *push, const tf_neighbors *all,
                      const range *own, int part)
{
    for (size_t i = own->pair; i < own->pairs; i++) {
        int other = push->breaches.pair[i].other;
        if (tf_region_part(&push->regions, all, other) == part)
            return true;
    }
    return false;
}

/// Those of all paired parts that lie where the region does, seen from the nearest
/// breach.
static bool add_acute(tf_push *push, const tf_tangle *tangle, const double x[],
                      const range *own)
{
    const tf_neighbors *all = &tangle->near;
    for (int f = 0; f < all->facets; f++) {
        int vertex = all->facet[(ptrdiff_t)all->axes * f];
        if (!is_paired(push, all, own, all->part[vertex]))
            continue;
        tf_vector middle = middle_of(all, x, f);
        ptrdiff_t near =
            nearest_breach(push, own->breach, own->breaches, middle);
        const tf_breach *breach = &push->breaches.breach[near];
        if (tf_vector_dot(tf_vector_difference(middle, breach->place),
                          breach->inward) > 0)
            add_target(push, own->region, f);
        if (!tf_watch_work(tangle->watch, own->breaches - own->breach))
            return false;
    }
    return true;
}

//: List the targets of a region
static bool list_targets(tf_push *push, const tf_tangle *tangle,
                         const double x[], const range *own)
{
    const tf_neighbors *all = &tangle->near;
    push->targets = 0;
    add_breached(push, all, own);
    bool has_wrong = add_paired(push, all, own);
    if (!has_wrong && push->acute && push->regions.size[own->region] > 20 &&
        !add_acute(push, tangle, x, own))
        return false;
    drop_own(push, all, own->region);
    return true;
}

//: Find the nearest target of a vertex
/// Where a vertex is nearest to a facet.
typedef struct landing {
    int facet;        ///< -1: nowhere
    double weight[3]; ///< barycentric coordinates
    tf_vector out;    ///< from there to the vertex
    double distance;
} landing;

static landing land(const tf_neighbors *all, const double x[], int vertex,
                    int facet)
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * facet;
    const double *place[4] = {x + (ptrdiff_t)all->axes * vertex};
    for (int c = 0; c < all->axes; c++)
        place[1 + c] = x + (ptrdiff_t)all->axes * corner[c];
    tf_nearest found = tf_nearest_of(
        all->axes == 2 ? TF_POINT_EDGE : TF_POINT_TRIANGLE, place);
    landing own = {.facet = facet, .out = tf_place(all, x, vertex)};
    for (int c = 0; c < all->axes; c++) {
        own.weight[c] = found.barycentric[1][c];
        own.out =
            tf_vector_sum(own.out, -own.weight[c], tf_place(all, x, corner[c]));
    }
    own.distance = tf_vector_length(own.out);
    return own;
}

static landing land_nearest(const tf_push *push, const tf_neighbors *all,
                            const double x[], int vertex)
{
    landing best = {.facet = -1, .distance = INFINITY};
    for (int i = 0; i < push->targets; i++) {
        const int *corner = all->facet + (ptrdiff_t)all->axes * push->target[i];
        bool own = false;
        for (int c = 0; c < all->axes; c++)
            own = own || corner[c] == vertex;
        landing next = own ? best : land(all, x, vertex, push->target[i]);
        if (next.distance < best.distance)
            best = next;
    }
    return best;
}

//: Find on which side of a facet a vertex is right
/// 1: where the normal of the facet's sheet points to; -1: on the other side; 0:
/// the region has no breach of the sheet.  The breaches vote; if they disagree,
/// the nearest one decides.
static int side_of(const tf_push *push, const tf_neighbors *all,
                   const range *own, int facet, tf_vector place)
{
    for (size_t i = own->side; i < own->sides; i++) {
        const tf_region_side *side = &push->breaches.side[i];
        if (side->sheet != all->sheet[facet])
            continue;
        if (2 * abs(side->sum) > side->all)
            return side->sum > 0 ? 1 : -1;
        ptrdiff_t near = nearest_breach(push, side->first,
                                        side->first + (size_t)side->all, place);
        return push->breaches.breach[near].side;
    }
    return 0;
}

//: Push a vertex out
/// Where a vertex has to go from its landing: along the facet's normal or, if the
/// landing is at the facet's rim, to the landing; sets by how much it is beyond.
static tf_vector way_out(const landing *own, tf_vector normal, double *gap)
{
    *gap = tf_vector_dot(own->out, normal);
    if (*gap >= 0 || own->distance <= 2 * fabs(*gap))
        return normal;
    *gap = -own->distance;
    return tf_vector_scaled(-1 / own->distance, own->out);
}

static void push_vertex(const tf_push *push, const tf_tangle *tangle,
                        const double x[], const range *own, int vertex,
                        tf_change *change)
{
    const tf_neighbors *all = &tangle->near;
    landing at = land_nearest(push, all, x, vertex);
    if (at.facet < 0)
        return;
    int side = side_of(push, all, own, at.facet, tf_place(all, x, vertex));
    double gap = 0;
    tf_vector normal = tf_facet_normal(all, x, at.facet);
    tf_vector way = way_out(&at, tf_vector_scaled(side, normal), &gap);
    double missing = tangle->edge / 10 - gap;
    if (side == 0 || missing <= 0)
        return;
    const int *corner = all->facet + (ptrdiff_t)all->axes * at.facet;
    bool alone =
        tangle->fixed[vertex] || tf_are_fixed(tangle, all->axes, corner);
    double length = alone ? missing : missing / 2;
    tf_change_add(change, tangle, vertex, way, length, 1);
    for (int c = 0; c < all->axes; c++)
        tf_change_add(change, tangle, corner[c], way, -length, at.weight[c]);
}

//: Push a region out
static bool push_region(tf_push *push, const tf_tangle *tangle,
                        const double x[], const range *own, tf_change *change)
{
    const tf_lists *members = &push->regions.members;
    if (!list_targets(push, tangle, x, own))
        return false;
    for (int i = members->start[own->region];
         i < members->start[own->region + 1]; i++) {
        push_vertex(push, tangle, x, own, members->item[i], change);
        if (!tf_watch_work(tangle->watch, (size_t)push->targets))
            return false;
    }
    return true;
}

//: Go from one region to the next
/// The breaches, pairs and sides of the next region, after those of the last one.
static range next_range(const tf_breaches *all, const range *last)
{
    range own = {.region = all->breach[last->breaches].region,
                 .breach = last->breaches,
                 .breaches = last->breaches,
                 .pair = last->pairs,
                 .pairs = last->pairs,
                 .side = last->sides,
                 .sides = last->sides};
    while (own.breaches < all->count &&
           all->breach[own.breaches].region == own.region)
        own.breaches++;
    while (own.pairs < all->pairs && all->pair[own.pairs].region == own.region)
        own.pairs++;
    while (own.sides < all->sides && all->side[own.sides].region == own.region)
        own.sides++;
    return own;
}

//: Propose a push
bool tf_push_propose(tf_push *push, const tf_tangle *tangle, const double x[],
                     tf_change *change)
{
    const tf_neighbors *all = &tangle->near;
    if (!find_wrong(push, tangle, x))
        return false;
    for (size_t i = 0; i < push->curves.count; i++)
        if (tf_wrong_end(&push->regions, all, &push->curves.point[i]) < 0)
            tf_shorten_curve(change, tangle, x, &push->curves.point[i]);
    memset(push->stamp, -1, sizeof(int) * (size_t)all->facets);
    for (range own = {0}; own.breaches < push->breaches.count;) {
        own = next_range(&push->breaches, &own);
        if (!push_region(push, tangle, x, &own, change))
            return false;
    }
    return true;
}
