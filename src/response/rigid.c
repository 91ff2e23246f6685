//: Include what rigid zones need
#include "response/rigid.h"

#include <stddef.h>
#include <string.h>

//: Hold a rigid body
/// What is known about a zone, at its root.
typedef struct body {
    bool joined;   ///< has a contact in this round
    bool scripted; ///< has a scripted vertex, one of inverse mass 0
    double mass;
    double center[3];       ///< at the start
    double displacement[3]; ///< of the center
    double momentum[3];     ///< angular, about the center
    double inertia[3][3];   ///< about the center
    double turn[3];         ///< the angular displacement
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
    memcpy(rigid->entry.data, step->end, bytes);
    return true;
}

//: Unite the zones of contacts
static void unite(tf_rigid *rigid, const tf_contacts *contacts)
{
    for (size_t i = 0; i < contacts->count; i++) {
        const int *vertex = contacts->contact[i].vertex;
        for (int j = 1; j < 4 && vertex[j] >= 0; j++)
            tf_groups_unite(&rigid->groups, vertex[0], vertex[j]);
    }
    body *all = rigid->body.data;
    for (size_t i = 0; i < contacts->count; i++)
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

//: Multiply vectors of a body
static void cross(const double a[3], const double b[3], double product[3])
{
    for (int k = 0; k < 3; k++)
        product[k] =
            a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
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
        ptrdiff_t place = (ptrdiff_t)step->axes * v;
        double d[3], mass = 1 / step->inverse_mass[v];
        tf_step_displacement(step, v, entry + place, d);
        own->mass += mass;
        for (int k = 0; k < step->axes; k++) {
            own->center[k] += mass * step->start[place + k];
            own->displacement[k] += mass * d[k];
        }
    }
    body *all = rigid->body.data;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; all[v].mass > 0 && k < 3; k++) {
            all[v].center[k] /= all[v].mass;
            all[v].displacement[k] /= all[v].mass;
        }
}

//: Find how a vertex is placed in its body
/// The vector from the center to the vertex at the start.
static void arm_of(const tf_step *step, const body *own, int vertex,
                   double arm[3])
{
    const double *start = step->start + (ptrdiff_t)step->axes * vertex;
    for (int k = 0; k < 3; k++)
        arm[k] = k < step->axes ? start[k] - own->center[k] : 0;
}

//: Add up angular momenta and inertia
static void add_up(tf_rigid *rigid, const tf_step *step)
{
    const double *entry = rigid->entry.data;
    for (int v = 0; v < step->vertices; v++) {
        body *own = moving_body(rigid, v);
        if (!own)
            continue;
        double arm[3], d[3], moment[3], mass = 1 / step->inverse_mass[v];
        arm_of(step, own, v, arm);
        tf_step_displacement(step, v, entry + (ptrdiff_t)step->axes * v, d);
        cross(arm, d, moment);
        for (int i = 0; i < 3; i++) {
            own->momentum[i] += mass * moment[i];
            own->inertia[i][i] += mass * dot(arm, arm);
            for (int j = 0; j < 3; j++)
                own->inertia[i][j] -= mass * arm[i] * arm[j];
        }
    }
}

//: Find the turns
/// Solves inertia * turn = momentum by Cramer's rule.  A body with hardly any
/// inertia about some axis does not turn.
static void find_turn(body *own, int axes)
{
    double column[3][3], minor[3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            column[i][j] = own->inertia[j][i];
    cross(column[1], column[2], minor);
    double trace = own->inertia[0][0] + own->inertia[1][1] + own->inertia[2][2];
    double determinant = dot(column[0], minor);
    if (axes == 2 && trace > 0)
        own->turn[2] = own->momentum[2] / own->inertia[2][2];
    if (axes == 2 || !(determinant > 1e-9 * trace * trace * trace))
        return;
    own->turn[0] = dot(own->momentum, minor) / determinant;
    cross(column[2], column[0], minor);
    own->turn[1] = dot(own->momentum, minor) / determinant;
    cross(column[0], column[1], minor);
    own->turn[2] = dot(own->momentum, minor) / determinant;
}

//: Move a vertex with its body
/// Turns the arm by Cayley's map, which needs no sines and is a rotation for
/// any vector: about this vector, by twice the arc tangent of half its length.
/// `to` is a displacement from the start.
static void move_with_body(const tf_rigid *rigid, tf_step *step,
                           const body *own, int vertex)
{
    double arm[3], half[3], first[3], second[3], to[3];
    arm_of(step, own, vertex, arm);
    for (int k = 0; k < 3; k++)
        half[k] = own->turn[k] / 2;
    cross(half, arm, first);
    cross(half, first, second);
    double scale = 2 / (1 + dot(half, half));
    for (int k = 0; k < 3; k++)
        to[k] = own->displacement[k] + scale * (first[k] + second[k]);
    const double *entry = rigid->entry.data;
    tf_step_place(step, vertex, entry + (ptrdiff_t)step->axes * vertex, to);
}

//: Answer contacts by rigid bodies
void tf_rigid_round(tf_rigid *rigid, tf_step *step, const tf_contacts *contacts)
{
    memset(rigid->body.data, 0, (size_t)step->vertices * sizeof(body));
    unite(rigid, contacts);
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
