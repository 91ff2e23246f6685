#include "kit/pushed_pair.h"

#include "arithmetic/exact.h"
#include "query/query.h"
#include "response/contact_constraint.h"
#include "response/impulse.h"

#include <math.h>
#include <string.h>

enum {
    MANY_RETURNS = 4 ///< after which the library tries the pivots, too
};

/// What rounding may leave of a parting of 0.
static const double nothing = 1e-12;

bool fig_pair_meets(const fig_pair *pair, tf_contact *contact)
{
    tf_worldline vertex[FIG_PAIR_VERTICES];
    for (int i = 0; i < pair->count; i++) {
        tf_vector end = fig_sum(pair->start[i], pair->move[i]);
        vertex[i] = tf_worldline_between(pair->axes, pair->start[i].x, end.x);
    }
    tf_query(&tf_exact, pair->axes, pair->first, vertex,
             pair->count - pair->first, vertex + pair->first, contact);
    return contact->verdict == TF_HIT;
}

// Rows -------------------------------------------------------------------

/// The barycentric coordinates of the contact, the second element's negative.
static void share_by_coordinates(const fig_pair *pair,
                                 const tf_contact *contact, double share[])
{
    for (int i = 0; i < pair->count; i++)
        share[i] = i < pair->first ? contact->barycentric[0][i]
                                   : -contact->barycentric[1][i - pair->first];
}

/// How long the turns of an element's vertices have lasted by the contact.
static void share_turns(int count, const double coordinate[], double toi,
                        double share[])
{
    double begin = 0;
    for (int i = count - 1; i >= 0; begin += coordinate[i--])
        share[i] = fmin(fmax(toi - begin, 0), coordinate[i]);
}

static void share_by_gradient(const fig_pair *pair, const tf_contact *contact,
                              double share[])
{
    double toi = (contact->toi_lo + contact->toi_hi) / 2;
    share_turns(pair->first, contact->barycentric[0], toi, share);
    share_turns(pair->count - pair->first, contact->barycentric[1], toi,
                share + pair->first);
    for (int i = pair->first; i < pair->count; i++)
        share[i] = -share[i];
}

static void share_by_pivots(const fig_pair *pair, const tf_contact *contact,
                            double share[])
{
    for (int i = 0; i < pair->count; i++)
        share[i] = 0;
    share[contact->pivot[0]] = 1;
    share[pair->first + contact->pivot[1]] = -1;
}

tf_vector fig_pair_vector(const fig_pair *pair, const tf_contact *contact)
{
    double share[FIG_PAIR_VERTICES];
    share_by_coordinates(pair, contact, share);
    tf_vector vector = {{0, 0, 0}};
    for (int i = 0; i < pair->count; i++)
        vector = fig_combination(vector, share[i], pair->start[i]);
    return vector;
}

fig_pair_row fig_pair_row_of(const fig_pair *pair, const tf_contact *contact,
                             fig_candidate candidate)
{
    tf_vector normal = fig_vector_of(contact->normal);
    double side = tf_vector_dot(normal, fig_pair_vector(pair, contact));
    if (candidate == FIG_BY_PIVOTS)
        side = -contact->normal_velocity;
    fig_pair_row row = {.normal = tf_vector_scaled(side < 0 ? -1 : 1, normal)};
    share_by_coordinates(pair, contact, row.push);
    if (candidate == FIG_BY_GRADIENT)
        share_by_gradient(pair, contact, row.push);
    if (candidate == FIG_BY_PIVOTS)
        share_by_pivots(pair, contact, row.push);
    memcpy(row.want, row.push, sizeof row.want);
    if (candidate == FIG_BY_BOTH)
        share_by_gradient(pair, contact, row.want);
    return row;
}

double fig_pair_parting(const fig_pair *pair, const fig_pair_row *row)
{
    double sum = 0;
    for (int i = 0; i < pair->count; i++)
        sum += row->want[i] * tf_vector_dot(row->normal, pair->move[i]);
    return sum;
}

bool fig_pair_push(fig_pair *pair, const fig_pair_row *row)
{
    double parting = fig_pair_parting(pair, row), compliance = 0;
    if (parting >= -nothing)
        return false;
    for (int i = 0; i < pair->count; i++)
        compliance += row->push[i] * row->want[i];
    for (int i = 0; i < pair->count; i++)
        pair->move[i] = fig_combination(
            pair->move[i], -parting / compliance * row->push[i], row->normal);
    return true;
}

int fig_pair_part(fig_pair *pair, fig_candidate candidate)
{
    tf_contact contact;
    for (int round = 0; round <= FIG_PAIR_ROUNDS; round++) {
        if (!fig_pair_meets(pair, &contact))
            return round;
        fig_pair_row row = fig_pair_row_of(pair, &contact, candidate);
        if (!fig_pair_push(pair, &row))
            return -1;
    }
    return -1;
}

// As the library does it ---------------------------------------------------

/// The pair as a step of the library's, with room for its vertices.
typedef struct flat_pair {
    double start[3 * FIG_PAIR_VERTICES], end[3 * FIG_PAIR_VERTICES];
    double move[3 * FIG_PAIR_VERTICES];
} flat_pair;

static void flatten(const fig_pair *pair, flat_pair *flat)
{
    for (int i = 0; i < pair->count; i++)
        for (int k = 0; k < pair->axes; k++) {
            int place = pair->axes * i + k;
            flat->start[place] = pair->start[i].x[k];
            flat->move[place] = pair->move[i].x[k];
            flat->end[place] = pair->start[i].x[k] + pair->move[i].x[k];
        }
}

static tf_surface_contact name_contact(const fig_pair *pair,
                                       const tf_contact *contact)
{
    tf_kind kind = pair->axes == 2    ? TF_POINT_EDGE
                   : pair->first == 1 ? TF_POINT_TRIANGLE
                                      : TF_EDGE_EDGE;
    return (tf_surface_contact){
        kind, {0, 1, 2, pair->axes == 2 ? -1 : 3}, *contact};
}

/// Push by the library's row; `by_pivots`: by that of the pivots.
static void push_as_library(fig_pair *pair, const tf_contact *contact,
                            bool by_pivots)
{
    static const double inverse_mass[FIG_PAIR_VERTICES] = {1, 1, 1, 1};
    flat_pair flat;
    flatten(pair, &flat);
    tf_step step = {.axes = pair->axes,
                    .vertices = pair->count,
                    .start = flat.start,
                    .end = flat.end,
                    .inverse_mass = inverse_mass};
    tf_contact_rule rule = {.base = flat.end};
    tf_surface_contact named = name_contact(pair, contact);
    tf_contact_gap gap;
    tf_constraint row =
        tf_contact_constraint(&step, &named, &rule, by_pivots, &gap);
    tf_constraint_visit(&row, 0,
                        &(tf_bodies){pair->axes, inverse_mass, flat.move});
    for (int i = 0; i < pair->count; i++)
        for (int k = 0; k < pair->axes; k++)
            pair->move[i].x[k] = flat.move[pair->axes * i + k];
}

int fig_pair_part_as_library(fig_pair *pair)
{
    tf_contact contact;
    for (int round = 0; round <= FIG_PAIR_ROUNDS; round++) {
        if (!fig_pair_meets(pair, &contact))
            return round;
        bool by_pivots = round >= MANY_RETURNS && round % 2 == 0;
        push_as_library(pair, &contact, by_pivots);
    }
    return -1;
}
