//: Include what the failsafe needs
#include "response/failsafe.h"

#include <math.h>
#include <string.h>

//: Hold a group of the failsafe
/// What is known about a group, at its root.
typedef struct group {
    bool resting;  ///< at rest, for good
    bool joined;   ///< changed in this round: its members are to be moved
    bool scripted; ///< has scripted vertices, those of inverse mass 0
    double mass;
    tf_vector displacement; ///< of all vertices; at first a sum
} group;

//: Begin the failsafe
bool tf_failsafe_begin(tf_failsafe *failsafe, const tf_step *step)
{
    size_t vertices = (size_t)step->vertices;
    size_t bytes = (size_t)step->axes * vertices * sizeof(double);
    if (!tf_groups_begin(&failsafe->groups, step->vertices) ||
        !tf_buffer_reserve(&failsafe->entry, bytes, 1) ||
        !tf_buffer_reserve(&failsafe->group, vertices, sizeof(group)))
        return false;
    memcpy(failsafe->entry.data, step->unpushed, bytes);
    memset(failsafe->group.data, 0, vertices * sizeof(group));
    return true;
}

//: Put groups to rest that touch themselves
/// Whether all vertices of a contact are in one group.  Moved by exactly the
/// same displacement, they would stay apart, so roundings or scripts that
/// disagree are to blame.
static bool is_within_group(tf_groups *groups,
                            const tf_surface_contact *contact)
{
    int root = tf_groups_find(groups, contact->vertex[0]);
    for (int i = 1; i < 4 && contact->vertex[i] >= 0; i++)
        if (tf_groups_find(groups, contact->vertex[i]) != root)
            return false;
    return true;
}

static void put_to_rest(tf_failsafe *failsafe, const tf_contacts *contacts,
                        tf_watch *watch)
{
    group *all = failsafe->group.data;
    for (size_t i = 0; i < contacts->count && tf_watch_work(watch, 1); i++) {
        const tf_surface_contact *contact = &contacts->contact[i];
        int root = tf_groups_find(&failsafe->groups, contact->vertex[0]);
        if (is_within_group(&failsafe->groups, contact))
            all[root].resting = true;
    }
}

//: Unite the groups of contacts
static void unite(tf_failsafe *failsafe, int a, int b)
{
    group *all = failsafe->group.data;
    a = tf_groups_find(&failsafe->groups, a);
    b = tf_groups_find(&failsafe->groups, b);
    int root = tf_groups_unite(&failsafe->groups, a, b);
    all[root].resting = all[a].resting || all[b].resting;
    all[root].joined = true;
}

static void unite_all(tf_failsafe *failsafe, const tf_contacts *contacts,
                      tf_watch *watch)
{
    for (size_t i = 0; i < contacts->count && tf_watch_work(watch, 2); i++) {
        const int *vertex = contacts->contact[i].vertex;
        for (int j = 1; j < 4 && vertex[j] >= 0; j++)
            unite(failsafe, vertex[0], vertex[j]);
    }
}

//: Visit the members of joined groups
/// The group of a vertex if the group has changed in this round, or NULL.
static group *joined_group(tf_failsafe *failsafe, int vertex)
{
    group *own = (group *)failsafe->group.data +
                 tf_groups_find(&failsafe->groups, vertex);
    return own->joined ? own : NULL;
}

//: Follow a scripted vertex
/// Gives a group the displacement of a scripted vertex, the first one that it
/// has.  Others may have another displacement, if only by rounding.  Where this
/// makes the group touch itself, the next round puts it to rest.
static void follow(group *own, const tf_step *step, int vertex)
{
    if (own->scripted)
        return;
    own->displacement = tf_step_displacement(step, vertex, step->proposed);
    own->scripted = true;
}

//: Add up momenta
static void add_momentum(group *own, const tf_failsafe *failsafe,
                         const tf_step *step, int vertex)
{
    const double *entry = failsafe->entry.data;
    double mass = 1 / step->inverse_mass[vertex];
    tf_vector d = tf_step_displacement(step, vertex, entry);
    own->mass += mass;
    own->displacement = tf_vector_sum(own->displacement, mass, d);
}

//: Find the displacements of joined groups
static void clear_sums(tf_failsafe *failsafe, int vertices)
{
    group *all = failsafe->group.data;
    for (int v = 0; v < vertices; v++) {
        all[v].scripted = false;
        all[v].mass = 0;
        all[v].displacement = (tf_vector){{0}};
    }
}

/// The scripted vertices come first, because they leave the others no choice.
static void find_displacements(tf_failsafe *failsafe, const tf_step *step)
{
    clear_sums(failsafe, step->vertices);
    for (int v = 0; v < step->vertices; v++) {
        group *own = joined_group(failsafe, v);
        if (own && !(step->inverse_mass[v] > 0))
            follow(own, step, v);
    }
    for (int v = 0; v < step->vertices; v++) {
        group *own = joined_group(failsafe, v);
        if (own && !own->scripted)
            add_momentum(own, failsafe, step, v);
    }
    group *all = failsafe->group.data;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; all[v].mass > 0 && k < TF_AXES; k++)
            all[v].displacement.x[k] /= all[v].mass;
}

//: Keep positions finite
/// Puts groups to rest that would otherwise get an end that is not finite.
static void rest_at_infinity(tf_failsafe *failsafe, const tf_step *step)
{
    for (int v = 0; v < step->vertices; v++) {
        group *own = joined_group(failsafe, v);
        for (int k = 0; own && k < step->axes; k++) {
            double x = step->start[(ptrdiff_t)step->axes * v + k];
            if (!isfinite(x + own->displacement.x[k]))
                own->resting = true;
        }
    }
}

//: Move groups
static void move_groups(tf_failsafe *failsafe, tf_step *step)
{
    for (int v = 0; v < step->vertices; v++) {
        const group *own = joined_group(failsafe, v);
        bool scripted = !(step->inverse_mass[v] > 0);
        for (int k = 0; own && k < step->axes; k++) {
            ptrdiff_t place = (ptrdiff_t)step->axes * v + k;
            double to = step->start[place];
            if (!own->resting)
                to = scripted ? step->proposed[place]
                              : to + own->displacement.x[k];
            if (to != step->end[place]) // -0 must not become +0
                step->end[place] = to;
            step->unpushed[place] = step->end[place];
        }
    }
}

//: Answer contacts by groups
void tf_failsafe_round(tf_failsafe *failsafe, tf_step *step,
                       const tf_contacts *contacts)
{
    group *all = failsafe->group.data;
    for (int v = 0; v < step->vertices; v++)
        all[v].joined = false;
    put_to_rest(failsafe, contacts, step->watch);
    unite_all(failsafe, contacts, step->watch);
    find_displacements(failsafe, step);
    rest_at_infinity(failsafe, step);
    move_groups(failsafe, step);
}

//: Count the groups
int tf_failsafe_mark(tf_failsafe *failsafe, const tf_step *step)
{
    group *all = failsafe->group.data;
    int groups = 0;
    for (int v = 0; v < step->vertices; v++)
        all[v].joined = false;
    for (int v = 0; v < step->vertices; v++) {
        int root = tf_groups_find(&failsafe->groups, v);
        // The root of a group is the least of its vertices, so the first member
        // that differs from it is the second one of the group.
        bool second = root != v && !all[root].joined;
        all[root].joined |= second;
        groups += second;
        if (root != v)
            step->flags[root] |= TF_VERTEX_GROUPED;
        step->flags[v] |= (root != v ? TF_VERTEX_GROUPED : 0) |
                          (all[root].resting ? TF_VERTEX_RESTING : 0);
    }
    return groups;
}

//: Account for the memory of the failsafe
size_t tf_failsafe_memory(const tf_failsafe *failsafe)
{
    return failsafe->groups.storage.bytes + failsafe->entry.bytes +
           failsafe->group.bytes;
}

void tf_failsafe_free(tf_failsafe *failsafe)
{
    tf_buffer_free(&failsafe->groups.storage);
    tf_buffer_free(&failsafe->entry);
    tf_buffer_free(&failsafe->group);
}
