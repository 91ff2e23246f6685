//: Include what contacts need
#include "query/contact.h"

#include "spacetime/meet.h"

#include <math.h>

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

//: Hold an element in order
/// The vertices of an element in increasing index, in their given order where
/// they have the same.
typedef struct element {
    int vertices;
    tf_worldline vertex[TF_VERTICES];
    int place[TF_VERTICES]; ///< where the given element has the vertex
    int parity;             ///< +1: ordered by an even number of swaps, -1: odd
} element;

//: Order the vertices of an element
static element order_vertices(int vertices, const tf_worldline given[])
{
    element ordered;
    ordered.vertices = vertices;
    ordered.parity = 1;
    for (int i = 0; i < vertices; i++) {
        int to = i;
        for (; to > 0; to--) {
            if (ordered.vertex[to - 1].at[0].vertex <= given[i].at[0].vertex)
                break;
            ordered.vertex[to] = ordered.vertex[to - 1];
            ordered.place[to] = ordered.place[to - 1];
            ordered.parity = -ordered.parity;
        }
        ordered.vertex[to] = given[i];
        ordered.place[to] = i;
    }
    return ordered;
}

//: Weigh the vertices
/// A vertex weighs what its two events weigh.
static void weigh_vertices(const tf_pair *pair, const tf_meeting *meeting,
                           int side, const element *ordered,
                           double weight[TF_VERTICES])
{
    for (int v = 0; v < ordered->vertices; v++) {
        const tf_event *at = ordered->vertex[v].at;
        double sum = 0;
        for (int i = 0; i < pair->count; i++)
            if (pair->side[i] == side &&
                (pair->event[i] == &at[0] || pair->event[i] == &at[1]))
                sum += meeting->weight[i];
        weight[ordered->place[v]] = sum;
    }
}

//: Gather the horizontal edges
/// Add the edges that a simplex has within t = 0 and within t = 1.
static void add_horizontal_edges(const tf_simplex *simplex,
                                 tf_differences *edges)
{
    for (int i = 1; i < simplex->count; i++) {
        if (i == simplex->mover + 1)
            continue;
        int first = i <= simplex->mover ? 0 : simplex->mover + 1;
        edges->to[edges->n] = simplex->event[i];
        edges->from[edges->n++] = simplex->event[first];
    }
}

//: Multiply the horizontal edges
/// The cross product of the axes - 1 horizontal edges of S and R, each
/// component a determinant, to length 1 and times `parity`; `normal`, zero
/// before, stays so if the edges are dependent or a component overflows.
static void find_normal(const tf_arithmetic *arithmetic, int axes,
                        const tf_simplex *s, const tf_simplex *r, int parity,
                        double normal[TF_AXES])
{
    tf_differences edges = {.n = 0};
    add_horizontal_edges(s, &edges);
    add_horizontal_edges(r, &edges);

    //: Find the components of the cross product
    tf_value component[TF_AXES] = {{0}};
    for (int k = 0; k < axes; k++) {
        // In the order k + 1, k + 2 of space the minors need no sign; in the
        // plane the left normal of (x, y) is (-y, x).
        for (int j = 0; j < axes - 1; j++)
            edges.axis[j] = (k + 1 + j) % axes;
        component[k] = arithmetic->value(&edges);
        if (axes == 2 && k == 0)
            component[k].number = -component[k].number;
        if (!isfinite(component[k].number))
            return;
    }

    //: Scale the cross product to length 1
    tf_values_scale(axes, component);
    double square = 0;
    for (int k = 0; k < axes; k++)
        square += component[k].number * component[k].number;
    // Adding zero turns -0 into 0.
    for (int k = 0; k < axes && square > 0; k++)
        normal[k] = parity * component[k].number / sqrt(square) + 0.0;
}

//: Find the relative velocity
static double saturate(double x)
{
    return fmax(-DBL_MAX, fmin(x, DBL_MAX));
}

/// The displacement of a simplex, that of its mover, times `scale`.
static double displacement(const tf_simplex *simplex, int axis, double scale)
{
    const tf_event *start = simplex->event[simplex->mover];
    const tf_event *end = simplex->event[simplex->mover + 1];
    return end->x[axis] * scale - start->x[axis] * scale;
}

static double relative_velocity(const tf_simplex *s, const tf_simplex *r,
                                int axis)
{
    double plain = displacement(s, axis, 1) - displacement(r, axis, 1);
    if (isfinite(plain))
        return plain;

    // A quarter of two displacements cannot overflow.
    double quarter = displacement(s, axis, 0.25) - displacement(r, axis, 0.25);
    return saturate(4 * quarter);
}

//: Find the speed along the normal
static double dot(const double a[TF_AXES], const double b[TF_AXES],
                  double scale)
{
    return a[0] * scale * b[0] + a[1] * scale * b[1] + a[2] * scale * b[2];
}

static double normal_speed(const double velocity[TF_AXES],
                           const double normal[TF_AXES])
{
    double plain = dot(velocity, normal, 1) + 0.0;
    return isfinite(plain) ? plain : saturate(4 * dot(velocity, normal, 0.25));
}

//: Describe a contact
/// The first meeting of two elements, and the simplices that meet.
typedef struct first_meeting {
    tf_meeting meeting;
    tf_simplex s, r;
    tf_pair pair;
} first_meeting;

static void describe(const tf_arithmetic *arithmetic, int axes, int parity,
                     const first_meeting *found, tf_contact *contact)
{
    contact->verdict = found->meeting.verdict;
    contact->decision = found->meeting.decision;
    contact->toi_lo = found->meeting.toi_lo;
    contact->toi_hi = found->meeting.toi_hi;
    find_normal(arithmetic, axes, &found->s, &found->r, parity,
                contact->normal);
    for (int k = 0; k < axes; k++)
        contact->velocity[k] = relative_velocity(&found->s, &found->r, k);
    contact->speed = normal_speed(contact->velocity, contact->normal);
}

//: Find the first meeting of two sweeps
static void find_first(const tf_arithmetic *arithmetic, int axes,
                       const element *first, const element *second,
                       first_meeting *found)
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(first->vertices, first->vertex, s);
    tf_sweep(second->vertices, second->vertex, r);
    found->meeting = tf_meeting_apart;
    for (int i = 0; i < first->vertices; i++)
        for (int j = 0; j < second->vertices; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], axes);
            tf_meeting own = tf_meet(arithmetic, &pair);
            if (own.verdict == TF_APART)
                continue;
            bool earlier = found->meeting.verdict == TF_APART ||
                           own.toi_lo < found->meeting.toi_lo;
            if (earlier) {
                found->s = s[i];
                found->r = r[j];
                found->pair = pair;
            }
            found->meeting = tf_meeting_earlier(&found->meeting, &own);
        }
}

//: Query two elements
tf_status tf_query(const tf_arithmetic *arithmetic, int axes, int vertices,
                   const tf_worldline first[], int others,
                   const tf_worldline second[], tf_contact *contact)
{
    //: Check what the caller promises
    TF_REQUIRE(axes == 2 || axes == 3);
    TF_REQUIRE(vertices >= 1 && others >= 1 && vertices + others == axes + 1);
    TF_REQUIRE(tf_environment_is_ieee());

    //: Check what the input holds
    tf_status status = check_coordinates(arithmetic, axes, vertices, first);
    if (status == TF_OK)
        status = check_coordinates(arithmetic, axes, others, second);
    if (status != TF_OK)
        return status;

    //: Answer with the first meeting
    element a = order_vertices(vertices, first);
    element b = order_vertices(others, second);
    first_meeting found;
    find_first(arithmetic, axes, &a, &b, &found);
    *contact = (tf_contact){.verdict = found.meeting.verdict};
    if (contact->verdict == TF_APART)
        return TF_OK;
    describe(arithmetic, axes, a.parity * b.parity, &found, contact);
    weigh_vertices(&found.pair, &found.meeting, +1, &a, contact->weight[0]);
    weigh_vertices(&found.pair, &found.meeting, -1, &b, contact->weight[1]);
    return TF_OK;
}
