#include "support/invariants.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/integer.h"
#include "intersect/cascade.h"
#include "query/narrow_phase.h"
#include "support/contacts.h"
#include "support/judge.h"
#include "support/query_changes.h"

#include <math.h>
#include <stdio.h>

// Time reversed ---------------------------------------------------------------

/// Whether the interval a and the mirrored b may enclose one time.  A sum that
/// exceeds 1 does so after rounding, too, or becomes 1.
static bool mirrors(const tf_intersection *a, const tf_intersection *b)
{
    return a->toi_lo + b->toi_lo <= 1 && a->toi_hi + b->toi_hi >= 1;
}

/// Also lowers `earliest` to the time of the pair, unless it is apart.
static const char *pair_reversal_fault(const tf_pair *forward,
                                       const tf_pair *backward,
                                       double *earliest)
{
    tf_intersection a = tf_intersect(&tf_exact, forward, TF_WITH_TIME);
    tf_intersection b = tf_intersect(&tf_exact, backward, TF_WITH_TIME);
    if (a.verdict != b.verdict)
        return "time reversed: a pair meets in one direction only";
    if (a.verdict == TF_APART)
        return NULL;
    if (a.classification != b.classification || a.unique != b.unique)
        return "time reversed: a pair is classified otherwise";
    if (a.unique ? !mirrors(&a, &b) : a.toi_lo + b.toi_lo > 1)
        return "time reversed: a pair meets at another time";
    *earliest = fmin(*earliest, a.toi_lo);
    return NULL;
}

/// Compares the pairs of simplices, of vertices in index order.
static const char *pairs_reversal_fault(const query *q, const query *reversed,
                                        const tf_contact *exact)
{
    double earliest = INFINITY;
    tf_simplex s[2][TF_VERTICES], r[2][TF_VERTICES];
    tf_sweep(q->vertices, q->vertex, s[0]);
    tf_sweep(q->others, query_const_others(q), r[0]);
    tf_sweep(q->vertices, reversed->vertex, s[1]);
    tf_sweep(q->others, query_const_others(reversed), r[1]);
    for (int i = 0; i < q->vertices; i++)
        for (int j = 0; j < q->others; j++) {
            tf_pair forward = tf_pair_of(&s[0][i], &r[0][j], q->axes);
            tf_pair backward = tf_pair_of(&s[1][q->vertices - 1 - i],
                                          &r[1][q->others - 1 - j], q->axes);
            const char *fault =
                pair_reversal_fault(&forward, &backward, &earliest);
            if (fault)
                return fault;
        }
    return earliest == exact->toi_lo ? NULL
                                     : "the contact is not that of the first "
                                       "pair";
}

const char *reversal_fault(generator *random, const query *q,
                           const tf_contact *exact)
{
    (void)random;
    query reversed = query_reversed(q);
    tf_contact back = ask(&tf_exact, &reversed);
    if (back.verdict != exact->verdict)
        return "time reversed: another verdict";
    if (exact->verdict == TF_APART)
        return NULL;
    if (exact->toi_lo + back.toi_lo > 1)
        return "time reversed: the first contact is after the last";
    return pairs_reversal_fault(q, &reversed, exact);
}

// Other arithmetics -----------------------------------------------------------

static bool holds(const tf_arithmetic *arithmetic, const query *q)
{
    query copy = *q;
    for (int i = 0; i < query_size(q); i++)
        if (!tf_arithmetic_holds(arithmetic, q->axes,
                                 *query_coordinate(&copy, i)))
            return false;
    return true;
}

static const char *integer_fault(const tf_arithmetic *arithmetic,
                                 const query *q, const tf_contact *exact)
{
    if (!holds(arithmetic, q))
        return NULL;
    tf_contact integer = ask(arithmetic, q);
    if (integer.verdict != exact->verdict)
        return "integers: another verdict";
    if (integer.classification != exact->classification)
        return "integers: another classification";
    return contacts_share_time(&integer, exact) ? NULL
                                                : "integers: another time";
}

const char *integers_fault(generator *random, const query *q,
                           const tf_contact *exact)
{
    (void)random;
    const char *fault = integer_fault(&tf_integer64, q, exact);
    return fault ? fault : integer_fault(&tf_integer128, q, exact);
}

const char *clamped_fault(generator *random, const query *q,
                          const tf_contact *exact)
{
    (void)random;
    tf_contact clamped = ask(&tf_clamped, q);
    if (clamped.verdict != TF_UNDECIDED && clamped.verdict != exact->verdict)
        return "clamped: another verdict";
    if (exact->verdict == TF_HIT && !contacts_share_time(&clamped, exact))
        return "clamped: another time";
    return NULL;
}

// One contact -----------------------------------------------------------------

static bool convex(int vertices, const double barycentric[])
{
    double sum = 0;
    for (int i = 0; i < vertices; i++) {
        if (!(barycentric[i] >= 0))
            return false;
        sum += barycentric[i];
    }
    return fabs(sum - 1) <= 1e-12;
}

const char *contact_fault(generator *random, const query *q,
                          const tf_contact *exact)
{
    (void)random;
    if (exact->verdict == TF_APART)
        return NULL;
    if (exact->verdict != TF_HIT)
        return "exact: there is no verdict";
    if (!(0 <= exact->toi_lo && exact->toi_lo <= exact->toi_hi &&
          exact->toi_hi <= 1))
        return "exact: the time is no interval within 0 to 1";
    if (exact->toi_hi - exact->toi_lo > 0x1p-50)
        return "exact: the time is too wide";
    if (!convex(q->vertices, exact->barycentric[0]) ||
        !convex(q->others, exact->barycentric[1]))
        return "exact: the barycentric coordinates are no convex combination";
    return NULL;
}

// Changes ---------------------------------------------------------------------

/// Changes a query and its contact.  True if all of the contact is known then;
/// because of rounding and of ties it may be the verdict and the time only.
typedef bool change(generator *random, query *q, tf_contact *contact);

static void turn_normal(tf_contact *contact)
{
    for (int k = 0; k < TF_AXES; k++)
        contact->normal[k] = 0.0 - contact->normal[k];
    contact->normal_velocity = 0.0 - contact->normal_velocity;
}

static bool turn_axes(generator *random, query *q, tf_contact *contact)
{
    (void)contact;
    int first = below(random, q->axes);
    query_turn_axes(q, first, first == 0 || below(random, 2));
    return false;
}

static bool mirror(generator *random, query *q, tf_contact *contact)
{
    int axis = below(random, q->axes);
    query_mirror(q, axis);

    // A cross product is reflected and turned around.
    turn_normal(contact);
    contact->normal[axis] = 0.0 - contact->normal[axis];
    contact->velocity[axis] = 0.0 - contact->velocity[axis];
    return true;
}

static bool swap_elements(generator *random, query *q, tf_contact *contact)
{
    (void)random;
    (void)contact;
    query_swap_elements(q);
    return false;
}

/// Whether nothing rounded that is made of the coordinates can underflow or
/// overflow, nor after a change of the unit by less than 2^100.
static bool moderate(query *q)
{
    for (int i = 0; i < query_size(q); i++) {
        double x = fabs(*query_coordinate(q, i));
        if (x != 0 && (x < 0x1p-100 || x > 0x1p100))
            return false;
    }
    return true;
}

static bool change_unit(generator *random, query *q, tf_contact *contact)
{
    int exponent = below(random, 200) - 99;
    bool all = moderate(q);
    if (!query_change_unit(q, exponent))
        return true;
    for (int k = 0; k < TF_AXES; k++)
        contact->velocity[k] = ldexp(contact->velocity[k], exponent);
    contact->normal_velocity = ldexp(contact->normal_velocity, exponent);
    return all;
}

static bool swap_vertices(generator *random, query *q, tf_contact *contact)
{
    bool first = q->vertices > 1 && below(random, 2);
    int begin = first ? 0 : q->vertices,
        count = first ? q->vertices : q->others;
    int i = below(random, count),
        j = (i + 1 + below(random, count - 1)) % count;
    double *barycentric = contact->barycentric[!first], own = barycentric[i];
    barycentric[i] = barycentric[j];
    barycentric[j] = own;
    tf_worldline line = q->vertex[begin + i];
    q->vertex[begin + i] = q->vertex[begin + j];
    q->vertex[begin + j] = line;
    turn_normal(contact);
    return true;
}

static const struct {
    change *make;
    const char *fault;
} changes[] = {
    {turn_axes, "axes turned: another answer"},
    {mirror, "an axis mirrored: another answer"},
    {swap_elements, "elements swapped: another answer"},
    {change_unit, "another unit of length: another answer"},
    {swap_vertices, "vertices swapped: another answer"},
};

enum {
    CHANGES = sizeof changes / sizeof *changes
};

const char *change_fault(generator *random, const query *q,
                         const tf_contact *exact)
{
    int i = below(random, CHANGES);
    query changed = *q;
    tf_contact expected = *exact;
    bool all = changes[i].make(random, &changed, &expected);
    tf_contact contact = ask(&tf_exact, &changed);
    bool good = all ? contacts_are_same(&contact, &expected)
                    : contact.verdict == expected.verdict &&
                          contacts_share_time(&contact, &expected);
    return good ? NULL : changes[i].fault;
}

// Many queries ----------------------------------------------------------------

enum {
    VERSIONS = CHANGES + 2, // the query itself and its reverse
    VERTICES = VERSIONS * QUERY_VERTICES
};

/// Versions of a query in one scene.
typedef struct scene {
    int vertices, index[VERTICES];
    double x[2][VERTICES * TF_AXES];
} scene;

/// The query's vertices must be numbered from 0.
static void add(scene *all, const query *q)
{
    int count = q->vertices + q->others, first = all->vertices;
    for (int i = 0; i < count; i++) {
        int vertex = first + q->vertex[i].at[0].vertex;
        all->index[all->vertices++] = vertex;
        for (int t = 0; t < 2; t++)
            for (int k = 0; k < q->axes; k++)
                all->x[t][vertex * q->axes + k] = q->vertex[i].at[t].x[k];
    }
}

static tf_kind kind_of(const query *q)
{
    return q->axes == 2       ? TF_POINT_EDGE
           : q->vertices == 1 ? TF_POINT_TRIANGLE
                              : TF_EDGE_EDGE;
}

const char *batch_fault(generator *random, const query *q,
                        const tf_contact *exact)
{
    scene all;
    all.vertices = 0;
    query reversed = query_reversed(q);
    add(&all, q);
    add(&all, &reversed);
    for (int i = 0; i < CHANGES; i++) {
        query changed = *q;
        tf_contact ignored = *exact;
        changes[i].make(random, &changed, &ignored);
        add(&all, &changed);
    }

    tf_motion motion = {q->axes, all.vertices, all.x[0], all.x[1]};
    tf_queries queries = {kind_of(q), &motion, VERSIONS, all.index};
    tf_verdict verdict[VERSIONS];
    if (tf_reference.decide(NULL, &tf_exact, &queries, verdict, &(size_t){0}) !=
        TF_OK)
        return "a batch is refused";
    for (int i = 0; i < VERSIONS; i++)
        if (verdict[i] != exact->verdict)
            return "another verdict in a batch";
    return NULL;
}
