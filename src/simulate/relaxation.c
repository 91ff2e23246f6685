//: Include what relaxation needs
#include "simulate/relaxation.h"

#include "base/always_inline.h"
#include "geometry/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SWEEPS = 20 // over all elements and contacts
};

/// Springs become rigid when they are longer than at rest by this factor.
static const double limit = 1.04;

/// Vertices may move unnoticed by this part of the mean rest length.
static const double tolerance = 1e-5;

//: Hold the relaxation
/// An elastic element as it is relaxed.
typedef struct bond {
    int count, vertex[4];
    double weight[4];
    double share[4];   ///< how far a unit impulse moves each vertex
    double rest;       ///< the length that its sum wants to have
    double limit;      ///< the length that its sum is not to exceed
    double reach;      ///< how much a unit impulse changes its sum
    double compliance; ///< how much longer a unit impulse makes it
    double yield;      ///< 1 / (reach + compliance)
    tf_vector impulse; ///< how hard it pulls
} bond;

/// A contact as it is relaxed.
typedef struct stop {
    int vertex[4];
    double weight[4], share[4];
    double reach;    ///< how much a unit impulse widens the gap
    double coulomb;  ///< the coefficient of its friction
    tf_vector start; ///< the gap, as a vector, at the start
    tf_vector normal;
    double impulse;
    tf_vector friction;
} stop;

struct tf_relaxation {
    int axes, vertices;
    double *inverse_mass;
    int bonds;
    bond *bond;
    size_t stops, room;
    stop *stop;
    double unnoticed; ///< the square of how far a vertex may move unnoticed
    int sweep;        ///< which one is made, from 1
    int *moved;       ///< of each vertex: in which sweep it moved last
    tf_vector *start, *at; ///< where the vertices were, and where they are
};

//: Prepare elastic elements to be relaxed
static bond bond_of(const tf_elastic *elastic, double step,
                    const double inverse_mass[])
{
    bool spring = elastic->count == 2 && elastic->rest > 0;
    bond b = {.count = elastic->count,
              .rest = elastic->rest,
              .limit = spring ? limit * elastic->rest : INFINITY,
              .compliance = 1 / (step * step * elastic->stiffness)};
    for (int i = 0; i < elastic->count; i++) {
        b.vertex[i] = elastic->vertex[i];
        b.weight[i] = elastic->weight[i];
        b.share[i] = b.weight[i] * inverse_mass[b.vertex[i]];
        b.reach += b.weight[i] * b.share[i];
    }
    b.yield = 1 / (b.reach + b.compliance);
    return b;
}

static void add_bonds(tf_relaxation *r, const tf_body *body, double step)
{
    for (int i = 0; i < body->elastics; i++) {
        bond b = bond_of(&body->elastic[i], step, r->inverse_mass);
        if (b.reach > 0 && body->elastic[i].stiffness > 0)
            r->bond[r->bonds++] = b;
    }
}

/// The mean rest length of the bonds that have one.
static double mean_rest(const tf_relaxation *r)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < r->bonds; i++) {
        sum += r->bond[i].rest;
        count += r->bond[i].rest > 0;
    }
    return count > 0 ? sum / count : 0;
}

//: Prepare a relaxation
static bool prepare_relaxation(tf_relaxation *r, const tf_body *body,
                               double step)
{
    size_t vertices = (size_t)body->vertices;
    r->axes = body->axes;
    r->vertices = body->vertices;
    r->inverse_mass = malloc(sizeof *r->inverse_mass * (vertices + 1));
    r->start = calloc(vertices + 1, sizeof *r->start);
    r->at = calloc(vertices + 1, sizeof *r->at);
    r->moved = calloc(vertices + 1, sizeof *r->moved);
    r->bond = malloc(sizeof *r->bond * ((size_t)body->elastics + 1));
    if (!r->inverse_mass || !r->start || !r->at || !r->moved || !r->bond)
        return false;
    for (size_t v = 0; v < vertices; v++)
        r->inverse_mass[v] = body->mass[v] > 0 ? 1 / body->mass[v] : 0;
    add_bonds(r, body, step);
    r->unnoticed = pow(tolerance * mean_rest(r), 2);
    return true;
}

//: Make and free a relaxation
tf_status tf_relaxation_create(const tf_body *body, double step,
                               tf_relaxation **relaxation)
{
    tf_relaxation *r = calloc(1, sizeof *r);
    if (!r)
        return TF_OUT_OF_MEMORY;
    if (!prepare_relaxation(r, body, step)) {
        tf_relaxation_free(r);
        return TF_OUT_OF_MEMORY;
    }
    *relaxation = r;
    return TF_OK;
}

void tf_relaxation_free(tf_relaxation *relaxation)
{
    if (!relaxation)
        return;
    free(relaxation->inverse_mass);
    free(relaxation->start);
    free(relaxation->at);
    free(relaxation->moved);
    free(relaxation->bond);
    free(relaxation->stop);
    free(relaxation);
}

//: Push vertices by an impulse
TF_ALWAYS_INLINE tf_vector weighted_sum(int count, const int vertex[],
                                        const double weight[],
                                        const tf_vector at[])
{
    tf_vector sum = tf_vector_scaled(weight[0], at[vertex[0]]);
    for (int i = 1; i < count; i++)
        sum = tf_vector_sum(sum, weight[i], at[vertex[i]]);
    return sum;
}

/// Notes which vertices have moved.
TF_ALWAYS_INLINE void push_vertices(const tf_relaxation *r, int count,
                                    const int vertex[], const double share[],
                                    tf_vector impulse)
{
    double square = tf_vector_dot(impulse, impulse);
    for (int i = 0; i < count; i++) {
        tf_vector *at = &r->at[vertex[i]];
        *at = tf_vector_sum(*at, share[i], impulse);
        if (share[i] * share[i] * square > r->unnoticed)
            r->moved[vertex[i]] = r->sweep;
    }
}

//: See what is to be visited
/// Whether something is to be visited, as one of its vertices has moved in this
/// sweep or the last one.
TF_ALWAYS_INLINE bool is_due(const tf_relaxation *r, int count,
                             const int vertex[])
{
    bool due = false;
    for (int i = 0; i < count; i++)
        due |= r->moved[vertex[i]] >= r->sweep - 1;
    return due;
}

/// Makes what has one of these vertices due.
static void call_on(const tf_relaxation *r, const int vertex[4],
                    const double weight[4])
{
    for (int i = 0; i < 4; i++)
        if (weight[i] != 0)
            r->moved[vertex[i]] = r->sweep;
}

//: Visit an elastic element
/// What has to be added to the sum of a bond so that it has its rest length, as
/// a multiple of the sum.
TF_ALWAYS_INLINE double lack_of(const bond *b, tf_vector sum)
{
    if (b->rest == 0)
        return -1;
    double length = tf_vector_length(sum);
    return length > 0 ? b->rest / length - 1 : -1;
}

static bool is_too_long(const bond *b, tf_vector sum)
{
    return tf_vector_dot(sum, sum) > b->limit * b->limit;
}

/// Sets the impulse of a bond to what its sum and its compliance ask for, and
/// shortens what is longer than the limit.
TF_ALWAYS_INLINE tf_vector answer_of(bond *b, tf_vector sum)
{
    tf_vector wrong = tf_vector_scaled(lack_of(b, sum), sum);
    wrong = tf_vector_sum(wrong, -b->compliance, b->impulse);
    tf_vector impulse = tf_vector_scaled(b->yield, wrong);
    b->impulse = tf_vector_sum(b->impulse, 1, impulse);
    sum = tf_vector_sum(sum, b->reach, impulse);
    if (!is_too_long(b, sum))
        return impulse;
    double excess = 1 - b->limit / tf_vector_length(sum);
    return tf_vector_sum(impulse, -excess / b->reach, sum);
}

TF_ALWAYS_INLINE void visit_bond(const tf_relaxation *r, bond *b, int count)
{
    if (!is_due(r, count, b->vertex))
        return;
    tf_vector sum = weighted_sum(count, b->vertex, b->weight, r->at);
    push_vertices(r, count, b->vertex, b->share, answer_of(b, sum));
}

//: Visit a contact
static tf_vector shortened(tf_vector v, double most)
{
    double length = tf_vector_length(v);
    return length > most ? tf_vector_scaled(most / length, v) : v;
}

static void visit_stop(const tf_relaxation *r, stop *s)
{
    tf_vector change = tf_vector_difference(
        weighted_sum(4, s->vertex, s->weight, r->at), s->start);
    double apart = tf_vector_dot(change, s->normal);
    tf_vector across = tf_vector_sum(change, -apart, s->normal);
    double impulse = fmax(0, s->impulse - apart / s->reach);
    tf_vector grip =
        shortened(tf_vector_sum(s->friction, -1 / s->reach, across),
                  s->coulomb * impulse);
    tf_vector push = tf_vector_sum(tf_vector_difference(grip, s->friction),
                                   impulse - s->impulse, s->normal);
    s->impulse = impulse;
    s->friction = grip;
    push_vertices(r, 4, s->vertex, s->share, push);
}

//: Begin a step
/// Each bond pulls as hard as its length says.
static void begin_bond(const tf_relaxation *r, bond *b)
{
    tf_vector sum = weighted_sum(4, b->vertex, b->weight, r->at);
    if (is_too_long(b, sum))
        call_on(r, b->vertex, b->weight);
    b->impulse = tf_vector_scaled(lack_of(b, sum) / b->compliance, sum);
}

void tf_relaxation_begin(tf_relaxation *r, const double start[],
                         const double end[])
{
    for (int v = 0; v < r->vertices; v++)
        for (int k = 0; k < r->axes; k++) {
            r->start[v].x[k] = start[r->axes * v + k];
            r->at[v].x[k] = end[r->axes * v + k];
        }
    r->sweep = 1;
    memset(r->moved, 0, sizeof *r->moved * (size_t)r->vertices);
    for (int i = 0; i < r->bonds; i++)
        begin_bond(r, &r->bond[i]);
    r->stops = 0;
}

//: Find the friction of a contact
/// The mean of the coefficients of one element's vertices: of those whose weights
/// have this sign.
static double mean_coulomb(const tf_answered_contact *contact, double sign,
                           const double own[])
{
    double sum = 0;
    for (int i = 0; i < 4; i++)
        if (sign * contact->coefficient[i] > 0)
            sum += sign * contact->coefficient[i] * own[contact->vertex[i]];
    return sum;
}

/// As the response finds it.
static double coulomb_of(const tf_answered_contact *contact,
                         const tf_response_options *options)
{
    const double *own = options->vertex_friction;
    return own ? sqrt(mean_coulomb(contact, 1, own)) *
                     sqrt(mean_coulomb(contact, -1, own))
               : options->friction;
}

//: Add contacts
static stop stop_of(const tf_relaxation *r, const tf_answered_contact *contact)
{
    stop s = {.normal = tf_vector_at(contact->normal, 0),
              .impulse = fmax(0, contact->impulse),
              .friction = tf_vector_at(contact->friction, 0)};
    for (int i = 0; i < 4; i++)
        if (contact->coefficient[i] != 0) {
            s.vertex[i] = contact->vertex[i];
            s.weight[i] = contact->coefficient[i];
            s.share[i] = s.weight[i] * r->inverse_mass[s.vertex[i]];
            s.reach += s.weight[i] * s.share[i];
        }
    s.start = weighted_sum(4, s.vertex, s.weight, r->start);
    return s;
}

static bool make_room(tf_relaxation *r, size_t stops)
{
    if (stops <= r->room)
        return true;
    stop *bigger = realloc(r->stop, sizeof *bigger * 2 * stops);
    if (!bigger)
        return false;
    r->stop = bigger;
    r->room = 2 * stops;
    return true;
}

tf_status tf_relaxation_add(tf_relaxation *r,
                            const tf_response_options *options, size_t contacts,
                            const tf_answered_contact contact[])
{
    if (!make_room(r, r->stops + contacts))
        return TF_OUT_OF_MEMORY;
    for (size_t i = 0; i < contacts; i++) {
        stop s = stop_of(r, &contact[i]);
        s.coulomb = coulomb_of(&contact[i], options);
        tf_vector push = tf_vector_sum(s.friction, s.impulse, s.normal);
        push_vertices(r, 4, s.vertex, s.share, push);
        call_on(r, s.vertex, s.weight);
        if (s.reach > 0)
            r->stop[r->stops++] = s;
    }
    return TF_OK;
}

//: Relax
/// Forward and backward in turn, so that neither direction is preferred.
static void sweep(tf_relaxation *r)
{
    bool back = ++r->sweep % 2 == 0;
    for (int i = 0; i < r->bonds; i++) {
        bond *b = &r->bond[back ? r->bonds - 1 - i : i];
        // Springs, which are most, have loops of their own.
        if (b->count == 2)
            visit_bond(r, b, 2);
        else
            visit_bond(r, b, 4);
    }
    for (size_t i = 0; i < r->stops; i++) {
        stop *s = &r->stop[back ? r->stops - 1 - i : i];
        if (is_due(r, 4, s->vertex))
            visit_stop(r, s);
    }
}

void tf_relaxation_run(tf_relaxation *r, double end[])
{
    for (int i = 0; i < SWEEPS; i++)
        sweep(r);
    for (int i = 0; i < r->axes * r->vertices; i++)
        end[i] = r->at[i / r->axes].x[i % r->axes];
}
