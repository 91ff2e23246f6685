//: Include what the estimate needs
#include "fast/estimate.h"

#include "fast/determinants.h"

#include <math.h>
#include <stddef.h>

//: Choose when an estimate is good enough
// The weights err by at most TF_SHARE_SURE, 2^-45, as a share of Mx My Mz (see
// fast/lanes.h).  If each is at least this far from zero, it is right to 2^-21 of
// itself, and a coordinate, the quotient of two sums, to about 2^-20.
#define TF_SHARE_GOOD 0x1p-24

//: Hold a pair of pieces
/// A pair of simplices that two elements sweep.
typedef struct pieces {
    int pivot[2];            ///< the place of each one's pivot in its element
    const double *weight[2]; ///< of the events of each; a point has none
} pieces;

/// All pairs of pieces of two elements.
typedef struct all_pieces {
    int corners[2]; ///< how many vertices each element has
    int count;
    pieces pair[4];
} all_pieces;

//: Weigh all pieces
typedef struct weighed_query {
    tf_lane lane;
    tf_lane_evidence shown;
    tf_lane_tetrahedra tetrahedra;
    tf_lane_triangles triangles;
} weighed_query;

static all_pieces weigh_point_triangle(weighed_query *query)
{
    const tf_lane_tetrahedra *w = &query->tetrahedra;
    query->shown = tf_lane_point_triangle(&query->lane, &query->tetrahedra);
    return (all_pieces){{1, 3},
                        3,
                        {{{0, 2}, {NULL, w->ABCc}},
                         {{0, 1}, {NULL, w->ABbc}},
                         {{0, 0}, {NULL, w->Aabc}}}};
}

static all_pieces weigh_edge_edge(weighed_query *query)
{
    const tf_lane_triangles *w = &query->triangles;
    query->shown = tf_lane_edge_edge(&query->lane, &query->triangles);
    return (all_pieces){{2, 2},
                        4,
                        {{{1, 1}, {w->ABb_CDd, w->ABb_CDd + 3}},
                         {{1, 0}, {w->ABb_Ccd, w->ABb_Ccd + 3}},
                         {{0, 1}, {w->Aab_CDd, w->Aab_CDd + 3}},
                         {{0, 0}, {w->Aab_Ccd, w->Aab_Ccd + 3}}}};
}

//: See whether two pieces meet
static tf_lane_range range_of(int count, const double number[])
{
    tf_lane_range range = tf_lane_range_of(number[0], number[0]);
    for (int i = 1; i < count; i++)
        range = tf_lane_union(range, tf_lane_range_of(number[i], number[i]));
    return range;
}

/// The range of all weights of two pieces.
static tf_lane_range range_of_pieces(const all_pieces *all, const pieces *pair)
{
    tf_lane_range range = range_of(all->corners[1] + 1, pair->weight[1]);
    return pair->weight[0] ? tf_lane_union(range, range_of(all->corners[0] + 1,
                                                           pair->weight[0]))
                           : range;
}

//: See when two pieces meet
static double sum_of(int count, const double number[])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += number[i];
    return sum;
}

/// The share of the weights of the events at the end.
static double time_of(int corners, int pivot, const double weight[])
{
    return sum_of(corners - pivot, weight + pivot + 1) /
           sum_of(corners + 1, weight);
}

//: Find the first pieces that meet
/// Sets when they do; NULL if none do, or if it is not certain of each pair, by
/// more than `error`, whether it does.
static const pieces *find_first(const all_pieces *all, double error,
                                double *time)
{
    const pieces *first = NULL;
    *time = INFINITY;
    for (const pieces *pair = all->pair; pair < all->pair + all->count;
         pair++) {
        tf_lane_range range = range_of_pieces(all, pair);
        if (tf_lane_conflict(range) > error)
            continue;
        if (!(tf_lane_agreement(range) > error))
            return NULL;
        double own = time_of(all->corners[1], pair->pivot[1], pair->weight[1]);
        if (!(own < *time))
            continue;
        *time = own;
        first = pair;
    }
    return first;
}

//: Find where they meet
/// A vertex gets the weights of its events, as a share of all.
static void set_coordinates(int corners, int pivot, const double weight[],
                            double barycentric[3])
{
    if (corners == 1) {
        barycentric[0] = 1;
        return;
    }
    double sum = sum_of(corners + 1, weight);
    for (int v = 0; v < corners; v++) {
        double at_start = v <= pivot ? weight[v] : 0;
        double at_end = v >= pivot ? weight[v + 1] : 0;
        barycentric[v] = (at_start + at_end) / sum;
    }
}

//: Multiply two edges of the pieces
/// The edge of a piece from the vertex at `place` of the lane to the next.
static tf_vector edge_of(const tf_lane *lane, int place, bool at_start)
{
    const tf_vector *x = at_start ? lane->start : lane->end;
    return tf_vector_difference(x[place + 1], x[place]);
}

static tf_vector normal_of(const tf_lane *lane, const int corners[2],
                           const int pivot[2])
{
    tf_vector first, second;
    if (corners[0] == 1) {
        first = edge_of(lane, 1, pivot[1] > 0);
        second = edge_of(lane, 2, pivot[1] > 1);
    } else {
        first = edge_of(lane, 0, pivot[0] > 0);
        second = edge_of(lane, 2, pivot[1] > 0);
    }
    return tf_vector_cross(first, second);
}

//: Describe the contact
static tf_vector velocity_of(const tf_lane *lane, int first, int second)
{
    return tf_vector_difference(
        tf_vector_difference(lane->end[first], lane->start[first]),
        tf_vector_difference(lane->end[second], lane->start[second]));
}

static void set_vector(tf_vector v, double length, double to[3])
{
    to[0] = v.x[0] / length;
    to[1] = v.x[1] / length;
    to[2] = v.x[2] / length;
}

/// False if the length of the normal cannot be told.
static bool describe(const tf_lane *lane, const all_pieces *all,
                     const pieces *first, double time, tf_contact *contact)
{
    const int *corners = all->corners, *pivot = first->pivot;
    tf_vector normal = normal_of(lane, corners, pivot);
    double square = tf_vector_dot(normal, normal);
    if (!(square > 0x1p-900 && square < 0x1p900))
        return false;
    tf_vector velocity = velocity_of(lane, pivot[0], corners[0] + pivot[1]);
    static const tf_contact hit = {.verdict = TF_HIT,
                                   .classification = TF_GENERIC};
    *contact = hit;
    contact->toi_lo = contact->toi_hi = time;
    for (int i = 0; i < 2; i++) {
        set_coordinates(corners[i], pivot[i], first->weight[i],
                        contact->barycentric[i]);
        contact->pivot[i] = pivot[i];
    }
    double length = sqrt(square);
    set_vector(normal, length, contact->normal);
    set_vector(velocity, 1, contact->velocity);
    contact->normal_velocity = tf_vector_dot(velocity, normal) / length;
    return true;
}

//: Estimate a contact
bool tf_contact_estimate(tf_kind kind, const tf_motion *motion,
                         const int vertex[4], tf_contact *contact)
{
    if (kind != TF_POINT_TRIANGLE && kind != TF_EDGE_EDGE)
        return false;
    weighed_query query;
    for (int i = 0; i < 4; i++) {
        query.lane.start[i] = tf_vector_at(motion->start, vertex[i]);
        query.lane.end[i] = tf_vector_at(motion->end, vertex[i]);
    }
    all_pieces all = kind == TF_EDGE_EDGE ? weigh_edge_edge(&query)
                                          : weigh_point_triangle(&query);
    double time;
    const pieces *first =
        find_first(&all, TF_SHARE_GOOD * query.shown.volume, &time);
    return first && query.shown.reach <= 0x1p300 &&
           describe(&query.lane, &all, first, time, contact);
}
