//: Include what limits need
#include "untangle/limit.h"

#include "fast/detect.h"

//: Weigh the vertices of a contact
/// How much the distance of a contact's elements depends on each of its vertices;
/// the sum of the squares of those that are not fixed.
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
        const tf_surface_contact *own = &contacts->contact[i];
        int corners = own->vertex[3] < 0 ? 3 : 4;
        if (tf_scope_has(scope, &tangle->near, own))
            continue;
        count++;
        if (turn >= TURNS || !take_approach(tangle, own, corners, move))
            shorten(own, corners, turn < HALVES ? 0.5 : 0, move);
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

tf_status tf_limit_moves(const tf_tangle *tangle, const tf_scope *scope,
                         const double x[], tf_vector move[], double to[])
{
    const tf_neighbors *all = &tangle->near;
    tf_detect_options options = {.size = sizeof options,
                                 .parallel = tangle->parallel};
    tf_motion motion = {all->axes, all->vertices, x, to};
    for (int turn = 0;; turn++) {
        for (int v = 0; turn > STOPS && v < all->vertices; v++)
            move[v] = (tf_vector){{0, 0, 0}};
        move_all(tangle, x, move, to);
        tf_contacts contacts;
        tf_status status = tf_surface_detect(tangle->surface, &motion, &options,
                                             &contacts, NULL);
        if (status != TF_OK || turn > STOPS ||
            answer(tangle, scope, &contacts, turn, move) == 0)
            return status;
    }
}
