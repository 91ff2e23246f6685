//: Include what queries need
#include "query/query.h"

#include "arithmetic/functions.h"
#include "base/environment.h"
#include "base/require.h"
#include "intersect/cascade.h"
#include "intersect/normal.h"
#include "intersect/separation.h"
#include "intersect/velocity.h"

#include <math.h>
#include <stddef.h>

//: Check the coordinates
static tf_status check_coordinates(const tf_arithmetic *arithmetic, int axes,
                                   int vertices, const tf_worldline element[])
{
    for (int i = 0; i < vertices; i++)
        for (int k = 0; k < axes; k++)
            for (int t = 0; t < 2; t++) {
                double x = element[i].at[t].x[k];
                if (!isfinite(x))
                    return TF_NOT_FINITE;
                if (arithmetic->bits[axes] != 0 &&
                    !tf_arithmetic_holds(arithmetic, axes, x))
                    return TF_OUT_OF_RANGE;
            }
    return TF_OK;
}

//: Check the indices
/// Whether all vertices have an index of their own, or none has one, if the
/// arithmetic allows that.
static bool indices_are_good(const tf_arithmetic *arithmetic, int count,
                             const int index[])
{
    int least = arithmetic->needs_indices ? 0 : TF_NO_INDEX;
    for (int i = 0; i < count; i++) {
        if (index[i] < least || (index[i] < 0) != (index[0] < 0))
            return false;
        for (int j = 0; j < i; j++)
            if (index[j] == index[i] && index[i] >= 0)
                return false;
    }
    return true;
}

//: Hold an element in order
/// The vertices of an element in increasing index, or, without indices, in
/// their given order.
typedef struct ordered_element {
    int vertices;
    const tf_worldline *vertex; ///< the given ones, or `copy`
    tf_worldline copy[TF_VERTICES];
    int source[TF_VERTICES]; ///< which vertex of the given element each is
    int parity; ///< +1: ordered by an even number of swaps, -1: odd
} ordered_element;

//: Order the vertices of an element
static void order_vertices(int vertices, const tf_worldline given[],
                           ordered_element *ordered)
{
    ordered->vertices = vertices;
    ordered->vertex = given;
    ordered->parity = 1;
    for (int i = 0; i < vertices; i++) {
        int to = i, index = given[i].at[0].vertex;
        for (; to > 0; to--) {
            if (given[ordered->source[to - 1]].at[0].vertex <= index)
                break;
            ordered->source[to] = ordered->source[to - 1];
            ordered->parity = -ordered->parity;
            ordered->vertex = ordered->copy;
        }
        ordered->source[to] = i;
    }
    for (int i = 0; i < vertices && ordered->vertex != given; i++)
        ordered->copy[i] = given[ordered->source[i]];
}

//: Check a query
static tf_status check_query(const tf_arithmetic *arithmetic, int axes,
                             int vertices, const tf_worldline first[],
                             int others, const tf_worldline second[])
{
    //: Check what the caller promises
    TF_REQUIRE(axes == 2 || axes == 3);
    TF_REQUIRE(vertices >= 1 && others >= 1 && vertices + others == axes + 1);

    //: Check what the input holds
    int index[TF_AXES + 1];
    for (int i = 0; i < vertices; i++)
        index[i] = first[i].at[0].vertex;
    for (int i = 0; i < others; i++)
        index[vertices + i] = second[i].at[0].vertex;
    if (!indices_are_good(arithmetic, vertices + others, index))
        return TF_BAD_INDEX;
    tf_status status = check_coordinates(arithmetic, axes, vertices, first);
    return status == TF_OK ? check_coordinates(arithmetic, axes, others, second)
                           : status;
}

//: Hold two elements and their sweeps
typedef struct operands {
    int axes;
    ordered_element first, second;
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
} operands;

//: Sweep two elements
static void sweep(int axes, int vertices, const tf_worldline first[],
                  int others, const tf_worldline second[], operands *swept)
{
    swept->axes = axes;
    order_vertices(vertices, first, &swept->first);
    order_vertices(others, second, &swept->second);
    tf_sweep(vertices, swept->first.vertex, swept->s);
    tf_sweep(others, swept->second.vertex, swept->r);
}

//: Decide each pair
enum {
    MOST_PAIRS = 4 // 1 x 3 or 2 x 2
};

/// A pair of simplices that intersect, or perhaps do.
typedef struct candidate {
    const tf_simplex *s, *r;
    tf_pair pair;
    tf_intersection found;
} candidate;

/// Lists the pairs that are not apart, up to the first hit if no more are
/// wanted; returns how many there are.
static int decide_pairs(const tf_arithmetic *arithmetic, const operands *swept,
                        bool stop_at_hit, candidate found[MOST_PAIRS])
{
    int count = 0;
    for (int i = 0; i < swept->first.vertices; i++)
        for (int j = 0; j < swept->second.vertices; j++) {
            // In place: the next pair overwrites one that is apart.
            candidate *c = &found[count];
            c->s = &swept->s[i];
            c->r = &swept->r[j];
            tf_pair_set(&c->pair, c->s, c->r, swept->axes);
            c->found = tf_intersect(arithmetic, &c->pair, TF_ONLY_VERDICT);
            count += c->found.verdict != TF_APART;
            if (stop_at_hit && c->found.verdict == TF_HIT)
                return count;
        }
    return count;
}

//: Find the first of all intersections
static bool is_at_start(const tf_intersection *found)
{
    return found->verdict == TF_HIT && found->toi_hi == 0;
}

/// Of one or more candidates the one that intersects first, with what is known
/// about the first contact of all.
static const candidate *find_first(const tf_arithmetic *arithmetic, int count,
                                   candidate c[MOST_PAIRS])
{
    //: Compare the times of several
    candidate *first = c;
    tf_intersection earliest = tf_intersection_apart;
    for (int i = 0; i < count && count > 1 && !is_at_start(&earliest); i++) {
        tf_intersection_describe(arithmetic, &c[i].pair, TF_WITH_TIME,
                                 &c[i].found);
        if (c[i].found.toi_lo < earliest.toi_lo)
            first = &c[i];
        earliest = tf_intersection_earlier(&earliest, &c[i].found);
    }

    //: Describe the first
    tf_intersection_describe(arithmetic, &first->pair, TF_WITH_POINT,
                             &first->found);
    if (count == 1)
        return first;
    first->found.verdict = earliest.verdict;
    first->found.toi_hi = earliest.toi_hi;
    return first;
}

//: Add up the coordinates of a vertex
/// A vertex gets the sum of the barycentric coordinates of its two events.
static void add_up_vertices(const tf_pair *pair, const tf_intersection *found,
                            int operand, const ordered_element *ordered,
                            double barycentric[TF_VERTICES])
{
    for (int v = 0; v < ordered->vertices; v++) {
        const tf_event *at = ordered->vertex[v].at;
        double sum = 0;
        for (int i = 0; i < pair->count; i++)
            if (pair->operand[i] == operand &&
                (pair->event[i] == &at[0] || pair->event[i] == &at[1]))
                sum += found->barycentric[i];
        barycentric[ordered->source[v]] = sum;
    }
}

//: Describe a contact
static void describe(const tf_arithmetic *arithmetic, const operands *swept,
                     const candidate *first, tf_contact *contact)
{
    const tf_intersection *found = &first->found;
    contact->verdict = found->verdict;
    contact->classification = found->classification;
    contact->toi_lo = found->toi_lo;
    contact->toi_hi = found->toi_hi;
    add_up_vertices(&first->pair, found, +1, &swept->first,
                    contact->barycentric[0]);
    add_up_vertices(&first->pair, found, -1, &swept->second,
                    contact->barycentric[1]);

    //: Turn the normal to the given order of vertices
    int parity = swept->first.parity * swept->second.parity;
    tf_vector normal = tf_vector_scaled(
        parity, tf_contact_normal(arithmetic, swept->axes, first->s, first->r));
    tf_vector velocity = tf_relative_velocity(swept->axes, first->s, first->r);
    for (int k = 0; k < TF_AXES; k++) {
        // Adding zero turns -0 into 0.
        contact->normal[k] = normal.x[k] + 0.0;
        contact->velocity[k] = velocity.x[k];
    }
    contact->normal_velocity = tf_normal_velocity(velocity, normal) + 0.0;
    contact->pivot[0] = swept->first.source[first->s->pivot];
    contact->pivot[1] = swept->second.source[first->r->pivot];
}

//: Query two elements
tf_status tf_query(const tf_arithmetic *arithmetic, int axes, int vertices,
                   const tf_worldline first[], int others,
                   const tf_worldline second[], tf_contact *contact)
{
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    tf_status status =
        check_query(arithmetic, axes, vertices, first, others, second);
    if (status != TF_OK)
        return status;
    static const tf_contact apart = {.verdict = TF_APART};
    *contact = apart;
    if (tf_elements_separated(axes, vertices, first, others, second))
        return TF_OK;

    operands swept;
    candidate candidates[MOST_PAIRS];
    sweep(axes, vertices, first, others, second, &swept);
    int count = decide_pairs(arithmetic, &swept, false, candidates);
    if (count > 0)
        describe(arithmetic, &swept, find_first(arithmetic, count, candidates),
                 contact);
    return TF_OK;
}

//: Take the elements of a scene
typedef struct scene_query {
    tf_worldline first[TF_VERTICES], second[TF_VERTICES];
} scene_query;

/// Makes the event in place: to copy a worldline costs more than to make it.
static void gather_event(int axes, const double x[], int t, int vertex,
                         tf_event *event)
{
    for (int k = 0; k < TF_AXES; k++)
        event->x[k] = k < axes ? x[k] : 0;
    event->t = t;
    event->vertex = vertex;
}

/// False if an index names no vertex.
static bool gather_element(const tf_motion *motion, int axes, int vertices,
                           const int index[], tf_worldline line[])
{
    for (int i = 0; i < vertices; i++) {
        if (index[i] < 0 || index[i] >= motion->vertices)
            return false;
        ptrdiff_t first = (ptrdiff_t)axes * index[i];
        gather_event(axes, motion->start + first, 0, index[i], &line[i].at[0]);
        gather_event(axes, motion->end + first, 1, index[i], &line[i].at[1]);
    }
    return true;
}

static tf_status gather(int axes, const tf_motion *motion, int vertices,
                        const int first[], int others, const int second[],
                        scene_query *query)
{
    TF_REQUIRE(motion && first && second);
    tf_status status = tf_motion_check(motion, axes);
    if (status != TF_OK)
        return status;
    bool good = gather_element(motion, axes, vertices, first, query->first) &&
                gather_element(motion, axes, others, second, query->second);
    return good ? TF_OK : TF_BAD_INDEX;
}

//: Check a motion
tf_status tf_motion_check(const tf_motion *motion, int axes)
{
    bool without = motion->vertices > 0 && !(motion->start && motion->end);
    if (motion->axes != axes)
        return TF_BAD_AXES;
    return motion->vertices < 0 || without ? TF_BAD_COUNT : TF_OK;
}

//: Query two elements of a scene
tf_status tf_query_motion(const tf_arithmetic *arithmetic, int axes,
                          const tf_motion *motion, int vertices,
                          const int first[], int others, const int second[],
                          tf_contact *contact)
{
    TF_REQUIRE(arithmetic && contact);
    scene_query query;
    tf_status status =
        gather(axes, motion, vertices, first, others, second, &query);
    if (status != TF_OK)
        return status;
    return tf_query(arithmetic, axes, vertices, query.first, others,
                    query.second, contact);
}

//: Find the verdict alone
tf_status tf_query_verdict(const tf_arithmetic *arithmetic, int axes,
                           const tf_motion *motion, int vertices,
                           const int first[], int others, const int second[],
                           tf_verdict *verdict, bool *separated)
{
    TF_REQUIRE(arithmetic && verdict && separated);
    scene_query query;
    tf_status status =
        gather(axes, motion, vertices, first, others, second, &query);
    if (status == TF_OK)
        status = check_query(arithmetic, axes, vertices, query.first, others,
                             query.second);
    if (status != TF_OK)
        return status;
    *verdict = TF_APART;
    *separated = tf_elements_separated(axes, vertices, query.first, others,
                                       query.second);
    if (*separated)
        return TF_OK;

    operands swept;
    candidate found[MOST_PAIRS];
    sweep(axes, vertices, query.first, others, query.second, &swept);
    int count = decide_pairs(arithmetic, &swept, true, found);
    if (count > 0)
        *verdict = found[count - 1].found.verdict;
    return TF_OK;
}
