//: Include what measures need
#include "untangle/measures.h"

#include <string.h>

//: Measure how far vertices have moved
static double distance(const tf_tangle *tangle, const double x[], int vertex)
{
    return tf_vector_length(
        tf_vector_difference(tf_place(&tangle->near, x, vertex),
                             tf_place(&tangle->near, tangle->in, vertex)));
}

double tf_deviation(const tf_tangle *tangle, const double x[])
{
    int vertices = tangle->near.vertices;
    double sum = 0;
    for (int v = 0; v < vertices; v++) {
        double way = distance(tangle, x, v);
        sum += way * way;
    }
    return vertices > 0 ? sqrt(sum / vertices) : 0;
}

static void measure_ways(const tf_tangle *tangle, const double x[],
                         tf_untangle_report *report)
{
    double sum = 0;
    report->moved = 0;
    report->farthest = 0;
    for (int v = 0; v < tangle->near.vertices; v++) {
        if (tf_vector_equals(tf_place(&tangle->near, x, v),
                             tf_place(&tangle->near, tangle->in, v)))
            continue;
        double way = distance(tangle, x, v);
        report->moved++;
        report->farthest = fmax(report->farthest, way);
        sum += way;
    }
    report->mean = report->moved > 0 ? sum / report->moved : 0;
    report->deviation = tf_deviation(tangle, x);
}

//: Measure how edges have stretched
static double edge_length(const tf_neighbors *near, const double x[], int edge)
{
    const int *end = near->edge + 2 * (ptrdiff_t)edge;
    return tf_vector_length(tf_vector_difference(tf_place(near, x, end[0]),
                                                 tf_place(near, x, end[1])));
}

/// Edges that have no length, before or after, don't count.
static void measure_stretch(const tf_tangle *tangle, const double x[],
                            tf_untangle_report *report)
{
    const tf_neighbors *near = &tangle->near;
    report->edge = tangle->edge;
    report->stretched = 0;
    report->stretch = 1;
    for (int e = 0; e < near->edges; e++) {
        double before = edge_length(near, tangle->in, e);
        double after = edge_length(near, x, e);
        double low = fmin(before, after), high = fmax(before, after);
        if (low <= 0)
            continue;
        report->stretched += high > 1.5 * low;
        report->stretch = fmax(report->stretch, high / low);
    }
}

//: Hold the sheets that are measured
typedef struct sheet {
    bool is_open;
    int origin; ///< a vertex of it
    double before, after;
} sheet;

typedef struct sheets {
    const tf_neighbors *near;
    sheet *sheet;
    int *rim; ///< of each edge, in the plane of each vertex: how often facets
              ///< pass it one way more than the other
    tf_buffer storage, rims;
} sheets;

//: Add up the rims of facets
/// What facets share: the edges of a triangle, all but the last from the lower
/// to the higher vertex, and the ends of an edge.
static int side_of(const tf_neighbors *near, const int corner[], int side)
{
    return near->axes == 2
               ? corner[side]
               : tf_edge_of(near, corner[side], corner[(side + 1) % 3]);
}

static void add_rims(sheets *all)
{
    const tf_neighbors *near = all->near;
    for (int f = 0; f < near->facets; f++) {
        const int *corner = near->facet + (ptrdiff_t)near->axes * f;
        for (int i = 0; i < near->axes; i++) {
            int sign = i < near->axes - 1 ? near->turn[f] : -near->turn[f];
            all->rim[side_of(near, corner, i)] += sign;
        }
        all->sheet[near->sheet[f]].origin = corner[0];
    }
}

/// A sheet is closed if its facets, turned as the sheet turns them, have no
/// rim.
static void find_open(sheets *all)
{
    const tf_neighbors *near = all->near;
    for (int f = 0; f < near->facets; f++) {
        const int *corner = near->facet + (ptrdiff_t)near->axes * f;
        for (int i = 0; i < near->axes; i++)
            if (all->rim[side_of(near, corner, i)] != 0)
                all->sheet[near->sheet[f]].is_open = true;
    }
}

//: Measure the volume between a facet and a vertex
/// Signed; in the plane, the area.
static double volume_of(const tf_neighbors *near, const double x[], int facet,
                        int origin)
{
    const int *corner = near->facet + (ptrdiff_t)near->axes * facet;
    tf_vector from = tf_place(near, x, origin), way[3];
    for (int c = 0; c < near->axes; c++)
        way[c] = tf_vector_difference(tf_place(near, x, corner[c]), from);
    tf_vector product = tf_vector_cross(way[0], way[1]);
    double volume =
        near->axes == 2 ? product.x[2] / 2 : tf_vector_dot(product, way[2]) / 6;
    return near->turn[facet] * volume;
}

//: Measure the volumes of sheets
/// The surface has forgotten which side of it is out; so it is the one that
/// makes volumes positive before.
static void measure_volumes(const tf_tangle *tangle, const double x[],
                            sheets *all, tf_untangle_report *report)
{
    const tf_neighbors *near = all->near;
    for (int f = 0; f < near->facets; f++) {
        sheet *own = &all->sheet[near->sheet[f]];
        own->before += volume_of(near, tangle->in, f, own->origin);
        own->after += volume_of(near, x, f, own->origin);
    }
    report->volume_before = report->volume_after = 0;
    report->turned = 0;
    for (int s = 0; s < near->sheets; s++) {
        const sheet *own = &all->sheet[s];
        if (own->is_open)
            continue;
        double sign = own->before < 0 ? -1 : 1;
        report->volume_before += sign * own->before;
        report->volume_after += sign * own->after;
        report->turned += own->before != 0 && sign * own->after < 0;
    }
}

//: Make room for measures
static bool reserve(sheets *all)
{
    const tf_neighbors *near = all->near;
    size_t sides = (size_t)(near->axes == 2 ? near->vertices : near->edges);
    size_t count = (size_t)near->sheets;
    if (!tf_buffer_reserve(&all->storage, count, sizeof *all->sheet) ||
        !tf_buffer_reserve(&all->rims, sides, sizeof *all->rim))
        return false;
    all->sheet = all->storage.data;
    all->rim = all->rims.data;
    if (count > 0)
        memset(all->sheet, 0, count * sizeof *all->sheet);
    if (sides > 0)
        memset(all->rim, 0, sides * sizeof *all->rim);
    return true;
}

//: Scale measures back
static void scale_back(tf_untangle_report *report, int axes, int power)
{
    report->farthest = ldexp(report->farthest, power);
    report->mean = ldexp(report->mean, power);
    report->deviation = ldexp(report->deviation, power);
    report->edge = ldexp(report->edge, power);
    report->volume_before = ldexp(report->volume_before, axes * power);
    report->volume_after = ldexp(report->volume_after, axes * power);
}

//: Measure what an untangling has done
bool tf_measure(const tf_tangle *tangle, const double x[], int power,
                tf_untangle_report *report)
{
    sheets all = {.near = &tangle->near};
    bool has_room = reserve(&all);
    if (has_room) {
        measure_ways(tangle, x, report);
        measure_stretch(tangle, x, report);
        add_rims(&all);
        find_open(&all);
        measure_volumes(tangle, x, &all, report);
        scale_back(report, all.near->axes, power);
    }
    tf_buffer_free(&all.storage);
    tf_buffer_free(&all.rims);
    return has_room;
}
