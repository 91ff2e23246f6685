//: Include what limits need
#include "untangle/limit.h"

#include "fast/vectorized.h"

#include <string.h>

//: Weigh the vertices of a contact
/// How much the distance of a contact's elements depends on each of its
/// vertices; the sum of the squares of those that are not fixed.
static double weigh(const tf_tangle *tangle, const tf_surface_contact *contact,
                    int corners, double weight[4])
{
    int first = contact->kind == TF_EDGE_EDGE ? 2 : 1;
    double sum = 0;
    for (int i = 0; i < corners; i++) {
        const double(*of)[3] = contact->contact.barycentric;
        weight[i] = i < first ? of[0][i] : -of[1][i - first];
        if (!tangle->fixed[contact->vertex[i]])
            sum += weight[i] * weight[i];
    }
    return sum;
}

//: Take from the moves of a contact
/// Takes from the moves what brings the elements nearer along the normal; false
/// if they cannot give way so.
static bool take_approach(const tf_tangle *tangle,
                          const tf_surface_contact *contact, int corners,
                          tf_vector move[])
{
    double weight[4], approach = 0;
    double sum = weigh(tangle, contact, corners, weight);
    const double *n = contact->contact.normal;
    tf_vector normal = {{n[0], n[1], tangle->near.axes == 3 ? n[2] : 0}};
    if (sum <= 0 || tf_vector_dot(normal, normal) < 0.5)
        return false;
    for (int i = 0; i < corners; i++)
        approach += weight[i] * tf_vector_dot(move[contact->vertex[i]], normal);
    for (int i = 0; i < corners; i++) {
        tf_vector *own = &move[contact->vertex[i]];
        if (!tangle->fixed[contact->vertex[i]])
            *own = tf_vector_sum(*own, -approach * weight[i] / sum, normal);
    }
    return true;
}

static void shorten(const tf_surface_contact *contact, int corners,
                    double factor, tf_vector move[])
{
    for (int i = 0; i < corners; i++)
        move[contact->vertex[i]] =
            tf_vector_scaled(factor, move[contact->vertex[i]]);
}

//: Limit moves
enum {
    TURNS = 6,   ///< how often contacts turn moves aside
    HALVES = 14, ///< how often in all they are answered before moves end
    STOPS = 40   ///< and before all moves do
};

/// Answers the contacts outside of all zones; returns how many there were.
static size_t answer(const tf_tangle *tangle, const tf_scope *scope,
                     const tf_contacts *contacts, int turn, tf_vector move[])
{
    size_t count = 0;
    for (size_t i = 0; i < contacts->count; i++) {
        tf_surface_contact own = contacts->contact[i];
        int corners = own.vertex[3] < 0 ? 3 : 4;
        if (tangle->patch.is_used)
            tf_near_patch_name(&tangle->patch, corners, own.vertex);
        if (tf_scope_has(scope, &tangle->near, &own))
            continue;
        count++;
        if (turn >= TURNS || !take_approach(tangle, &own, corners, move))
            shorten(&own, corners, turn < HALVES ? 0.5 : 0, move);
    }
    return count;
}

//: Move vertices
static void move_all(const tf_tangle *tangle, const double x[],
                     tf_vector move[], double to[])
{
    const tf_neighbors *all = &tangle->near;
    for (int v = 0; v < all->vertices; v++) {
        if (tangle->fixed[v])
            move[v] = (tf_vector){{0, 0, 0}};
        tf_put(all, to, v, tf_vector_sum(tf_place(all, x, v), 1, move[v]));
    }
}

//: Find the contacts of a round
/// The motion from x to where the vertices go: of the patch, if there is one.
static tf_motion motion_of(tf_tangle *tangle, const double x[],
                           const double to[])
{
    const tf_neighbors *all = &tangle->near;
    tf_near_patch *patch = &tangle->patch;
    if (!patch->is_used)
        return (tf_motion){all->axes, all->vertices, x, to};
    tf_near_patch_gather(patch, all, x, patch->start);
    tf_near_patch_gather(patch, all, to, patch->end);
    return (tf_motion){all->axes, patch->vertices, patch->start, patch->end};
}

/// Finds them among the pairs that the last search has looked at, if there are
/// any; where that has found nothing to answer, from the beginning.
static tf_status find_contacts(tf_tangle *tangle, const double x[],
                               const double to[], bool again,
                               tf_contacts *contacts)
{
    tf_motion motion = motion_of(tangle, x, to);
    tf_near_patch *patch = &tangle->patch;
    tf_contact_search search = {.surface = patch->is_used ? patch->surface
                                                          : tangle->surface,
                                .motion = &motion,
                                .narrow_phase = &tf_vectorized,
                                .parallel = tangle->parallel};
    return again ? tf_pair_cache_update(&tangle->pairs, &search, contacts)
                 : tf_pair_cache_build(&tangle->pairs, &search, contacts, NULL);
}

//: Limit moves until nothing meets
static tf_status limit(tf_tangle *tangle, const tf_scope *scope,
                       const double x[], tf_vector move[], double to[])
{
    bool again = false;
    for (int turn = 0;;) {
        for (int v = 0; turn > STOPS && v < tangle->near.vertices; v++)
            move[v] = (tf_vector){{0, 0, 0}};
        move_all(tangle, x, move, to);
        if (turn > STOPS)
            return TF_OK;
        tf_contacts contacts;
        tf_status status = find_contacts(tangle, x, to, again, &contacts);
        if (status != TF_OK)
            return status;
        bool meets = answer(tangle, scope, &contacts, turn, move) > 0;
        if (!meets && !again)
            return TF_OK;
        turn += meets;
        again = meets;
    }
}

//: Limit moves near where they are
/// Within a patch if that is enough: what meets what moves may move, too, and
/// leave the patch.  Then all begins anew, with the whole surface.
tf_status tf_limit_moves(tf_tangle *tangle, const tf_scope *scope,
                         const double x[], tf_vector move[], double to[])
{
    tf_near_patch *patch = &tangle->patch;
    tf_near_patch_source source = {tangle->surface, &tangle->near,
                                   tangle->edge};
    size_t bytes = (size_t)tangle->near.vertices * sizeof *move;
    tf_status status = tf_near_patch_find(patch, &source, x, move);
    if (status != TF_OK || !patch->is_used)
        return status != TF_OK ? status : limit(tangle, scope, x, move, to);
    if (!tf_buffer_reserve(&tangle->moves, bytes, 1))
        return TF_OUT_OF_MEMORY;
    memcpy(tangle->moves.data, move, bytes);
    status = limit(tangle, scope, x, move, to);
    if (status != TF_OK || tf_near_patch_covers(patch, &tangle->near, x, to))
        return status;
    patch->is_used = false;
    memcpy(move, tangle->moves.data, bytes);
    return limit(tangle, scope, x, move, to);
}
