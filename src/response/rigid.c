//: Include what rigid zones need
#include "response/rigid.h"

#include "response/options.h"

#include <stddef.h>
#include <string.h>

//: Hold a rigid body
/// What is known about a zone, at its root.
typedef struct body {
    bool joined;   ///< has a contact in this round
    bool scripted; ///< has a scripted vertex, one of inverse mass 0
    double mass;
    tf_vector center;       ///< at the start
    tf_vector displacement; ///< of the center
    tf_vector momentum;     ///< angular, about the center
    double inertia[3][3];   ///< about the center
    tf_vector turn;         ///< the angular displacement
} body;

//: Begin with single vertices
bool tf_rigid_begin(tf_rigid *rigid, const tf_step *step)
{
    size_t vertices = (size_t)step->vertices;
    size_t bytes = (size_t)step->axes * vertices * sizeof(double);
    if (!tf_groups_begin(&rigid->groups, step->vertices) ||
        !tf_buffer_reserve(&rigid->entry, bytes, 1) ||
        !tf_buffer_reserve(&rigid->body, vertices, sizeof(body)))
        return false;
    memcpy(rigid->entry.data, step->unpushed, bytes);
    return true;
}

//: Unite the zones of contacts
static void unite(tf_rigid *rigid, const tf_contacts *contacts, tf_watch *watch)
{
    for (size_t i = 0; i < contacts->count && tf_watch_work(watch, 2); i++) {
        const int *vertex = contacts->contact[i].vertex;
        for (int j = 1; j < 4 && vertex[j] >= 0; j++)
            tf_groups_unite(&rigid->groups, vertex[0], vertex[j]);
    }
    body *all = rigid->body.data;
    for (size_t i = 0; i < contacts->count && tf_watch_work(watch, 1); i++)
        all[tf_groups_find(&rigid->groups, contacts->contact[i].vertex[0])]
            .joined = true;
}

/// The body of a vertex if the body is to be moved, or NULL.
static body *moving_body(tf_rigid *rigid, int vertex)
{
    body *own =
        (body *)rigid->body.data + tf_groups_find(&rigid->groups, vertex);
    return own->joined && !own->scripted ? own : NULL;
}

//: Find the centers
static void find_scripted(tf_rigid *rigid, const tf_step *step)
{
    for (int v = 0; v < step->vertices; v++) {
        body *own = moving_body(rigid, v);
        if (own && !(step->inverse_mass[v] > 0))
            own->scripted = true;
    }
}

static void find_centers(tf_rigid *rigid, const tf_step *step)
{
    const double *entry = rigid->entry.data;
    for (int v = 0; v < step->vertices; v++) {
        body *own = moving_body(rigid, v);
        if (!own)
            continue;
        double mass = 1 / step->inverse_mass[v];
        tf_vector start = tf_step_position(step, v, step->start);
        tf_vector d = tf_step_displacement(step, v, entry);
        own->mass += mass;
        own->center = tf_vector_sum(own->center, mass, start);
        own->displacement = tf_vector_sum(own->displacement, mass, d);
    }
    body *all = rigid->body.data;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; all[v].mass > 0 && k < TF_AXES; k++) {
            all[v].center.x[k] /= all[v].mass;
            all[v].displacement.x[k] /= all[v].mass;
        }
}

//: Find how a vertex is placed in its body
/// The vector from the center to the vertex at the start.
static tf_vector arm_of(const tf_step *step, const body *own, int vertex)
{
    return tf_vector_difference(tf_step_position(step, vertex, step->start),
                                own->center);
}

//: Add up angular momenta and inertia
static void add_up(tf_rigid *rigid, const tf_step *step)
{
    const double *entry = rigid->entry.data;
    for (int v = 0; v < step->vertices; v++) {
        body *own = moving_body(rigid, v);
        if (!own)
            continue;
        double mass = 1 / step->inverse_mass[v];
        tf_vector arm = arm_of(step, own, v);
        tf_vector moment =
            tf_vector_cross(arm, tf_step_displacement(step, v, entry));
        own->momentum = tf_vector_sum(own->momentum, mass, moment);
        for (int i = 0; i < TF_AXES; i++) {
            own->inertia[i][i] += mass * tf_vector_dot(arm, arm);
            for (int j = 0; j < TF_AXES; j++)
                own->inertia[i][j] -= mass * arm.x[i] * arm.x[j];
        }
    }
}

//: Find the turns
/// Solves inertia * turn = momentum by Cramer's rule.  A body with hardly any
/// inertia about some axis does not turn.
static void find_turn(body *own, int axes)
{
    tf_vector column[TF_AXES], minor[TF_AXES];
    for (int i = 0; i < TF_AXES; i++)
        for (int j = 0; j < TF_AXES; j++)
            column[i].x[j] = own->inertia[j][i];
    for (int i = 0; i < TF_AXES; i++)
        minor[i] = tf_vector_cross(column[(i + 1) % 3], column[(i + 2) % 3]);
    double trace = own->inertia[0][0] + own->inertia[1][1] + own->inertia[2][2];
    double determinant = tf_vector_dot(column[0], minor[0]);
    if (axes == 2 && trace > 0)
        own->turn.x[2] = own->momentum.x[2] / own->inertia[2][2];
    if (axes == 2 || !(determinant > 1e-9 * trace * trace * trace))
        return;
    for (int i = 0; i < TF_AXES; i++)
        own->turn.x[i] = tf_vector_dot(own->momentum, minor[i]) / determinant;
}

//: Move a vertex with its body
/// Turns the arm by Cayley's map, which needs no sines and is a rotation for any
/// vector: about this vector, by twice the arc tangent of half its length.  `to`
/// is a displacement from the start.
static void move_with_body(const tf_rigid *rigid, tf_step *step,
                           const body *own, int vertex)
{
    tf_vector half = tf_vector_scaled(0.5, own->turn);
    tf_vector first = tf_vector_cross(half, arm_of(step, own, vertex));
    tf_vector second = tf_vector_cross(half, first);
    double scale = 2 / (1 + tf_vector_dot(half, half));
    tf_vector to = tf_vector_sum(own->displacement, scale,
                                 tf_vector_sum(first, 1, second));
    tf_step_move(step, vertex, rigid->entry.data, to.x, step->end);
    tf_step_move(step, vertex, rigid->entry.data, to.x, step->unpushed);
    step->flags[vertex] |= TF_VERTEX_RIGID;
}

//: Answer contacts by rigid bodies
void tf_rigid_round(tf_rigid *rigid, tf_step *step, const tf_contacts *contacts)
{
    memset(rigid->body.data, 0, (size_t)step->vertices * sizeof(body));
    unite(rigid, contacts, step->watch);
    find_scripted(rigid, step);
    find_centers(rigid, step);
    add_up(rigid, step);
    body *all = rigid->body.data;
    for (int v = 0; v < step->vertices; v++)
        if (all[v].mass > 0)
            find_turn(&all[v], step->axes);
    for (int v = 0; v < step->vertices; v++) {
        const body *own = moving_body(rigid, v);
        if (own)
            move_with_body(rigid, step, own, v);
    }
}

//: Account for the memory of rigid zones
size_t tf_rigid_memory(const tf_rigid *rigid)
{
    return rigid->groups.storage.bytes + rigid->entry.bytes + rigid->body.bytes;
}

void tf_rigid_free(tf_rigid *rigid)
{
    tf_buffer_free(&rigid->groups.storage);
    tf_buffer_free(&rigid->entry);
    tf_buffer_free(&rigid->body);
}
