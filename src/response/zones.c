//: Include what zones need
#include "response/zones.h"

#include "response/gauss_seidel.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

//: Count how often a contact returns
enum {
    RETURN_SLOTS =
        1 << 16, // two contacts may share one, which does little harm
    MANY_RETURNS = 4
};

/// Forgets the constraints of the last step; see the header.
bool tf_zones_begin(tf_zones *zones, const tf_step *step)
{
    zones->constraints = zones->old = 0;
    size_t bytes = sizeof(double) * (size_t)step->axes * (size_t)step->vertices;
    if (!tf_groups_begin(&zones->groups, step->vertices) ||
        !tf_buffer_reserve(&zones->returns, RETURN_SLOTS, 1) ||
        !tf_buffer_reserve(&zones->entry, bytes, 1))
        return false;
    memcpy(zones->entry.data, step->end, bytes);
    memset(zones->returns.data, 0, RETURN_SLOTS);
    return true;
}

/// Whether the pivots' constraint shall be taken: from the fourth return on
/// every other time, as the constraint of the contact's point has not helped.
static bool is_turn_of_pivots(tf_zones *zones,
                              const tf_surface_contact *contact)
{
    uint32_t hash = (uint32_t)contact->kind;
    for (int i = 0; i < 4; i++)
        hash = (hash ^ (uint32_t)contact->vertex[i]) * UINT32_C(0x9e3779b1);
    unsigned char *times = (unsigned char *)zones->returns.data +
                           hash / (UINT32_MAX / RETURN_SLOTS + 1);
    bool turn = *times >= MANY_RETURNS && *times % 2 == 0;
    if (*times < UCHAR_MAX - 1)
        (*times)++;
    else
        (*times)--;
    return turn;
}

//: Add the constraints of contacts
static bool make_place(tf_zones *zones, size_t constraints)
{
    return tf_buffer_extend(&zones->constraint, constraints,
                            sizeof(tf_constraint)) &&
           tf_buffer_extend(&zones->gap, constraints, sizeof(tf_contact_gap));
}

bool tf_zones_add(tf_zones *zones, const tf_step *step,
                  const tf_contacts *contacts, const tf_contact_rule *rule,
                  tf_zone_statistics *statistics)
{
    if (contacts->count > (size_t)(INT_MAX - zones->constraints) ||
        !make_place(zones, (size_t)zones->constraints + contacts->count))
        return false;
    tf_constraint *constraint = zones->constraint.data;
    tf_contact_gap *gap = zones->gap.data;
    for (size_t i = 0; i < contacts->count && tf_watch_work(step->watch, 4);
         i++) {
        const tf_surface_contact *contact = &contacts->contact[i];
        bool by_pivots = is_turn_of_pivots(zones, contact);
        int own = zones->constraints++;
        constraint[own] =
            tf_contact_constraint(step, contact, rule, by_pivots, &gap[own]);
        statistics->smallest_gap =
            fmin(statistics->smallest_gap, gap[own].start);
    }
    return !tf_watch_cancelled(step->watch);
}

//: Divide the constraints into zones
/// A division of constraints into zones: the constraints of zone z are
/// order[first[z]] to order[first[z + 1] - 1].
typedef struct division {
    int zones;
    int *zone; ///< by root, -1: none
    int *
        place; ///< by vertex: its place in the zone that is being solved, or -1
    int *vertex; ///< by this place
    int *first, *order;
} division;

/// The root of the zone of a constraint, or -1 if it can move nothing.
static int root_of(tf_groups *groups, const tf_constraint *constraint,
                   const double inverse_mass[])
{
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        if (inverse_mass[constraint->vertex[i]] > 0)
            return tf_groups_find(groups, constraint->vertex[i]);
    return -1;
}

//: Unite the vertices of constraints
/// Joins the vertices that new constraints can move.
static void unite_vertices(tf_zones *zones, const tf_step *step)
{
    const double *inverse_mass = step->inverse_mass;
    const tf_constraint *constraint = zones->constraint.data;
    for (int i = zones->old;
         i < zones->constraints && tf_watch_work(step->watch, 1); i++) {
        int root = root_of(&zones->groups, &constraint[i], inverse_mass);
        for (int j = 0; j < 4 && root >= 0 && constraint[i].vertex[j] >= 0; j++)
            if (inverse_mass[constraint[i].vertex[j]] > 0)
                root = tf_groups_unite(&zones->groups, root,
                                       constraint[i].vertex[j]);
    }
}

//: Number the zones that have a new constraint
static void number_zones(tf_zones *zones, const tf_step *step, division *d)
{
    const double *inverse_mass = step->inverse_mass;
    const tf_constraint *constraint = zones->constraint.data;
    d->zones = 0;
    for (int v = 0; v < zones->groups.count; v++)
        d->zone[v] = d->place[v] = -1;
    for (int i = zones->old;
         i < zones->constraints && tf_watch_work(step->watch, 1); i++) {
        int root = root_of(&zones->groups, &constraint[i], inverse_mass);
        if (root >= 0 && d->zone[root] < 0)
            d->zone[root] = d->zones++;
    }
}

//: Order the constraints by zones
/// The zone of a constraint, or -1 if it is not solved now.
static int zone_of(tf_zones *zones, const tf_constraint *constraint,
                   const double inverse_mass[], const division *d)
{
    int root = root_of(&zones->groups, constraint, inverse_mass);
    return root >= 0 ? d->zone[root] : -1;
}

static void order_constraints(tf_zones *zones, const tf_step *step, division *d)
{
    const double *inverse_mass = step->inverse_mass;
    const tf_constraint *constraint = zones->constraint.data;
    memset(d->first, 0, sizeof *d->first * ((size_t)d->zones + 2));
    for (int i = 0; i < zones->constraints && tf_watch_work(step->watch, 1);
         i++)
        d->first[zone_of(zones, &constraint[i], inverse_mass, d) + 2]++;
    d->first[1] = 0; // of the constraints that are in no zone
    for (int z = 0; z < d->zones; z++)
        d->first[z + 2] += d->first[z + 1];
    for (int i = 0; i < zones->constraints && tf_watch_work(step->watch, 1);
         i++) {
        int z = zone_of(zones, &constraint[i], inverse_mass, d);
        if (z >= 0)
            d->order[d->first[z + 1]++] = i;
    }
}

//: Divide
static bool divide(tf_zones *zones, const tf_step *step, division *d)
{
    size_t vertices = (size_t)step->vertices,
           constraints = (size_t)zones->constraints;
    if (!tf_buffer_reserve(&zones->by_vertex, 3 * vertices, sizeof(int)) ||
        !tf_buffer_reserve(&zones->by_constraint, 2 * constraints + 2,
                           sizeof(int)))
        return false;
    d->zone = zones->by_vertex.data;
    d->place = d->zone + vertices;
    d->vertex = d->place + vertices;
    d->first = zones->by_constraint.data;
    d->order = d->first + constraints + 2;
    unite_vertices(zones, step);
    number_zones(zones, step, d);
    order_constraints(zones, step, d);
    return !tf_watch_cancelled(step->watch);
}

//: Number the vertices of a zone
/// Copies the constraints of a zone and gives their vertices numbers of its
/// own.  False if the caller has cancelled.
static bool copy_constraints(tf_zones *zones, division *d, int z, tf_zone *zone)
{
    const tf_constraint *constraint = zones->constraint.data;
    zone->constraints = d->first[z + 1] - d->first[z];
    zone->constraint = zones->zone_constraint.data;
    zone->vertices = zone->solved = 0;
    for (int i = 0; i < zone->constraints; i++) {
        if (!tf_watch_work(zone->watch, 2))
            return false;
        tf_constraint *own = &zone->constraint[i];
        int from = d->order[d->first[z] + i];
        zone->solved += from < zones->old;
        *own = constraint[from];
        for (int j = 0; j < 4 && own->vertex[j] >= 0; j++) {
            int *place = &d->place[own->vertex[j]];
            if (*place < 0) {
                *place = zone->vertices;
                d->vertex[zone->vertices++] = own->vertex[j];
            }
            own->vertex[j] = *place;
        }
    }
    return true;
}

//: Find how much memory zones need
/// How many constraints the largest zone has.
static int largest_zone(const division *d)
{
    int largest = 0;
    for (int z = 0; z < d->zones; z++) {
        int constraints = d->first[z + 1] - d->first[z];
        largest = constraints > largest ? constraints : largest;
    }
    return largest;
}

/// Room for the solver, and for that of the pushes.
static size_t workspace_for(const tf_zone *zone, const tf_zone_solver *solver)
{
    size_t own =
        solver->workspace(zone->axes, zone->vertices, zone->constraints);
    size_t other = tf_gauss_seidel.workspace(zone->axes, zone->vertices,
                                             zone->constraints);
    return own > other ? own : other;
}

//: Pose the motion of a zone
static bool pose(tf_zones *zones, const tf_step *step,
                 const tf_contact_rule *rule, const tf_zone_options *options,
                 division *d, tf_zone *zone)
{
    size_t vertices = (size_t)zone->vertices, axes = (size_t)step->axes;
    size_t workspace = workspace_for(zone, options->solver);
    if (!tf_buffer_reserve(&zones->mass, 2 * vertices, sizeof(double)) ||
        !tf_buffer_reserve(&zones->displacement, axes * vertices,
                           sizeof(double)) ||
        !tf_buffer_reserve(&zones->workspace, workspace, sizeof(double)))
        return false;
    double *inverse_mass = zones->mass.data;
    zone->displacement = zones->displacement.data;
    zone->workspace = zones->workspace.data;
    for (int i = 0; i < zone->vertices; i++) {
        int v = d->vertex[i];
        tf_vector own = tf_step_displacement(step, v, rule->base);
        memcpy(zone->displacement + (ptrdiff_t)step->axes * i, own.x,
               axes * sizeof *own.x);
        inverse_mass[i] = step->inverse_mass[v];
        if (options->friction.own)
            inverse_mass[vertices + (size_t)i] = options->friction.own[v];
        d->place[v] = -1;
    }
    zone->inverse_mass = inverse_mass;
    zone->friction = options->friction.own ? -1 : options->friction.all;
    return true;
}

//: Take the answer of a solver
enum {
    PUSHED = -2 // in the place of a vertex
};

static bool is_changed(const tf_constraint *a, const tf_constraint *b)
{
    bool changed = a->impulse != b->impulse;
    for (int k = 0; k < 3; k++)
        changed |= a->friction[k] != b->friction[k];
    return changed;
}

/// Notes the vertices of constraints whose impulses are new.
static void keep_impulses(tf_zones *zones, const division *d, int z,
                          const tf_zone *zone)
{
    tf_constraint *constraint = zones->constraint.data;
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 2);
         i++) {
        tf_constraint *to = &constraint[d->order[d->first[z] + i]];
        const tf_constraint *from = &zone->constraint[i];
        bool changed = is_changed(to, from);
        for (int j = 0; changed && j < 4 && to->vertex[j] >= 0; j++)
            d->place[to->vertex[j]] = PUSHED;
        // A solver that has failed shall not start there again.
        bool good = isfinite(from->impulse) != 0;
        to->impulse = good ? from->impulse : 0;
        for (int k = 0; k < 3; k++)
            to->friction[k] = good ? from->friction[k] : 0;
    }
}

//: Ask for room
/// Takes what pushes have done before this level for the proposal of what they
/// are to do in a zone.
static bool pose_pushes(tf_zones *zones, const tf_step *step,
                        const tf_contact_rule *rule, const division *d,
                        const tf_zone *zone)
{
    size_t axes = (size_t)step->axes;
    if (!tf_buffer_reserve(&zones->pushed, axes * (size_t)zone->vertices,
                           sizeof(double)))
        return false;
    double *displacement = zones->pushed.data;
    for (int i = 0; i < zone->vertices; i++) {
        int v = d->vertex[i];
        const double *entry = zones->entry.data;
        tf_vector own =
            tf_vector_difference(tf_step_position(step, v, entry),
                                 tf_step_position(step, v, rule->base));
        memcpy(displacement + axes * (size_t)i, own.x, axes * sizeof *own.x);
    }
    return true;
}

/// Makes the constraints of a zone, whose motion is solved, those of its pushes:
/// they give each gap the room that the motion does not give it, and make none
/// narrower.  Returns whether there is anything to be done.
static bool ask_for_room(const tf_zones *zones, const division *d, int z,
                         tf_zone *zone, const double pushed[])
{
    const tf_contact_gap *all = zones->gap.data;
    bool any = false;
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1);
         i++) {
        tf_constraint *own = &zone->constraint[i];
        const tf_contact_gap *gap = &all[d->order[d->first[z] + i]];
        own->bound = 0;
        if (gap->room > 0)
            own->bound =
                fmax(0, gap->room - tf_constraint_gap_change(
                                        zone->axes, own, zone->displacement));
        own->impulse = gap->push;
        memset(own->friction, 0, sizeof own->friction);
        any = any ||
              tf_constraint_gap_change(zone->axes, own, pushed) < own->bound;
    }
    return any;
}

//: Take the pushes of a solver
/// Notes the vertices of constraints whose pushes are new.
static void keep_pushes(const tf_zones *zones, const division *d, int z,
                        const tf_zone *zone, bool any)
{
    const tf_constraint *constraint = zones->constraint.data;
    tf_contact_gap *gap = zones->gap.data;
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1);
         i++) {
        int own = d->order[d->first[z] + i];
        double found = any ? zone->constraint[i].impulse : 0;
        double push = isfinite(found) != 0 ? found : 0;
        for (int j = 0; push != gap[own].push && j < 4; j++)
            if (constraint[own].vertex[j] >= 0)
                d->place[constraint[own].vertex[j]] = PUSHED;
        gap[own].push = push;
    }
}

//: Push the pairs of a zone apart
enum {
    PUSH_SWEEPS = 6 ///< the next steps make the room that these do not
};

/// Solves the constraints of a zone a second time, for pushes: without friction,
/// from where pushes have led before, and always by Gauss-Seidel, as pushes must
/// not pull.  Constraints that were solved for their motion count as solved,
/// though their bounds may be new.  The displacements of the zone stay those of
/// its motion; those with the pushes are left in `pushed`.  False if there is no
/// memory.
static bool push_apart(tf_zones *zones, const tf_step *step,
                       const tf_contact_rule *rule, const division *d, int z,
                       const tf_zone *zone, tf_zone_statistics *statistics)
{
    if (!pose_pushes(zones, step, rule, d, zone))
        return false;
    tf_zone pushing = *zone;
    bool any = ask_for_room(zones, d, z, &pushing, zones->pushed.data);
    pushing.displacement = zones->pushed.data;
    pushing.friction = 0;
    pushing.sweeps = zone->sweeps < PUSH_SWEEPS ? zone->sweeps : PUSH_SWEEPS;
    if (any)
        statistics->iterations += (size_t)tf_gauss_seidel.solve(&pushing);
    keep_pushes(zones, d, z, &pushing, any);
    for (int i = 0; i < zone->axes * zone->vertices; i++)
        pushing.displacement[i] += zone->displacement[i];
    return true;
}

//: Move the vertices of a zone
/// Moves the vertices that were noted.  The others stay where they are: rounded
/// anew, they would have to be decided again.
static void move_vertices(tf_step *step, const tf_contact_rule *rule,
                          const division *d, const tf_zone *zone,
                          const double pushed[])
{
    for (int i = 0; i < zone->vertices; i++) {
        int *mark = &d->place[d->vertex[i]];
        if (*mark != PUSHED)
            continue;
        *mark = -1;
        ptrdiff_t place = (ptrdiff_t)step->axes * i;
        tf_step_move(step, d->vertex[i], rule->base, zone->displacement + place,
                     step->unpushed);
        tf_step_move(step, d->vertex[i], rule->base, pushed + place, step->end);
    }
}

//: Account for a zone
static void account(const tf_zone *zone, int iterations,
                    tf_zone_statistics *statistics)
{
    statistics->zones++;
    statistics->iterations += (size_t)iterations;
    if ((size_t)zone->constraints > statistics->largest)
        statistics->largest = (size_t)zone->constraints;
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1);
         i++) {
        double gap_change = tf_constraint_gap_change(
            zone->axes, &zone->constraint[i], zone->displacement);
        statistics->violation =
            fmax(statistics->violation, zone->constraint[i].bound - gap_change);
    }
}

//: Solve the zones
bool tf_zones_solve(tf_zones *zones, tf_step *step, const tf_contact_rule *rule,
                    const tf_zone_options *options,
                    tf_zone_statistics *statistics)
{
    division d;
    if (!divide(zones, step, &d) ||
        !tf_buffer_reserve(&zones->zone_constraint, (size_t)largest_zone(&d),
                           sizeof(tf_constraint)))
        return false;
    tf_watch_stage(step->watch, "zones", (size_t)d.first[d.zones]);
    for (int z = 0; z < d.zones; z++) {
        tf_zone zone = {.axes = step->axes,
                        .sweeps = options->sweeps,
                        .watch = step->watch};
        if (!copy_constraints(zones, &d, z, &zone) ||
            !pose(zones, step, rule, options, &d, &zone))
            return false;
        account(&zone, options->solver->solve(&zone), statistics);
        keep_impulses(zones, &d, z, &zone);
        if (!push_apart(zones, step, rule, &d, z, &zone, statistics))
            return false;
        move_vertices(step, rule, &d, &zone, zones->pushed.data);
        tf_watch_advance(step->watch, (size_t)zone.constraints);
    }
    zones->old = zones->constraints;
    return !tf_watch_cancelled(step->watch);
}

//: Account for the memory of zones
size_t tf_zones_memory(const tf_zones *zones)
{
    return zones->constraint.bytes + zones->gap.bytes + zones->entry.bytes +
           zones->pushed.bytes + zones->returns.bytes +
           zones->groups.storage.bytes + zones->by_vertex.bytes +
           zones->by_constraint.bytes + zones->zone_constraint.bytes +
           zones->mass.bytes + zones->displacement.bytes +
           zones->workspace.bytes;
}

void tf_zones_free(tf_zones *zones)
{
    tf_buffer_free(&zones->constraint);
    tf_buffer_free(&zones->gap);
    tf_buffer_free(&zones->entry);
    tf_buffer_free(&zones->pushed);
    tf_buffer_free(&zones->returns);
    tf_buffer_free(&zones->groups.storage);
    tf_buffer_free(&zones->by_vertex);
    tf_buffer_free(&zones->by_constraint);
    tf_buffer_free(&zones->zone_constraint);
    tf_buffer_free(&zones->mass);
    tf_buffer_free(&zones->displacement);
    tf_buffer_free(&zones->workspace);
}
